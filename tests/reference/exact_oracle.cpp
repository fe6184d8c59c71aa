// SPDX-License-Identifier: MIT
// The oracle: every face, exactly, and the earliest.
#include "tests/reference/exact_oracle.h"

#include <algorithm>

namespace firma::reference {

ExactOracle::ExactOracle(const std::vector<std::vector<Vec3>>& polygons, const std::vector<bool>& two_sided) {
    faces_.reserve(polygons.size());
    for (std::size_t f = 0; f < polygons.size(); ++f)
        faces_.push_back({ExactPolygon(polygons[f]), Hull(polygons[f]), f < two_sided.size() && two_sided[f]});
}

bool is_valid(const Cast& cast) {
    const double most = std::max({max_abs(cast.sphere.centre), max_abs(cast.path), cast.sphere.radius});
    return is_finite(cast.sphere.centre) && is_finite(cast.path) && most <= 0x1p200 && cast.sphere.radius >= 0;
}

bool ExactOracle::considers(const Cast& cast, std::uint32_t face, const SeenPolygon& seen) const {
    return cast.sides == Sides::kBoth || faces_[face].two_sided || seen.facing() < 0;
}

namespace {

/// Surely path . normal > 0, though computed in double.
bool surely_from_behind(const Hull& hull, const Vec3& path) {
    if (max_abs(path) < 1e-200) return false;  // products below would lose their digits
    const Vec3 n = cross(hull.corners[1] - hull.corners[0], hull.corners[2] - hull.corners[0]);
    const double sizes = (std::fabs(n.x) + std::fabs(n.y) + std::fabs(n.z)) * max_abs(path);
    const double extent =
        std::max(max_abs(hull.corners[1] - hull.corners[0]), max_abs(hull.corners[2] - hull.corners[0]));
    return dot(n, path) > (sizes + extent * extent * max_abs(path)) * 0x1p-40;
}

/// A fraction not below the root, and little above.
double just_above(const Root& at) {
    const double near = nearest({at.floor_times(Integer(1) << 256) + 1, 1}, -256);
    return std::min(1.0, near * (1 + 0x1p-48));
}

struct Met {
    Meeting meeting = Meeting::kNot;
    Touch touch;
};

Met meet(const SeenPolygon& seen) {
    const std::optional<Touch> touch = seen.first_touch();
    if (!touch) return {};
    if (!touch->at.is_zero()) return {Meeting::kHit, *touch};
    const Nearest start = seen.nearest_at(Ratio{0, 1});
    const bool closer = start.on_polygon() ? seen.facing() != 0 : start.closing < 0;
    return {closer ? Meeting::kInitialOverlap : Meeting::kIgnored, {Root(), start.feature, start.index}};
}

}  // namespace

Expected ExactOracle::expect_among(const Cast& cast, std::uint32_t first, std::uint32_t last) const {
    Expected expected;
    if (!is_valid(cast)) {
        expected.status = Status::kInvalid;
        return expected;
    }
    const ExactCast exact(cast.sphere, cast.path);
    if (!exact.moves()) return expected;
    double end = 1;
    for (std::uint32_t f = first; f < last; ++f) {
        const Face& face = faces_[f];
        const bool both = cast.sides == Sides::kBoth || face.two_sided;
        if (!both && surely_from_behind(face.hull, cast.path)) continue;
        if (surely_apart(face.hull, cast.sphere.centre, cast.path, end, cast.sphere.radius)) continue;
        const SeenPolygon seen(face.exact, exact);
        if (!considers(cast, f, seen)) continue;
        const Met met = meet(seen);
        if (met.meeting != Meeting::kHit && met.meeting != Meeting::kInitialOverlap) continue;
        const int order = expected.touched() ? compare(met.touch.at, expected.at) : -1;
        if (order < 0) {
            expected = {met.meeting == Meeting::kHit ? Status::kHit : Status::kInitialOverlap,
                        met.touch.at,
                        {f},
                        met.touch.feature,
                        met.touch.index};
            end = just_above(expected.at);
        } else if (order == 0) {
            expected.faces.push_back(f);
        }
    }
    return expected;
}

Expected ExactOracle::expect(const Cast& cast) const {
    return expect_among(cast, 0, std::uint32_t(faces_.size()));
}

Expected ExactOracle::expect(const Cast& cast, std::uint32_t face) const {
    return expect_among(cast, face, face + 1);
}

bool ExactOracle::overlaps(const Sphere& sphere, std::uint32_t face) const {
    const ExactCast exact(sphere, {});
    const Ratio distance_square = SeenPolygon(faces_[face].exact, exact).nearest_at(Ratio{0, 1}).square;
    return compare(distance_square, {square(exact.radius), 1}) <= 0;
}

}  // namespace firma::reference
