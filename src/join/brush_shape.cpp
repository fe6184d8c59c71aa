// SPDX-License-Identifier: MIT
// A brush as a convex body: on each plane a square larger than the world, cut by all other planes.
//
// Corners on the way may lie far outside the world, where exact points do not go: so they are kept as the three planes
// that meet there, and their sides are signs of determinants of planes.
#include "join/brush_shape.h"

#include <algorithm>
#include <cmath>

#include "geometry/rounding.h"

namespace firma {
namespace {

/// A corner somewhere in space: where three planes meet.
struct FarCorner {
    Meet meet;
    double at[3];  ///< each coordinate off by at most rounding(3) of itself
};

/// A side of the polygon on its way, and the corner it begins with.
struct FarSide {
    FarCorner corner;
    PlaneId plane;
};

FarCorner corner_of(const Plane& a, const Plane& b, const Plane& c) {
    FarCorner corner{meet(a, b, c), {}};
    const double w = corner.meet.w.to_double();
    corner.at[0] = corner.meet.x.to_double() / w;
    corner.at[1] = corner.meet.y.to_double() / w;
    corner.at[2] = corner.meet.z.to_double() / w;
    return corner;
}

/// The 4x4 determinant of the planes: at most 16 * 2^(3 * 52 + 77), wherever they meet.
int side_of(const Plane& plane, const FarCorner& corner) {
    double sum = plane.d, size = std::fabs(plane.d);
    for (int axis = 0; axis < 3; ++axis) {
        const double term = double(plane.normal[axis]) * corner.at[axis];
        sum += term;
        size += std::fabs(term);
    }
    // Each term: three roundings of the coordinate, one of the product, three of sums; two more for the bound itself.
    if (std::fabs(sum) > rounding(10) * size) return sum > 0 ? 1 : -1;
    const Meet& m = corner.meet;
    return (m.x * plane.normal[0] + m.y * plane.normal[1] + m.z * plane.normal[2] + m.w * plane.offset()).sign();
}

class PlaneClipper {
public:
    PlaneClipper(ExactTables& tables, std::span<const PlaneId> planes) : tables_(tables), planes_(planes) {
        for (int axis = 0; axis < 3; ++axis) {
            const Plane rim = axis_plane(axis, kRimSteps);
            rim_[axis][0] = tables.planes.add(rim);
            rim_[axis][1] = tables.planes.add(flipped(axis_plane(axis, -kRimSteps)));
        }
    }

    /// What the other planes leave of one; @return false when it has no area
    bool clip(std::size_t index) {
        const PlaneId own = planes_[index];
        start(own);
        for (std::size_t k = 0; k < planes_.size(); ++k) {
            if (planes_[k] == own) {
                if (k < index) return false;  // a repeated one: the first stands for both
                continue;
            }
            if (planes_[k] == from_behind(own)) return false;
            if (!cut(own, planes_[k])) return false;
        }
        return true;
    }

    /// Whether the rim of the world still bounds what clip() left.
    bool open() const {
        for (const FarSide& side : sides_)
            for (const auto& pair : rim_)
                if (side.plane == pair[0] || side.plane == pair[1]) return true;
        return false;
    }

    /// @return false when a corner lies outside the world
    bool write(PlaneId own, ConvexPiece& piece) {
        piece.plane = own;
        piece.sides.clear();
        for (std::size_t k = 0; k < sides_.size(); ++k) {
            const PlaneId before = sides_[k > 0 ? k - 1 : sides_.size() - 1].plane;
            const std::uint32_t corner = tables_.points.add(own, before, sides_[k].plane);
            if (corner == PointTable::kNone) return false;
            piece.sides.push_back({corner, sides_[k].plane});
        }
        return true;
    }

private:
    const Plane& plane(PlaneId id) const { return tables_.planes.plane(id); }

    /// A square in the plane, as wide as the world along the two axes that the plane is least steep to.
    void start(PlaneId own) {
        const int axis = plane(own).dominant_axis();
        const int u = (axis + 1) % 3, v = (axis + 2) % 3;
        PlaneId around[4] = {rim_[u][0], rim_[v][0], rim_[u][1], rim_[v][1]};
        if (plane(own).normal[axis] < 0) std::swap(around[1], around[3]);
        sides_.clear();
        for (int k = 0; k < 4; ++k)
            sides_.push_back({corner_of(plane(own), plane(around[(k + 3) % 4]), plane(around[k])), around[k]});
    }

    bool cut(PlaneId own, PlaneId by) {
        const std::size_t count = sides_.size();
        at_.clear();
        bool any_front = false, any_behind = false;
        for (const FarSide& side : sides_) {
            at_.push_back(side_of(plane(by), side.corner));
            any_front |= at_.back() > 0;
            any_behind |= at_.back() < 0;
        }
        if (!any_behind) return false;
        if (!any_front) return true;
        kept_.clear();
        for (std::size_t k = 0; k < count; ++k) {
            const int here = at_[k], there = at_[k + 1 < count ? k + 1 : 0];
            if (here <= 0) kept_.push_back({sides_[k].corner, here == 0 && there > 0 ? by : sides_[k].plane});
            if (here * there < 0)
                kept_.push_back(
                    {corner_of(plane(own), plane(sides_[k].plane), plane(by)), here < 0 ? by : sides_[k].plane});
        }
        std::swap(sides_, kept_);
        return true;
    }

    ExactTables& tables_;
    std::span<const PlaneId> planes_;
    PlaneId rim_[3][2];
    std::vector<FarSide> sides_, kept_;
    std::vector<int> at_;
};

}  // namespace

BrushFault make_brush_shape(ExactTables& tables, std::span<const PlaneId> planes, BrushShape& shape) {
    shape.faces.clear();
    shape.corners.clear();
    shape.box = {};
    if (planes.size() > kMostBrushPlanes) return BrushFault::kTooMany;
    PlaneClipper clipper(tables, planes);
    for (std::uint32_t k = 0; k < planes.size(); ++k) {
        if (!clipper.clip(k)) continue;
        if (clipper.open()) return BrushFault::kOpen;
        BrushShape::Face face;
        face.side = k;
        if (!clipper.write(planes[k], face.piece)) return BrushFault::kOpen;
        shape.box.add(face.piece.box(tables.points));
        for (const PieceSide& side : face.piece.sides) shape.corners.push_back(side.corner);
        shape.faces.push_back(std::move(face));
    }
    std::sort(shape.corners.begin(), shape.corners.end());
    shape.corners.erase(std::unique(shape.corners.begin(), shape.corners.end()), shape.corners.end());
    // Half spaces that have a volume in common, and no more than that, have at least four faces.
    if (shape.faces.size() < 4) return shape.faces.empty() ? BrushFault::kEmpty : BrushFault::kOpen;
    return BrushFault::kNone;
}

}  // namespace firma
