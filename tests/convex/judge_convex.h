// SPDX-License-Identifier: MIT
// Whether convex pieces are convex, the whole, and none over another: by brute force, in exact arithmetic.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <vector>

#include "firma/convex_pieces.h"
#include "firma/fracture.h"
#include "scenes/rng.h"
#include "solid/boundary.h"
#include "solid/measure_boundary.h"
#include "solid/solid_data.h"
#include "tests/reference/carve_oracle.h"

namespace firma::test {

/// The exact boundary of a piece: its planes and corners.
struct JudgedPiece {
    Boundary boundary;
    std::vector<const Plane*> planes;

    explicit JudgedPiece(const Solid& solid) : boundary(take_boundary(solid.data().faces.root.get())) {
        for (const PatchFace& face : boundary.patch.faces) planes.push_back(&face.plane->plane);
    }
    /// The most in front of a plane that any corner lies, as a sign; by integers alone.
    [[nodiscard]] int highest(const Plane& plane) const {
        int most = -1;
        for (const PatchVertex& vertex : boundary.patch.vertices)
            most = std::max(most, exact_side_by_integers(plane, vertex.point));
        return most;
    }
    [[nodiscard]] int lowest(const Plane& plane) const {
        int least = 1;
        for (const PatchVertex& vertex : boundary.patch.vertices)
            least = std::min(least, exact_side_by_integers(plane, vertex.point));
        return least;
    }
    /// 1 strictly inside, 0 on its surface, -1 outside.
    [[nodiscard]] int holds(const ExactPoint& point) const {
        int least = 1;
        for (const Plane* plane : planes) least = std::min(least, -exact_side_by_integers(*plane, point));
        return least;
    }
};

/// All corners of each behind or on each of its planes, its surface sound, its numbers its own.
inline void expect_convex(const ConvexBody& piece, const JudgedPiece& judged) {
    const std::optional<SolidFault> fault = check_solid(piece.solid);
    EXPECT_FALSE(fault) << fault->what;
    for (const Plane* plane : judged.planes) EXPECT_LE(judged.highest(*plane), 0);
    EXPECT_GT(piece.mass.volume, 0);
    EXPECT_EQ(piece.overhang, 0);
    EXPECT_GE(piece.corners.size(), 3u);
    for (const ConvexFace& face : piece.faces) {
        EXPECT_NEAR(length(face.normal), 1, 1e-12);
        ASSERT_GE(face.count, 3u);
        ASSERT_LE(std::size_t(face.first) + face.count, piece.loops.size());
        for (const Vec3& corner : piece.corners) EXPECT_LE(dot(face.normal, corner) - face.offset, 3.4e-6);
        Vec3 area;
        for (std::uint32_t k = 0; k < face.count; ++k) {
            const Vec3& corner = piece.corners.at(piece.loops[face.first + k]);
            EXPECT_NEAR(dot(face.normal, corner), face.offset, 3.4e-6);
            area += cross(corner, piece.corners.at(piece.loops[face.first + (k + 1) % face.count]));
        }
        // A needle's may be folded over by rounding.
        EXPECT_GT(dot(area, face.normal), -1e-5);
    }
    EXPECT_NEAR(piece.hull_volume, piece.mass.volume, 4e-6 * std::max(measure_solid(piece.solid).area, 1e-9));
}

/// Whether a plane of either has them on different sides, or any of `others` has.
inline bool separated(const JudgedPiece& a, const JudgedPiece& b, const std::vector<const Plane*>& others) {
    for (const Plane* plane : a.planes)
        if (b.lowest(*plane) >= 0) return true;
    for (const Plane* plane : b.planes)
        if (a.lowest(*plane) >= 0) return true;
    for (const Plane* plane : others)
        if ((a.highest(*plane) <= 0 && b.lowest(*plane) >= 0) || (b.highest(*plane) <= 0 && a.lowest(*plane) >= 0))
            return true;
    return false;
}

/// Volumes as sums of 100 bits.
inline void expect_volumes(const Solid& whole, const std::vector<JudgedPiece>& pieces) {
    const Boundary boundary = take_boundary(whole.data().faces.root.get());
    DoubleDouble sum = -measure_boundary(boundary).volume;
    double size = std::fabs(sum.high);
    for (const JudgedPiece& piece : pieces) {
        const DoubleDouble volume = measure_boundary(piece.boundary).volume;
        sum = sum + volume;
        size += std::fabs(volume.high);
    }
    // Each is off by some last bits of 106, and so is each sum, of what cones come to from a point in the middle.
    EXPECT_LE(std::fabs(sum.high), size * double(pieces.size() + 1) * 0x1p-92);
}

struct ConvexJudgement {
    std::size_t pairs = 0;   ///< of pieces whose boxes meet
    std::size_t by_cut = 0;  ///< of these, which no plane of the solid has on different sides
    std::size_t inside = 0;  ///< points tried that lie in the whole
    std::size_t outside = 0;
};

/// All pieces exact: they are the whole.
inline void expect_convex_pieces(const Solid& whole, const ConvexPieces& result, ConvexJudgement& judgement,
                                 std::uint64_t seed = 1, int points = 60) {
    std::vector<JudgedPiece> pieces;
    std::vector<const Plane*> planes;
    std::vector<Box> boxes;
    ASSERT_EQ(result.exact, result.pieces.size());
    for (const ConvexBody& piece : result.pieces) {
        pieces.emplace_back(piece.solid);
        boxes.push_back(piece.solid.bounds());
        expect_convex(piece, pieces.back());
    }
    const JudgedPiece of_whole(whole);
    planes = of_whole.planes;
    expect_volumes(whole, pieces);
    for (std::size_t a = 0; a < pieces.size(); ++a)
        for (std::size_t b = a + 1; b < pieces.size(); ++b) {
            bool apart = false;
            for (int axis = 0; axis < 3; ++axis)
                apart = apart || boxes[a].high[axis] < boxes[b].low[axis] || boxes[b].high[axis] < boxes[a].low[axis];
            if (apart) continue;
            ++judgement.pairs;
            if (separated(pieces[a], pieces[b], planes)) continue;
            ++judgement.by_cut;
            const Cutter cutter = cutter_from_solid(result.pieces[b].solid).value();
            EXPECT_EQ(subtract(result.pieces[a].solid, cutter, {}).status, CarveStatus::kNothing);
        }
    scenes::Rng rng(seed);
    const Box box = whole.bounds();
    for (int k = 0; k < points; ++k) {
        Vec3 at;
        for (int axis = 0; axis < 3; ++axis) at[axis] = rng.uniform(box.low[axis], box.high[axis]);
        const std::optional<GridPoint> snapped = snap(at);
        if (!snapped) continue;
        const ExactPoint point(to_input(*snapped));
        const double winding = reference::winding(of_whole.boundary.facets, to_metres(*snapped));
        std::size_t within = 0, on = 0;
        for (const JudgedPiece& piece : pieces) {
            const int holds = piece.holds(point);
            within += holds > 0;
            on += holds == 0;
        }
        EXPECT_LE(within, 1u);
        EXPECT_TRUE(within == 0 || on == 0);
        if (std::fabs(winding - 0.5) < 0.4) continue;  // on the surface, or as near as rounding leaves open
        if (winding > 0.5)
            EXPECT_GE(within + on, 1u);
        else
            EXPECT_EQ(within, 0u);
        ++(winding > 0.5 ? judgement.inside : judgement.outside);
    }
}

/// All of them united are the whole, by another exact way.
inline void expect_union(const Solid& whole, const ConvexPieces& result) {
    Solid united;
    for (const ConvexBody& piece : result.pieces) {
        const SolidResult more = unite(united, cutter_from_solid(piece.solid).value(), {});
        ASSERT_TRUE(more.done()) << more.error.reason;
        united = more.solid;
    }
    EXPECT_TRUE(same_solid(united, whole));
}

inline std::uint64_t hash_of(const ConvexPieces& result) {
    std::uint64_t hash = result.pieces.size();
    const auto add = [&](double value) {
        std::uint64_t bits = 0;
        std::memcpy(&bits, &value, sizeof bits);
        hash = (hash ^ bits) * 0x9E3779B97F4A7C15u + (hash >> 31);
    };
    for (const ConvexBody& piece : result.pieces) {
        add(double(piece.exact ? hash_solid(piece.solid) >> 12 : 1));
        for (const Vec3& corner : piece.corners)
            for (int axis = 0; axis < 3; ++axis) add(corner[axis]);
        for (const std::uint32_t corner : piece.loops) add(corner);
        for (const double value : {piece.mass.volume, piece.mass.mass, piece.mass.centre.x, piece.mass.inertia[0].y,
                                   piece.hull_volume, piece.overhang})
            add(value);
    }
    return hash;
}

}  // namespace firma::test
