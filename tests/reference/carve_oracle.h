// SPDX-License-Identifier: MIT
// How much of a cutter lies in a solid: by another way than cutting, and to far more digits than are asked for.
//
// Both are sums of signed vertical prisms: what lies below a face that looks up counts once, below one that looks down
// it is taken away again. What two prisms have in common lies below both faces, over where their projections overlap:
// an integral of the lower of two linear heights over a convex polygon. Nothing is labelled, traced or ordered, and a
// sign that were wrong by a hair would change the sum by no more than that.
#pragma once

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <boost/multiprecision/cpp_int.hpp>
#include <span>
#include <string>

#include "carve/place_cutter.h"
#include "firma/world.h"
#include "solid/solid_patch.h"

namespace firma::reference {

/// 233 bits: numerators and denominators of exact points fit.
using Real = boost::multiprecision::number<boost::multiprecision::cpp_bin_float<70>, boost::multiprecision::et_off>;
using Fraction = boost::multiprecision::cpp_rational;

/// Volume of cutter and solid in common, cubic metres. The solid is what its exact faces bound, not its facets.
Real volume_within(const World& world, const PlacedCutter& cutter);
/// The same without any rounding: slow.
Fraction exact_volume_within(const World& world, const PlacedCutter& cutter);

Real volume_of(const PlacedCutter& cutter);

/// How much more solid `before` has than `after`, cubic metres, by the exact faces of facets that only one of them has.
Real volume_lost(std::span<const FacetPlace> gone, std::span<const FacetPlace> come, const PlacedCutter& near);

/// Whether two worlds have the same solid, however their faces are divided: in every plane, by the way that they look,
/// the exact faces have the same area and the same moments of it up to the second order.
bool same_solid(const World& a, const World& b);

/// Whether faces of these facets lie on other faces of the world, looking the same way or the opposite one: a skin
/// without volume, or a face twice. In exact arithmetic's digits, by the areas that two faces of a plane share.
/// @param facets  of the world
/// @return a corner of a face that does, in words; empty when none does
std::string doubled_face(const World& world, std::span<const FacetPlace> facets);

/// How often the surface of the solid winds around a point, by solid angles over all facets: 0 in air and 1 in the
/// solid, or -1 and 0 in a world whose outside is rock. In double, so for points well clear of the surface.
double winding(std::span<const FacetPlace> facets, const Vec3& point);
double winding(const PlacedCutter& cutter, const Vec3& point);
/// The part of one polygon in it.
double winding(std::span<const Vec3> polygon, const Vec3& point);

}  // namespace firma::reference
