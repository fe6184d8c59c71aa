// SPDX-License-Identifier: MIT
// Lines through the centres of cells, cut by brushes.
#include "brush/air_grid.h"

#include <algorithm>
#include <cmath>

#include "brush/winding.h"
#include "firma/grid.h"
#include "join/brush_bodies.h"

namespace firma {
namespace {

constexpr double kThinnest = 0.0625;   ///< metres: no layer is thinner
constexpr double kThickest = 8;        ///< times as much: none is thicker
constexpr int kMostTries = 24;         ///< of doubling that: layers wider than the world
constexpr double kMostWork = 2e8;      ///< sides asked by lines
constexpr double kMostNumbered = 2e9;  ///< so that 32 bits number them
constexpr std::size_t kMostSidesOfABrush = 1024;
constexpr double kBeyond = 1;  ///< metres: thickness of the outermost layers, or that of the thinnest

double on_input_grid(double metres) {
    return std::floor(metres * kInputSteps + 0.5) / kInputSteps;
}

/// Layers with centres in an interval.
std::pair<int, int> layers_in(const std::vector<double>& centres, double low, double high) {
    const auto first = std::lower_bound(centres.begin(), centres.end(), low);
    const auto last = std::upper_bound(first, centres.end(), high);
    return {int(first - centres.begin()), int(last - centres.begin())};
}

}  // namespace

/// A brush in double. Its surface is part of it: where brushes lie against each other is no air.
struct AirGrid::Body {
    std::vector<FloatPlane> planes;
    std::vector<bool> portal;  ///< by plane: it is one
    Box box;
    bool solid = false;
};

/// Along an axis, through a cell.
struct AirGrid::Line {
    int axis = 0;
    std::size_t first_cell = 0;
    Vec3 place;  ///< but for the axis' coordinate
};

bool AirGrid::is_outermost(std::size_t cell) const {
    for (int axis = 0; axis < 3; ++axis) {
        const int layer = layer_of(cell, axis);
        if (layer == 0 || layer + 1 == layers(axis)) return true;
    }
    return false;
}

std::optional<std::size_t> AirGrid::cell_at(const Vec3& point) const {
    std::size_t cell = 0;
    for (int axis = 0; axis < 3; ++axis) {
        const std::vector<double>& borders = layers_[axis].borders;
        if (!(point[axis] >= borders.front() && point[axis] < borders.back())) return std::nullopt;
        const auto after = std::upper_bound(borders.begin(), borders.end(), point[axis]);
        cell += std::size_t(after - borders.begin() - 1) * strides_[axis];
    }
    return cell;
}

/// Borders where bodies begin and end, but for those too near to the one before; between them evenly.
void AirGrid::set_layers(const std::vector<Body>& bodies, double thinnest) {
    for (int axis = 0; axis < 3; ++axis) {
        std::vector<double> places;
        for (const Body& body : bodies) {
            if (!body.solid) continue;
            places.push_back(body.box.low[axis]);
            places.push_back(body.box.high[axis]);
        }
        std::sort(places.begin(), places.end());
        auto& [borders, centres] = layers_[axis];
        const double beyond = std::max(kBeyond, thinnest);
        borders = {places.front() - beyond, places.front()};
        for (const double place : places) {
            const double from = borders.back();
            if (place - from < thinnest) continue;
            const int parts = int((place - from) / (kThickest * thinnest)) + 1;
            for (int part = 1; part < parts; ++part) borders.push_back(from + (place - from) * part / parts);
            borders.push_back(place);
        }
        borders.push_back(std::max(borders.back(), places.back()) + beyond);
        centres.clear();
        for (std::size_t k = 1; k < borders.size(); ++k)
            centres.push_back(on_input_grid((borders[k - 1] + borders[k]) / 2));
    }
    strides_[1] = std::size_t(layers(0));
    strides_[2] = strides_[1] * std::size_t(layers(1));
}

/// How many sides will be asked.
double AirGrid::lines_through(const std::vector<Body>& bodies) const {
    double count = 0;
    for (const Body& body : bodies) {
        double across[3];
        for (int axis = 0; axis < 3; ++axis) {
            const auto [first, last] = layers_in(layers_[axis].centres, body.box.low[axis], body.box.high[axis]);
            across[axis] = last - first;
        }
        count += (across[0] * across[1] + across[1] * across[2] + across[2] * across[0]) * double(body.planes.size());
    }
    return count;
}

void AirGrid::enter(const Body& body, const Line& line) {
    double low = -INFINITY, high = INFINITY;
    bool portal_low = false, portal_high = false;
    for (std::size_t k = 0; k < body.planes.size(); ++k) {
        const Vec3& normal = body.planes[k].normal;
        const double slope = normal[line.axis], rest = body.planes[k].distance - dot(normal, line.place);
        if (slope == 0) {
            if (rest < 0) return;
        } else if (const double at = rest / slope; slope > 0 && at < high) {
            high = at;
            portal_high = body.portal[k];
        } else if (slope < 0 && at > low) {
            low = at;
            portal_low = body.portal[k];
        }
    }
    if (!(low <= high)) return;
    const std::vector<double>& centres = layers_[line.axis].centres;
    const std::size_t stride = strides_[line.axis];
    const auto layer_before = [&](double at) {  // -1: none
        return int(std::lower_bound(centres.begin(), centres.end(), at) - centres.begin()) - 1;
    };
    if (!body.solid) {
        for (const auto& [at, portal] : {std::pair(low, portal_low), std::pair(high, portal_high)})
            if (const int layer = layer_before(at); portal && layer >= 0)
                cut(line.first_cell + std::size_t(layer) * stride, line.axis);
        return;
    }
    for (int k = std::max(layer_before(low), 0); k < int(centres.size()) && centres[std::size_t(k)] <= high; ++k) {
        std::uint8_t& flags = flags_[line.first_cell + std::size_t(k) * stride];
        flags = std::uint8_t(flags & ~(kWay << line.axis));
        if (centres[std::size_t(k)] >= low) flags = std::uint8_t(flags & ~kAir);
    }
}

void AirGrid::enter(const Body& body) {
    for (int axis = 0; axis < 3; ++axis) {
        const int u = (axis + 1) % 3, v = (axis + 2) % 3;
        const auto [first_u, last_u] = layers_in(layers_[u].centres, body.box.low[u], body.box.high[u]);
        const auto [first_v, last_v] = layers_in(layers_[v].centres, body.box.low[v], body.box.high[v]);
        for (int j = first_v; j < last_v; ++j)
            for (int i = first_u; i < last_u; ++i) {
                Line line{axis, std::size_t(i) * strides_[u] + std::size_t(j) * strides_[v], {}};
                line.place[u] = centre(u, i);
                line.place[v] = centre(v, j);
                enter(body, line);
            }
    }
}

/// From the last layers, and where the lines along another axis found a centre to be in the solid.
void AirGrid::close_ways() {
    for (std::size_t cell = 0; cell < cells(); ++cell)
        for (int axis = 0; axis < 3; ++axis) {
            const bool last = layer_of(cell, axis) + 1 == layers(axis);
            if (last || !is_air(cell) || !is_air(cell + strides_[axis]))
                flags_[cell] = std::uint8_t(flags_[cell] & ~(kWay << axis));
        }
}

std::optional<AirGrid> AirGrid::make(const BrushLevel& level, std::size_t max_cells) {
    std::vector<Body> bodies;
    std::uint64_t pairs = 0;
    bool any_solid = false;
    for (const Brush& brush : level.brushes) {
        const bool solid = is_solid(brush.kind);
        if ((!solid && brush.kind != BrushKind::kPortal) || brush.side_count > kMostSidesOfABrush) continue;
        pairs += std::uint64_t(brush.side_count) * brush.side_count;
        if (pairs > kMostSidePairs) return std::nullopt;
        Body body;
        body.solid = solid;
        for (std::uint32_t k = brush.first_side; k < brush.first_side + brush.side_count; ++k) {
            const BrushSide& side = level.sides[k];
            const std::optional<FloatPlane> plane =
                float_plane(to_metres(side.points[0]), to_metres(side.points[1]), to_metres(side.points[2]));
            if (!plane) continue;
            body.planes.push_back(*plane);
            body.portal.push_back(side.portal);
        }
        for (std::size_t k = 0; k < body.planes.size(); ++k)
            for (const Vec3& corner : winding(body.planes, k, 4 * kWorldRim)) body.box.add(corner);
        if (body.box.empty() || max_abs(body.box.low) > kWorldRim || max_abs(body.box.high) > kWorldRim) continue;
        any_solid |= solid;
        bodies.push_back(std::move(body));
    }
    if (!any_solid) return std::nullopt;
    AirGrid grid;
    double thinnest = kThinnest;
    for (int tries = 0; tries < kMostTries; ++tries, thinnest *= 2) {
        grid.set_layers(bodies, thinnest);
        const double cells = double(grid.layers(0)) * grid.layers(1) * grid.layers(2);
        if (cells > std::min(double(max_cells), kMostNumbered) || grid.lines_through(bodies) > kMostWork) continue;
        grid.flags_.assign(std::size_t(cells), std::uint8_t(kAir | kWay | kWay << 1 | kWay << 2));
        for (const Body& body : bodies) grid.enter(body);
        grid.close_ways();
        return grid;
    }
    return std::nullopt;
}

}  // namespace firma
