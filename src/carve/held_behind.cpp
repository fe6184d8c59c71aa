// SPDX-License-Identifier: MIT
// All in whole numbers. The line runs between the corners' coordinates, so that it meets no corner. It goes by facets,
// not by exact faces: facets close where faces do and lie within kFacetReach of them, so how often a shell goes around
// a place that lies farther off than that is the same by both. Two such places are taken, one before the facet and one
// behind it. A shell that looks outward goes around no place or once around it; so, as nothing but the facet lies
// between the two, once around that behind it, and whatever leads away from there leaves the shell.
#include "carve/held_behind.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "carve/gather.h"
#include "carve/side_of_solid.h"
#include "geometry/flat_point.h"
#include "index/traverse.h"
#include "solid/near_facets.h"

namespace firma {
namespace {

constexpr std::int64_t kAway = 512;  ///< half surface steps from the facet to each of the two places: a millimetre

/// In half surface steps: odd across the axis, so between those of corners.
struct LineBehind {
    FlatView view;
    FlatPoint at;
    std::int64_t height = 0;  ///< of the facet, along the axis

    std::int64_t low() const { return height - kAway; }
    std::int64_t high() const { return height + kAway; }
    Vec3 place(std::int64_t along) const {
        Vec3 place;
        place[view.axis] = double(along);
        place[view.u()] = double(at.u);
        place[view.v()] = double(at.v);
        return place * (0.5 / kSurfaceSteps);
    }
};

/// Through the middle of the largest triangle at the facet's first corner, along the axis that sees it largest.
std::optional<LineBehind> line_through(const FacetPlace& facet) {
    const auto corner = [&](std::size_t k) { return to_metres(facet.block->corner(facet.record(), k)); };
    double largest = 0;
    LineBehind line;
    Vec3 sum;
    for (std::size_t k = 2; k < facet.record().corner_count; ++k) {
        const Vec3 a = corner(0), b = corner(k - 1), c = corner(k), normal = cross(b - a, c - a);
        for (int axis = 0; axis < 3; ++axis) {
            if (!(std::abs(normal[axis]) > largest)) continue;
            largest = std::abs(normal[axis]);
            line.view.axis = axis;
            sum = a + b + c;
        }
    }
    if (!(largest > 0)) return std::nullopt;
    const auto halves = [&](int axis) { return std::int64_t(std::llround(sum[axis] * (2 * kSurfaceSteps / 3))); };
    line.at = {halves(line.view.u()) | 1, halves(line.view.v()) | 1};
    line.height = halves(line.view.axis);
    return line;
}

/// How often a facet goes around a line, counter-clockwise about the axis; nothing where the line meets a side.
std::optional<int> turns_around(const Block& block, const FaceRecord& face, const LineBehind& line) {
    const auto halves = [&](std::uint32_t k) {
        const FlatPoint point = project(block.corner(face, k), line.view);
        return FlatPoint{2 * point.u, 2 * point.v};
    };
    int turns = 0;
    FlatPoint from = halves(face.corner_count - 1u);
    for (std::uint32_t k = 0; k < face.corner_count; ++k) {
        const FlatPoint to = halves(k);
        const bool below = from.v < line.at.v;
        if (below != (to.v < line.at.v)) {
            const Int128 side = turn(from, to, line.at);
            if (side == 0) return std::nullopt;
            if ((side > 0) == below) turns += below ? 1 : -1;
        }
        from = to;
    }
    return turns;
}

struct BehindVisitor {
    const FacetPlace& start;
    const LineBehind& line;
    const Anchors& anchors;
    const bool upward;
    bool held = true;

    bool enter(const BoxF& box, double& nearest) const {
        nearest = 0;
        const Vec3 low = line.place(line.low()), high = line.place(line.high());
        for (const int axis : {line.view.u(), line.view.v()})
            if (low[axis] < double(box.low[axis]) || low[axis] > double(box.high[axis])) return false;
        const int axis = line.view.axis;
        return upward ? double(box.high[axis]) >= low[axis] : double(box.low[axis]) <= high[axis];
    }
    bool still(double) const { return held; }
    bool facets(const IndexedFacets& facets, std::uint32_t first, std::uint32_t count) {
        const Block& block = as_block(facets);
        for (std::uint32_t slot = first; slot < first + count; ++slot)
            if (block.faces[slot].solid && !(FacetPlace{&block, slot} == start) && tells_nothing(block, slot))
                held = false;
        return !held;
    }

    bool tells_nothing(const Block& block, std::uint32_t slot) const {
        const FaceRecord& face = block.faces[slot];
        const GridBox box = block.box_of(face);
        const int axis = line.view.axis;
        const std::int64_t low = 2 * std::int64_t(box.low[axis]), high = 2 * std::int64_t(box.high[axis]);
        if (upward ? high < line.low() : low > line.high()) return false;
        const std::optional<int> turns = turns_around(block, face, line);
        if (!turns) return true;
        if (*turns == 0) return false;
        if (upward ? low <= line.high() : high >= line.low()) return true;  // beside the facet
        return (*turns > 0) == upward && !anchors.holds(face);
    }
};

bool meets_line(const GridBox& box, const LineBehind& line, bool upward) {
    const auto meets = [&](int axis, std::int64_t at) {
        return 2 * std::int64_t(box.low[axis]) <= at && at <= 2 * std::int64_t(box.high[axis]);
    };
    const int axis = line.view.axis;
    return meets(line.view.u(), line.at.u) && meets(line.view.v(), line.at.v) &&
           (upward ? 2 * std::int64_t(box.high[axis]) >= line.low() : 2 * std::int64_t(box.low[axis]) <= line.high());
}

}  // namespace

bool is_held_behind(const Node& root, const FacetPlace& facet, const GridBox& cutter, const Anchors& anchors) {
    const std::optional<LineBehind> line = line_through(facet);
    if (!line) return false;
    const std::optional<int> turns = turns_around(*facet.block, facet.record(), *line);
    if (!turns || std::abs(*turns) != 1) return false;
    const bool upward = *turns < 0;
    if (meets_line(grown(cutter, kFacetReach + 2), *line, upward)) return false;
    BehindVisitor visitor{facet, *line, anchors, upward};
    traverse(root, visitor);
    if (!visitor.held) return false;
    const auto is_clear = [&](std::int64_t along) {
        return !any_facet_near(&root, line->place(along), (kFacetReach + 1) / kSurfaceSteps);
    };
    return is_clear(line->low()) && is_clear(line->high());
}

}  // namespace firma
