// SPDX-License-Identifier: MIT
// A sphere against a polygon: the earliest of face, edges and vertices.
// Source: C. Ericson, Real-Time Collision Detection, 2005, section 5.5.6, for the order of the questions.
#include "cast/cast_sphere_polygon.h"

#include <cmath>

#include "cast/cast_particle_polygon.h"
#include "cast/cast_sphere_edge.h"
#include "cast/cast_sphere_face.h"
#include "cast/cast_sphere_vertex.h"
#include "cast/start_contact.h"
#include "geometry/exact_predicates.h"
#include "geometry/rounding.h"

namespace firma {
namespace {

/// Whether the plane is certainly not reached before `latest`, or was left behind for good.
bool out_of_reach(const Sweep& sweep, const PlaneView& view, double latest) {
    const double error = view.height_error;
    if (view.height + error < -sweep.radius) return true;
    const double fall = (view.approach + view.approach_error) * latest;
    return view.height - error - sweep.radius > fall * (1 + rounding(8));
}

/// Whether the start is certainly farther than the radius from a box around the polygon.
bool starts_clear(const Sweep& sweep, const PolygonShape& polygon) {
    for (int axis = 0; axis < 3; ++axis) {
        double low = polygon.corners[0][axis], high = low;
        for (const Vec3& corner : polygon.corners) {
            if (corner[axis] < low) low = corner[axis];
            if (corner[axis] > high) high = corner[axis];
        }
        const double p = sweep.start[axis];
        const double margin =
            sweep.radius + rounding(8) * (std::fabs(p) + std::fabs(low) + std::fabs(high) + sweep.radius);
        if (p < low - margin || p > high + margin) return true;
    }
    return false;
}

void keep_earlier(Contact& best, const Entry& entry, Feature feature, std::size_t index) {
    if (entry.kind != Entry::kFound || (best.touched() && best.t <= entry.t)) return;
    best = {entry.t > 0 ? Status::kHit : Status::kInitialOverlap, feature, std::uint32_t(index), entry.t};
}

/// The box around the sphere's path up to the earliest touch known: edges and vertices clear of it cannot be met in
/// time.
class PathBox {
public:
    PathBox(const Sweep& sweep, double latest) {
        const Vec3 end = sweep.at(latest);
        const double size = max_abs(sweep.start) + max_abs(end) + sweep.radius + kWorldRim;
        const double margin = sweep.radius + rounding(64) * size;
        for (int axis = 0; axis < 3; ++axis) {
            const bool forward = sweep.start[axis] < end[axis];
            low_[axis] = (forward ? sweep.start : end)[axis] - margin;
            high_[axis] = (forward ? end : sweep.start)[axis] + margin;
        }
    }

    bool clear_of(const Vec3& vertex) const { return clear_of(vertex, vertex); }
    bool clear_of(const Vec3& a, const Vec3& b) const {
        for (int axis = 0; axis < 3; ++axis) {
            if (a[axis] < low_[axis] && b[axis] < low_[axis]) return true;
            if (a[axis] > high_[axis] && b[axis] > high_[axis]) return true;
        }
        return false;
    }

private:
    Vec3 low_, high_;
};

Contact cast_rim(const Sweep& sweep, const PolygonShape& polygon, double latest, CastCounts* counts) {
    const PathBox path(sweep, latest);
    Contact best;
    const auto corners = polygon.corners;
    for (std::size_t k = 0; k < corners.size(); ++k) {
        Entry vertex = path.clear_of(corners[k]) ? Entry{} : enter_vertex(sweep, corners[k]);
        if (vertex.kind == Entry::kDoubtful) {
            vertex = enter_vertex_precisely(sweep, corners[k]);
            if (counts) ++counts->precise;
        }
        keep_earlier(best, vertex, Feature::kVertex, k);
        const Vec3 &a = corners[k], &b = corners[polygon.next(k)];
        Entry edge = path.clear_of(a, b) ? Entry{} : enter_edge(sweep, a, b);
        if (edge.kind == Entry::kDoubtful) {
            edge = enter_edge_precisely(sweep, a, b);
            if (counts) ++counts->precise;
        }
        keep_earlier(best, edge, Feature::kEdge, k);
    }
    return best;
}

/// A sphere not much larger than rounding could slip between features; its centre, decided exactly, cannot.
bool radius_is_near_rounding(const Sweep& sweep, const PolygonShape& polygon) {
    constexpr double kFarAboveRounding = 0x1p-36;
    const double far = length(sweep.start - polygon.corners[0]) + sweep.end * sweep.direction_length;
    return sweep.radius < kFarAboveRounding * far;
}

}  // namespace

Contact cast_sweep_polygon(const Sweep& sweep, const PolygonShape& polygon, Sides sides, double latest,
                           CastCounts* counts) {
    const int facing = exact_facing(sweep.direction, polygon);
    if (facing >= 0 && sides == Sides::kFront) return {};
    const PlaneView view = view_plane(sweep, polygon, facing);
    if (out_of_reach(sweep, view, latest)) return {};
    if (sweep.radius == 0) return cast_particle_polygon(sweep, polygon, facing);

    if (std::fabs(view.height) - view.height_error <= sweep.radius && !starts_clear(sweep, polygon)) {
        const StartContact start = start_contact(sweep, polygon, facing);
        if (start.kind != StartContact::kApart) return start.contact;
    }
    if (facing != 0 && view.height + view.height_error >= sweep.radius) {
        const Entry entry = enter_plane(sweep, polygon, view);
        if (entry.kind == Entry::kNone) return {};  // not even the plane is reached
        if (foot_inside(sweep, polygon, entry.t))
            return {entry.t > 0 ? Status::kHit : Status::kInitialOverlap, Feature::kFace, 0, entry.t};
    }
    // The centre stands in only for a rim that is not met at all, so then the whole path is looked at.
    const bool tiny = radius_is_near_rounding(sweep, polygon);
    Contact best = cast_rim(sweep, polygon, tiny ? sweep.end : latest, counts);
    if (!best.touched() && facing != 0 && tiny) {
        best = cast_particle_polygon(sweep, polygon, facing);
        if (best.status == Status::kHit && view.approach > 0) {
            const double earlier = best.t - sweep.radius / view.approach;
            best.t = earlier < 0 ? 0 : earlier;
            if (best.t == 0) best.status = Status::kInitialOverlap;
        }
    }
    return best;
}

}  // namespace firma
