// SPDX-License-Identifier: MIT
// Which sides are two of one edge, and which follow each other around a face.
#include <algorithm>

#include "base/sort.h"
#include "convex/sides.h"

namespace firma {
namespace {

class SidePairing {
public:
    SidePairing(ConvexSpace& space, SolidSides& solid) : space_(space), solid_(solid) {}

    bool run() {
        const std::size_t count = solid_.size();
        solid_.twin.assign(count, kNone);
        solid_.bend.assign(count, 0);
        solid_.next.assign(count, kNone);
        return pair_all() && bend_all() && follow_all();
    }

private:
    static constexpr std::uint32_t kNone = ~0u;

    const FaceSide& side(std::uint32_t k) const { return solid_.sides[k]; }
    bool runs_up(std::uint32_t k) const { return side(k).from < side(k).to; }

    bool pair_all() {
        std::vector<std::uint32_t> order(solid_.size());
        for (std::uint32_t k = 0; k < order.size(); ++k) order[k] = k;
        const auto ends = [&](std::uint32_t k) { return std::minmax(side(k).from, side(k).to); };
        sort_range(order,
                   [&](std::uint32_t a, std::uint32_t b) { return ends(a) != ends(b) ? ends(a) < ends(b) : a < b; });
        for (std::size_t first = 0, end; first < order.size(); first = end) {
            end = first + 1;
            while (end < order.size() && ends(order[end]) == ends(order[first])) ++end;
            if (!pair_edge({order.data() + first, end - first})) return false;
        }
        return true;
    }

    bool pair_edge(std::span<std::uint32_t> sides) {
        if (sides.size() % 2 != 0) return false;
        if (sides.size() == 2) return join(sides[0], sides[1]);
        return pair_around(sides);
    }

    bool join(std::uint32_t a, std::uint32_t b) {
        if (runs_up(a) == runs_up(b) || same_plane(side(a).plane, side(b).plane)) return false;
        solid_.twin[a] = b;
        solid_.twin[b] = a;
        return true;
    }

    /// Where solids touch along an edge: sorted counter-clockwise about the edge, seen from its higher number, half
    /// planes that run down have solid after them, those that run up before.
    bool pair_around(std::span<std::uint32_t> sides) {
        std::size_t other = 1;
        while (other < sides.size() && same_plane(side(sides[0]).plane, side(sides[other]).plane)) ++other;
        if (other == sides.size()) return false;
        const auto [low, high] = std::minmax(side(sides[0]).from, side(sides[0]).to);
        const std::uint32_t line = space_.lines.add(side(sides[0]).plane, side(sides[other]).plane, low);
        const int along = space_.lines.before(line, low, high) ? 1 : -1;
        // A half plane's angle is that of a normal, a quarter turn on.
        const auto normal = [&](std::uint32_t k) { return runs_up(k) ? side(k).plane : from_behind(side(k).plane); };
        const auto turn = [&](PlaneId a, PlaneId b) {
            return same_plane(a, b) ? 0 : along * space_.lines.turn(line, a, b);
        };
        const PlaneId start = normal(sides[0]);
        const auto part = [&](PlaneId n) {
            if (n == start) return 0;
            if (n == from_behind(start)) return 2;
            return turn(start, n) > 0 ? 1 : 3;
        };
        sort_range(sides, [&](std::uint32_t a, std::uint32_t b) {
            const PlaneId p = normal(a), q = normal(b);
            if (part(p) != part(q)) return part(p) < part(q);
            const int way = turn(p, q);
            return way != 0 ? way > 0 : a < b;
        });
        for (std::size_t k = 0; k < sides.size(); ++k) {
            const std::uint32_t here = sides[k], there = sides[k + 1 < sides.size() ? k + 1 : 0];
            if (normal(here) == normal(there) || runs_up(here) == runs_up(there)) return false;
            if (!runs_up(here) && !join(here, there)) return false;
        }
        return true;
    }

    bool bend_all() {
        for (std::uint32_t k = 0; k < solid_.size(); ++k) {
            if (k > solid_.twin[k]) continue;
            const PlaneId own = side(k).plane, other = solid_.across(k);
            const std::uint32_t line = space_.lines.add(own, other, side(k).from);
            const int along = space_.lines.before(line, side(k).from, side(k).to) ? 1 : -1;
            const int bend = along * space_.lines.turn(line, own, other);
            if (bend == 0) return false;
            solid_.bend[k] = solid_.bend[solid_.twin[k]] = std::int8_t(bend);
        }
        return true;
    }

    /// Of two sides in one plane, the way from the first one's direction to the second one's.
    int turn_between(std::uint32_t a, std::uint32_t b) const {
        const int sign = solid_.bend[a] * solid_.bend[b];
        return sign *
               exact_turn(space_.plane(side(a).plane), space_.plane(solid_.across(a)), space_.plane(solid_.across(b)));
    }

    /// Whether the first comes before the second, clockwise from the way back along `in`.
    bool comes_before(std::uint32_t in, std::uint32_t a, std::uint32_t b) const {
        const int turn_a = turn_between(in, a), turn_b = turn_between(in, b);
        if (turn_a != turn_b) return turn_a > turn_b;
        return turn_between(a, b) < 0;
    }

    /// Each side goes on with the first one clockwise from the way back: loops of faces that touch are apart.
    bool follow_all() {
        std::vector<std::uint8_t> used(solid_.size(), 0);
        for (std::uint32_t k = 0; k < solid_.size(); ++k) {
            const FaceSide wanted{side(k).plane, side(k).to, 0};
            const auto first = std::lower_bound(solid_.sides.begin(), solid_.sides.end(), wanted);
            std::uint32_t best = kNone;
            for (auto at = first; at != solid_.sides.end() && at->plane == wanted.plane && at->from == wanted.from;
                 ++at) {
                const auto candidate = std::uint32_t(at - solid_.sides.begin());
                if (best == kNone || comes_before(k, candidate, best)) best = candidate;
            }
            if (best == kNone || used[best]) return false;
            used[best] = 1;
            solid_.next[k] = best;
        }
        return true;
    }

    ConvexSpace& space_;
    SolidSides& solid_;
};

}  // namespace

bool pair_sides(ConvexSpace& space, FaceSides sides, SolidSides& paired) {
    paired.sides = std::move(sides);
    return SidePairing(space, paired).run();
}

}  // namespace firma
