// SPDX-License-Identifier: MIT
// A ball against the surface of the sum of polygon and segment.
#include "tests/reference/exact_capsule.h"

#include <algorithm>
#include <cmath>

namespace firma::reference {
namespace {

void make_finer(ExactCast& cast, int unit) {
    const Integer scale = Integer(1) << unsigned(unit - cast.unit);
    cast.start = cast.start * scale;
    cast.path = cast.path * scale;
    cast.radius = cast.radius * scale;
    cast.unit = unit;
}

}  // namespace

ExactCapsuleCast::ExactCapsuleCast(const Capsule& capsule, const Vec3& path, std::span<const Vec3> polygon)
    : a_({capsule.from, capsule.radius}, path), b_({capsule.to, capsule.radius}, path) {
    const int unit = std::max(a_.unit, b_.unit);
    make_finer(a_, unit);
    make_finer(b_, unit);
    for (const Vec3& v : polygon) corners_.push_back({in_units(v.x, unit), in_units(v.y, unit), in_units(v.z, unit)});
    polygons_.emplace_back(polygon);
    pieces_ = {{0, false}, {0, true}};
    const IntegerVec s = b_.start - a_.start;
    for (std::size_t k = 0; k < corners_.size(); ++k) {
        const IntegerVec &v = corners_[k], &next = corners_[(k + 1) % corners_.size()];
        const IntegerVec u = cross(next - v, s);
        if (sign(dot(u, u)) == 0) continue;
        pieces_.push_back({polygons_.size(), false});
        polygons_.emplace_back(std::vector<IntegerVec>{v, next, next - s, v - s}, unit);
    }
}

SeenPolygon ExactCapsuleCast::seen(const Piece& piece) const {
    return SeenPolygon(polygons_[piece.polygon], piece.of_b ? b_ : a_);
}

Nearest ExactCapsuleCast::nearest_at(const Ratio& t) const {
    std::optional<Nearest> nearest;
    for (const Piece& piece : pieces_) {
        const Nearest here = seen(piece).nearest_at(t);
        if (!nearest || compare(here.square, nearest->square) < 0) nearest = here;
    }
    return *nearest;
}

CapsuleExpected ExactCapsuleCast::expect(Sides sides) const {
    CapsuleExpected expected;
    if (!a_.moves()) return expected;
    if (sides == Sides::kFront && SeenPolygon(polygons_[0], a_).facing() >= 0) return expected;
    const IntegerVec s = b_.start - a_.start;
    const Nearest start = nearest_at(Ratio{0, 1});
    const bool flat = sign(dot(s, polygons_[0].normal)) == 0;
    const ExactHullCast axis({IntegerVec{0, 0, 0}, s}, a_.start, a_.path, corners_, a_.unit);
    if (flat ? start.on_polygon() : axis.overlaps()) {
        expected.segment_meets = true;
        if (flat) {  // both ways along the normal are as near
            const int facing = SeenPolygon(polygons_[0], a_).facing();
            if (facing != 0) expected.status = Status::kInitialOverlap;
            return expected;
        }
        const HullExpected out = axis.in_overlap();
        expected.status = out.status;
        expected.doubt = out.doubt;
        expected.ways = out.normals;
        return expected;
    }
    if (compare(start.square, {square(a_.radius), 1}) <= 0) {
        if (start.closing < 0) expected.status = Status::kInitialOverlap;
        return expected;
    }
    for (const Piece& piece : pieces_) {
        const std::optional<Touch> touch = seen(piece).first_touch();
        if (!touch) continue;
        if (expected.status == Status::kMiss || compare(touch->at, expected.at) < 0) expected.at = touch->at;
        expected.status = Status::kHit;
    }
    return expected;
}

double ExactCapsuleCast::gap_at(double fraction) const {
    const Dyadic t = dyadic(fraction);
    return nearest_at(Ratio{Integer(t.mantissa), Integer(1) << unsigned(std::max(0, -t.exponent))}).gap;
}

Vec3 ExactCapsuleCast::away_at(double fraction) const {
    const Dyadic t = dyadic(fraction);
    return nearest_at(Ratio{Integer(t.mantissa), Integer(1) << unsigned(std::max(0, -t.exponent))}).direction;
}

double ExactCapsuleCast::margin() const {
    double deepest = -INFINITY;
    for (const Piece& piece : pieces_) deepest = std::max(deepest, seen(piece).margin());
    return deepest;
}

}  // namespace firma::reference
