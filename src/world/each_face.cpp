// SPDX-License-Identifier: MIT
// Faces of a world for a visitor: all, in a box, in a room, in a region.
#include <array>
#include <cmath>

#include "firma/world.h"
#include "index/box_tree.h"
#include "solid/region.h"
#include "world/block_faces.h"
#include "world/facets_in_box.h"
#include "world/world_data.h"

namespace firma {
namespace {

constexpr GridBox kWholeWorld{{INT32_MIN, INT32_MIN, INT32_MIN}, {INT32_MAX, INT32_MAX, INT32_MAX}};

/// Shows the faces near a box, those that `wanted` takes.
template <class Wanted, class Roots>
bool show_faces(const WorldData& data, const Roots& roots, const GridBox& box, const Wanted& wanted,
                FaceVisitor visit) {
    return facets_in_box(roots, box, [&](const Block& block, std::uint32_t slot) {
        const FaceRecord& record = block.faces[slot];
        if (!wanted(block, record)) return true;
        const FaceShape shape(block, record);
        if (!shape.polygon.has_area()) return true;
        const RoomId room{data.cells.current_room(block.part)};
        return visit({face_info(room, block, record, shape.polygon), shape.polygon.corners});
    });
}

/// The first surface step at or above the low end of a range of metres, and the last at or below its high end: where
/// the range holds no step, the last comes before the first.
/// @return false where the range is empty, or outside the world
bool steps_of(double low, double high, std::int32_t& first, std::int32_t& last) {
    if (!(low <= high)) return false;
    const double from = std::ceil(low * kSurfaceSteps), to = std::floor(high * kSurfaceSteps);
    if (from > double(INT32_MAX) || to < double(INT32_MIN)) return false;
    first = from < double(INT32_MIN) ? INT32_MIN : std::int32_t(from);
    last = to > double(INT32_MAX) ? INT32_MAX : std::int32_t(to);
    return true;
}

}  // namespace

bool each_face(const World& world, FaceVisitor visit) {
    const auto any = [](const Block&, const FaceRecord&) { return true; };
    return show_faces(world.data(), all_facets(world.data()), kWholeWorld, any, visit);
}

bool each_face(const World& world, const Box& box, FaceVisitor visit) {
    GridBox steps;
    if (!is_finite(box.low) || !is_finite(box.high)) return true;
    for (int axis = 0; axis < 3; ++axis)
        if (!steps_of(box.low[axis], box.high[axis], steps.low[axis], steps.high[axis])) return true;
    const auto meets = [&](const Block& block, const FaceRecord& face) {
        return boxes_meet(block.box_of(face), steps);
    };
    return show_faces(world.data(), all_facets(world.data()), steps, meets, visit);
}

bool each_face(const World& world, RoomId room, FaceVisitor visit) {
    if (room == kAnyRoom) return each_face(world, visit);
    const WorldData& data = world.data();
    if (room.value >= data.cells.room_count()) return true;
    const auto any = [](const Block&, const FaceRecord&) { return true; };
    const std::array roots{data.faces_of(data.cells.current_room(room.value)).tree.get()};
    return show_faces(data, roots, kWholeWorld, any, visit);
}

bool each_face(const World& world, const Region& region, FaceVisitor visit) {
    const std::int32_t at[] = {region.x, region.y, region.z};
    constexpr std::int32_t kRim = 1 << (kRegionAxisBits - 1);
    GridBox cube;
    for (int axis = 0; axis < 3; ++axis) {
        if (at[axis] < -kRim || at[axis] >= kRim) return true;
        cube.low[axis] = at[axis] * (1 << kRegionBits);
        cube.high[axis] = cube.low[axis] + ((1 << kRegionBits) - 1);
    }
    const std::uint32_t wanted = region_of(cube.low);
    const auto begins_here = [&](const Block& block, const FaceRecord& face) {
        return region_of(lowest_corner(block, face)) == wanted;
    };
    return show_faces(world.data(), all_facets(world.data()), cube, begins_here, visit);
}

}  // namespace firma
