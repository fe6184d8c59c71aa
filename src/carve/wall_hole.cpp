// SPDX-License-Identifier: MIT
// A hole in a wall: its outline on the input grid, divided into parts, and prisms over these.
#include "carve/wall_hole.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "base/sort.h"
#include "carve/column_prism.h"
#include "geometry/flat_loop.h"
#include "geometry/triangulate.h"
#include "solid/check_loops.h"

namespace firma {
namespace {

constexpr double kUnderSquare = 8 * kInputStep;
/// More, as a longer way is straighter once it is snapped.
constexpr double kUnderSlanted = 32 * kInputStep;
/// A corner no farther from the line between others is left out.
constexpr double kBesideLine = kInputStep;
/// No hole takes less: its outline is no better known.
constexpr double kStrip = kInputStep / 4;

GridPoint to_steps_of(const Vec3& p) {
    GridPoint at;
    for (int axis = 0; axis < 3; ++axis)
        at[axis] = std::int32_t(std::clamp(p[axis] * kSurfaceSteps, double(INT32_MIN), double(INT32_MAX)));
    return at;
}

double distance_to_segment(const Vec3& p, const Vec3& from, const Vec3& to) {
    const Vec3 way = to - from;
    const double square = dot(way, way);
    const double share = square > 0 ? std::clamp(dot(p - from, way) / square, 0.0, 1.0) : 0;
    return length(p - (from + way * share));
}

/// The corners of a closed outline that bend it. From the lowest on, which does; a stretch grows while all corners in
/// it lie beside the line between its ends.
std::vector<Vec3> bends_of(std::span<const Vec3> outline) {
    std::vector<Vec3> loop;
    for (const Vec3& p : outline)
        if (const Vec3 at = to_input_grid(p); loop.empty() || at != loop.back()) loop.push_back(at);
    while (loop.size() > 1 && loop.front() == loop.back()) loop.pop_back();
    std::rotate(loop.begin(),
                std::min_element(loop.begin(), loop.end(),
                                 [](const Vec3& a, const Vec3& b) {
                                     return a.x != b.x ? a.x < b.x : a.y != b.y ? a.y < b.y : a.z < b.z;
                                 }),
                loop.end());
    std::vector<Vec3> bends;
    for (std::size_t from = 0, count = loop.size(); from < count;) {
        bends.push_back(loop[from]);
        std::size_t to = from + 1;
        const auto is_straight = [&](std::size_t end) {
            for (std::size_t k = from + 1; k < end; ++k)
                if (distance_to_segment(loop[k], loop[from], loop[end % count]) > kBesideLine) return false;
            return true;
        };
        while (to < count && is_straight(to + 1)) ++to;
        from = to;
    }
    return bends;
}

}  // namespace

WallHole::WallHole(const WallOutlines& outlines, const WallPlane& wall)
    : wall_(wall), axis_(steepest_axis(wall.normal)) {
    snap(outlines);
    for (const Vec3& p : outlines_.points) flat_outlines_.push_back(flat(p));
    if (!flat_outlines_.empty()) low_ = high_ = flat_outlines_[0];
    for (const Flat& p : flat_outlines_) {
        low_ = {std::min(low_.u, p.u), std::min(low_.v, p.v)};
        high_ = {std::max(high_.u, p.u), std::max(high_.v, p.v)};
    }
    if (!outlines_.ends.empty() && !divide_into_triangles()) divide_into_trapezoids();
}

void WallHole::snap(const WallOutlines& outlines) {
    std::uint32_t first = 0;
    for (const std::uint32_t end : outlines.ends) {
        const std::vector<Vec3> bends = bends_of(std::span(outlines.points).subspan(first, end - first));
        first = end;
        if (bends.size() < 3) continue;
        outlines_.points.insert(outlines_.points.end(), bends.begin(), bends.end());
        outlines_.ends.push_back(std::uint32_t(outlines_.points.size()));
    }
}

/// @return false where outlines meet themselves or each other
bool WallHole::divide_into_triangles() {
    const FlatView view{axis_, wall_.normal[axis_] < 0};
    std::vector<FlatPoint> flat;
    for (const Vec3& p : outlines_.points) flat.push_back(project(to_steps_of(p), view));
    if (!LoopChecker().simple(flat, outlines_.ends)) return false;
    std::vector<std::size_t> outer, holes;
    const auto loop = [&](std::size_t k) {
        const std::uint32_t first = k == 0 ? 0 : outlines_.ends[k - 1];
        return std::span<const FlatPoint>(flat).subspan(first, outlines_.ends[k] - first);
    };
    for (std::size_t k = 0; k < outlines_.ends.size(); ++k) (twice_area(loop(k)) > 0 ? outer : holes).push_back(k);
    std::vector<std::vector<std::size_t>> holes_of(outer.size());
    for (const std::size_t hole : holes) {
        std::size_t around = outer.size();
        for (std::size_t k = 0; k < outer.size(); ++k)
            if (encloses(loop(outer[k]), loop(hole)[0]) &&
                (around == outer.size() || encloses(loop(outer[around]), loop(outer[k])[0])))
                around = k;
        if (around == outer.size()) return false;
        holes_of[around].push_back(hole);
    }
    whole_ = true;
    for (std::size_t k = 0; k < outer.size(); ++k) whole_ = whole_ && add_outline(outer[k], holes_of[k]);
    if (!whole_) {
        corners_.clear();
        parts_.clear();
    }
    return whole_;
}

bool WallHole::add_outline(std::size_t outer, std::span<const std::size_t> holes) {
    std::vector<Vec3> corners;
    std::vector<std::uint32_t> ends;
    const auto add_loop = [&](std::size_t loop) {
        const std::uint32_t first = loop == 0 ? 0 : outlines_.ends[loop - 1];
        corners.insert(corners.end(), outlines_.points.begin() + first,
                       outlines_.points.begin() + outlines_.ends[loop]);
        ends.push_back(std::uint32_t(corners.size()));
    };
    add_loop(outer);
    for (const std::size_t hole : holes) add_loop(hole);
    std::vector<GridPoint> points;
    std::vector<FlatPoint> flat;
    for (const Vec3& p : corners) {
        points.push_back(to_steps_of(p));
        flat.push_back(project(points.back(), {axis_, wall_.normal[axis_] < 0}));
    }
    Triangles triangles;
    if (!Triangulator().make(points, flat, ends, triangles)) return false;
    for (std::size_t k = 0; k + 2 < triangles.corners.size(); k += 3) {
        const Vec3 part[3] = {corners[triangles.corners[k]], corners[triangles.corners[k + 1]],
                              corners[triangles.corners[k + 2]]};
        add_part(part);
    }
    return true;
}

/// Between each two heights of corners, of what outlines go around more often counter-clockwise than clockwise.
void WallHole::divide_into_trapezoids() {
    const int u = (axis_ + 1) % 3, v = (axis_ + 2) % 3;
    struct SlabSide {
        Vec3 low, high;
        int turns = 0;
    };
    std::vector<double> heights;
    for (const Vec3& p : outlines_.points) heights.push_back(p[v]);
    sort_range(heights);
    heights.erase(std::unique(heights.begin(), heights.end()), heights.end());
    std::vector<SlabSide> crossings;
    for (std::size_t level = 1; level < heights.size(); ++level) {
        crossings.clear();
        const double low = heights[level - 1], high = heights[level];
        std::uint32_t first = 0;
        for (const std::uint32_t end : outlines_.ends) {
            for (std::uint32_t k = first; k < end; ++k) {
                Vec3 a = outlines_.points[k], b = outlines_.points[k + 1 < end ? k + 1 : first];
                const bool up = a[v] < b[v];
                if (!up) std::swap(a, b);
                if (!(a[v] <= low && b[v] >= high)) continue;
                const Vec3 way = (b - a) * (1 / (b[v] - a[v]));
                crossings.push_back({a + way * (low - a[v]), a + way * (high - a[v]), up ? -1 : 1});
            }
            first = end;
        }
        sort_range(crossings,
                   [&](const SlabSide& a, const SlabSide& b) { return a.low[u] + a.high[u] < b.low[u] + b.high[u]; });
        int turns = 0;
        const int inside = wall_.normal[axis_] < 0 ? -1 : 1;
        for (std::size_t k = 0; k < crossings.size(); ++k) {
            turns += crossings[k].turns * inside;
            if (turns <= 0 || k + 1 == crossings.size()) continue;
            const SlabSide &left = crossings[k], &right = crossings[k + 1];
            Vec3 part[4] = {left.low, right.low, right.high, left.high};
            if (inside < 0) std::reverse(part, part + 4);
            add_part(part);
        }
    }
}

void WallHole::add_part(std::span<const Vec3> corners) {
    parts_.push_back({std::uint32_t(corners_.size()), std::uint32_t(corners.size())});
    corners_.insert(corners_.end(), corners.begin(), corners.end());
}

WallHole::Flat WallHole::flat(const Vec3& p) const {
    const Vec3 at = p - wall_.normal * wall_.height(p);
    return {at[(axis_ + 1) % 3], at[(axis_ + 2) % 3]};
}

/// The widest strip between two convex polygons that is square to a side of the first; negative where they overlap.
double WallHole::gap(std::span<const Flat> a, std::span<const Flat> b) {
    double widest = -INFINITY;
    for (std::size_t k = 0; k < a.size(); ++k) {
        const Flat &from = a[k], &to = a[k + 1 < a.size() ? k + 1 : 0];
        const double u = to.v - from.v, v = from.u - to.u, size = std::sqrt(u * u + v * v);
        if (!(size > 0)) continue;
        const auto along = [&](const Flat& p) { return ((p.u - from.u) * u + (p.v - from.v) * v) / size; };
        double low_a = 0, high_a = 0, low_b = INFINITY, high_b = -INFINITY;
        for (const Flat& p : a) low_a = std::min(low_a, along(p)), high_a = std::max(high_a, along(p));
        for (const Flat& p : b) low_b = std::min(low_b, along(p)), high_b = std::max(high_b, along(p));
        widest = std::max({widest, low_b - high_a, low_a - high_b});
    }
    return widest;
}

bool WallHole::takes_of(std::span<const Vec3> polygon) const {
    std::vector<Flat> other, own;
    for (const Vec3& p : polygon) other.push_back(flat(p));
    for (const Part& part : parts_) {
        own.clear();
        for (std::uint32_t k = 0; k < part.count; ++k) own.push_back(flat(corners_[part.first + k]));
        if (std::max(gap(own, other), gap(other, own)) < -kStrip) return true;
    }
    return false;
}

bool WallHole::may_be_over(std::span<const Vec3> polygon) const {
    if (std::all_of(polygon.begin(), polygon.end(),
                    [&](const Vec3& p) { return wall_.height(p) < -2 * kUnderSlanted; }))
        return false;
    std::vector<Flat> other;
    for (const Vec3& p : polygon) other.push_back(flat(p));
    // A polygon that is seen from its side is a line, whose width says as much as that of any.
    constexpr double kNear = 4 * kInputStep;
    const Flat box[4] = {low_, {high_.u, low_.v}, high_, {low_.u, high_.v}};
    return gap(box, other) < kNear && gap(other, flat_outlines_) < kNear;
}

std::optional<PlacedCutter> WallHole::raise_whole(const Vec3& under, const Vec3& over) const {
    const auto before = [](const Vec3& a, const Vec3& b) {
        return a.x != b.x ? a.x < b.x : a.y != b.y ? a.y < b.y : a.z < b.z;
    };
    ColumnPrism prism;
    prism.base = outlines_.points;
    sort_range(prism.base, before);
    const auto number = [&](const Vec3& p) {
        return std::uint32_t(std::lower_bound(prism.base.begin(), prism.base.end(), p, before) - prism.base.begin());
    };
    for (const Part& part : parts_)
        prism.triangles.push_back(
            {number(corners_[part.first]), number(corners_[part.first + 1]), number(corners_[part.first + 2])});
    return prism.raise(under, over);
}

std::optional<PlacedCutter> WallHole::raise_part(const Part& part, const Vec3& under, const Vec3& over) const {
    return grown_prism(std::span(corners_).subspan(part.first, part.count), wall_.normal).raise(under, over);
}

std::vector<PlacedCutter> WallHole::raise(double height) const {
    const Vec3 under = to_input_grid(wall_.normal * -(wall_.axis >= 0 ? kUnderSquare : kUnderSlanted));
    const Vec3 over = to_input_grid(wall_.normal * height);
    std::vector<PlacedCutter> columns;
    if (whole_)
        if (std::optional<PlacedCutter> column = raise_whole(under, over)) {
            columns.push_back(*std::move(column));
            return columns;
        }
    for (const Part& part : parts_)
        if (std::optional<PlacedCutter> column = raise_part(part, under, over)) columns.push_back(*std::move(column));
    return columns;
}

}  // namespace firma
