// SPDX-License-Identifier: MIT
// From a cutter's own doubles to points of the input grid, and what that must leave intact.
#include "carve/place_cutter.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "carve/cutter_data.h"
#include "geometry/grid_orient.h"

namespace firma {
namespace {

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
    return placed;
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

}  // namespace firma
