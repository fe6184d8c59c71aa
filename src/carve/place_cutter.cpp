// SPDX-License-Identifier: MIT
// From a cutter's own doubles to points of the input grid, and what that must leave intact.
#include "carve/place_cutter.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/random.h"
#include "carve/cutter_data.h"
#include "geometry/grid_orient.h"

namespace firma {
namespace {

/// Input steps from the middle of the world to its rim.
constexpr std::int32_t kRimSteps = std::int32_t(kWorldRim * kInputSteps);

Error error_at(const std::string& name, std::string place, ErrorCode code, std::string reason) {
    if (!name.empty()) place = place.empty() ? name : name + ": " + place;
    return {code, std::move(place), std::move(reason)};
}

Error outside(const std::string& name, std::size_t vertex) {
    return error_at(name, "vertex " + std::to_string(vertex), ErrorCode::kOutOfRange,
                    "lies outside the world, which spans 8192 m to each side");
}

/// Rows of a rotation times a scale.
struct Turn {
    Vec3 row[3];
};

std::optional<Turn> turn_of(const Quaternion& rotation, double scale) {
    double reach = 0;
    for (const double part : rotation) {
        if (!is_finite(part)) return std::nullopt;
        reach = std::max(reach, std::fabs(part));
    }
    if (reach == 0) return std::nullopt;
    // Divided by the largest part first, so that no square overflows and not all of them vanish.
    double q[4], square = 0;
    for (std::size_t k = 0; k < 4; ++k) {
        q[k] = rotation[k] / reach;
        square += q[k] * q[k];
    }
    const double size = std::sqrt(square);
    const double x = q[0] / size, y = q[1] / size, z = q[2] / size, w = q[3] / size;
    Turn turn{{{1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)},
               {2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)},
               {2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)}}};
    for (Vec3& row : turn.row) row = row * scale;
    return turn;
}

/// Hashes two numbers of 32 bits after those before.
void add_to_hash(std::uint64_t& hash, std::uint32_t a, std::uint32_t b) {
    hash = (hash ^ (std::uint64_t(a) << 32 | b)) * 0x9E3779B97F4A7C15ull;
    hash ^= hash >> 29;
}

std::uint64_t hash_of(const PlacedCutter& placed) {
    std::uint64_t hash = placed.triangles.size();
    for (const InputPoint& v : placed.vertices) {
        add_to_hash(hash, std::uint32_t(v.x), std::uint32_t(v.y));
        add_to_hash(hash, std::uint32_t(v.z), 0);
    }
    for (const auto& [a, b, c] : placed.triangles) {
        add_to_hash(hash, a, b);
        add_to_hash(hash, c, 0);
    }
    return mix_bits(hash);
}

/// The cutter on the grid, if it still is one.
Result<PlacedCutter> finish(PlacedCutter placed) {
    const InputPoint origin = placed.vertices[0];
    Int128 volume = 0;  // six times; a determinant has 82 bits, millions of them 105
    for (std::size_t t = 0; t < placed.triangles.size(); ++t) {
        const auto& [ia, ib, ic] = placed.triangles[t];
        const InputPoint &a = placed.vertices[ia], &b = placed.vertices[ib], &c = placed.vertices[ic];
        const AreaVector n = area_vector(a, b, c);
        if ((n.x | n.y | n.z) == 0)
            return error_at(placed.name, "triangle " + std::to_string(t), ErrorCode::kInvalid,
                            "has no area on the grid of 1/4096 m: the cutter is too small or too thin there");
        volume += height(origin, n, a);
    }
    if (volume <= 0)
        return error_at(placed.name, "", ErrorCode::kInvalid, "encloses no volume on the grid of 1/4096 m");
    placed.hash = hash_of(placed);
    return placed;
}

/// The first tries move little; a place that was cut again and again needs more room.
std::int32_t farthest_move(int tries) {
    const int doublings = tries <= 16 ? 0 : tries <= 32 ? 1 : tries <= 48 ? 2 : 3;
    return kLeastMove << doublings;
}

/// An axis along which a vertex looks outward by less than this part of its largest has no outward.
constexpr double kFlat = 0.25;

/// At each vertex the sum of its triangles' normals.
std::vector<Vec3> outward(const PlacedCutter& placed) {
    std::vector<Vec3> out(placed.vertices.size());
    const auto corner = [&](std::uint32_t v) {
        const InputPoint& p = placed.vertices[v];
        return Vec3{double(p.x), double(p.y), double(p.z)};
    };
    for (const auto& [a, b, c] : placed.triangles) {
        const Vec3 normal = cross(corner(b) - corner(a), corner(c) - corner(a));
        for (const std::uint32_t v : {a, b, c}) out[v] = out[v] + normal;
    }
    return out;
}

bool in_world(const InputPoint& p) {
    for (int axis = 0; axis < 3; ++axis)
        if (p[axis] < -kRimSteps || p[axis] >= kRimSteps) return false;
    return true;
}

}  // namespace

Result<PlacedCutter> place_cutter(const Cutter& cutter, const Pose& pose) {
    if (!cutter.valid()) return Error{ErrorCode::kInvalid, "", "an empty cutter"};
    const CutterData& data = *cutter.data();
    const auto refuse = [&](ErrorCode code, const char* reason) { return error_at(data.name, "", code, reason); };
    if (!(pose.scale > 0) || !is_finite(pose.scale))
        return refuse(ErrorCode::kInvalid, "the scale must be a finite number above zero");
    if (!is_finite(pose.position)) return refuse(ErrorCode::kOutOfRange, "the position is not finite");
    const std::optional<Turn> turn = turn_of(pose.rotation, pose.scale);
    if (!turn) return refuse(ErrorCode::kInvalid, "the rotation is zero or not finite");

    PlacedCutter placed;
    placed.name = data.name;
    placed.vertices.reserve(data.vertices.size());
    for (std::size_t k = 0; k < data.vertices.size(); ++k) {
        const Vec3& v = data.vertices[k];
        const Vec3 turned{dot(turn->row[0], v), dot(turn->row[1], v), dot(turn->row[2], v)};
        const std::optional<GridPoint> snapped = snap(turned + pose.position);
        if (!snapped) return outside(data.name, k);
        placed.vertices.push_back(to_input(*snapped));
    }
    placed.triangles = data.triangles;
    placed.topology = std::shared_ptr<const CutterTopology>(cutter.data(), &data.topology);
    return finish(std::move(placed));
}

Result<PlacedCutter> move_cutter(const PlacedCutter& placed, int tries) {
    Random random(placed.hash ^ mix_bits(std::uint64_t(tries)));
    const std::int32_t farthest = farthest_move(tries);
    const std::vector<Vec3> out = outward(placed);
    PlacedCutter moved = placed;
    for (std::size_t k = 0; k < moved.vertices.size(); ++k) {
        std::uint64_t bits = random.next();
        for (int axis = 0; axis < 3; ++axis, bits >>= 21) {
            const auto draw = [&](std::int32_t count) {
                return std::int32_t((bits & 0x1FFFFF) * std::uint64_t(count) >> 21);
            };
            // Outward by one step at least, where there is an outward along this axis.
            const double along = out[k][axis];
            const std::int32_t by = std::fabs(along) < kFlat * max_abs(out[k]) ? draw(2 * farthest + 1) - farthest
                                    : along > 0                                ? 1 + draw(farthest)
                                                                               : -1 - draw(farthest);
            moved.vertices[k][axis] += by;
        }
        if (!in_world(moved.vertices[k])) return outside(placed.name, k);
    }
    return finish(std::move(moved));
}

Result<PlacedCutter> move_vertices(const PlacedCutter& placed, const PlacedCutter& before,
                                   std::span<const std::uint32_t> vertices, int tries) {
    Random random(placed.hash ^ mix_bits(std::uint64_t(tries)));
    const std::int32_t farthest = std::min(1 + tries / 2, kFarthestMove);
    std::int32_t steps[3], flat_steps[3];
    for (int axis = 0; axis < 3; ++axis) {
        const std::uint64_t bits = random.next();
        steps[axis] = 1 + std::int32_t((bits >> 32) % std::uint64_t(farthest));
        flat_steps[axis] = bits & 1 ? steps[axis] : -steps[axis];
    }
    const std::vector<Vec3> out = outward(placed);
    PlacedCutter moved = before;
    for (const std::uint32_t k : vertices) {
        for (int axis = 0; axis < 3; ++axis) {
            const double along = out[k][axis];
            const bool flat = std::fabs(along) < kFlat * max_abs(out[k]);
            moved.vertices[k][axis] = placed.vertices[k][axis] + (flat        ? flat_steps[axis]
                                                                  : along > 0 ? steps[axis]
                                                                              : -steps[axis]);
        }
        if (!in_world(moved.vertices[k])) return outside(placed.name, k);
    }
    return finish(std::move(moved));
}

}  // namespace firma
