// SPDX-License-Identifier: MIT
// Where a point must lie after a level's cuts.
#include "tests/reference/cut_history.h"

#include <algorithm>
#include <cmath>

#include "tests/reference/carve_oracle.h"
#include "tests/reference/facet_corners.h"
#include "tests/reference/world_facets.h"
#include "world/world_data.h"

namespace firma::reference {
namespace {

constexpr double kClear = 2e-5;  ///< metres

bool in_box(const Box& box, const Vec3& p) {
    for (int axis = 0; axis < 3; ++axis)
        if (p[axis] < box.low[axis] - kClear || p[axis] > box.high[axis] + kClear) return false;
    return true;
}

}  // namespace

std::vector<Triangle> triangles_of(const World& world) {
    std::vector<Triangle> triangles;
    for (const FacetPlace& place : all_facets(world)) {
        if (!place.record().solid) continue;
        const auto corners = grid_corners_of(place);
        const auto at = [&](std::size_t k) { return to_metres(corners[k]); };
        for (std::size_t k = 2; k < corners.size(); ++k) triangles.push_back({at(0), at(k - 1), at(k)});
    }
    return triangles;
}

std::vector<Triangle> triangles_of(const PlacedCutter& cutter) {
    std::vector<Triangle> triangles;
    const auto at = [&](std::uint32_t v) { return to_metres(to_surface(cutter.vertices[v])); };
    for (const auto& [a, b, c] : cutter.triangles) triangles.push_back({at(a), at(b), at(c)});
    return triangles;
}

double winding(std::span<const Triangle> surface, const Vec3& point) {
    double sum = 0;
    for (const Triangle& triangle : surface) sum += winding(std::span<const Vec3>(triangle), point);
    return sum;
}

CutHistory::Shape CutHistory::shape_of(std::vector<Triangle> surface, CarveKind kind) {
    // Three corners of a facet may lie in a row.
    std::erase_if(surface, [](const Triangle& t) { return !(length(cross(t[1] - t[0], t[2] - t[0])) > 0); });
    Shape shape{std::move(surface), {}, kind, {}};
    for (const Triangle& t : shape.surface) {
        const Vec3 normal = cross(t[1] - t[0], t[2] - t[0]);
        shape.normals.push_back(normal * (1 / length(normal)));
        for (const Vec3& corner : t) shape.box.add(corner);
    }
    return shape;
}

CutHistory::CutHistory(const World& level) : rock_outside_(level.data().rock_outside()) {
    shapes_.push_back(shape_of(triangles_of(level), CarveKind::kFill));
}

void CutHistory::add(const PlacedCutter& cutter, CarveKind kind) {
    shapes_.push_back(shape_of(triangles_of(cutter), kind));
}

std::optional<bool> CutHistory::solid_at(const Vec3& point) const {
    bool solid = false;
    for (std::size_t k = 0; k < shapes_.size(); ++k) {
        const Shape& shape = shapes_[k];
        if (k > 0 && !in_box(shape.box, point)) continue;
        for (std::size_t t = 0; t < shape.surface.size(); ++t)
            if (std::fabs(dot(shape.normals[t], point - shape.surface[t][0])) < kClear) return std::nullopt;
        const double turns = winding(shape.surface, point) + (k == 0 && rock_outside_);
        if (std::fabs(turns - std::round(turns)) > 1e-3) return std::nullopt;
        if (turns > 0.5) solid = shape.kind == CarveKind::kFill;
    }
    return solid;
}

Vec3 CutHistory::point_beside(scenes::Rng& rng) const {
    const std::size_t last = shapes_.size() - 1;
    std::size_t which = last;
    if (last > 1 && rng.chance(0.3)) which = 1 + rng.below(std::uint32_t(last));
    const Shape& shape = shapes_[which];
    const Triangle& t = shape.surface[rng.below(std::uint32_t(shape.surface.size()))];
    const std::uint32_t k = rng.below(3);
    const Vec3 &a = t[k], &b = t[(k + 1) % 3], &c = t[(k + 2) % 3];
    const double what = rng.uniform(), u = rng.uniform(), v = rng.uniform();
    const Vec3 on_edge = a + (b - a) * (rng.chance(0.3) ? 0.5 : u);
    const Vec3 on = what < 0.2 ? a : what < 0.4 ? on_edge : on_edge + (c - on_edge) * v;
    return on + rng.direction() * std::ldexp(1.0, -5 - int(rng.below(8)));
}

}  // namespace firma::reference
