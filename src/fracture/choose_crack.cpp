// SPDX-License-Identifier: MIT
// Cracks of lumps and splinters, of bricks, of shards. All of it is by + - * / and roots: the same bits everywhere.
#include "fracture/choose_crack.h"

#include <algorithm>
#include <cmath>

#include "base/random.h"
#include "body/longest_axis.h"

namespace firma {
namespace {

/// Of a crooked lump: how far from the middle a crack is, as a share of its length, and how slanted.
constexpr double kOffMiddle = 0.3, kSlant = 0.7;
/// Of a brick: no crack leaves less of its size on either side.
constexpr double kLeastBrick = 0.2;
/// A crack through several rows divides bricks: only where a piece is so many times as long as high, in bricks.
constexpr double kThroughRows = 8;
/// Cracks away from a point of impact, at least.
constexpr double kSpokes = 7;
/// Where a ring divides a shard: nearer to the impact than to the rim.
constexpr double kRing = 0.4;

Vec3 unit(const Vec3& v) {
    return v * (1 / length(v));
}

/// A quarter turn to the left, seen along z.
Vec3 turned_left(const Vec3& v) {
    return {-v.y, v.x, 0};
}

double distance_to_box(const Vec3& point, const Vec3& low, const Vec3& high) {
    Vec3 gap;
    for (int axis = 0; axis < 3; ++axis) gap[axis] = std::max({low[axis] - point[axis], point[axis] - high[axis], 0.0});
    return length(gap);
}

/// By how much pieces are larger here than at the point of impact.
double growth_at(const CrackField& field, const CrackCell& cell) {
    return field.hit ? 1 + field.pattern.growth * distance_to_box(field.impact, cell.low, cell.high) : 1;
}

/// Along each axis, in sizes of a piece.
Vec3 in_sizes(const CrackField& field, const CrackCell& cell) {
    const double growth = growth_at(field, cell);
    Vec3 ratio;
    for (int axis = 0; axis < 3; ++axis)
        ratio[axis] = (cell.high[axis] - cell.low[axis]) / (field.pattern.size[axis] * growth);
    return ratio;
}

Vec3 middle_of(const CrackCell& cell) {
    return (cell.low + cell.high) * 0.5;
}

/// Across the longest way through the piece, where lengths are counted in sizes of a piece: so what is to be long
/// splits along its length, and its ends slant.
std::optional<CrackChoice> crack_of_lump(const CrackField& field, const CrackCell& cell, Random& random) {
    const int along = longest_axis(in_sizes(field, cell));
    const double crooked = field.pattern.crooked;
    CrackChoice crack;
    crack.point = middle_of(cell);
    const double off = random.uniform(-kOffMiddle, kOffMiddle) * crooked;
    crack.point[along] += off * (cell.high[along] - cell.low[along]);
    for (int axis = 0; axis < 3; ++axis) {
        const double slant = random.uniform(-kSlant, kSlant) * crooked;
        crack.normal[axis] = ((axis == along ? 1 : 0) + slant) / field.pattern.size[axis];
    }
    crack.normal = unit(crack.normal);
    return crack;
}

/// The line between bricks that is nearest to the middle of a piece along an axis.
/// @return nothing where it leaves too little on one side
std::optional<double> brick_line(const CrackField& field, const CrackCell& cell, int axis) {
    const Vec3 size = field.pattern.size, middle = middle_of(cell);
    double first = field.brick_corner[axis];
    if (axis == 0) {
        const double row = std::floor((middle.z - field.brick_corner.z) / size.z);
        if (row - 2 * std::floor(row / 2) != 0) first += size.x / 2;
    }
    const double line = first + size[axis] * std::floor((middle[axis] - first) / size[axis] + 0.5);
    const double least = size[axis] * kLeastBrick;
    if (!(line - cell.low[axis] > least && cell.high[axis] - line > least)) return std::nullopt;
    return line;
}

/// Rows first, then bricks of a row.
std::optional<CrackChoice> crack_of_bricks(const CrackField& field, const CrackCell& cell, Random& random) {
    Vec3 ratio = in_sizes(field, cell);
    if (ratio.z > 1 && ratio.x > 1) ratio.x = std::max(ratio.x / kThroughRows, 1.001);
    for (int tried = 0; tried < 3; ++tried) {
        const int along = longest_axis(ratio);
        if (ratio[along] <= 1) break;
        if (const std::optional<double> line = brick_line(field, cell, along)) {
            CrackChoice crack;
            crack.point = middle_of(cell);
            crack.point[along] = *line;
            for (int axis = 0; axis < 3; ++axis) {
                const double slant = random.uniform(-kSlant, kSlant) * field.pattern.crooked;
                crack.normal[axis] = axis == along ? 1 : slant * field.pattern.size[along] / field.pattern.size[axis];
            }
            crack.normal = unit(crack.normal);
            return crack;
        }
        ratio[along] = 0;
    }
    return std::nullopt;
}

bool is_whole(const CrackSector& sector) {
    return sector.from == Vec3{};
}

/// Between both sides of a sector, unit.
Vec3 middle_way(const CrackSector& sector) {
    const Vec3 sum = sector.from + sector.to;
    // Of half a circle the sum is nothing but rounding.
    return dot(sum, sum) < 1e-6 ? turned_left(sector.from) : unit(sum);
}

/// A shard as seen from the point of impact.
struct ShardShape {
    double near = 0, far = 0;  ///< along the middle of its sector, metres
    double rings = 0;          ///< how much longer than it should be, as a factor
    double spokes = 0;         ///< and wider
};

ShardShape shape_of_shard(const CrackField& field, const CrackCell& cell) {
    ShardShape shape;
    const Vec3 size = field.pattern.size;
    if (is_whole(cell.sector)) {
        shape.spokes = kSpokes;
        shape.far = length(cell.high - cell.low);
        return shape;
    }
    const Vec3 way = middle_way(cell.sector);
    shape.near = INFINITY;
    shape.far = -INFINITY;
    for (const Vec3& corner : cell.corners) {
        const double at = dot(corner - field.impact, way);
        shape.near = std::min(shape.near, at);
        shape.far = std::max(shape.far, at);
    }
    shape.near = std::max(shape.near, 0.0);
    const double growth = field.hit ? 1 + field.pattern.growth * shape.near : 1;
    const double chord = length(cell.sector.to - cell.sector.from);
    shape.rings = (shape.far - shape.near) / (size.x * growth);
    shape.spokes = chord * (shape.near + shape.far) / 2 / (size.y * growth);
    // 6.3 is around: at the point of impact there are so many spokes before there are rings.
    if (shape.near < size.x) shape.spokes = std::max(shape.spokes, chord * kSpokes / 6.3 * kWorthDividing);
    return shape;
}

/// A unit direction across z.
Vec3 random_way(Random& random) {
    for (;;) {
        Vec3 way;
        way.x = random.uniform(-1, 1);
        way.y = random.uniform(-1, 1);
        const double square = dot(way, way);
        if (square > 0.01 && square <= 1) return unit(way);
    }
}

/// The way of the next spoke of a sector.
Vec3 spoke(const CrackField& field, const CrackCell& cell, Random& random) {
    const double crooked = field.pattern.crooked;
    const CrackSector& sector = cell.sector;
    if (is_whole(sector)) {
        Vec3 to_middle = middle_of(cell) - field.impact;
        to_middle.z = 0;
        const bool outside = field.impact.x < cell.low.x || field.impact.x > cell.high.x ||
                             field.impact.y < cell.low.y || field.impact.y > cell.high.y;
        return outside ? unit(to_middle) : random_way(random);
    }
    const Vec3 middle = middle_way(sector);
    const double chord = length(sector.to - sector.from);
    return unit(middle + turned_left(middle) * (random.uniform(-kOffMiddle, kOffMiddle) * crooked * chord));
}

std::optional<CrackChoice> crack_of_shard(const CrackField& field, const CrackCell& cell, Random& random) {
    const ShardShape shape = shape_of_shard(field, cell);
    CrackChoice crack;
    if (shape.spokes >= shape.rings) {
        const Vec3 way = spoke(field, cell, random);
        crack.point = field.impact;
        crack.normal = turned_left(way);
        const bool whole = is_whole(cell.sector);
        crack.in_front = {way, whole ? -way : cell.sector.to};
        crack.behind = {whole ? -way : cell.sector.from, way};
        return crack;
    }
    const double crooked = field.pattern.crooked;
    const Vec3 way = middle_way(cell.sector);
    const double at = kRing + random.uniform(-0.2, 0.2) * crooked;
    const double slant = random.uniform(-kSlant, kSlant) * crooked;
    crack.point = field.impact + way * (shape.near + (shape.far - shape.near) * at);
    crack.normal = unit(way + turned_left(way) * slant);
    crack.in_front = crack.behind = cell.sector;
    return crack;
}

}  // namespace

void measure_cell(CrackCell& cell) {
    Box box;
    for (const Vec3& corner : cell.corners) box.add(corner);
    cell.low = box.low;
    cell.high = box.high;
}

double excess_of(const CrackField& field, const CrackCell& cell) {
    if (field.pattern.style == CrackStyle::kShards) {
        const ShardShape shape = shape_of_shard(field, cell);
        return std::max(shape.rings, shape.spokes);
    }
    const Vec3 ratio = in_sizes(field, cell);
    return ratio[longest_axis(ratio)];
}

std::optional<CrackChoice> choose_crack(const CrackField& field, const CrackCell& cell, std::uint64_t seed) {
    Random random(seed);
    switch (field.pattern.style) {
        case CrackStyle::kLumps:
            return crack_of_lump(field, cell, random);
        case CrackStyle::kBricks:
            return crack_of_bricks(field, cell, random);
        case CrackStyle::kShards:
            return crack_of_shard(field, cell, random);
    }
    return std::nullopt;
}

}  // namespace firma
