// SPDX-License-Identifier: MIT
// Many casts at once, piece by piece.
#include "world/cast_many.h"

#include <algorithm>
#include <atomic>
#include <mutex>
#include <vector>

#include "base/lock.h"
#include "world/run_tasks.h"

namespace firma {
namespace {

/// What one call of the work does.
constexpr std::size_t kCastsAPiece = 256;
/// What is put in order at once: as many as there are, yet so few that several threads share it.
constexpr std::size_t kFewestInOrder = std::size_t(1) << 16, kPartsForThreads = 8;
/// As long as memory takes, about.
constexpr std::size_t kCastsAhead = 3;
/// Fewer casts, or a world of fewer faces, gain nothing by an order.
constexpr std::size_t kFewCasts = 1024, kFewFaces = 20000;

constexpr std::size_t parts_of(std::size_t count, std::size_t size) {
    return count / size + (count % size != 0);
}

class ManyRun {
public:
    ManyRun(const World& world, const ManyCasts& casts, const ManyOptions& options)
        : casts_(casts), options_(options), pieces_(parts_of(casts.count, kCastsAPiece)) {
        options_.cast.trail = nullptr;
        if (options.cast.counts) counts_.resize(pieces_);
        if (options.progress) made_.resize(pieces_);
        const bool orders =
            options.order == CastOrder::kBest && casts.count >= kFewCasts && world.face_count() >= kFewFaces;
        if (!orders) return;
        order_.resize(casts.count);
        spare_.resize(casts.count);
        if (options.tasks) {
            const std::size_t shared = parts_of(casts.count, kPartsForThreads * kCastsAPiece) * kCastsAPiece;
            part_size_ = std::clamp(shared, kFewestInOrder, kMostInOrder);
        }
        in_order_.resize(parts_of(casts.count, part_size_));
        bounds_ = world.bounds();
    }

    ManyResult run() {
        const Tasks tasks = options_.tasks ? *options_.tasks : Tasks{};
        const auto put_in_order = [](void* context, std::size_t part) { static_cast<ManyRun*>(context)->order(part); };
        const auto make = [](void* context, std::size_t piece) { static_cast<ManyRun*>(context)->make(piece); };
        if (!run_tasks(tasks, in_order_.size(), put_in_order, this) || !run_tasks(tasks, pieces_, make, this)) {
            for (std::size_t k = 0; k < casts_.count; ++k) casts_.answer(k, nullptr);
            return ManyResult::kRefused;
        }
        if (options_.cast.counts)
            for (const CastCounts& seen : counts_) {
                options_.cast.counts->nodes += seen.nodes;
                options_.cast.counts->boxes += seen.boxes;
                options_.cast.counts->faces += seen.faces;
                options_.cast.counts->precise += seen.precise;
            }
        if (!stopped_) return ManyResult::kDone;
        bool whole = true;
        for (std::size_t piece = 0; piece < pieces_; ++piece) {
            if (made_[piece]) continue;
            whole = false;
            each_of(piece, [&](std::size_t k) { casts_.answer(k, nullptr); });
        }
        return whole ? ManyResult::kDone : ManyResult::kCancelled;
    }

private:
    void order(std::size_t part) {
        const std::size_t begin = part * part_size_, count = std::min(part_size_, casts_.count - begin);
        const auto way = [&](std::size_t k) { return casts_.way(begin + k); };
        in_order_[part] =
            order_casts(bounds_, way, std::span(order_).subspan(begin, count), std::span(spare_).subspan(begin, count));
    }

    /// A piece lies in one part, as parts are whole pieces.
    template <class Function>
    void each_of(std::size_t piece, const Function& function) const {
        const std::size_t begin = piece * kCastsAPiece, end = std::min(begin + kCastsAPiece, casts_.count);
        const std::size_t part = begin / part_size_;
        if (in_order_.empty() || !in_order_[part]) {
            for (std::size_t k = begin; k < end; ++k) function(k);
            return;
        }
        const auto cast_at = [&](std::size_t k) { return part * part_size_ + cast_of(order_[k]); };
        for (std::size_t k = begin; k < end; ++k) {
            if (k + kCastsAhead < end) casts_.fetch(cast_at(k + kCastsAhead));
            function(cast_at(k));
        }
    }

    void make(std::size_t piece) {
        if (stopped_.load(std::memory_order_relaxed)) return;
        CastOptions options = options_.cast;
        if (!counts_.empty()) options.counts = &counts_[piece];
        each_of(piece, [&](std::size_t k) { casts_.answer(k, &options); });
        if (!options_.progress) return;
        const std::lock_guard lock(told_);
        made_[piece] = 1;
        done_ += std::min(kCastsAPiece, casts_.count - piece * kCastsAPiece);
        if (!stopped_ && !options_.progress(done_, casts_.count, options_.user)) stopped_ = true;
    }

    const ManyCasts& casts_;
    ManyOptions options_;
    const std::size_t pieces_;
    std::size_t part_size_ = kMostInOrder;
    Box bounds_;
    std::vector<std::uint64_t> order_, spare_;
    std::vector<std::uint8_t> in_order_;  ///< of each part: whether order_ holds for it
    std::vector<CastCounts> counts_;      ///< of each piece, when they are wanted
    std::vector<std::uint8_t> made_;      ///< of each piece, when there is progress
    Lock told_;
    std::size_t done_ = 0;
    std::atomic<bool> stopped_ = false;
};

}  // namespace

ManyResult run_many(const World& world, const ManyCasts& casts, const ManyOptions& options) {
    if (!casts.fits) {
        for (std::size_t k = 0; k < casts.count; ++k) casts.answer(k, nullptr);
        return ManyResult::kRefused;
    }
    return ManyRun(world, casts, options).run();
}

}  // namespace firma
