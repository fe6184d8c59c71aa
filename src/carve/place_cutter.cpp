// SPDX-License-Identifier: MIT
// From a cutter's own doubles to points of the input grid, and what that must leave intact.
#include "carve/place_cutter.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "carve/cutter_data.h"
#include "carve/pose_turn.h"
#include "geometry/grid_orient.h"

namespace firma {

Error cutter_error(const std::string& name, std::string place, ErrorCode code, std::string reason) {
    if (!name.empty()) place = place.empty() ? name : name + ": " + place;
    return {code, std::move(place), std::move(reason)};
}

Error outside_world(const std::string& name, std::size_t vertex) {
    return cutter_error(name, "vertex " + std::to_string(vertex), ErrorCode::kOutOfRange,
                        "lies outside the world, which spans 8192 m to each side");
}

namespace {

/// The cutter on the grid, if it still is one.
Result<PlacedCutter> finish(PlacedCutter placed) {
    const InputPoint origin = placed.vertices[0];
    Int128 volume = 0;  // six times; a determinant has 82 bits, millions of them 105
    for (std::size_t t = 0; t < placed.triangles.size(); ++t) {
        const auto& [ia, ib, ic] = placed.triangles[t];
        const InputPoint &a = placed.vertices[ia], &b = placed.vertices[ib], &c = placed.vertices[ic];
        const AreaVector n = area_vector(a, b, c);
        if ((n.x | n.y | n.z) == 0)
            return cutter_error(placed.name, "triangle " + std::to_string(t), ErrorCode::kInvalid,
                                "has no area on the grid of 1/4096 m: the cutter is too small or too thin there");
        volume += height(origin, n, a);
    }
    if (volume <= 0)
        return cutter_error(placed.name, "", ErrorCode::kInvalid, "encloses no volume on the grid of 1/4096 m");
    return placed;
}

}  // namespace

Result<PoseTurn> judge_pose(const Cutter& cutter, const Pose& pose) {
    if (!cutter.valid()) return Error{ErrorCode::kInvalid, "", "an empty cutter"};
    const auto refuse = [&](ErrorCode code, const char* reason) {
        return cutter_error(cutter.name(), "", code, reason);
    };
    if (!(pose.scale > 0) || !is_finite(pose.scale))
        return refuse(ErrorCode::kInvalid, "the scale must be a finite number above zero");
    if (!is_finite(pose.position)) return refuse(ErrorCode::kOutOfRange, "the position is not finite");
    const std::optional<PoseTurn> turn = turn_of(pose.rotation, pose.scale);
    if (!turn) return refuse(ErrorCode::kInvalid, "the rotation is zero or not finite");
    return *turn;
}

Result<PlacedCutter> place_cutter(const Cutter& cutter, const Pose& pose) {
    const Result<PoseTurn> turn = judge_pose(cutter, pose);
    if (!turn) return turn.error();
    const CutterData& data = *cutter.data();
    PlacedCutter placed;
    placed.name = data.name;
    placed.vertices.reserve(data.vertices.size());
    for (std::size_t k = 0; k < data.vertices.size(); ++k) {
        const std::optional<GridPoint> snapped = snap(turn.value().turned(data.vertices[k]) + pose.position);
        if (!snapped) return outside_world(data.name, k);
        placed.vertices.push_back(to_input(*snapped));
    }
    placed.triangles = data.triangles;
    placed.topology = std::shared_ptr<const CutterTopology>(cutter.data(), &data.topology);
    return finish(std::move(placed));
}

}  // namespace firma
