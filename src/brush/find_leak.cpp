// SPDX-License-Identifier: MIT
// Where a level is open to the void: a search, breadth first, over a lattice of points that see their neighbours.
#include "firma/brush_world.h"
#include "firma/queries.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/flat_map.h"

namespace firma {
namespace {

constexpr double kSpacings[] = {2, 1, 0.5, 0.25, 0.125};  // metres
constexpr std::size_t kMostPoints = 4'000'000;            ///< looked at with one spacing
constexpr std::int64_t kMostSteps = 1 << 20;              ///< from the first point, along an axis: 21 bits in a key

class LeakSearch {
public:
    LeakSearch(const World& world, const Vec3& from, std::uint32_t mask, double spacing)
        : world_(world), from_(from), spacing_(spacing), bounds_(world.bounds()) {
        options_.mask = mask;
    }

    std::vector<Vec3> search() {
        add({0, 0, 0}, 0);
        for (std::uint32_t at = 0; at < found_.size() && found_.size() < kMostPoints; ++at) {
            const Vec3 here = place(found_[at].steps);
            if (outside(here)) return way_to(at);
            for (int axis = 0; axis < 3; ++axis)
                for (const int step : {-1, 1}) {
                    std::array<std::int64_t, 3> next = found_[at].steps;
                    next[axis] += step;
                    if (std::abs(next[axis]) >= kMostSteps || known(next)) continue;
                    if (sees(here, place(next))) add(next, at);
                }
        }
        return {};
    }

private:
    struct Found {
        std::array<std::int64_t, 3> steps;
        std::uint32_t before;
    };

    static std::uint64_t key(const std::array<std::int64_t, 3>& steps) {
        std::uint64_t bits = 0;
        for (const std::int64_t s : steps) bits = bits << 21 | std::uint64_t(s + kMostSteps - 1);
        return bits;
    }
    bool known(const std::array<std::int64_t, 3>& steps) const { return index_.find(key(steps)) != FlatMap::kNone; }
    void add(const std::array<std::int64_t, 3>& steps, std::uint32_t before) {
        index_.at(key(steps)) = std::uint32_t(found_.size());
        found_.push_back({steps, before});
    }

    Vec3 place(const std::array<std::int64_t, 3>& steps) const {
        return {from_.x + double(steps[0]) * spacing_, from_.y + double(steps[1]) * spacing_,
                from_.z + double(steps[2]) * spacing_};
    }
    bool outside(const Vec3& p) const {
        for (int axis = 0; axis < 3; ++axis)
            if (p[axis] < bounds_.low[axis] || p[axis] > bounds_.high[axis]) return true;
        return false;
    }
    bool sees(const Vec3& a, const Vec3& b) const { return cast_any(world_, {a, 0}, b - a, options_) == Status::kMiss; }

    /// The points on the way, without those that are not needed to see from one to the next.
    std::vector<Vec3> way_to(std::uint32_t at) const {
        std::vector<Vec3> all;
        for (;; at = found_[at].before) {
            all.push_back(place(found_[at].steps));
            if (at == 0) break;
        }
        std::reverse(all.begin(), all.end());
        std::vector<Vec3> way{all[0]};
        for (std::size_t k = 1; k < all.size(); ++k)
            if (k + 1 == all.size() || !sees(way.back(), all[k + 1])) way.push_back(all[k]);
        return way;
    }

    const World& world_;
    const Vec3 from_;
    const double spacing_;
    const Box bounds_;
    CastOptions options_;
    std::vector<Found> found_;
    FlatMap index_;
};

}  // namespace

std::vector<Vec3> find_leak(const World& world, const Vec3& from, std::uint32_t mask) {
    if (!is_finite(from)) return {};
    for (const double spacing : kSpacings) {
        std::vector<Vec3> way = LeakSearch(world, from, mask, spacing).search();
        if (!way.empty()) return way;
    }
    return {};
}

}  // namespace firma
