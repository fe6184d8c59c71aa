// SPDX-License-Identifier: MIT
// One polygon and one moving sphere, exactly.
#include "tests/reference/exact_polygon.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "firma/grid.h"

namespace firma::reference {

namespace {

constexpr int kGridBits = 18;  // steps of 2^-18 m

IntegerVec whole_units(const Vec3& v, int unit) {
    return {in_units(v.x, unit), in_units(v.y, unit), in_units(v.z, unit)};
}

Vec3 nearest_vec(const IntegerVec& v, const Integer& bottom, int exponent) {
    return {nearest({v.x, bottom}, exponent), nearest({v.y, bottom}, exponent), nearest({v.z, bottom}, exponent)};
}

/// The unit vector along v, or zero.
Vec3 direction(const IntegerVec& v) {
    const Integer largest_of = std::max({Integer(abs(v.x)), Integer(abs(v.y)), Integer(abs(v.z))});
    if (sign(largest_of) == 0) return {};
    const Vec3 near = nearest_vec(v, largest_of, 0);
    return near * (1 / length(near));
}

}  // namespace

ExactCast::ExactCast(const Sphere& sphere, const Vec3& motion) {
    unit = kGridBits;
    for (const double x :
         {sphere.centre.x, sphere.centre.y, sphere.centre.z, motion.x, motion.y, motion.z, sphere.radius}) {
        if (x != 0) unit = std::max(unit, -dyadic(x).exponent);
    }
    start = whole_units(sphere.centre, unit);
    path = whole_units(motion, unit);
    radius = in_units(sphere.radius, unit);
}

ExactPolygon::ExactPolygon(std::span<const Vec3> points)
    : ExactPolygon(
          [&] {
              std::vector<IntegerVec> whole;
              for (const Vec3& p : points) whole.push_back(whole_units(p, kGridBits));
              return whole;
          }(),
          kGridBits) {}

ExactPolygon::ExactPolygon(std::vector<IntegerVec> whole, int steps) : corners(std::move(whole)), unit(steps) {
    normal = {0, 0, 0};
    for (std::size_t k = 1; k + 1 < corners.size(); ++k)
        normal = normal + cross(corners[k] - corners[0], corners[k + 1] - corners[0]);
    normal_square = dot(normal, normal);
    for (std::size_t k = 0; k < corners.size(); ++k) {
        edges.push_back(corners[(k + 1) % corners.size()] - corners[k]);
        edge_squares.push_back(dot(edges[k], edges[k]));
        outward.push_back(cross(edges[k], normal));
    }
}

SeenPolygon::SeenPolygon(const ExactPolygon& polygon, const ExactCast& cast) : polygon_(polygon), cast_(cast) {
    const auto shift = unsigned(cast.unit - polygon.unit);
    for (const IntegerVec& v : polygon.corners)
        from_corner_.push_back(
            {cast.start.x - (v.x << shift), cast.start.y - (v.y << shift), cast.start.z - (v.z << shift)});
    path_square_ = dot(cast.path, cast.path);
    path_normal_ = dot(cast.path, polygon.normal);
    for (const IntegerVec& e : polygon.edges) path_edge_.push_back(dot(cast.path, e));
}

/// Where in [0, 1] some linear inequalities and at last one quadratic hold.
class SeenPolygon::Interval {
public:
    /// Keeps the t with c + t b <= 0.
    void keep(const Integer& c, const Integer& b) {
        if (sign(b) == 0) {
            empty_ = empty_ || sign(c) > 0;
        } else if (sign(b) > 0) {
            const Ratio bound{-c, b};
            if (compare(bound, high_) < 0) high_ = bound;
        } else {
            const Ratio bound{c, -b};
            if (compare(bound, low_) > 0) low_ = bound;
        }
    }
    bool empty() const { return empty_ || compare(low_, high_) > 0; }

    /// The least t that is left at which the convex quadratic is not above zero.
    std::optional<Root> first(const Quadratic& q) const {
        if (value(q, low_) <= 0) return Root{low_.top, 0, low_.bottom};
        if (sign(q.a) <= 0) return {};  // constant, and above
        const Integer discriminant = square(q.b) - q.a * q.c;
        if (sign(discriminant) < 0) return {};
        const Ratio lowest{-q.b, q.a};
        if (compare(lowest, low_) <= 0) return {};
        if (compare(lowest, high_) > 0 && value(q, high_) > 0) return {};
        return Root{-q.b, discriminant, q.a};
    }

private:
    static int value(const Quadratic& q, const Ratio& t) {
        return sign(q.a * square(t.top) + 2 * q.b * t.top * t.bottom + q.c * square(t.bottom));
    }
    Ratio low_{0, 1}, high_{1, 1};
    bool empty_ = false;
};

SeenPolygon::Quadratic SeenPolygon::of_ball(std::size_t k) const {
    const IntegerVec& a = from_corner_[k];
    return {path_square_, dot(a, cast_.path), dot(a, a) - square(cast_.radius)};
}

SeenPolygon::Quadratic SeenPolygon::of_cylinder(std::size_t k) const {
    const IntegerVec& a = from_corner_[k];
    const Integer &ee = polygon_.edge_squares[k], &de = path_edge_[k], ae = dot(a, polygon_.edges[k]);
    return {ee * path_square_ - square(de), ee * dot(a, cast_.path) - ae * de,
            ee * (dot(a, a) - square(cast_.radius)) - square(ae)};
}

SeenPolygon::Quadratic SeenPolygon::of_prism() const {
    const Integer an = dot(from_corner_[0], polygon_.normal);
    return {square(path_normal_), an * path_normal_, square(an) - square(cast_.radius) * polygon_.normal_square};
}

std::optional<Touch> SeenPolygon::first_touch() const {
    std::optional<Touch> first;
    const auto offer = [&](const Interval& interval, const Quadratic& q, Feature feature, std::size_t index) {
        const std::optional<Root> at = interval.first(q);
        if (at && (!first || compare(*at, first->at) < 0)) first = Touch{*at, feature, std::uint32_t(index)};
    };
    const std::size_t count = polygon_.corners.size();
    for (std::size_t k = 0; k < count; ++k) offer(Interval(), of_ball(k), Feature::kVertex, k);
    for (std::size_t k = 0; k < count; ++k) {
        const IntegerVec& e = polygon_.edges[k];
        Interval slab;
        slab.keep(-dot(from_corner_[k], e), -path_edge_[k]);
        slab.keep(dot(from_corner_[(k + 1) % count], e), path_edge_[k]);
        if (!slab.empty()) offer(slab, of_cylinder(k), Feature::kEdge, k);
    }
    Interval prism;
    for (std::size_t k = 0; k < count; ++k)
        prism.keep(dot(from_corner_[k], polygon_.outward[k]), dot(cast_.path, polygon_.outward[k]));
    if (!prism.empty()) offer(prism, of_prism(), Feature::kFace, 0);
    return first;
}

bool SeenPolygon::inside(const std::vector<IntegerVec>& from_corner) const {
    for (std::size_t k = 0; k < from_corner.size(); ++k)
        if (sign(dot(from_corner[k], polygon_.outward[k])) > 0) return false;
    return true;
}

Nearest SeenPolygon::nearest_at(const Ratio& t) const {
    const Integer& w = t.bottom;
    const IntegerVec moved = cast_.path * t.top;
    std::vector<IntegerVec> from;  // w (c - v_k)
    for (const IntegerVec& a : from_corner_) from.push_back(a * w + moved);

    Nearest found;
    IntegerVec away;  // (centre - point) * w * scale
    Integer scale = 1;
    Ratio best{-1, 1};  // of distance^2 w^2
    const auto offer = [&](const Ratio& square_of, Feature feature, std::size_t index) {
        if (sign(best.top) >= 0 && compare(square_of, best) >= 0) return false;
        best = square_of;
        found.feature = feature;
        found.index = std::uint32_t(index);
        return true;
    };
    const std::size_t count = from.size();
    for (std::size_t k = 0; k < count; ++k) {
        if (offer({dot(from[k], from[k]), 1}, Feature::kVertex, k)) away = from[k];
    }
    for (std::size_t k = 0; k < count; ++k) {
        const IntegerVec& e = polygon_.edges[k];
        const Integer along = dot(from[k], e);
        const Integer& ee = polygon_.edge_squares[k];
        if (sign(along) <= 0 || sign(dot(from[(k + 1) % count], e)) >= 0) continue;
        if (offer({dot(from[k], from[k]) * ee - square(along), ee}, Feature::kEdge, k)) {
            away = from[k] * ee - e * along;
            scale = ee;
        }
    }
    if (inside(from)) {
        const Integer height = dot(from[0], polygon_.normal);
        if (offer({square(height), polygon_.normal_square}, Feature::kFace, 0)) {
            away = polygon_.normal * height;
            scale = polygon_.normal_square;
        }
    }
    const IntegerVec centre = cast_.start * w + moved;
    found.centre = nearest_vec(centre, w, -cast_.unit);
    found.point = nearest_vec(centre * scale - away, w * scale, -cast_.unit);
    found.direction = direction(away);
    found.square = {best.top, best.bottom * square(w)};
    found.distance = root_minus(found.square, 0, -cast_.unit);
    found.gap = root_minus(found.square, cast_.radius, -cast_.unit);
    found.closing = sign(dot(cast_.path, away));
    return found;
}

Nearest SeenPolygon::nearest_at(const Root& t) const {
    const Integer scale = Integer(1) << 256;
    return nearest_at(Ratio{t.floor_times(scale), scale});
}

bool SeenPolygon::passes_through() const {
    if (sign(path_normal_) == 0) return false;
    Ratio t{-dot(from_corner_[0], polygon_.normal), path_normal_};
    if (sign(t.bottom) < 0) t = {-t.top, -t.bottom};
    if (sign(t.top) < 0 || t.top > t.bottom) return false;
    std::vector<IntegerVec> from;
    for (const IntegerVec& a : from_corner_) from.push_back(a * t.bottom + cast_.path * t.top);
    return inside(from);
}

// The pair of nearest points has an end of the path, a corner with the path's inside, or two insides of edge and path.
Ratio SeenPolygon::rim_square() const {
    const std::size_t count = polygon_.corners.size();
    std::optional<Ratio> least;
    const auto offer = [&](const Ratio& square_of) {
        if (!least || compare(square_of, *least) < 0) least = square_of;
    };
    const Integer to_units = Integer(1) << unsigned(cast_.unit - polygon_.unit);  // of a step
    for (std::size_t k = 0; k < count; ++k) {
        const IntegerVec &a = from_corner_[k], &e = polygon_.edges[k];
        const Integer &ee = polygon_.edge_squares[k], ad = dot(a, cast_.path);
        for (const IntegerVec& end : {a, a + cast_.path}) {
            offer({dot(end, end), 1});
            const Integer along = dot(end, e);
            if (sign(along) > 0 && along < ee * to_units) offer({dot(end, end) * ee - square(along), ee});
        }
        if (sign(ad) < 0 && -ad < path_square_) offer({dot(a, a) * path_square_ - square(ad), path_square_});
        const Quadratic q = of_cylinder(k);  // least at t = -b / a
        if (sign(q.a) <= 0 || sign(q.b) >= 0 || -q.b >= q.a) continue;
        const Integer along = dot(a, e) * q.a - q.b * path_edge_[k];  // times q.a
        if (sign(along) < 0 || along > ee * to_units * q.a) continue;
        const IntegerVec across = cross(e, cast_.path);
        offer({square(dot(a, across)), dot(across, across)});
    }
    return *least;
}

double SeenPolygon::margin() const {
    const Nearest start = nearest_at(Ratio{0, 1}), finish = nearest_at(Ratio{1, 1});
    if (start.on_polygon()) return 0;
    const double overlap = std::min(start.gap, 0.0), radius = nearest({cast_.radius, 1}, -cast_.unit);
    const Ratio rim = rim_square();
    if (passes_through()) {
        if (start.gap < 0) return start.distance;
        return radius + std::min(finish.distance, root_minus(rim, 0, -cast_.unit));
    }
    const double gap = root_minus(rim, cast_.radius, -cast_.unit);
    return overlap - std::min({start.gap, finish.gap, gap});
}

}  // namespace firma::reference
