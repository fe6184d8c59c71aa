// SPDX-License-Identifier: MIT
// Pieces of portals that lie side by side in one plane become one.
#include "world/join_sheets.h"

#include <algorithm>

#include "base/disjoint_sets.h"
#include "base/sort.h"
#include "geometry/flat_loop.h"

namespace firma {
namespace {

/// A side of a face, by its rounded ends: in one plane those of two edges are the same only where the edges are.
struct SheetSide {
    GridPoint low, high;
    bool down = false;  ///< it runs from `high`
    std::uint32_t sheet = 0;
    const SolidUse* use = nullptr;
    bool within = false;  ///< between two that become one

    bool along(const SheetSide& other) const { return low == other.low && high == other.high; }
};

class SheetJoiner {
public:
    explicit SheetJoiner(std::span<const Ref<const SolidFace>> sheets) : sheets_(sheets), sets_(sheets.size()) {}

    std::vector<JoinedSheet> join() {
        gather_sides();
        join_at_sides();
        std::vector<JoinedSheet> joined;
        for (std::uint32_t k = 0; k < sheets_.size(); ++k)
            if (sets_.find(k) == k) add(k, joined);
        sort_range(joined, [](const JoinedSheet& a, const JoinedSheet& b) { return a.members[0] < b.members[0]; });
        return joined;
    }

private:
    const Plane& plane(std::uint32_t sheet) const { return sheets_[sheet]->plane->plane; }

    void gather_sides() {
        for (std::uint32_t k = 0; k < sheets_.size(); ++k)
            for (const SolidUse& use : sheets_[k]->uses) {
                const GridPoint a = use.from().point.rounded();
                const GridPoint b = use.edge().vertex[!use.reversed()]->point.rounded();
                sides_.push_back({std::min(a, b), std::max(a, b), b < a, k, &use});
            }
        sort_range(sides_, [](const SheetSide& a, const SheetSide& b) {
            if (a.low != b.low) return a.low < b.low;
            if (a.high != b.high) return a.high < b.high;
            return a.sheet != b.sheet ? a.sheet < b.sheet : a.down < b.down;
        });
    }

    void join_at_sides() {
        for (std::size_t first = 0, end = 0; first < sides_.size(); first = end) {
            for (end = first + 1; end < sides_.size() && sides_[end].along(sides_[first]);) ++end;
            for (std::size_t a = first; a < end; ++a)
                for (std::size_t b = a + 1; b < end; ++b) {
                    SheetSide &one = sides_[a], &other = sides_[b];
                    if (one.within || other.within || one.down == other.down || one.low == one.high) continue;
                    if (!(plane(one.sheet) == plane(other.sheet))) continue;
                    one.within = other.within = true;
                    sets_.join(one.sheet, other.sheet);
                }
        }
    }

    void add(std::uint32_t set, std::vector<JoinedSheet>& joined) {
        JoinedSheet whole;
        for (std::uint32_t k = set; k < sheets_.size(); ++k)
            if (sets_.find(k) == set) whole.members.push_back(k);
        if (whole.members.size() == 1 || trace(whole)) {
            joined.push_back(std::move(whole));
            return;
        }
        for (const std::uint32_t member : whole.members) joined.push_back({{member}, {}, {}});
    }

    struct Step {
        GridPoint from, to;
        const SolidUse* use;
    };

    /// Of what is left of the members' sides.
    bool trace(JoinedSheet& whole) const {
        std::vector<Step> steps;
        for (const SheetSide& side : sides_)
            if (!side.within && std::binary_search(whole.members.begin(), whole.members.end(), side.sheet))
                steps.push_back({side.down ? side.high : side.low, side.down ? side.low : side.high, side.use});
        if (steps.size() > kMostJoinedCorners) return false;
        const auto by_start = [](const Step& a, const Step& b) { return a.from < b.from; };
        sort_range(steps, by_start);
        for (std::size_t k = 1; k < steps.size(); ++k)
            if (steps[k].from == steps[k - 1].from) return false;
        std::vector<std::uint8_t> passed(steps.size(), 0);
        std::vector<std::vector<const SolidUse*>> loops;
        std::size_t outer = steps.size(), outlines = 0;
        for (std::size_t start = 0; start < steps.size(); ++start) {
            if (passed[start]) continue;
            std::vector<const SolidUse*>& loop = loops.emplace_back();
            std::vector<FlatPoint> corners;
            for (std::size_t at = start; !passed[at];) {
                passed[at] = 1;
                loop.push_back(steps[at].use);
                corners.push_back(project(steps[at].from, plane(whole.members[0]).front_view()));
                const auto next =
                    std::lower_bound(steps.begin(), steps.end(), Step{steps[at].to, {}, nullptr}, by_start);
                if (next == steps.end() || next->from != steps[at].to) return false;
                at = std::size_t(next - steps.begin());
            }
            const Int128 area = twice_area(corners);
            if (area == 0) return false;
            if (area > 0) {
                outer = loops.size() - 1;
                ++outlines;
            }
        }
        if (outlines != 1) return false;
        std::swap(loops[0], loops[outer]);
        for (const std::vector<const SolidUse*>& loop : loops) {
            for (const SolidUse* use : loop) whole.uses.push_back(*use);
            whole.ends.push_back(std::uint32_t(whole.uses.size()));
        }
        return true;
    }

    const std::span<const Ref<const SolidFace>> sheets_;
    DisjointSets sets_;
    std::vector<SheetSide> sides_;
};

}  // namespace

std::vector<JoinedSheet> join_sheets(std::span<const Ref<const SolidFace>> sheets) {
    return SheetJoiner(sheets).join();
}

}  // namespace firma
