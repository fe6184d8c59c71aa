// SPDX-License-Identifier: MIT
// What edits and doors have to know of parts that move.
#include "firma/part_edits.h"

#include <cstdint>

#include "firma/rooms.h"
#include "moving/part_frame.h"

namespace firma {
namespace {

/// How far from the rim to the middle of a portal's polygon what is asked of lies: rims lie on walls, and doors may
/// have a gap.
constexpr double kFromRim = 1.0 / 16;

bool in_solid(const MovingPart& part, const PartFrame& frame, const Vec3& point) {
    return locate(part.world(), frame.in(point)).where == Where::kSolid;
}

bool closes(const MovingPart& part, const PartFrame& frame, const std::vector<Vec3>& polygon) {
    Vec3 middle;
    for (const Vec3& corner : polygon) middle += corner * (1.0 / double(polygon.size()));
    if (!in_solid(part, frame, middle)) return false;
    for (const Vec3& corner : polygon)
        if (!in_solid(part, frame, corner + (middle - corner) * kFromRim)) return false;
    return true;
}

bool boxes_share(const Box& a, const Box& b) {
    for (int axis = 0; axis < 3; ++axis)
        if (!(a.low[axis] <= b.high[axis] && b.low[axis] <= a.high[axis])) return false;
    return true;
}

/// Around a part's box as it stands.
Box box_in_world(const MovingPart& part, const PartFrame& frame) {
    const Box& box = part.bounds();
    Box around;
    for (int k = 0; k < 8; ++k)
        around.add(frame.out(
            {k & 1 ? box.low.x : box.high.x, k & 2 ? box.low.y : box.high.y, k & 4 ? box.low.z : box.high.z}));
    return around;
}

}  // namespace

Pose pose_in_part(const MovingPart& part, double fraction, const Pose& pose) {
    const PartFrame frame(part.motion, fraction);
    Pose seen = pose;
    seen.position = frame.in(pose.position);
    if (frame.turned)
        seen.rotation =
            normalised(compose(turn_back(pose_at(part.motion, fraction).rotation), normalised(pose.rotation)));
    return seen;
}

std::vector<PortalId> portals_closed_by(const World& world, const MovingPart& part) {
    std::vector<PortalId> closed;
    if (!is_usable_part(part) || part.bounds().empty()) return closed;
    const PartFrame frame(part.motion, 0);
    const Box box = box_in_world(part, frame);
    for (std::uint32_t k = 0; k < portal_count(world); ++k) {
        const auto info = portal_info(world, {k});
        if (!info || info->polygons == 0 || !boxes_share(box, info->bounds)) continue;
        bool all = true;
        for (const std::vector<Vec3>& polygon : portal_polygons(world, {k})) all = all && closes(part, frame, polygon);
        if (all) closed.push_back({k});
    }
    return closed;
}

}  // namespace firma
