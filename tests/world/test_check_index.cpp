// SPDX-License-Identifier: MIT
// What check_world() finds wrong with indices: a box that is too small hides faces from casts.
#include <gtest/gtest.h>

#include "firma/level.h"
#include "firma/save.h"
#include "scenes/hub.h"
#include "world/world_data.h"

namespace firma {
namespace {

/// The same nodes over the same blocks, each box `change`d.
template <class Change>
Ref<const Node> with_boxes(const Node& node, const Change& change) {
    Ref<Node> made(new Node);
    made->facets_below = node.facets_below;
    made->depth = node.depth;
    made->facets = node.facets;
    made->bins = node.bins;
    for (Bin& bin : made->bins) change(bin.box);
    for (const Ref<const Node>& child : node.children) made->children.push_back(with_boxes(*child, change));
    return Ref<const Node>(made.get());
}

/// A room given an index of its own over its faces.
template <class Change>
World with_index(const World& world, std::uint32_t room, const Change& change) {
    auto data = std::make_shared<WorldData>(world.data());
    Ref<RoomFaces> faces(new RoomFaces);
    faces->count = data->faces_of(room).count;
    faces->hash = data->faces_of(room).hash;
    faces->tree = with_boxes(*data->faces_of(room).tree, change);
    data->set_room(room, data->cells.record(room), Ref<const RoomFaces>(faces.get()));
    return World(std::move(data));
}

void expect_found_and_refused(const World& world, const std::string& what) {
    const std::optional<WorldFault> fault = check_world(world);
    ASSERT_TRUE(fault);
    EXPECT_EQ(fault->what, what);
    const Result<World> read = unpack_world(pack_world(world), "a.firma");
    ASSERT_FALSE(read.ok());
    EXPECT_NE(read.error().text().find(what), std::string::npos) << read.error().text();
}

TEST(CheckIndex, BoxesOfARoomHoldItsFaces) {
    for (const World& world : {assemble_world(scenes::hub_parts({8, true})).value(),
                               make_world(read_level(FIRMA_ROOT "/levels/first.obj").value()).value()}) {
        for (std::uint32_t room = 0; room < world.room_count(); ++room) {
            ASSERT_TRUE(world.data().faces_of(room).tree);
            EXPECT_FALSE(check_world(with_index(world, room, [](BoxF&) {})));
            const auto points = [](BoxF& box) {
                for (int axis = 0; axis < 3; ++axis) box.high[axis] = box.low[axis] = 0;
            };
            expect_found_and_refused(with_index(world, room, points), "a face reaches out of its leaf");
            const auto higher = [](BoxF& box) {
                box.low[2] += 1;
                box.high[2] += 1;
            };
            expect_found_and_refused(with_index(world, room, higher), "a face reaches out of its leaf");
        }
    }
}

}  // namespace
}  // namespace firma
