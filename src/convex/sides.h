// SPDX-License-Identifier: MIT
// A solid as what is divided into convex pieces: for each plane of its faces the sides of what lies in it.
//
// Sides in one plane are a chain: they may be those of many faces, with holes, in any order, and what two chains have
// in opposite directions cancels. So dividing and joining solids is adding chains; loops are traced where they are
// needed. All planes are those of the solid's faces: nothing is rounded anywhere, however often it is divided.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "arrange/line_table.h"
#include "firma/solid.h"

namespace firma {

struct ConvexSpace {
    ExactTables tables;
    LineTable lines{tables};

    const Plane& plane(PlaneId id) const { return tables.planes.plane(id); }
    const ExactPoint& point(std::uint32_t id) const { return tables.points.point(id); }
};

/// The side of a face: the face lies to its left, seen from the front of the plane.
struct FaceSide {
    PlaneId plane = kNoPlane;
    std::uint32_t from = 0, to = 0;
    friend bool operator==(const FaceSide&, const FaceSide&) = default;
    friend auto operator<=>(const FaceSide&, const FaceSide&) = default;
};

/// Sorted; what runs both ways in one plane goes.
using FaceSides = std::vector<FaceSide>;
void settle_sides(FaceSides& sides);

/// Of a solid without rock outside.
/// @return false for one with faces that have no area or reach beyond what planes can say
bool sides_of_solid(ConvexSpace& space, const Solid& solid, FaceSides& sides);

/// Sides with what lies beyond each.
struct SolidSides {
    FaceSides sides;                  ///< settled
    std::vector<std::uint32_t> twin;  ///< of each: the side of the face that meets it there, behind both is solid
    /// Of each: 1 where the two faces meet in a convex edge, -1 in a reflex one. It runs so often along the cross
    /// product of the normals of its plane and of its twin's.
    std::vector<std::int8_t> bend;
    std::vector<std::uint32_t> next;  ///< of each: what follows in its loop

    PlaneId across(std::size_t side) const { return sides[twin[side]].plane; }
    std::size_t size() const { return sides.size(); }
};

/// @param sides  settled
/// @return false where they do not close: the solid crosses itself
bool pair_sides(ConvexSpace& space, FaceSides sides, SolidSides& paired);

/// Reflex edges, each once.
std::size_t count_reflex(const SolidSides& solid);

/// Takes out points along which edges only go straight on.
void straighten_sides(ConvexSpace& space, FaceSides& sides);

/// What is connected, one by one: each with its hollows. Parts that only touch are apart.
/// @return of each side the number of its part; parts in order of their first side
std::vector<std::uint32_t> parts_of_sides(const ConvexSpace& space, const SolidSides& solid, std::uint32_t& count);

}  // namespace firma
