// SPDX-License-Identifier: MIT
// Sides of dropped outlines are divided at the outline's own corners, and the sides against them likewise, in rounds: a
// neighbour may have been dropped as well.
#include "level/mend_dropped.h"

#include <algorithm>
#include <cstdlib>
#include <map>
#include <span>
#include <utility>

#include "base/sort.h"
#include "geometry/polygon_shape.h"

namespace firma {
namespace {

__extension__ using Wide = __int128;
using Outline = std::vector<std::uint32_t>;
/// From a position to another.
using Side = std::pair<GridPoint, GridPoint>;
/// Corners to put into sides, in order along them; several faces may use one side.
using Corners = std::multimap<Side, Outline>;

/// A chain of neighbours that were all dropped is this long at most; the end of a longer one stays a T-joint.
constexpr int kMostRounds = 16;
/// Of a dropped outline, its neighbours' corners included.
constexpr std::size_t kMostOfAnOutline = 256;

std::int64_t along(const GridPoint& a, const GridPoint& b, int axis) {
    return std::int64_t(b[axis]) - a[axis];
}

bool on_one_line(const GridPoint& a, const GridPoint& b, const GridPoint& p) {
    for (int axis = 0; axis < 3; ++axis) {
        const int u = (axis + 1) % 3, v = (axis + 2) % 3;
        if (Wide(along(a, b, u)) * along(a, p, v) != Wide(along(a, b, v)) * along(a, p, u)) return false;
    }
    return true;
}

int longest_axis(const GridPoint& a, const GridPoint& b) {
    int longest = 0;
    for (int axis = 1; axis < 3; ++axis)
        if (std::abs(along(a, b, axis)) > std::abs(along(a, b, longest))) longest = axis;
    return longest;
}

/// The corners of an outline strictly inside one of its own sides, from its beginning to its end, one a position.
Outline inside_side(const Outline& outline, const Side& side, const std::vector<GridPoint>& vertices) {
    const GridPoint from = side.first, to = side.second;  // by name: clang 14 captures no structured bindings
    if (from == to) return {};
    const int axis = longest_axis(from, to);
    const std::int64_t length = along(from, to, axis);
    const auto place = [&](std::uint32_t corner) {
        return length > 0 ? along(from, vertices[corner], axis) : -along(from, vertices[corner], axis);
    };
    Outline inside;
    for (const std::uint32_t corner : outline)
        if (on_one_line(from, to, vertices[corner]) && place(corner) > 0 && place(corner) < std::abs(length))
            inside.push_back(corner);
    sort_range(inside,
               [&](std::uint32_t a, std::uint32_t b) { return place(a) != place(b) ? place(a) < place(b) : a < b; });
    const auto same = [&](std::uint32_t a, std::uint32_t b) { return vertices[a] == vertices[b]; };
    inside.erase(std::unique(inside.begin(), inside.end(), same), inside.end());
    return inside;
}

Side side_of(std::span<const std::uint32_t> outline, std::size_t k, const std::vector<GridPoint>& vertices) {
    return {vertices[outline[k]], vertices[outline[k + 1 < outline.size() ? k + 1 : 0]]};
}

/// Divides an outline's sides at its own corners; notes what the sides against them need.
void divide_at_own_corners(Outline& outline, const std::vector<GridPoint>& vertices, Corners& wanted) {
    Outline divided;
    for (std::size_t k = 0; k < outline.size(); ++k) {
        const Side side = side_of(outline, k, vertices);
        Outline inside = inside_side(outline, side, vertices);
        divided.push_back(outline[k]);
        divided.insert(divided.end(), inside.begin(), inside.end());
        if (inside.empty()) continue;
        std::reverse(inside.begin(), inside.end());
        wanted.emplace(Side{side.second, side.first}, std::move(inside));
    }
    outline = std::move(divided);
}

/// The outline with what its sides want, which is then taken from `wanted`; empty when they want nothing, or it would
/// have more than `most` corners.
Outline with_corners(std::span<const std::uint32_t> outline, std::size_t most, const std::vector<GridPoint>& vertices,
                     Corners& wanted) {
    Outline mended;
    std::vector<Corners::iterator> used;
    for (std::size_t k = 0; k < outline.size(); ++k) {
        mended.push_back(outline[k]);
        const auto found = wanted.find(side_of(outline, k, vertices));
        if (found == wanted.end() || std::find(used.begin(), used.end(), found) != used.end()) continue;
        mended.insert(mended.end(), found->second.begin(), found->second.end());
        used.push_back(found);
    }
    if (used.empty() || mended.size() > most) return {};
    for (const Corners::iterator& corners : used) wanted.erase(corners);
    return mended;
}

void mend_faces(Level& level, Corners& wanted) {
    std::vector<std::uint32_t> corners;
    corners.reserve(level.corners.size());
    for (LevelFace& face : level.faces) {
        const std::span<const std::uint32_t> outline(level.corners.data() + face.first_corner, face.corner_count);
        const Outline mended = with_corners(outline, std::size_t(kMaxCorners), level.vertices, wanted);
        const std::span<const std::uint32_t> kept = mended.empty() ? outline : std::span(mended);
        face.first_corner = std::uint32_t(corners.size());
        face.corner_count = std::uint32_t(kept.size());
        corners.insert(corners.end(), kept.begin(), kept.end());
    }
    level.corners = std::move(corners);
}

}  // namespace

void mend_dropped(std::vector<Outline> dropped, Level& level) {
    std::erase_if(dropped, [](const Outline& outline) { return outline.size() > std::size_t(kMaxCorners); });
    for (int round = 0; round < kMostRounds; ++round) {
        Corners wanted;
        for (Outline& outline : dropped) divide_at_own_corners(outline, level.vertices, wanted);
        if (wanted.empty()) return;
        for (Outline& outline : dropped) {
            Outline mended = with_corners(outline, kMostOfAnOutline, level.vertices, wanted);
            if (!mended.empty()) outline = std::move(mended);
        }
        if (!wanted.empty()) mend_faces(level, wanted);
    }
}

}  // namespace firma
