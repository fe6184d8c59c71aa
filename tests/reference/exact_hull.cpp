// SPDX-License-Identifier: MIT
// A particle against the sum of polygon and hull, in whole numbers.
#include "tests/reference/exact_hull.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace firma::reference {

ExactHullCast::ExactHullCast(std::span<const Vec3> corners, const Vec3& start, const Vec3& path,
                             std::span<const Vec3> polygon) {
    const auto widen = [&](const Vec3& v) {
        for (int axis = 0; axis < 3; ++axis) unit_ = std::max(unit_, -dyadic(v[axis]).exponent);
    };
    for (const Vec3& corner : corners) widen(corner);
    widen(start);
    widen(path);
    const auto whole = [&](const Vec3& v) {
        return IntegerVec{in_units(v.x, unit_), in_units(v.y, unit_), in_units(v.z, unit_)};
    };
    for (const Vec3& corner : corners) hull_.push_back(whole(corner));
    for (const Vec3& corner : polygon) polygon_.push_back(whole(corner));
    start_ = whole(start);
    path_ = whole(path);
    add_facets();
}

ExactHullCast::ExactHullCast(std::vector<IntegerVec> corners, const IntegerVec& start, const IntegerVec& path,
                             std::vector<IntegerVec> polygon, int unit)
    : unit_(unit), hull_(std::move(corners)), polygon_(std::move(polygon)), start_(start), path_(path) {
    add_facets();
}

void ExactHullCast::add_facets() {
    IntegerVec normal;
    for (std::size_t k = 2; k < polygon_.size(); ++k)
        normal = normal + cross(polygon_[k - 1] - polygon_[0], polygon_[k] - polygon_[0]);
    facing_ = dot(normal, path_);
    add(normal, true);
    for (std::size_t i = 0; i < hull_.size(); ++i)
        for (std::size_t j = i + 1; j < hull_.size(); ++j) {
            const IntegerVec g = hull_[j] - hull_[i];
            for (std::size_t k = j + 1; k < hull_.size(); ++k) add(cross(g, hull_[k] - hull_[i]), false);
            for (std::size_t k = 0; k < polygon_.size(); ++k)
                add(cross(polygon_[(k + 1) % polygon_.size()] - polygon_[k], g), false);
        }
}

void ExactHullCast::add(const IntegerVec& u, bool plane) {
    if (sign(dot(u, u)) == 0) return;
    Integer hull_low = dot(u, hull_[0]), hull_high = hull_low;
    for (const IntegerVec& o : hull_) {
        const Integer at = dot(u, o);
        if (at < hull_low) hull_low = at;
        if (at > hull_high) hull_high = at;
    }
    Integer low = dot(u, polygon_[0]), high = low;
    for (const IntegerVec& v : polygon_) {
        const Integer at = dot(u, v);
        if (at < low) low = at;
        if (at > high) high = at;
    }
    const Integer here = dot(u, start_), change = dot(u, path_);
    facets_.push_back({u, plane, here + hull_low - high, change});
    facets_.push_back({u * Integer(-1), plane, low - here - hull_high, -change});
}

Vec3 ExactHullCast::unit(const IntegerVec& u) const {
    const Integer most = std::max({Integer(abs(u.x)), Integer(abs(u.y)), Integer(abs(u.z))});
    const Vec3 v{nearest({u.x, most}), nearest({u.y, most}), nearest({u.z, most})};
    return v * (1 / length(v));
}

HullExpected ExactHullCast::expect(Sides sides) const {
    HullExpected expected;
    if (sign(dot(path_, path_)) == 0) return expected;
    if (sides == Sides::kFront && sign(facing_) >= 0) return expected;
    bool apart = false, inside = true, deeper = true;
    Ratio leaves{2, 1};
    for (const Facet& f : facets_) {
        const int now = sign(f.now), change = sign(f.change);
        if (now > 0) {
            if (change >= 0) return expected;
            const Ratio t{f.now, -f.change};
            if (!apart || compare(t, expected.at) > 0) expected.at = t;
            apart = true;
        } else {
            if (change > 0 && compare({-f.now, f.change}, leaves) < 0) leaves = {-f.now, f.change};
            if (now == 0) {
                inside = false;
                deeper = deeper && change < 0;
            }
        }
    }
    if (apart) {
        if (compare(expected.at, {1, 1}) > 0 || compare(expected.at, leaves) > 0) return expected;
        expected.status = Status::kHit;
        for (const Facet& f : facets_)
            if (sign(f.now) > 0 && compare({f.now, -f.change}, expected.at) == 0) expected.normals.push_back(unit(f.u));
        return expected;
    }
    if (!inside) {  // in touch
        if (!deeper) return expected;
        expected.status = Status::kInitialOverlap;
        for (const Facet& f : facets_)
            if (sign(f.now) == 0) expected.normals.push_back(unit(f.u));
        return expected;
    }
    return in_overlap();
}

bool ExactHullCast::overlaps() const {
    return std::all_of(facets_.begin(), facets_.end(), [](const Facet& f) { return sign(f.now) <= 0; });
}

HullExpected ExactHullCast::in_overlap() const {
    HullExpected expected;
    Ratio least{0, 0};
    for (const Facet& f : facets_) {
        const Ratio square_depth{square(f.now), dot(f.u, f.u)};
        if (sign(least.bottom) == 0 || compare(square_depth, least) < 0) least = square_depth;
    }
    const double depth = root_minus(least, 0, -unit_);
    bool by_plane = false, deeper = true;
    for (const Facet& f : facets_) {
        const Ratio square_depth{square(f.now), dot(f.u, f.u)};
        if (compare(square_depth, least) == 0) {
            deeper = deeper && sign(f.change) < 0;
            by_plane = by_plane || (f.plane && sign(f.change) < 0);
            expected.normals.push_back(unit(f.u));
        } else {
            expected.doubt = std::min(expected.doubt, root_minus(square_depth, 0, -unit_) - depth);
        }
    }
    if (deeper || by_plane) expected.status = Status::kInitialOverlap;
    return expected;
}

double ExactHullCast::gap_at(double fraction) const {
    const Dyadic t = dyadic(fraction);
    const int shift = std::max(0, -t.exponent);
    const Integer part = Integer(t.mantissa) << unsigned(t.exponent + shift);
    double largest = -INFINITY;
    for (const Facet& f : facets_) {
        const Integer value = (f.now << unsigned(shift)) + part * f.change;
        const double size = root_minus({square(value), dot(f.u, f.u)}, 0, -unit_ - shift);
        largest = std::max(largest, sign(value) < 0 ? -size : size);
    }
    return largest;
}

}  // namespace firma::reference
