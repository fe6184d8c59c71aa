// SPDX-License-Identifier: MIT
// From loops in one plane to faces.
#include "carve/group_loops.h"

#include <algorithm>

#include "carve/gather.h"
#include "geometry/exact_loop.h"
#include "geometry/flat_loop.h"
#include "index/box_tree.h"

namespace firma {
namespace {

class Grouper {
public:
    Grouper(const CutView& view, const NewFace& like, std::span<const PatchUse> loops,
            std::span<const std::uint32_t> ends, NewLoops& made)
        : view_(view), made_(made), like_(like), loops_(loops), ends_(ends) {}

    Verdict group() {
        if (ends_.size() == 1) {
            add_face(0, {});
            return Verdict::kFine;
        }
        project_corners();
        std::vector<Int128> area(ends_.size());
        // By exact corners: rounded, a thin one may run the other way.
        std::vector<std::size_t> outer, inner;
        for (std::size_t loop = 0; loop < ends_.size(); ++loop) {
            area[loop] = twice_area(corners(loop));
            const auto corner = [&](std::size_t k) -> const ExactPoint& {
                return view_.point(view_.from(loops_[start(loop) + k]));
            };
            const int turns = surely_turns(corners(loop).size(), corner, like_.plane->plane.front_view());
            if (turns == 0) return Verdict::kDegenerate;
            (turns > 0 ? outer : inner).push_back(loop);
        }
        if (outer.empty()) return Verdict::kDegenerate;
        std::vector<std::vector<std::size_t>> holes(outer.size());
        if (outer.size() == 1)
            holes[0] = inner;
        else if (!group_holes(outer, inner, area, holes))
            return Verdict::kDegenerate;
        for (std::size_t k = 0; k < outer.size(); ++k) add_face(outer[k], holes[k]);
        return Verdict::kFine;
    }

private:
    /// Each hole lies in the smallest outline around it. By boxes: there may be as many outlines as holes.
    /// @return false where that is left open
    bool group_holes(std::span<const std::size_t> outer, std::span<const std::size_t> inner,
                     std::span<const Int128> area, std::vector<std::vector<std::size_t>>& holes) const {
        std::vector<GridBox> boxes(outer.size());
        for (std::size_t k = 0; k < outer.size(); ++k)
            for (const PatchUse& use : loops_.subspan(start(outer[k]), ends_[outer[k]] - start(outer[k])))
                boxes[k].add(view_.point(view_.from(use)).rounded());
        const BoxTree tree(boxes);
        for (const std::size_t loop : inner) {
            GridBox at;
            at.add(view_.point(view_.from(loops_[start(loop)])).rounded());
            std::size_t best = outer.size();
            const bool open = tree.for_each_meeting(grown(at, kNearInSpace), [&](std::size_t k) {
                if (too_near(corners(outer[k]), corners_[start(loop)])) return true;
                if (!encloses(corners(outer[k]), corners_[start(loop)])) return false;
                // Of two that enclose it, one lies in the other: rounded, thin ones may be equally large.
                if (best != outer.size() && area[outer[k]] == area[outer[best]]) return true;
                if (best == outer.size() || area[outer[k]] < area[outer[best]]) best = k;
                return false;
            });
            if (open || best == outer.size()) return false;
            holes[best].push_back(loop);
        }
        return true;
    }

    std::size_t start(std::size_t loop) const { return loop == 0 ? 0 : ends_[loop - 1]; }
    std::span<const FlatPoint> corners(std::size_t loop) const {
        return std::span(corners_).subspan(start(loop), ends_[loop] - start(loop));
    }

    /// Rounded corners lie within half a step of the exact ones along each axis: two of them, seen from each other, and
    /// the line of a side between two more, within so many.
    static constexpr std::int64_t kNearSteps = 2;
    /// What is so near as seen along the axis is this near in the plane: it rises by no more than it goes along both
    /// axes, and corners are rounded.
    static constexpr std::int32_t kNearInSpace = 2 * kNearSteps + 2;

    /// Whether a corner lies so near to a loop that, rounded, it may have changed to the other side.
    static bool too_near(std::span<const FlatPoint> loop, const FlatPoint& p) {
        for (std::size_t k = 0; k < loop.size(); ++k) {
            const FlatPoint &a = loop[k], &b = loop[k + 1 < loop.size() ? k + 1 : 0];
            if (std::max(a.u, b.u) + kNearSteps < p.u || std::min(a.u, b.u) - kNearSteps > p.u ||
                std::max(a.v, b.v) + kNearSteps < p.v || std::min(a.v, b.v) - kNearSteps > p.v)
                continue;
            // Twice the area with the side, by its length: how far from its line.
            const Int128 area = turn(a, b, p);
            const Int128 length = Int128(a.u < b.u ? b.u - a.u : a.u - b.u) + (a.v < b.v ? b.v - a.v : a.v - b.v);
            if ((area < 0 ? -area : area) <= kNearSteps * length) return true;
        }
        return false;
    }

    /// Loops around air run counter-clockwise.
    void project_corners() {
        const FlatView front = like_.plane->plane.front_view();
        corners_.reserve(loops_.size());
        for (const PatchUse& use : loops_) corners_.push_back(project(view_.point(view_.from(use)).rounded(), front));
    }

    void add_loop(std::size_t loop, NewFace& face) {
        made_.all_uses.insert(made_.all_uses.end(), loops_.begin() + std::ptrdiff_t(start(loop)),
                              loops_.begin() + ends_[loop]);
        made_.loop_ends.push_back(std::uint32_t(made_.all_uses.size()) - face.first_use);
        ++face.loop_count;
    }

    void add_face(std::size_t outer, const std::vector<std::size_t>& holes) {
        NewFace face = like_;
        face.first_use = std::uint32_t(made_.all_uses.size());
        face.first_loop = std::uint32_t(made_.loop_ends.size());
        add_loop(outer, face);
        for (const std::size_t hole : holes) add_loop(hole, face);
        face.use_count = std::uint32_t(made_.all_uses.size()) - face.first_use;
        made_.faces.push_back(std::move(face));
    }

    const CutView& view_;
    NewLoops& made_;
    const NewFace& like_;
    std::span<const PatchUse> loops_;
    std::span<const std::uint32_t> ends_;
    std::vector<FlatPoint> corners_;
};

}  // namespace

Verdict group_loops(const CutView& view, const NewFace& like, std::span<const PatchUse> loops,
                    std::span<const std::uint32_t> ends, NewLoops& made) {
    return Grouper(view, like, loops, ends, made).group();
}

}  // namespace firma
