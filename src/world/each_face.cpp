// SPDX-License-Identifier: MIT
// Faces of a world for a visitor: all, in a box, in a room, in a region.
#include <array>
#include <cmath>

#include "firma/world.h"
#include "index/box_tree.h"
#include "index/traverse.h"
#include "solid/region.h"
#include "world/block_faces.h"
#include "world/world_data.h"

namespace firma {
namespace {

/// Goes through the faces in bins that meet a box, and shows those that `wanted` takes.
template <class Wanted>
struct ShowFaces {
    const WorldData& data;
    const GridBox box;
    const Wanted& wanted;
    FaceVisitor visit;
    bool ended = false;

    bool enter(const Bin& bin, double& nearest) const {
        nearest = 0;
        const Vec3 low = to_metres(box.low), high = to_metres(box.high);
        for (int axis = 0; axis < 3; ++axis)
            if (high[axis] < double(bin.box.low[axis]) || low[axis] > double(bin.box.high[axis])) return false;
        return true;
    }
    bool still(double) const { return true; }
    bool facets(const IndexedFacets& facets, std::uint32_t first, std::uint32_t count) {
        const Block& block = as_block(facets);
        const RoomId room{data.cells.current_room(block.part)};
        for (std::uint32_t slot = first; slot < first + count; ++slot) {
            const FaceRecord& record = block.faces[slot];
            if (!wanted(block, record)) continue;
            const FaceShape shape(block, record);
            if (!shape.polygon.has_area()) continue;
            if (!visit({face_info(room, block, record, shape.polygon), shape.polygon.corners})) return ended = true;
        }
        return false;
    }
};

constexpr GridBox kWholeWorld{{INT32_MIN, INT32_MIN, INT32_MIN}, {INT32_MAX, INT32_MAX, INT32_MAX}};

template <class Wanted, class Roots>
bool show_faces(const WorldData& data, const Roots& roots, const GridBox& box, const Wanted& wanted,
                FaceVisitor visit) {
    ShowFaces<Wanted> show{data, box, wanted, visit};
    for (const Node* root : roots)
        if (root && !show.ended) traverse(*root, show);
    return !show.ended;
}

std::array<const Node*, 2> all_faces(const WorldData& data) {
    return {data.solid.data().faces.root.get(), data.castable.root.get()};
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
    return show_faces(world.data(), all_faces(world.data()), kWholeWorld, any, visit);
}

bool each_face(const World& world, const Box& box, FaceVisitor visit) {
    GridBox steps;
    if (!is_finite(box.low) || !is_finite(box.high)) return true;
    for (int axis = 0; axis < 3; ++axis)
        if (!steps_of(box.low[axis], box.high[axis], steps.low[axis], steps.high[axis])) return true;
    const auto meets = [&](const Block& block, const FaceRecord& face) {
        return boxes_meet(block.box_of(face), steps);
    };
    return show_faces(world.data(), all_faces(world.data()), steps, meets, visit);
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
    return show_faces(world.data(), all_faces(world.data()), cube, begins_here, visit);
}

}  // namespace firma
