// SPDX-License-Identifier: MIT
// The phases of a cut one by one, each from what it reads: a box through one wall of a room.
#include <gtest/gtest.h>

#include <algorithm>

#include "carve/cut_faces.h"
#include "carve/gather.h"
#include "carve/tile_faces.h"
#include "carve/trace_loops.h"
#include "firma/level.h"
#include "firma/solid.h"
#include "solid/solid_data.h"
#include "tests/carve/cutters.h"

namespace firma {
namespace {

using namespace test;

class CutPhases : public ::testing::Test {
protected:
    void place(const Vec3& low, const Vec3& high) {
        const Level level = read_obj(
                                "v -4 -4 -4\nv 4 -4 -4\nv 4 4 -4\nv -4 4 -4\nv -4 -4 4\nv 4 -4 4\nv 4 4 4\nv -4 4 4\n"
                                "f 1 2 3 4\nf 8 7 6 5\nf 5 6 2 1\nf 6 7 3 2\nf 7 8 4 3\nf 8 5 1 4\n",
                                "room")
                                .value();
        solid_ = make_solid(level).value();
        make_cutter_solid(place_cutter(box_mesh(low, high).cutter().value(), {}).value(), cutter_);
        std::vector<FacetPlace> facets;
        gather_facets(solid_.data().faces.root.get(), grown(cutter_.box, 2), facets);
        patch_.add(facets);
        for (std::uint32_t edge = 0; edge < patch_.edges.size(); ++edge) patch_.settle_planes(edge);
    }

    Verdict cut_all(FaceCutter& cutter) const {
        cutter.start();
        for (std::uint32_t face = 0; face < patch_.faces.size(); ++face)
            if (const Verdict verdict = cutter.cut_face(face); verdict != Verdict::kFine) return verdict;
        return Verdict::kFine;
    }

    Solid solid_;
    CutterSolid cutter_;
    SolidPatch patch_;
    CutInput input_{patch_, cutter_};
    PairBudget budget_;
};

TEST_F(CutPhases, EachFillsItsOwnAndMayRunAgain) {
    place({3.1, -1.2, -1.1}, {5.3, 1.3, 1.4});
    ASSERT_EQ(patch_.faces.size(), 1u);
    FaceCutter cutter(input_, budget_);
    CutOrder order;
    Labels labels;
    NewLoops loops;
    for (int round = 0; round < 2; ++round) {
        ASSERT_EQ(cut_all(cutter), Verdict::kFine);
        const Crossings& crossings = cutter.made();
        EXPECT_EQ(crossings.real.size(), 8u) << "four edges, and the diagonals of four sides";
        EXPECT_EQ(crossings.segments.size(), 8u);
        EXPECT_EQ(crossings.face_cut, std::vector<std::uint8_t>{1});

        ASSERT_EQ(order_cuts(input_, crossings, order), Verdict::kFine);
        EXPECT_EQ(order.along.size(), 8u);

        const auto never = [](std::uint32_t) { return CutSide::kUnknown; };
        ASSERT_EQ(label_vertices(input_, crossings, order, never, labels), Verdict::kFine);
        EXPECT_EQ(std::count(labels.world.begin(), labels.world.end(), CutSide::kOutside), 4);
        EXPECT_EQ(std::count(labels.cutter.begin(), labels.cutter.end(), CutSide::kInside), 4);
        EXPECT_EQ(std::count(labels.cutter.begin(), labels.cutter.end(), CutSide::kOutside), 4);

        ASSERT_EQ(trace_loops(input_, crossings, order, labels, loops), Verdict::kFine);
        EXPECT_EQ(loops.gone, std::vector<std::uint32_t>{0});
        ASSERT_EQ(loops.faces.size(), 6u) << "the wall, four sides, and the far one";
        EXPECT_EQ(loops.faces[0].loop_count, 2u) << "with a hole";
        EXPECT_TRUE(keep_pieces(patch_, loops.gone).pieces.empty());
    }
}

TEST_F(CutPhases, SayThatItTouches) {
    place({3.1, -1.2, -1.1}, {4, 1.3, 1.4});  // one side lies in the wall
    FaceCutter cutter(input_, budget_);
    EXPECT_EQ(cut_all(cutter), Verdict::kDegenerate);
}

}  // namespace
}  // namespace firma
