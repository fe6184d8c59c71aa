// SPDX-License-Identifier: MIT
// What of a solid is connected: loops that share edges, holes with what they lie in, hollows with what is around them.
//
// Where a hole or a hollow lies is judged by boxes: it is then with all that may hold it. So what is apart may stay
// together for a while, until it is divided further, but nothing that is one is taken apart.
#include <cmath>

#include "base/disjoint_sets.h"
#include "convex/sides.h"
#include "geometry/grid_box.h"

namespace firma {
namespace {

bool lies_within(const GridBox& inner, const GridBox& outer) {
    for (int axis = 0; axis < 3; ++axis)
        if (inner.low[axis] < outer.low[axis] || inner.high[axis] > outer.high[axis]) return false;
    return true;
}

/// A sum of terms, and how much rounding may have done to it.
struct SignedSum {
    double sum = 0, size = 0;
    void add(double term, double magnitude) {
        sum += term;
        size += magnitude;
    }
    /// Approximate corners are off by 2^-26 of steps that may be as small as one; some roundings besides.
    [[nodiscard]] bool positive() const { return sum > size * 1e-6; }
};

class PartFinder {
public:
    PartFinder(const ConvexSpace& space, const SolidSides& solid) : space_(space), solid_(solid), sets_(solid.size()) {}

    std::vector<std::uint32_t> find(std::uint32_t& count) {
        for (std::uint32_t k = 0; k < solid_.size(); ++k) {
            sets_.join(k, solid_.twin[k]);
            sets_.join(k, solid_.next[k]);
        }
        join_holes();
        join_hollows();
        std::vector<std::uint32_t> number(solid_.size(), ~0u);
        count = 0;
        for (std::uint32_t k = 0; k < solid_.size(); ++k)
            if (sets_.find(k) == k) number[k] = count++;
        for (std::uint32_t k = 0; k < solid_.size(); ++k) number[k] = number[sets_.find(k)];
        return number;
    }

private:
    struct Loop {
        std::uint32_t side = 0;
        PlaneId plane = kNoPlane;
        GridBox box;
        bool outer = false;
    };

    const Vec3& at(std::uint32_t side) const { return space_.point(solid_.sides[side].from).approximate(); }

    bool is_convex(std::uint32_t start) const {
        std::uint32_t k = start;
        do {
            const std::uint32_t next = solid_.next[k];
            const int turn = solid_.bend[k] * solid_.bend[next] *
                             exact_turn(space_.plane(solid_.sides[k].plane), space_.plane(solid_.across(k)),
                                        space_.plane(solid_.across(next)));
            if (turn < 0) return false;
            k = next;
        } while (k != start);
        return true;
    }

    /// Whether a loop runs counter-clockwise, surely.
    bool is_outer(std::uint32_t start) const {
        if (is_convex(start)) return true;
        const FlatView view = space_.plane(solid_.sides[start].plane).front_view();
        const int u = view.u(), v = view.v();
        SignedSum area;
        const Vec3 apex = at(start);
        std::uint32_t k = start;
        do {
            const Vec3 a = at(k) - apex, b = at(solid_.next[k]) - apex;
            area.add(a[u] * b[v] - a[v] * b[u], std::fabs(a[u] * b[v]) + std::fabs(a[v] * b[u]));
            k = solid_.next[k];
        } while (k != start);
        return area.positive();
    }

    void join_holes() {
        std::vector<bool> seen(solid_.size(), false);
        std::vector<Loop> loops;  // plane by plane, as sides are
        for (std::uint32_t start = 0; start < solid_.size(); ++start) {
            if (seen[start]) continue;
            Loop loop{start, solid_.sides[start].plane, {}, is_outer(start)};
            for (std::uint32_t k = start; !seen[k]; k = solid_.next[k]) {
                seen[k] = true;
                loop.box.add(space_.point(solid_.sides[k].from).rounded());
            }
            loops.push_back(loop);
        }
        for (std::size_t first = 0, end; first < loops.size(); first = end) {
            end = first + 1;
            while (end < loops.size() && loops[end].plane == loops[first].plane) ++end;
            for (std::size_t hole = first; hole < end; ++hole)
                for (std::size_t k = first; k < end && !loops[hole].outer; ++k)
                    if (lies_within(loops[hole].box, loops[k].box)) sets_.join(loops[hole].side, loops[k].side);
        }
    }

    struct Shell {
        GridBox box;
        SignedSum volume;
        bool reflex = false, seen = false;
        [[nodiscard]] bool hollow() const { return reflex && !volume.positive(); }
    };

    void join_hollows() {
        std::vector<Shell> shells(solid_.size());
        std::vector<std::uint32_t> listed;
        std::vector<Vec3> apex(solid_.size());
        for (std::uint32_t k = 0; k < solid_.size(); ++k) {
            const std::uint32_t number = sets_.find(k);
            Shell& shell = shells[number];
            if (!shell.seen) {
                shell.seen = true;
                listed.push_back(number);
                apex[number] = at(k);
            }
            shell.box.add(space_.point(solid_.sides[k].from).rounded());
            shell.reflex |= solid_.bend[k] < 0;
        }
        if (listed.size() == 1) return;
        std::vector<bool> seen(solid_.size(), false);
        for (std::uint32_t start = 0; start < solid_.size(); ++start) {
            const std::uint32_t number = sets_.find(start);
            const Vec3 first = at(start) - apex[number];
            for (std::uint32_t k = start; !seen[k]; k = solid_.next[k]) {
                seen[k] = true;
                const Vec3 a = at(k) - apex[number], b = at(solid_.next[k]) - apex[number];
                shells[number].volume.add(dot(first, cross(a, b)), length(first) * length(a) * length(b));
            }
        }
        for (const std::uint32_t inner : listed)
            for (const std::uint32_t outer : listed)
                if (inner != outer && shells[inner].hollow() && lies_within(shells[inner].box, shells[outer].box))
                    sets_.join(inner, outer);
    }

    const ConvexSpace& space_;
    const SolidSides& solid_;
    DisjointSets sets_;
};

}  // namespace

std::vector<std::uint32_t> parts_of_sides(const ConvexSpace& space, const SolidSides& solid, std::uint32_t& count) {
    return PartFinder(space, solid).find(count);
}

}  // namespace firma
