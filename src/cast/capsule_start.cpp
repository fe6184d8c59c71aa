// SPDX-License-Identifier: MIT
// A capsule before it moves.
//
// Its segment shares a point with the polygon exactly when A lies in the sum of the polygon and all -y s, y in 0..1: a
// prism, unless s is parallel to the plane. Its facets are the polygon's plane, both ways, and e x s turned outward.
#include "cast/capsule_start.h"

#include <cmath>

#include "cast/cast_axis_side.h"
#include "cast/cast_sphere_face.h"
#include "cast/nearness.h"
#include "geometry/exact_predicates.h"
#include "geometry/rounding.h"

namespace firma {
namespace {

using Deep = DoubleDouble;

/// Nearest pairs gathered: the nearest, and the range of parts that are as near to rounding.
class NearestParts {
public:
    explicit NearestParts(double size) : noise_(rounding(256) * size) {}

    void offer(double distance, double part, NearestOnAxis::Kind kind, std::size_t index) {
        all_.at[count_] = {distance, part, kind, std::uint32_t(index)};
        if (count_++ == 0 || distance < best_.distance) best_ = all_.at[count_ - 1];
    }
    const NearestOnAxis& nearest() const { return best_; }
    double noise() const { return noise_; }
    /// Calls function(pair) for those as near as the nearest, to rounding.
    template <class Function>
    void each_nearest(const Function& function) const {
        for (std::size_t k = 0; k < count_; ++k)
            if (all_.at[k].distance <= best_.distance + noise_) function(all_.at[k]);
    }
    /// The least and the largest part as near as the nearest, to rounding.
    void range(double& low, double& high) const {
        low = high = best_.part;
        each_nearest([&](const NearestOnAxis& pair) {
            if (pair.part < low) low = pair.part;
            if (pair.part > high) high = pair.part;
        });
    }

private:
    /// Without the zeros that each begins with: there are many, and few are used.
    union Pairs {
        Pairs() {}
        NearestOnAxis at[2 + 2 * kMaxCorners];
    } all_;
    std::size_t count_ = 0;
    const double noise_;
    NearestOnAxis best_;
};

/// Where a side and the segment are nearest with their insides, if they are.
struct SideCrossing {
    bool inside = false;
    double distance = 0, part = 0;
};

template <class Real>
SideCrossing side_crossing(const VectorOf<Real>& w, const VectorOf<Real>& e, const VectorOf<Real>& s) {
    const VectorOf<Real> u = cross(e, s);
    const Real uu = dot(u, u), x = dot(w, cross(s, u)), y = -dot(w, cross(u, e));
    if (!(Real(0.0) < x && x < uu && Real(0.0) < y && y < uu)) return {};
    return {true, std::fabs(rounded(dot(u, w) / square_root(uu))), rounded(y / uu)};
}

/// In double-double where both are so nearly parallel that double would lose digits; as parallel they have none.
SideCrossing side_crossing(const Vec3& w, const Vec3& e, const Vec3& s) {
    const Vec3 u = cross(e, s);
    const double uu = dot(u, u), all = dot(e, e) * dot(s, s);
    if (!(uu > 0x1p-80 * all)) return {};
    if (uu < kShallow * all) return side_crossing(exactly<Deep>(w), exactly<Deep>(e), exactly<Deep>(s));
    return side_crossing(exactly<double>(w), exactly<double>(e), exactly<double>(s));
}

/// All pairs of features whose insides may hold the nearest points.
NearestParts nearest_pairs(const Vec3& a, const Vec3& s, const PolygonShape& polygon) {
    const Vec3 b = a + s;
    NearestParts parts(max_abs(a) + max_abs(b) + max_abs(polygon.corners.back() - polygon.corners[0]));
    parts.offer(closest_to(a, polygon).distance, 0, NearestOnAxis::kEndA, 0);
    parts.offer(closest_to(b, polygon).distance, 1, NearestOnAxis::kEndB, 0);
    const double ss = dot(s, s);
    for (std::size_t k = 0; k < polygon.corners.size(); ++k) {
        const Vec3 w = a - (polygon.corners[k] - polygon.corners[0]);
        const double along = -dot(w, s);
        if (along > 0 && along < ss) parts.offer(length(w + s * (along / ss)), along / ss, NearestOnAxis::kCorner, k);
        const SideCrossing side = side_crossing(w, polygon.corners[polygon.next(k)] - polygon.corners[k], s);
        if (side.inside) parts.offer(side.distance, side.part, NearestOnAxis::kSide, k);
    }
    return parts;
}

/// Decides exactly, from the sides of the plane that the ends are on, whether the segment meets the polygon. Not for a
/// segment within the plane.
bool axis_meets(const CapsuleSweep& capsule, const PolygonShape& polygon, int rise) {
    const SumVec<2> s = capsule.exact_s();
    const double size = length(capsule.s);
    for (std::size_t k = 0; k < polygon.corners.size(); ++k) {
        const Vec3 &v = polygon.corners[k], e = polygon.corners[polygon.next(k)] - v;
        const Vec3 w = capsule.a.start - v;
        const double estimate = dot(w, cross(e, capsule.s)), error = rounding(64) * size * length(w) * length(e);
        const int side = estimate > error    ? 1
                         : estimate < -error ? -1
                                             : exact_triple_sign(difference_as_sum(capsule.a.start, v), as_sum(e), s);
        if (rise * side > 0) return false;
    }
    return true;
}

/// Equal depths to rounding in double-double count as equal.
bool as_far_out(const Deep& a, const Deep& b) {
    const Deep rest = a - b;
    return std::fabs(rest.high) <= 64 * kDoubleDoubleRoundoff * (std::fabs(a.high) + std::fabs(b.high));
}

/// The facets of the prism, by how deep A is below each.
class AxisWaysOut {
public:
    void offer(const Deep& depth, bool against, bool plane, std::size_t side, const Vec3& way) {
        const bool equal = any_ && as_far_out(depth, least_);
        if (any_ && !equal && least_ < depth) return;
        if (!equal) {
            least_ = depth;
            deeper_ = true;
            by_plane_ = chosen_ = false;
        }
        any_ = true;
        deeper_ = deeper_ && against;
        const bool plane_decides = plane && against;
        if (!chosen_ || (plane_decides && !by_plane_)) {
            way_ = way;
            plane_ = plane;
            side_ = std::uint32_t(side);
        }
        by_plane_ = by_plane_ || plane_decides;
        chosen_ = true;
    }
    CapsuleStart answer() const {
        CapsuleStart start;
        start.pierces = true;
        if (!deeper_ && !by_plane_) {
            start.kind = StartContact::kIgnored;
            return start;
        }
        start.kind = StartContact::kInitialOverlap;
        start.contact = {Status::kInitialOverlap, plane_ ? Feature::kFace : Feature::kEdge, plane_ ? 0 : side_, 0};
        start.out = way_;
        start.plane = plane_;
        return start;
    }

private:
    Deep least_;
    bool any_ = false, deeper_ = true, by_plane_ = false, chosen_ = false, plane_ = true;
    std::uint32_t side_ = 0;
    Vec3 way_;
};

CapsuleStart start_in_polygon(const CapsuleSweep& capsule, const PolygonShape& polygon, int facing, int rise) {
    const VectorOf<Deep> n = precise_normal(polygon), s = capsule.precise_s();
    const Deep n_length = square_root(dot(n, n));
    const Deep one = dot(difference<Deep>(capsule.a.start, polygon.corners[0]), n) / n_length;
    const Deep other = dot(difference<Deep>(capsule.b.start, polygon.corners[0]), n) / n_length;
    const Deep lowest = one < other ? one : other, highest = one < other ? other : one;
    AxisWaysOut ways;
    const Vec3 unit = polygon.unit_normal();
    ways.offer(rise == 0 ? Deep() : -lowest, facing < 0, true, 0, unit);
    ways.offer(rise == 0 ? Deep() : highest, facing > 0, true, 0, -unit);
    for (std::size_t k = 0; k < polygon.corners.size() && rise != 0; ++k) {
        const Vec3 &v = polygon.corners[k], e = polygon.corners[polygon.next(k)] - v;
        const VectorOf<Deep> u = cross(exactly<Deep>(e), s) * Deep(double(rise));
        const Deep u_length = square_root(dot(u, u));
        if (!(u_length.high > 0)) continue;
        const bool touch = exact_triple_sign(difference_as_sum(capsule.a.start, v), as_sum(e), capsule.exact_s()) == 0;
        const Deep depth = touch ? Deep() : -dot(u, difference<Deep>(capsule.a.start, v)) / u_length;
        const bool against = rise * exact_triple_sign(as_sum(capsule.direction()), as_sum(e), capsule.exact_s()) < 0;
        ways.offer(depth, against, false, k,
                   {rounded(u.x / u_length), rounded(u.y / u_length), rounded(u.z / u_length)});
    }
    return ways.answer();
}

/// A pair in double-double: the square of its distance, and what that says.
struct PreciseNearness {
    Deep square;
    Nearness near;
};

PreciseNearness precise_nearness(const CapsuleSweep& capsule, const PolygonShape& polygon, int facing,
                                 const NearestOnAxis& pair) {
    const Vec3& d = capsule.direction();
    const double r = capsule.radius();
    const VectorOf<Deep> s = capsule.precise_s(), way = exactly<Deep>(d);
    if (pair.kind == NearestOnAxis::kEndA || pair.kind == NearestOnAxis::kEndB) {
        const Vec3& end = pair.kind == NearestOnAxis::kEndA ? capsule.a.start : capsule.b.start;
        const Closest closest = closest_to(end - polygon.corners[0], polygon);
        const Vec3 &v = polygon.corners[closest.index], &next = polygon.corners[polygon.next(closest.index)];
        const VectorOf<Deep> w = difference<Deep>(end, v);
        Deep square = dot(w, w);
        if (closest.feature == Feature::kEdge) {
            const VectorOf<Deep> e = difference<Deep>(next, v), m = cross(w, e);
            square = dot(m, m) / dot(e, e);
        } else if (closest.feature == Feature::kFace) {
            const VectorOf<Deep> n = precise_normal(polygon);
            const Deep height = dot(w, n);
            square = height * height / dot(n, n);
        }
        return {square, nearness(end, r, d, facing, polygon, closest)};
    }
    const Vec3& v = polygon.corners[pair.index];
    const VectorOf<Deep> w = difference<Deep>(capsule.a.start, v);
    if (pair.kind == NearestOnAxis::kCorner) {
        const VectorOf<Deep> m = cross(w, s);
        return {dot(m, m) / dot(s, s), near_line(w, s, way, r)};
    }
    const VectorOf<Deep> u = cross(difference<Deep>(polygon.corners[polygon.next(pair.index)], v), s);
    const Deep height = dot(u, w), uu = dot(u, u);
    return {height * height / uu, near_plane(height, dot(u, way), uu, r)};
}

/// Of the nearest pairs the nearest.
Nearness least_nearness(const CapsuleSweep& capsule, const PolygonShape& polygon, int facing,
                        const NearestParts& pairs) {
    PreciseNearness least;
    bool any = false;
    pairs.each_nearest([&](const NearestOnAxis& pair) {
        const PreciseNearness here = precise_nearness(capsule, polygon, facing, pair);
        if (any && !(here.square < least.square)) return;
        least = here;
        any = true;
    });
    return least.near;
}

/// Sides of the plane that the ends are on, exactly.
struct AxisSides {
    int one, other, rise;

    AxisSides(const CapsuleSweep& capsule, const PolygonShape& polygon)
        : one(exact_plane_side(capsule.a.start, polygon)), other(exact_plane_side(capsule.b.start, polygon)) {
        rise = other > one ? 1 : other < one ? -1 : 0;
    }
    /// Whether the segment, if it is not within the plane, shares a point with the polygon.
    bool pierce(const CapsuleSweep& capsule, const PolygonShape& polygon) const {
        return rise != 0 && one * other <= 0 && axis_meets(capsule, polygon, rise);
    }
};

/// The shortest way out of the sum for a segment that meets the polygon and is not within its plane.
void shortest_of_axis(const CapsuleSweep& capsule, const PolygonShape& polygon, int rise, WayOut& out) {
    const VectorOf<Deep> n = precise_normal(polygon), s = capsule.precise_s();
    const Deep n_length = square_root(dot(n, n));
    const Deep one = dot(difference<Deep>(capsule.a.start, polygon.corners[0]), n) / n_length;
    const Deep other = dot(difference<Deep>(capsule.b.start, polygon.corners[0]), n) / n_length;
    Deep least = one < other ? -one : -other;
    out.direction = polygon.unit_normal();
    const auto offer = [&](const Deep& depth, const Vec3& way) {
        if (!(depth < least) || as_far_out(depth, least)) return;
        least = depth;
        out.direction = way;
    };
    offer(one < other ? other : one, -polygon.unit_normal());
    for (std::size_t k = 0; k < polygon.corners.size(); ++k) {
        const Vec3 &v = polygon.corners[k], e = polygon.corners[polygon.next(k)] - v;
        const VectorOf<Deep> u = cross(exactly<Deep>(e), s) * Deep(double(rise));
        const Deep u_length = square_root(dot(u, u));
        if (!(u_length.high > 0)) continue;
        offer(-dot(u, difference<Deep>(capsule.a.start, v)) / u_length,
              {rounded(u.x / u_length), rounded(u.y / u_length), rounded(u.z / u_length)});
    }
    out.depth = capsule.radius() + rounded(least);
}

}  // namespace

NearestOnAxis nearest_on_axis(const Vec3& a, const Vec3& s, const PolygonShape& polygon) {
    const NearestParts parts = nearest_pairs(a, s, polygon);
    NearestOnAxis found = parts.nearest();
    const double over_a = dot(a, polygon.normal), over_b = dot(a + s, polygon.normal);
    if (over_a * over_b < 0) {
        const double through = over_a / (over_a - over_b);
        if (closest_to(a + s * through, polygon).distance <= parts.noise()) {
            found.distance = 0;
            found.part = through;
            return found;
        }
    }
    double low = 0, high = 0;
    parts.range(low, high);
    if (low == high) return found;
    // All of them are nearest when the way to the polygon is the same.
    const Closest one = closest_to(a + s * low, polygon), other = closest_to(a + s * high, polygon);
    if (max_abs(one.away - other.away) <= parts.noise()) found.part = low + (high - low) / 2;
    return found;
}

CapsuleStart capsule_start(const CapsuleSweep& capsule, const PolygonShape& polygon, int facing) {
    const Vec3 a = capsule.a.start - polygon.corners[0];
    const AxisSides ends(capsule, polygon);
    if (ends.pierce(capsule, polygon)) return start_in_polygon(capsule, polygon, facing, ends.rise);
    const NearestParts pairs = nearest_pairs(a, capsule.s, polygon);
    if (pairs.nearest().distance - pairs.noise() > capsule.radius()) return {};
    const Nearness near = least_nearness(capsule, polygon, facing, pairs);
    if (!near.within) return {};
    if (near.on_it) return start_in_polygon(capsule, polygon, facing, 0);
    CapsuleStart start;
    start.kind = near.change < 0 ? StartContact::kInitialOverlap : StartContact::kIgnored;
    if (near.change < 0) start.contact = {Status::kInitialOverlap, Feature::kFace, 0, 0};
    return start;
}

bool capsule_meets(const CapsuleSweep& capsule, const PolygonShape& polygon) {
    if (AxisSides(capsule, polygon).pierce(capsule, polygon)) return true;
    const NearestParts pairs = nearest_pairs(capsule.a.start - polygon.corners[0], capsule.s, polygon);
    if (pairs.nearest().distance - pairs.noise() > capsule.radius()) return false;
    if (pairs.nearest().distance + pairs.noise() < capsule.radius()) return true;
    return least_nearness(capsule, polygon, 0, pairs).within;
}

WayOut way_out_of_capsule(const CapsuleSweep& capsule, const PolygonShape& polygon, bool along_normal) {
    const Vec3 a = capsule.a.start - polygon.corners[0], unit = polygon.unit_normal();
    const NearestOnAxis nearest = nearest_on_axis(a, capsule.s, polygon);
    WayOut out;
    out.closest = closest_to(a + capsule.s * nearest.part, polygon);
    const double one = dot(a, unit), other = dot(a + capsule.s, unit), low = one < other ? one : other;
    const double noise = rounding(64) * (max_abs(a) + max_abs(capsule.s));
    const AxisSides ends(capsule, polygon);
    if (ends.pierce(capsule, polygon)) out.closest.distance = 0;
    if (along_normal) {
        out.direction = unit;
        out.depth = capsule.radius() - low;
    } else if (out.closest.distance > noise) {
        out.direction = out.closest.away * (1 / out.closest.distance);
        out.depth = capsule.radius() - out.closest.distance;
    } else if (ends.rise != 0) {
        shortest_of_axis(capsule, polygon, ends.rise, out);
    } else {  // both ends on one side, or on the plane
        out.direction = ends.one < 0 ? -unit : unit;
        out.depth = capsule.radius() - (ends.one < 0 ? -(one < other ? other : one) : low);
    }
    if (!(out.depth > 0)) out.depth = 0;
    return out;
}

}  // namespace firma
