// SPDX-License-Identifier: MIT
// Sound solids pass; each way to break one is named.
#include "solid/check_boundary.h"

#include <gtest/gtest.h>

#include <array>

#include "tests/solid/solid_levels.h"

namespace firma {
namespace {

using test::Parts;

World cut(const World& world, CutterShape shape, const Pose& pose) {
    const CarveResult result = carve(world, make_crater(shape, 3), pose);
    EXPECT_EQ(result.status, CarveStatus::kDone) << result.error.reason;
    return result.world;
}

/// A block of rock with a pit in its lid, which has a hole now.
const World& pitted() {
    static const World world = cut(make_world(test::box_level({-3, -3, -3}, {3, 3, 3})).value(), CutterShape::kBox,
                                   {.position = {0.1, 0.2, 3.05}});
    return world;
}

std::string fault_of(const World& world) {
    const std::optional<SolidFault> fault = check_solid(world);
    return fault ? fault->what : "";
}
/// Without a world around them, which would hash what is broken.
std::string fault_of(const Parts& parts) {
    const FaceStore store = parts.store();
    const std::optional<SolidFault> fault = check_boundary(take_boundary(store.root.get()));
    return fault ? fault->what : "";
}

TEST(CheckBoundary, SoundSolidsPass) {
    EXPECT_EQ(fault_of(World()), "");
    EXPECT_EQ(fault_of(pitted()), "");
    EXPECT_EQ(fault_of(Parts(pitted())), "") << "taken apart and put together";
    World world = make_world(test::box_level({-20, -20, -20}, {20, 20, 20}, true)).value();
    EXPECT_EQ(fault_of(world), "");
    for (int k = 0; k < 12; ++k) {
        const Vec3 at{k - 5.5, k % 3 * 2.0, -19.8};
        world = cut(world, k % 2 ? CutterShape::kRocky : CutterShape::kSpiky,
                    {.position = at, .rotation = random_turn(std::uint64_t(k)), .scale = 1.3});
        ASSERT_EQ(fault_of(world), "") << k;
    }
}

TEST(CheckBoundary, FacesThatAreNotThere) {
    Parts parts(pitted());
    const FaceId gone = parts.untouched().id;
    std::erase_if(parts.set.faces, [&](const auto& entry) { return entry.id == gone; });
    const std::optional<SolidFault> fault = check_solid(parts.world());
    ASSERT_TRUE(fault);
    EXPECT_EQ(fault->what, "an edge is used once");
    for (int axis = 0; axis < 3; ++axis) EXPECT_EQ(std::fabs(fault->at[axis]), 3) << "a corner of the block";
    EXPECT_TRUE(fault->face.valid());
}

TEST(CheckBoundary, FacesTurnedOver) {
    Parts parts(pitted());
    const FaceSet::Entry& entry = parts.untouched();
    std::reverse(parts.set.corners.begin() + entry.first_corner,
                 parts.set.corners.begin() + entry.first_corner + entry.corner_count);
    EXPECT_EQ(fault_of(parts), "an edge is not used exactly once each way");
}

TEST(CheckBoundary, FacesThereTwice) {
    Parts parts(pitted());
    FaceSet::Entry again = parts.untouched();
    again.id = {parts.from.data().next_face()};
    parts.set.faces.push_back(again);
    EXPECT_EQ(fault_of(parts), "an edge is not used exactly once each way");
}

TEST(CheckBoundary, FacetsThatAreMissingOrOverMuch) {
    Parts parts(pitted());
    SolidFace& face = parts.with_holes(true);
    ++face.facets;
    EXPECT_EQ(fault_of(parts), "a face has not the facets that it counts");
    --face.facets;
    EXPECT_EQ(fault_of(parts), "");
    const FaceId gone = parts.facet_of(face).id;
    std::erase_if(parts.set.faces, [&](const auto& entry) { return entry.id == gone; });
    EXPECT_EQ(fault_of(parts), "a face has not the facets that it counts");
    --face.facets;
    EXPECT_EQ(fault_of(parts), "facets do not cover their face");
}

TEST(CheckBoundary, FacetsElsewhere) {
    Parts parts(pitted());
    const FaceSet::Entry& facet = parts.facet_of(parts.with_holes(false));
    GridPoint moved = parts.set.vertices[parts.set.corners[facet.first_corner]];
    ++moved.y;
    parts.set.corners[facet.first_corner] = std::uint32_t(parts.set.vertices.size());
    parts.set.vertices.push_back(moved);
    EXPECT_EQ(fault_of(parts), "a facet's corner is no rounded vertex of its face");
}

TEST(CheckBoundary, FacetsTurnedOver) {
    Parts parts(pitted());
    const FaceSet::Entry& facet = parts.facet_of(parts.with_holes(true));
    std::reverse(parts.set.corners.begin() + facet.first_corner,
                 parts.set.corners.begin() + facet.first_corner + facet.corner_count);
    EXPECT_EQ(fault_of(parts), "facets do not cover their face");
}

TEST(CheckBoundary, LoopsThatDoNotClose) {
    Parts parts(pitted());
    SolidFace& face = parts.with_holes(false);
    std::swap(face.uses[0], face.uses[1]);
    EXPECT_EQ(fault_of(parts), "a loop is open");
    face.uses.resize(2);
    face.set_loop_ends(std::array{2u});
    EXPECT_EQ(fault_of(parts), "a loop of fewer than three edges");
    face.set_loop_ends({});
    EXPECT_EQ(fault_of(parts), "a face without loops");
}

void turn_over(SolidFace& face, std::uint32_t first, std::uint32_t end) {
    std::reverse(face.uses.begin() + first, face.uses.begin() + end);
    for (std::uint32_t k = first; k < end; ++k)
        face.uses[k] = SolidUse(Ref<const SolidEdge>(&face.uses[k].edge()), !face.uses[k].reversed());
}

TEST(CheckBoundary, LoopsTheWrongWayAround) {
    Parts parts(pitted());
    SolidFace& face = parts.with_holes(true);
    turn_over(face, face.loop_ends()[0], face.loop_ends()[1]);
    EXPECT_EQ(fault_of(parts), "a hole runs the same way as the outer loop");
    turn_over(face, face.loop_ends()[0], face.loop_ends()[1]);
    const std::uint32_t outer = face.loop_ends()[0], all = face.loop_ends()[1];
    std::rotate(face.uses.begin(), face.uses.begin() + outer, face.uses.end());
    face.set_loop_ends(std::array{all - outer, all});
    EXPECT_EQ(fault_of(parts), "the outer loop runs against the normal") << "the hole came first";
}

TEST(CheckBoundary, PlanesThatAreWrong) {
    Parts parts(pitted());
    SolidFace& face = parts.with_holes(true);
    const Ref<const SolidPlane> right = face.plane;
    face.plane = Ref<const SolidPlane>(new SolidPlane(flipped(right->plane)));
    EXPECT_EQ(fault_of(parts), "the outer loop runs against the normal");
    Plane moved = right->plane;
    moved.set_offset(moved.offset() + 1);
    moved.d += 1;
    face.plane = Ref<const SolidPlane>(new SolidPlane(moved));
    EXPECT_EQ(fault_of(parts), "a vertex lies off the plane of its face");
    face.plane = Ref<const SolidPlane>();
    EXPECT_EQ(fault_of(parts), "a face without a plane");
    face.plane = right;
    face.normal = -face.normal;
    EXPECT_EQ(fault_of(parts), "a face's normal points into the solid");
    face.normal = -face.normal;
    face.box.high.x -= 1;
    EXPECT_EQ(fault_of(parts), "a face reaches out of its box");
    face.box.high.x += 1;
    EXPECT_EQ(fault_of(parts), "");
}

TEST(CheckBoundary, VerticesOfTheirOwn) {
    Parts parts(pitted());
    SolidFace& face = parts.with_holes(true);
    const SolidEdge& old = face.uses.back().edge();  // of the hole
    Ref<SolidEdge> copy(new SolidEdge);
    for (int k = 0; k < 2; ++k) {
        copy->vertex[k] = old.vertex[k];
        copy->plane[k] = old.plane[k];
    }
    face.uses.back() = SolidUse(Ref<const SolidEdge>(copy.get()), face.uses.back().reversed());
    EXPECT_EQ(fault_of(parts), "an edge is used once") << "neighbours know each other by the object";
    Ref<const SolidPlane> planes[3];
    for (int k = 0; k < 3; ++k) planes[k] = Ref<const SolidPlane>(old.vertex[0]->plane(k));
    copy->vertex[0] = Ref<const SolidVertex>(new SolidVertex(old.vertex[0]->point, planes));
    EXPECT_EQ(fault_of(parts), "an edge is used once") << "vertices by where they lie: no loop is open";
}

/// A copy of an edge of the hole, in both of its faces.
SolidEdge& replace_edge(Parts& parts) {
    const Ref<const SolidEdge> old(&parts.with_holes(true).uses.back().edge());
    Ref<SolidEdge> copy(new SolidEdge);
    for (int k = 0; k < 2; ++k) {
        copy->vertex[k] = old->vertex[k];
        copy->plane[k] = old->plane[k];
    }
    for (Ref<SolidFace>& face : parts.faces)
        for (SolidUse& use : face->uses)
            if (&use.edge() == old.get()) use = SolidUse(Ref<const SolidEdge>(copy.get()), use.reversed());
    return *copy;  // the faces hold it
}

TEST(CheckBoundary, EdgePlanesThatAreWrong) {
    Parts parts(pitted());
    SolidEdge& edge = replace_edge(parts);
    EXPECT_EQ(fault_of(parts), "");
    const Ref<const SolidPlane> right = edge.plane[1];
    edge.plane[1] = Ref<const SolidPlane>(new SolidPlane(flipped(edge.plane[0]->plane)));
    EXPECT_EQ(fault_of(parts), "an edge's two planes are parallel");
    Plane moved = right->plane;
    moved.set_offset(moved.offset() + 1);
    moved.d += 1;
    edge.plane[1] = Ref<const SolidPlane>(new SolidPlane(moved));
    EXPECT_EQ(fault_of(parts), "an edge's plane does not hold its vertex");
    edge.plane[1] = Ref<const SolidPlane>();
    EXPECT_EQ(fault_of(parts), "an edge lacks a plane");
}

TEST(CheckBoundary, UntouchedFacesLieOnTheInputGrid) {
    Parts parts(pitted());
    parts.set.vertices[parts.set.corners[parts.untouched().first_corner]].x += 1;
    EXPECT_EQ(fault_of(parts), "a face that no cut touched has a corner off the input grid");
}

}  // namespace
}  // namespace firma
