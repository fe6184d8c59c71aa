// SPDX-License-Identifier: MIT
// Where the plane of a wall meets a placed cutter: vertices lie above it or below, and the section runs from edge to
// edge between them.
#include "carve/wall_section.h"

#include <algorithm>
#include <cmath>

#include "base/sort.h"

namespace firma {
namespace {

constexpr double kBehindSlanted = 4 / kSurfaceSteps;
/// Metres: so near a vertex lies in the plane of a wall that is square to an axis.
constexpr double kInPlane = 0.5 / kSurfaceSteps;

/// An edge that the plane crosses: its vertex above in the upper half.
using CrossedEdge = std::uint64_t;

CrossedEdge crossed_edge(std::uint32_t above, std::uint32_t below) {
    return CrossedEdge(above) << 32 | below;
}

/// Across one triangle.
struct SectionSide {
    CrossedEdge from = 0, to = 0;
    bool used = false;
};

class CutterSection {
public:
    CutterSection(const CutterSolid& cutter, const WallPlane& wall) : wall_(wall) {
        const std::size_t count = cutter.points.size();
        at_.reserve(count);
        for (std::size_t v = 0; v < count; ++v) at_.push_back(cutter.points[v].approximate() * (1 / kInputSteps));
        const double behind = wall.axis >= 0 ? 0 : kBehindSlanted, near = wall.axis >= 0 ? kInPlane : 0;
        for (const Vec3& p : at_) {
            const double height = wall.height(p) + behind;
            height_.push_back(std::fabs(height) <= near ? 0 : height);
        }
    }

    WallOutlines find(const CutterSolid& cutter) {
        for (const CutterTriangle& corners : cutter.placed.triangles) add(corners);
        sort_range(sides_, [](const SectionSide& a, const SectionSide& b) {
            return a.from != b.from ? a.from < b.from : a.to < b.to;
        });
        WallOutlines outlines;
        for (SectionSide& first : sides_) {
            if (first.used) continue;
            for (SectionSide* side = &first; side; side = next_of(*side)) {
                side->used = true;
                outlines.points.push_back(point_of(side->from));
            }
            outlines.ends.push_back(std::uint32_t(outlines.points.size()));
        }
        return outlines;
    }

private:
    bool above(std::uint32_t v) const { return height_[v] >= 0; }

    void add(const CutterTriangle& corners) {
        if (above(corners[0]) == above(corners[1]) && above(corners[1]) == above(corners[2])) return;
        SectionSide side;
        for (std::size_t k = 0; k < 3; ++k) {
            const std::uint32_t a = corners[k], b = corners[(k + 1) % 3];
            if (above(a) && !above(b)) side.from = crossed_edge(a, b);
            if (!above(a) && above(b)) side.to = crossed_edge(b, a);
        }
        sides_.push_back(side);
    }

    SectionSide* next_of(const SectionSide& side) {
        auto next = std::partition_point(sides_.begin(), sides_.end(),
                                         [&](const SectionSide& other) { return other.from < side.to; });
        while (next != sides_.end() && next->from == side.to && next->used) ++next;
        return next != sides_.end() && next->from == side.to ? &*next : nullptr;
    }

    Vec3 point_of(CrossedEdge edge) const {
        const auto above = std::size_t(edge >> 32), below = std::size_t(edge & UINT32_MAX);
        const double share = height_[above] / (height_[above] - height_[below]);
        Vec3 p = at_[above] + (at_[below] - at_[above]) * share;
        if (wall_.axis >= 0) p[wall_.axis] = wall_.level / kSurfaceSteps;
        return p;
    }

    const WallPlane& wall_;
    std::vector<Vec3> at_;  ///< the cutter's vertices, metres
    std::vector<double> height_;
    std::vector<SectionSide> sides_;
};

}  // namespace

WallPlane wall_plane(const Vec3& normal, const GridPoint& point) {
    WallPlane wall{normal, dot(normal, to_metres(point)), -1, 0};
    for (int axis = 0; axis < 3; ++axis) {
        if (std::fabs(normal[axis]) != 1) continue;
        wall.axis = axis;
        wall.level = point[axis];
    }
    return wall;
}

WallOutlines section_of(const CutterSolid& cutter, const WallPlane& wall) {
    return CutterSection(cutter, wall).find(cutter);
}

}  // namespace firma
