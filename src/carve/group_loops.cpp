// SPDX-License-Identifier: MIT
// From loops in one plane to faces.
#include "carve/group_loops.h"

namespace firma {
namespace {

/// The plane seen along an axis, so that loops around air run counter-clockwise.
struct Seen {
    int u, v;

    explicit Seen(const Plane& plane) {
        const int axis = plane.dominant_axis();
        const bool flip = plane.normal[axis] < 0;
        u = (axis + (flip ? 2 : 1)) % 3;
        v = (axis + (flip ? 1 : 2)) % 3;
    }
};

class Grouper {
public:
    Grouper(const CutView& view, const NewFace& like, std::span<const PatchUse> loops,
            std::span<const std::uint32_t> ends, NewLoops& made)
        : view_(view), made_(made), like_(like), seen_(like.plane->plane), loops_(loops), ends_(ends) {}

    Verdict group() {
        if (ends_.size() == 1) {
            add_face(0, {});
            return Verdict::kFine;
        }
        std::vector<Int128> area(ends_.size());
        std::vector<std::size_t> outer;
        for (std::size_t loop = 0; loop < ends_.size(); ++loop) {
            area[loop] = doubled_area(loop);
            if (area[loop] == 0) return Verdict::kDegenerate;
            if (area[loop] > 0) outer.push_back(loop);
        }
        if (outer.empty()) return Verdict::kDegenerate;
        std::vector<std::vector<std::size_t>> holes(outer.size());
        for (std::size_t loop = 0; loop < ends_.size(); ++loop) {
            if (area[loop] > 0) continue;
            std::size_t best = outer.size();
            for (std::size_t k = 0; k < outer.size(); ++k) {
                const bool smaller = best == outer.size() || area[outer[k]] < area[outer[best]];
                if (outer.size() == 1 || (smaller && contains(outer[k], corner(start(loop))))) best = k;
            }
            if (best == outer.size()) return Verdict::kDegenerate;
            holes[best].push_back(loop);
        }
        for (std::size_t k = 0; k < outer.size(); ++k) add_face(outer[k], holes[k]);
        return Verdict::kFine;
    }

private:
    std::size_t start(std::size_t loop) const { return loop == 0 ? 0 : ends_[loop - 1]; }
    const GridPoint& corner(std::size_t k) const { return view_.point(view_.from(loops_[k])).rounded(); }

    Int128 doubled_area(std::size_t loop) const {
        const GridPoint& first = corner(start(loop));
        Int128 sum = 0;
        for (std::size_t k = start(loop); k < ends_[loop]; ++k) {
            const GridPoint &a = corner(k), &b = corner(k + 1 < ends_[loop] ? k + 1 : start(loop));
            sum += turn(first, a, b);
        }
        return sum;
    }

    /// Twice the area of a triangle, seen along the axis.
    Int128 turn(const GridPoint& a, const GridPoint& b, const GridPoint& c) const {
        const auto du = [&](const GridPoint& p) { return std::int64_t(p[seen_.u]) - a[seen_.u]; };
        const auto dv = [&](const GridPoint& p) { return std::int64_t(p[seen_.v]) - a[seen_.v]; };
        return Int128(du(b)) * dv(c) - Int128(dv(b)) * du(c);
    }

    /// Counts the sides to the right of the point that cross its height; a corner at that height counts as above.
    bool contains(std::size_t loop, const GridPoint& p) const {
        bool inside = false;
        for (std::size_t k = start(loop); k < ends_[loop]; ++k) {
            const GridPoint &a = corner(k), &b = corner(k + 1 < ends_[loop] ? k + 1 : start(loop));
            if ((a[seen_.v] < p[seen_.v]) == (b[seen_.v] < p[seen_.v])) continue;
            const bool upward = b[seen_.v] > a[seen_.v];
            if ((turn(a, b, p) > 0) == upward) inside = !inside;
        }
        return inside;
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
    const Seen seen_;
    std::span<const PatchUse> loops_;
    std::span<const std::uint32_t> ends_;
};

}  // namespace

Verdict group_loops(const CutView& view, const NewFace& like, std::span<const PatchUse> loops,
                    std::span<const std::uint32_t> ends, NewLoops& made) {
    return Grouper(view, like, loops, ends, made).group();
}

}  // namespace firma
