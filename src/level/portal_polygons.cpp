// SPDX-License-Identifier: MIT
// Makes polygons of the triangles that a portal was drawn by.
#include "level/portal_polygons.h"

#include <cstdint>
#include <map>
#include <tuple>

#include "geometry/exact_plane.h"
#include "level/divide_polygon.h"
#include "level/join_triangles.h"

namespace firma {
namespace {

class Joiner {
public:
    void add(const std::array<GridPoint, 3>& triangle) {
        const Plane plane = plane_through(to_input(triangle[0]), to_input(triangle[1]), to_input(triangle[2]));
        if (!plane.valid()) return;
        const auto [entry, is_new] = planes_.try_emplace(
            std::tuple(plane.normal[0], plane.normal[1], plane.normal[2], plane.offset()), surfaces_.size());
        if (is_new) surfaces_.emplace_back();
        for (const GridPoint& point : triangle) surfaces_[entry->second].push_back(vertex_at(point));
    }

    std::vector<std::vector<GridPoint>> polygons() const {
        std::vector<std::vector<GridPoint>> polygons;
        for (const std::vector<std::uint32_t>& triangles : surfaces_)
            for (const std::vector<std::uint32_t>& outline : join_triangles(triangles, points_))
                add_outline(outline, polygons);
        return polygons;
    }

private:
    std::uint32_t vertex_at(const GridPoint& point) {
        const auto [entry, is_new] = vertices_.try_emplace(point, std::uint32_t(points_.size()));
        if (is_new) points_.push_back(point);
        return entry->second;
    }

    void add_outline(const std::vector<std::uint32_t>& outline, std::vector<std::vector<GridPoint>>& polygons) const {
        std::vector<GridPoint> corners;
        for (const std::uint32_t vertex : outline) corners.push_back(points_[vertex]);
        const Division division = divide_polygon(corners);
        if (division.what == Division::What::kWhole) polygons.push_back(std::move(corners));
        for (const auto& [a, b, c] : division.triangles) polygons.push_back({corners[a], corners[b], corners[c]});
    }

    std::map<GridPoint, std::uint32_t> vertices_;
    std::vector<GridPoint> points_;
    std::map<std::tuple<std::int64_t, std::int64_t, std::int64_t, Int128>, std::size_t> planes_;
    std::vector<std::vector<std::uint32_t>> surfaces_;  ///< triangles of a plane each
};

}  // namespace

std::vector<std::vector<GridPoint>> portal_polygons(std::span<const std::array<GridPoint, 3>> triangles) {
    Joiner joiner;
    for (const std::array<GridPoint, 3>& triangle : triangles) joiner.add(triangle);
    return joiner.polygons();
}

}  // namespace firma
