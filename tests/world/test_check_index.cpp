// SPDX-License-Identifier: MIT
// What check_world() finds wrong with indices: a box that is too small hides faces from casts, and so does all else
// that casts read in its place.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <map>
#include <string>

#include "firma/carve.h"
#include "firma/level.h"
#include "firma/queries.h"
#include "firma/save.h"
#include "scenes/grid_polygons.h"
#include "scenes/hub.h"
#include "tests/world/copied_node.h"
#include "world/sweep_lanes.h"
#include "world/world_data.h"

namespace firma {
namespace {

/// The nodes of indices once more, over the same blocks, each `change`d. One that several lead to stays one.
class ChangedNodes {
public:
    explicit ChangedNodes(std::function<void(Node&)> change) : change_(std::move(change)) {}

    Ref<const Node> of(const Ref<const Node>& node) {
        if (!node) return node;
        Ref<const Node>& made = made_[node.get()];
        if (!made) made = make(*node);
        return made;
    }

private:
    Ref<const Node> make(const Node& node) {
        PoolVector<Ref<const Node>> children;
        for (const Ref<const Node>& child : node.children) children.push_back(of(child));
        Ref<Node> made = test::copied_node(node, std::move(children));
        change_(*made);
        return Ref<const Node>(made.get());
    }

    std::function<void(Node&)> change_;
    std::map<const Node*, Ref<const Node>> made_;
};

/// The world with changed nodes in all of its indices, or in those of rooms alone.
World with_nodes(const World& world, const std::function<void(Node&)>& change, bool of_rooms_alone = false) {
    ChangedNodes changed(change);
    auto data = std::make_shared<WorldData>(world.data());
    if (!of_rooms_alone) {
        auto solid = std::make_shared<SolidData>(data->solid.data());
        solid->faces.root = changed.of(solid->faces.root);
        data->solid = Solid(std::move(solid));
        data->castable.root = changed.of(data->castable.root);
    }
    for (std::uint32_t room = 0; room < world.room_count(); ++room) {
        Ref<RoomFaces> faces(new RoomFaces);
        faces->count = data->faces_of(room).count;
        faces->hash = data->faces_of(room).hash;
        faces->tree = changed.of(data->faces_of(room).tree);
        data->set_room(room, data->cells.record(room), Ref<const RoomFaces>(faces.get()));
    }
    return World(std::move(data));
}

/// No file has an index: it is made anew.
void expect_found(const World& world, const std::string& what) {
    const std::optional<WorldFault> fault = check_world(world);
    ASSERT_TRUE(fault);
    EXPECT_EQ(fault->what, what);
    EXPECT_TRUE(unpack_world(pack_world(world), "a.firma").ok());
}

/// Faces of twelve corners: ten triangles each.
World rounded_faces() {
    std::vector<scenes::GridPolygon> faces;
    for (std::int64_t k = 0; k < 24; ++k) {
        std::vector<GridPoint>& face = faces.emplace_back();
        for (std::int64_t x = 0; x < 12; ++x)
            face.push_back(scenes::in_world({x * scenes::kMetre, x * x * scenes::kMetre / 4, k * scenes::kMetre}));
    }
    return make_world(scenes::level_of(faces)).value();
}

std::vector<World> worlds_to_spoil() {
    const World first = make_world(read_level(FIRMA_ROOT "/levels/first.obj").value()).value();
    const Cutter crater = make_crater(CutterShape::kRocky, 1);
    return {assemble_world(scenes::hub_parts({8, true})).value(), first, rounded_faces(),
            carve(first, crater, {.position = cast(first, {{35, 29, 2}, 0.5}, {0, 0, 10}).point, .scale = 0.5}).world};
}

TEST(CheckIndex, NodesHaveTheBoxesOfTheirFaces) {
    for (const World& world : worlds_to_spoil()) {
        for (std::uint32_t room = 0; room < world.room_count(); ++room)
            ASSERT_TRUE(world.data().faces_of(room).tree) << room;
        EXPECT_FALSE(check_world(with_nodes(world, [](Node&) {})));
        const char* const what = "an index block's box is not that around what it holds";
        expect_found(with_nodes(world, [](Node& node) { node.box.high = node.box.low; }), what);
        expect_found(with_nodes(world, [](Node& node) { ++node.box.low[2]; }), what);
        expect_found(with_nodes(world, [](Node& node) { ++node.box.high[1]; }), what);
    }
}

TEST(CheckIndex, RoomsHaveTheLeavesOfTheStores) {
    for (const World& world : worlds_to_spoil())
        expect_found(
            with_nodes(world, [](Node&) {}, true), "a block lies in no room, in several, or in another leaf there");
}

class CheckWideNodes : public testing::Test {
protected:
    /// Changes the first node that `change` says yes to; expects that this is found.
    /// @param of_a_face  whether the fault names a face
    void expect_found(const std::string& what, bool of_a_face, const std::function<bool(Node&)>& change) {
        std::size_t changed = 0;
        for (const World& world : worlds_) {
            bool done = false;
            const World spoiled = with_nodes(world, [&](Node& node) { done = done || change(node); });
            changed += done;
            const std::optional<WorldFault> fault = check_world(spoiled);
            ASSERT_EQ(fault.has_value(), done) << what << (fault ? ": " + fault->what : "");
            if (!fault) continue;
            EXPECT_EQ(fault->what, what);
            EXPECT_EQ(fault->face.valid(), of_a_face) << what;
            if (index_alone_) {
                EXPECT_TRUE(unpack_world(pack_world(spoiled), "a.firma").ok()) << what;
            }
        }
        EXPECT_GT(changed, 0u) << what;
    }
    void expect_items(const std::string& what, const std::function<bool(Node&, LaneItems&)>& change) {
        expect_found(what, false, [&](Node& node) {
            for (LaneItems& items : node.lane_items)
                if (change(node, items)) return true;
            return false;
        });
    }
    void expect_wide(const std::string& what, const std::function<bool(Node&, WideNode&)>& change) {
        expect_found(what, false, [&](Node& node) {
            for (WideNode& wide : node.wide)
                if (change(node, wide)) return true;
            return false;
        });
    }
    /// The same, of the lanes of a leaf.
    void expect_lanes(const std::string& what, bool of_a_face,
                      const std::function<bool(Node&, Block&, FaceLanes&)>& change) {
        expect_found(what, of_a_face, [&](Node& node) {
            if (!node.is_leaf()) return false;
            Block& block = test::own_block(node);
            for (FaceLanes& lanes : block.lanes)
                if (change(node, block, lanes)) return true;
            return false;
        });
    }

    const std::vector<World> worlds_ = worlds_to_spoil();
    bool index_alone_ = true;  ///< what is changed
};

TEST_F(CheckWideNodes, FindsFaults) {
    expect_found("an index block has no nodes", false, [](Node& node) {
        node.wide.clear();
        return true;
    });
    expect_found("an index block does not tell of each wide node what it leads to", false, [](Node& node) {
        node.lane_items.pop_back();
        return true;
    });
    for (const std::uint8_t count : {std::uint8_t(0), std::uint8_t(9)})
        expect_items("a wide node does not hold 1 to 8 boxes", [&](Node&, LaneItems& items) {
            items.count = count;
            return true;
        });
    for (const float side : {0.3f, NAN, HUGE_VALF, 8192.5f})
        expect_wide("a side of a wide node is no whole step", [&](Node&, WideNode& wide) {
            wide.side[1][1][0] = side;
            return true;
        });
    expect_wide("a side of a wide node is no whole step", [](Node&, WideNode& wide) {
        wide.side[0][2][0] = -HUGE_VALF;
        return true;
    });
    expect_wide("a wide node has boxes beyond those in use", [](Node& node, WideNode& wide) {
        const std::uint32_t count = node.items_of(wide).count;
        if (count == WideNode::kLanes) return false;
        wide.side[0][1][count] = wide.side[1][1][count] = 0;
        return true;
    });
    expect_wide("a wide node has boxes beyond those in use", [](Node& node, WideNode& wide) {
        const std::uint32_t count = node.items_of(wide).count;
        if (count == WideNode::kLanes) return false;
        wide.lead_to(count, &wide);
        return true;
    });
    expect_wide("a wide node leads backward", [](Node& node, WideNode& wide) {
        if (wide.leads_to_facets(0) || node.leads_to_node(wide, 0)) return false;
        wide.lead_to(0, &wide);
        return true;
    });
    expect_wide("a wide node leads to nothing of its index block", [](Node& node, WideNode& wide) {
        if (wide.leads_to_facets(0) || node.is_leaf()) return false;
        wide.below[0] = reinterpret_cast<std::uintptr_t>(&node);
        return true;
    });
    expect_wide("a wide node leads to faces from above index blocks", [](Node& node, WideNode& wide) {
        if (node.is_leaf()) return false;
        wide.lead_to_facets(0, nullptr);
        return true;
    });
    expect_items("a wide node's boxes do not hold an item and more each", [](Node&, LaneItems& items) {
        if (items.count < 2) return false;
        --items.count;
        return true;
    });
    expect_items("a wide node's boxes do not hold an item and more each", [](Node&, LaneItems& items) {
        if (items.count < 2) return false;
        items.first[1] = items.first[0];
        return true;
    });
    expect_items("an item is not in exactly one wide node", [](Node&, LaneItems& items) {
        if (items.items(0) < 2) return false;
        ++items.first[0];
        return true;
    });
    expect_wide("a wide node leads to faces that are not there", [](Node& node, WideNode& wide) {
        LaneItems& items = node.lane_items[std::size_t(&wide - node.wide.data())];
        if (!node.is_leaf() || items.count == WideNode::kLanes || !wide.leads_to_facets(items.count - 1u)) return false;
        for (std::uint32_t lane = items.count; lane <= WideNode::kLanes; ++lane) items.first[lane] = 200;
        return true;
    });
    expect_wide("an index block reaches out of its wide node", [](Node& node, WideNode& wide) {
        if (node.is_leaf() || wide.wide(0) != node.children[0]->wide.data()) return false;
        wide.side[1][0][0] = wide.side[0][0][0];
        return true;
    });
    expect_wide("a wide node is not led to exactly once", [](Node& node, WideNode& wide) {
        for (std::uint32_t lane = 0; lane + 1u < node.items_of(wide).count; ++lane)
            for (const WideNode& below : node.wide)
                if (wide.wide(lane) == &below && !wide.leads_to_facets(lane + 1) &&
                    !node.leads_to_node(wide, lane + 1)) {
                    wide.lead_to(lane + 1, &below);
                    return true;
                }
        return false;
    });
}

/// Also where the box is that of a wide node above the one that leads to the face.
TEST_F(CheckWideNodes, FindsFaultsOfBoxesAroundFaces) {
    expect_found("a face reaches out of its wide node", true, [](Node& node) {
        for (WideNode& wide : node.wide)
            for (std::uint32_t lane = 0; lane < node.items_of(wide).count; ++lane)
                if (node.is_leaf() && !wide.leads_to_facets(lane)) {
                    wide.side[0][2][lane] = 8192;
                    wide.side[1][2][lane] = -8192;
                    return true;
                }
        return false;
    });
    for (int which = 0; which < 2; ++which)
        for (int axis = 0; axis < 3; ++axis)
            expect_found("a face reaches out of its wide node", true, [&](Node& node) {
                for (WideNode& wide : node.wide)
                    for (std::uint32_t lane = 0; lane < WideNode::kLanes; ++lane) {
                        if (!wide.leads_to_facets(lane) || wide.side[0][axis][lane] == wide.side[1][axis][lane])
                            continue;
                        wide.side[which][axis][lane] = wide.side[1 - which][axis][lane];
                        return true;
                    }
                return false;
            });
}

TEST_F(CheckWideNodes, FindsFaultsOfLanes) {
    expect_lanes("a wide node leads out of its lanes", false, [](Node&, Block& block, FaceLanes& lanes) {
        if (&lanes + lanes.in_a_row() != block.lanes.data() + block.lanes.size()) return false;
        lanes.uneven_high |= FaceLanes::kMore;
        return true;
    });
    expect_wide("a wide node leads out of its lanes", [](Node&, WideNode& wide) {
        if (!wide.leads_to_facets(0)) return false;
        wide.below[0] += 8;
        return true;
    });
    index_alone_ = false;  // faces have their corners in lanes
    expect_lanes("lanes name another block than theirs", false, [](Node&, Block&, FaceLanes& lanes) {
        lanes.block = nullptr;
        return true;
    });
    expect_lanes("lanes name another block than theirs", false, [](Node&, Block& block, FaceLanes& lanes) {
        lanes.faces = block.faces.data() + 1;
        return true;
    });
    expect_lanes("a step of lanes is not a power of two", false, [](Node&, Block&, FaceLanes& lanes) {
        lanes.step *= 3;
        return true;
    });
    expect_lanes("lanes lack their second half", false, [](Node&, Block& block, FaceLanes& lanes) {
        if (&lanes != &block.lanes.back() || lanes.is_wide()) return false;
        lanes.packed |= FaceLanes::kWide;
        return true;
    });
    expect_lanes("a lane names a face that does not lie there", false, [](Node&, Block&, FaceLanes& lanes) {
        lanes.packed ^= 63u << FaceLanes::kFirstSlot;
        return true;
    });
    expect_lanes("lanes hold fewer triangles than their face", true, [](Node&, Block& block, FaceLanes& lanes) {
        if (&lanes != &block.lanes.back() || lanes.is_wide() || lanes.count() == 1) return false;
        lanes.packed -= 1u << FaceLanes::kCount;
        return true;
    });
    expect_lanes("lanes hold more triangles than their face", true, [](Node&, Block& block, FaceLanes& lanes) {
        // The last one is repeated in lanes that are not in use.
        if (&lanes != &block.lanes.back() || lanes.is_wide() || lanes.count() == 8) return false;
        lanes.packed += 1u << FaceLanes::kCount;
        return true;
    });
    expect_lanes("lanes hold fewer triangles than their face", true, [](Node&, Block& block, FaceLanes& lanes) {
        // The next face of the same number of corners is taken for the first one once more.
        if (lanes.count() < 2 || lanes.slot(0) == lanes.slot(1) || block.faces[lanes.slot(0)].corner_count != 3)
            return false;
        lanes.packed &= ~7u;  // of the second lane
        return true;
    });
    for (const int corner : {0, 1})
        expect_lanes("a lane has another triangle than its face", true, [&](Node&, Block&, FaceLanes& lanes) {
            if (lanes.is_wide() || lanes.count() < 2 || lanes.slot(0) != lanes.slot(1)) return false;
            ++lanes.corner[corner][1][1];
            return true;
        });
    expect_found("a face has corners that are not there", true, [](Node& node) {
        if (node.is_leaf()) test::own_block(node).faces[0].first_lane = 0x3FFF;
        return node.is_leaf();
    });
    expect_found("a face has corners that are not there", true, [](Node& node) {
        if (node.is_leaf()) test::own_block(node).faces[0].corner_count = 2;
        return node.is_leaf();
    });
    index_alone_ = true;
    expect_lanes("a lane's corner is farther than its lanes say", true, [](Node&, Block&, FaceLanes& lanes) {
        lanes.size = 0;
        return true;
    });
    expect_lanes("a lane's corner is shifted more than its lanes say", true, [](Node&, Block& block, FaceLanes& lanes) {
        if (block.faces[lanes.slot(0)].corner_count == 3 || lanes.is_wide()) return false;
        lanes.packed &= ~FaceLanes::kFans;
        return true;
    });
    expect_lanes("a face is less even than its lanes say", true, [](Node&, Block& block, FaceLanes& lanes) {
        if (block.faces[lanes.slot(0)].corner_count == 3) return false;
        lanes.uneven_high |= 0x7FC0;  // not a number
        return true;
    });
    expect_lanes("a lane says it is exact and is not", true, [](Node&, Block& block, FaceLanes& lanes) {
        if (block.faces[lanes.slot(0)].corner_count == 3) return false;
        lanes.whole |= 1;
        return true;
    });
    expect_lanes("a lane says which sides its face has, and is wrong", true, [](Node&, Block&, FaceLanes& lanes) {
        lanes.two_sided ^= 1;
        return true;
    });
    expect_lanes("a lane names a face that does not lie there", false, [](Node& node, Block&, FaceLanes& lanes) {
        // Of two groups next to each other one ends earlier, and the other begins there.
        if (!lanes.more_follow() || lanes.is_wide()) return false;
        FaceLanes& second = (&lanes)[1];
        if (second.more_follow() || second.is_wide() || second.slot(0) != lanes.slot(7)) return false;
        for (WideNode& wide : node.wide)
            for (std::uint32_t k = 0; k < WideNode::kLanes; ++k)
                if (wide.leads_to_facets(k) && wide.facets(k) == &second + 1) {
                    wide.lead_to_facets(k, &second);
                    lanes.uneven_high &= std::uint16_t(~FaceLanes::kMore);
                    second.uneven_high |= FaceLanes::kMore;
                    return true;
                }
        return false;
    });
    index_alone_ = false;
    expect_lanes("lanes have bits in their mask that a face has not", true, [](Node&, Block& block, FaceLanes& lanes) {
        block.faces[lanes.slot(0)].mask = 1;
        return true;
    });
    expect_lanes("faces below a lane do not lie by rising ids", true, [](Node&, Block& block, FaceLanes& lanes) {
        const std::uint32_t first = lanes.slot(0), last = lanes.slot(lanes.count() - 1);
        std::swap(block.faces[first].id, block.faces[last].id);
        return first != last;
    });
    expect_lanes("a block has bits in its mask that a face has not", true, [](Node&, Block& block, FaceLanes&) {
        block.faces[0].mask = 1;
        for (FaceLanes& lanes : block.lanes) lanes.mask_of_all = 1;
        return true;
    });
}

}  // namespace
}  // namespace firma
