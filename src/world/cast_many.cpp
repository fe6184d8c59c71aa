// SPDX-License-Identifier: MIT
// Many casts, piece by piece.
#include "world/cast_many.h"

#include <algorithm>
#include <atomic>
#include <mutex>
#include <vector>

#include "base/lock.h"
#include "base/run_tasks.h"
#include "world/invalid_hit.h"

namespace firma {
namespace {

/// What one call of the work does.
constexpr std::size_t kCastsAPiece = 256;

constexpr std::size_t parts_of(std::size_t count, std::size_t size) {
    return count / size + (count % size != 0);
}

class ManyRun {
public:
    using Make = FunctionRef<void(const AskedCasts& some, const CastOptions& each)>;
    using Refuse = FunctionRef<void(std::size_t k)>;

    /// @param refuse  puts kInvalid
    ManyRun(const ManyCasts& casts, Make make, Refuse refuse, const ManyOptions& options)
        : casts_(casts), make_(make), refuse_(refuse), options_(options), pieces_(parts_of(casts.count, kCastsAPiece)) {
        options_.cast.trail = nullptr;
        if (options.cast.counts) counts_.resize(pieces_);
        if (options.progress) made_.resize(pieces_);
    }

    ManyResult run() {
        if (!casts_.fits) return refuse_all();
        const Tasks tasks = options_.tasks ? *options_.tasks : Tasks{};
        const auto make = [](void* context, std::size_t piece) { static_cast<ManyRun*>(context)->make(piece); };
        if (!run_tasks(tasks, pieces_, make, this)) return refuse_all();
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
            for (std::size_t k = 0; k < size_of(piece); ++k) refuse_(piece * kCastsAPiece + k);
        }
        return whole ? ManyResult::kDone : ManyResult::kCancelled;
    }

private:
    ManyResult refuse_all() {
        for (std::size_t k = 0; k < casts_.count; ++k) refuse_(k);
        return ManyResult::kRefused;
    }

    std::size_t size_of(std::size_t piece) const { return std::min(kCastsAPiece, casts_.count - piece * kCastsAPiece); }

    void make(std::size_t piece) {
        if (stopped_.load(std::memory_order_relaxed)) return;
        CastOptions options = options_.cast;
        if (!counts_.empty()) options.counts = &counts_[piece];
        make_(AskedCasts{piece * kCastsAPiece, size_of(piece), casts_.spheres, casts_.ask}, options);
        if (!options_.progress) return;
        const std::lock_guard lock(told_);
        made_[piece] = 1;
        done_ += size_of(piece);
        if (!stopped_ && !options_.progress(done_, casts_.count, options_.user)) stopped_ = true;
    }

    const ManyCasts& casts_;
    const Make make_;
    const Refuse refuse_;
    ManyOptions options_;
    const std::size_t pieces_;
    std::vector<CastCounts> counts_;  ///< of each piece, when they are wanted
    std::vector<std::uint8_t> made_;  ///< of each piece, when there is progress
    Lock told_;
    std::size_t done_ = 0;
    std::atomic<bool> stopped_ = false;
};

}  // namespace

ManyResult run_many(const World& world, const ManyCasts& casts, FunctionRef<AnswerFirst> answer,
                    const ManyOptions& options) {
    const auto make = [&](const AskedCasts& some, const CastOptions& each) {
        cast_together(world, some, answer, each);
    };
    const auto refuse = [&](std::size_t k) {
        const Vec3 start = casts.fits ? casts.ask(k).around.centre : Vec3{};
        answer(k, [&](Hit& hit) { hit = invalid_hit(start); });
    };
    return ManyRun(casts, make, refuse, options).run();
}

ManyResult run_many_any(const World& world, const ManyCasts& casts, FunctionRef<AnswerAny> answer,
                        const ManyOptions& options) {
    const auto make = [&](const AskedCasts& some, const CastOptions& each) {
        cast_any_together(world, some, answer, each);
    };
    const auto refuse = [&](std::size_t k) { answer(k, Status::kInvalid); };
    return ManyRun(casts, make, refuse, options).run();
}

}  // namespace firma
