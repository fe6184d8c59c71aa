// SPDX-License-Identifier: MIT
// One polygon and one moving capsule, exactly: a ball against the surface of the sum of the polygon and the turned
// segment, given as polygons.
//
// With A and B the ends of the segment and s = B - A, the capsule touches the polygon when the ball around A touches
// the sum of the polygon and all -y s, y in 0..1. That is bounded by the polygon, the polygon moved by -s, and the
// parallelograms that the polygon's sides sweep; a ball touches a closed set first at its boundary. So each of them is
// asked, as exact_polygon.h asks a polygon: in whole numbers, as one quadratic and some linear inequalities.
// Parallelograms without area lie on lines that the rims of the others hold.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "firma/capsule.h"
#include "tests/reference/exact_hull.h"
#include "tests/reference/exact_polygon.h"

namespace firma::reference {

struct CapsuleExpected {
    Status status = Status::kMiss;
    Root at;  ///< the fraction of a hit
    /// What decided an overlap at the start was undecided to so little, metres.
    double doubt = INFINITY;
    /// Ways out, unit, where the segment itself meets the polygon at the start.
    std::vector<Vec3> ways;
    bool segment_meets = false;
};

class ExactCapsuleCast {
public:
    ExactCapsuleCast(const Capsule& capsule, const Vec3& path, std::span<const Vec3> polygon);

    CapsuleExpected expect(Sides sides) const;
    /// Distance of the segment from the polygon less the radius, metres; 0 less the radius where they meet.
    double gap_at(double fraction) const;
    /// How deep the capsule goes on its path, metres; negative: how far it stays away.
    double margin() const;
    /// The nearest points' difference at a time: unit, toward the segment; zero when they meet.
    Vec3 away_at(double fraction) const;

private:
    struct Piece {
        std::size_t polygon;
        bool of_b;  ///< asked of the ball around B
    };
    SeenPolygon seen(const Piece& piece) const;
    Nearest nearest_at(const Ratio& t) const;

    ExactCast a_, b_;
    std::vector<ExactPolygon> polygons_;
    std::vector<Piece> pieces_;
    std::vector<IntegerVec> corners_;  ///< in the cast's unit
};

}  // namespace firma::reference
