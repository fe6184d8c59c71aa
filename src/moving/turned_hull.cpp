// SPDX-License-Identifier: MIT
// A hull as a part sees it that stands turned.
// Source: the directions in which the sum of hull and face has facets, as in src/cast/hull_against_polygon.h.
#include "moving/turned_hull.h"

#include <cmath>

#include "moving/convex_distance.h"

namespace firma {

TurnedHull::TurnedHull(const PartFrame& frame, const Hull& hull, const Vec3& at)
    : frame_(frame), shape_(*hull.shape()), place_(frame.in(at)) {
    for (const Vec3& corner : hull.corners()) corner_.add(place_ + frame.direction_in(corner));
}

/// How far the hull has to go that way to be out.
double TurnedHull::out_along(const PolygonShape& face, const Vec3& direction) const {
    double highest = -INFINITY, lowest = INFINITY;
    for (const Vec3& corner : face.corners) highest = std::fmax(highest, dot(corner - place_, direction));
    for (const Vec3& corner : corners()) lowest = std::fmin(lowest, dot(corner - place_, direction));
    return highest - lowest;
}

Overlap TurnedHull::way_out(const PolygonShape& face, bool two_sided) const {
    const Vec3 normal = face.unit_normal();
    Overlap best;
    best.direction = normal;
    best.depth = out_along(face, normal);
    const bool behind = dot(place_ - face.corners[0], normal) < 0;
    const auto look = [&](const Vec3& direction) {
        const double size = length(direction);
        if (!(size > 0)) return;
        const Vec3 unit = direction * (1 / size);
        const double depth = out_along(face, unit);
        if (!(depth < best.depth)) return;
        best.direction = unit;
        best.depth = depth;
    };
    if (!behind || two_sided) {
        look(-normal);
        for (const HullShape::Triangle& triangle : shape_.triangles) look(frame_.direction_in(-triangle.normal));
        for (const HullShape::Edge& edge : shape_.edges)
            for (std::size_t k = 0; k < face.corners.size(); ++k) {
                const Vec3 side = face.corners[face.next(k)] - face.corners[k];
                const Vec3 along = corner_[edge.to] - corner_[edge.from];
                const Vec3 across = cross(side, along);
                // Of sides that are all but parallel rounding has the direction; their neighbours' is as short.
                if (length(across) < 0x1p-30 * length(side) * length(along)) continue;
                look(across);
                look(-across);
            }
    }
    if (!(best.depth > 0)) best.depth = 0;
    return best;
}

/// Where they still touch when the hull is out.
void TurnedHull::put_point(const PolygonShape& face, Overlap& overlap) const {
    CornerList moved, outline;
    const Vec3 away = overlap.direction * (overlap.depth + 0x1p-20);
    for (const Vec3& corner : corners()) moved.add(corner - place_ + away);
    for (const Vec3& corner : face.corners) outline.add(corner - place_);
    const Vec3 nearest = place_ + convex_distance(moved.all(), outline.all()).point;
    static_cast<ClosestPoint&>(overlap) = closest_point(nearest, face.corners);
    overlap.distance = 0;
}

void TurnedHull::overlap_each(const MovingPart& part, const NearOptions& options, OverlapVisitor visit) const {
    Box box;
    for (const Vec3& corner : corners()) box.add(corner);
    const Vec3 more{0x1p-16, 0x1p-16, 0x1p-16};
    box.low = box.low - more;
    box.high = box.high + more;
    each_face(part.world(), box, [&](const FaceView& view) {
        if (!(view.mask & options.mask)) return true;
        CornerList here, outline;
        for (const Vec3& corner : corners()) here.add(corner - place_);
        for (const Vec3& corner : view.corners) outline.add(corner - place_);
        if (convex_distance(here.all(), outline.all()).apart) return true;
        const PolygonShape face = make_shape(view.corners);
        Overlap overlap = way_out(face, view.two_sided);
        put_point(face, overlap);
        overlap.status = Status::kHit;
        overlap.face = view.ref();
        overlap.material = view.material;
        return visit(overlap);
    });
}

}  // namespace firma
