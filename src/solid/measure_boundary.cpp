// SPDX-License-Identifier: MIT
// Each face with the apex o makes a cone. Letters: n . p + d = 0 is the face's plane about o, k its dominant axis, S
// twice the face's area as seen along k, counter-clockwise about +k. As its area vector is parallel to n, twice that is
// n S / n[k]: six times the cone's volume is p . n S / n[k] = -d S / n[k], twice the area |n| S / n[k].
// So only two coordinates of each vertex matter, and only S is a sum of quotients.
#include "solid/measure_boundary.h"

#include "geometry/flat_loop.h"
#include "geometry/mesh_shells.h"
#include "geometry/polygon_shape.h"

namespace firma {
namespace {

struct Flat {
    DoubleDouble u, v;
};

/// (numerator - origin * w) / w: the difference has 186 bits.
DoubleDouble coordinate(const Int256& numerator, const Int256& w, std::int32_t origin) {
    return to_double_double(numerator - w * std::int64_t(origin)) / to_double_double(w);
}

/// A vertex as seen along an axis, about the apex.
Flat flat_vertex(const ExactPoint& point, int axis, const InputPoint& apex) {
    const int a = FlatView{axis}.u(), b = FlatView{axis}.v();
    if (point.on_grid())
        return {double(std::int64_t(point.grid()[a]) - apex[a]), double(std::int64_t(point.grid()[b]) - apex[b])};
    const Meet m = meet(*point.plane(0), *point.plane(1), *point.plane(2));
    const Int256* const numerator[3] = {&m.x, &m.y, &m.z};
    return {coordinate(*numerator[a], m.w, apex[a]), coordinate(*numerator[b], m.w, apex[b])};
}

/// S.
DoubleDouble twice_seen_area(const SolidPatch& patch, const PatchFace& face, int axis, const InputPoint& apex) {
    const auto uses = patch.uses(face);
    const auto corner = [&](std::uint32_t k) {
        return flat_vertex(patch.vertices[patch.from(uses[k])].point, axis, apex);
    };
    DoubleDouble sum;
    std::uint32_t first = 0;
    for (const std::uint32_t end : patch.ends(face)) {
        add_twice_area(first, end, corner, sum);
        first = end;
    }
    return sum;
}

Int128 six_times_cone(const FacetPlace& facet, const GridPoint& apex) {
    const FaceRecord& record = facet.record();
    GridPoint corners[kMaxCorners];
    for (std::size_t k = 0; k < record.corner_count; ++k) corners[k] = facet.block->corner(record, k);
    return six_times_cone({corners, record.corner_count}, apex);
}

}  // namespace

InputPoint middle_of(const GridBox& box) {
    InputPoint middle;
    for (int axis = 0; axis < 3; ++axis)
        middle[axis] = std::int32_t((std::int64_t(box.low[axis]) + box.high[axis]) / 2 / kSurfacePerInput);
    return middle;
}

DoubleDouble to_double_double(const Int256& value) {
    const bool negative = value.sign() < 0;
    const Int256 magnitude = negative ? -value : value;
    DoubleDouble sum;
    double scale = 0x1p224;
    int k = 3;
    for (; k > 0 && magnitude.word[k] == 0; --k) scale *= 0x1p-64;
    for (; k >= 0; --k)
        for (const std::uint64_t half : {magnitude.word[k] >> 32, magnitude.word[k] & 0xFFFFFFFFu}) {
            sum = sum + DoubleDouble(double(half) * scale);
            scale *= 0x1p-32;
        }
    return negative ? -sum : sum;
}

BoundaryMeasures measure_boundary(const Boundary& boundary) {
    const SolidPatch& patch = boundary.patch;
    BoundaryMeasures sums{};
    if (patch.faces.empty()) return sums;
    GridBox box;
    for (const PatchFace& face : patch.faces) box.add(face.box);
    const InputPoint apex = middle_of(box);
    for (const PatchFace& face : patch.faces) {
        const Plane& plane = face.plane->plane;
        if (!plane.valid()) continue;
        const int axis = plane.dominant_axis();
        const DoubleDouble ratio = twice_seen_area(patch, face, axis, apex) / DoubleDouble(double(plane.normal[axis]));
        Int256 offset = plane.offset(), square;
        for (int k = 0; k < 3; ++k) {
            offset = offset + product(plane.normal[k], apex[k]);
            square = square + product(plane.normal[k], plane.normal[k]);
        }
        sums.volume = sums.volume - to_double_double(offset) * ratio;
        sums.area = sums.area + square_root(to_double_double(square)) * ratio;
    }
    sums.volume = sums.volume / DoubleDouble(6);
    sums.area = sums.area * DoubleDouble(0.5);
    const GridPoint about = to_surface(apex);
    for (const FacetPlace& facet : boundary.facets) sums.facet_sixths += six_times_cone(facet, about);
    return sums;
}

}  // namespace firma
