// SPDX-License-Identifier: MIT
// Facets in a tree: what they were cut from is kept alive, and shows in hits.
#include <gtest/gtest.h>

#include "firma/queries.h"
#include "firma/world.h"
#include "world/assemble_world.h"

namespace firma {
namespace {

class CountedOwner : public FaceOwner {
public:
    explicit CountedOwner(int& alive) : alive_(alive) { ++alive_; }
    ~CountedOwner() override { --alive_; }
    std::size_t bytes() const override { return sizeof(*this); }

private:
    int& alive_;
};

constexpr std::int32_t kMetre = std::int32_t(kSurfaceSteps);

/// Squares on the ground, one a metre; even ones belong to `owner`, every third of the others is solid.
FaceSet squares(std::uint32_t count, const Ref<const FaceOwner>& owner) {
    FaceSet set;
    set.owners.push_back(owner);
    for (std::uint32_t k = 0; k < count; ++k) {
        const std::int32_t x = std::int32_t(k) * kMetre;
        FaceSet::Entry face;
        face.id = {k};
        face.source = 5;
        face.edit = k % 2;
        face.solid = k % 6 == 3;
        face.first_corner = std::uint32_t(set.corners.size());
        face.corner_count = 4;
        face.owner = k % 2 == 0 ? owner.get() : nullptr;
        for (const GridPoint p : {GridPoint{x, 0, 0}, {x + kMetre, 0, 0}, {x + kMetre, kMetre, 0}, {x, kMetre, 0}}) {
            set.corners.push_back(std::uint32_t(set.vertices.size()));
            set.vertices.push_back(p);
        }
        set.faces.push_back(face);
    }
    return set;
}

World world_with(FaceSet squares) {
    WorldParts parts;
    parts.rooms.resize(1);
    parts.rooms[0].faces = std::move(squares);
    parts.materials.resize(1);
    return assemble_world(std::move(parts)).value();
}

TEST(FaceOwners, LiveAsLongAsABlockHoldsAFacetOfTheirs) {
    int alive = 0;
    {
        World world;
        {
            Ref<CountedOwner> owner(new CountedOwner(alive));
            owner->normal = {0, 0, 1};
            world = world_with(squares(200, Ref<const FaceOwner>(owner.get())));
        }
        EXPECT_EQ(alive, 1);
        EXPECT_FALSE(check_world(world));
        const World copy = world;
        world = World();
        EXPECT_EQ(alive, 1);
        world = rebuild_index(copy, {.faces_per_leaf = 1});
        EXPECT_EQ(world.face_count(), 200u);
        EXPECT_EQ(alive, 1) << "new blocks keep the same one";
    }
    EXPECT_EQ(alive, 0);
}

TEST(FaceOwners, GiveTheFaceNormalAndNothingElse) {
    int alive = 0;
    Ref<CountedOwner> owner(new CountedOwner(alive));
    const Vec3 exact = Vec3{1e-6, 0, 1} * (1 / length(Vec3{1e-6, 0, 1}));
    owner->normal = exact;
    const World world = world_with(squares(200, Ref<const FaceOwner>(owner.get())));
    const Hit owned = cast(world, {{100.5, 0.5, 1}, 0.25}, {0, 0, -2});
    ASSERT_EQ(owned.face.id, (FaceId{100}));
    EXPECT_EQ(owned.face_normal, exact);
    EXPECT_EQ(owned.normal, (Vec3{0, 0, 1})) << "of the contact: the facet's own";
    EXPECT_EQ(world.face_info(owned.face)->source_edit, 0u);
    EXPECT_EQ(world.face(owned.face)->normal, exact);
    const Hit own = cast(world, {{99.5, 0.5, 1}, 0.25}, {0, 0, -2});
    ASSERT_EQ(own.face.id, (FaceId{99}));
    EXPECT_EQ(own.face_normal, (Vec3{0, 0, 1}));
    EXPECT_EQ(world.face(own.face)->source, 5u);
    EXPECT_TRUE(world.face(own.face)->solid);
    EXPECT_EQ(world.face(own.face)->source_edit, 1u);
    EXPECT_FALSE(world.face(owned.face)->solid);
    EXPECT_EQ(world.face_info(closest(world, {99.5, 0.5, 1}).face)->source_edit, 1u);
}

}  // namespace
}  // namespace firma
