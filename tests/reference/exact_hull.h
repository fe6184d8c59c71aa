// SPDX-License-Identifier: MIT
// One polygon and one moving convex hull, exactly: a particle against their Minkowski sum, by every direction in which
// a facet of the sum could lie.
//
// Corners v_k of the polygon, o_i of the hull from where it is put, at q(t) = start + t path. The hull shares a point
// with the polygon when for no direction u all u.(q + o_i) are above all u.v_k. It is enough to ask for u = +-n, for
// the crosses of all differences of three corners o_i, and for the crosses of all edges of the polygon with all
// differences of two corners o_i: among these are the directions of all facets. Nothing is known or assumed of the
// hull's faces.
#pragma once

#include <span>
#include <vector>

#include "firma/hit.h"
#include "firma/vec.h"
#include "tests/reference/exact_number.h"

namespace firma::reference {

struct HullExpected {
    Status status = Status::kMiss;
    Ratio at;                   ///< the fraction of a hit
    std::vector<Vec3> normals;  ///< unit, of all facets that are entered then, or are nearest in an overlap
    /// The depths of two facets in an overlap differ by so little that rounding may take one for the other, metres.
    double doubt = INFINITY;
};

class ExactHullCast {
public:
    /// @param corners  of the hull, from where it is put
    /// @param polygon  as cast_polygon() takes it
    ExactHullCast(std::span<const Vec3> corners, const Vec3& start, const Vec3& path, std::span<const Vec3> polygon);

    /// The same of whole numbers in units of 2^-unit metres.
    ExactHullCast(std::vector<IntegerVec> corners, const IntegerVec& start, const IntegerVec& path,
                  std::vector<IntegerVec> polygon, int unit);

    HullExpected expect(Sides sides) const;
    /// Whether the hull shares a point with the polygon at the start.
    bool overlaps() const;
    /// What a start in overlap means, by the nearest facets: among them the plane on the side that the path comes from
    /// decides alone.
    HullExpected in_overlap() const;
    /// The largest gap along any of the directions at a time, metres: 0 or less when they share a point.
    double gap_at(double fraction) const;

private:
    struct Facet {
        IntegerVec u;
        bool plane = false;
        Integer now, change;  ///< u.(q + o - v) = now + t change
    };
    void add_facets();
    void add(const IntegerVec& u, bool plane);
    Vec3 unit(const IntegerVec& u) const;

    int unit_ = 18;
    std::vector<IntegerVec> hull_, polygon_;
    IntegerVec start_, path_;
    Integer facing_;
    std::vector<Facet> facets_;
};

}  // namespace firma::reference
