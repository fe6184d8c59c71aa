// SPDX-License-Identifier: MIT
// Sets of spheres: the form in which bodies meet the world and each other.
#pragma once

#include <cstddef>
#include <vector>

#include "firma/export.h"
#include "firma/polygon.h"
#include "firma/result.h"
#include "firma/solid.h"
#include "firma/vec.h"

namespace firma {

/// Spheres that keep their places to each other, in a frame of their own. Metres.
using SphereSet = std::vector<Sphere>;

/// A set of more is refused.
inline constexpr std::size_t kMaxSpheres = 4096;

struct FitOptions {
    /// Metres: so far at most a point of the solid's surface may be from the nearest sphere. 0: a twentieth of the
    /// longest side of its box.
    double max_error = 0;
    std::size_t max_spheres = 64;  ///< 1 to kMaxSpheres
    /// Spheres are this much inside, metres: so a set that touches is a solid that does not.
    double margin = 0;
};

/// What a fit came to.
struct SphereFit {
    SphereSet spheres;  ///< each inside the solid; largest first, in its frame
    /// Metres: no point of the surface is farther from the nearest sphere. More than FitOptions::max_error where
    /// max_spheres did not do, or a thin edge or tip of the solid has no room for spheres that are near it.
    double error = 0;
};

/// Covers a solid from inside with few spheres: of the largest balls that touch its surface from inside, those that are
/// near most of it are taken first. It stops when max_error is reached, or max_spheres.
/// @param solid  closed, without rock outside (Solid::rock_outside()): a chunk, a piece, a mesh that make_solid() read
/// @return kInvalid for a solid without faces, with rock outside, or without room for any sphere; for options that are
///         not finite or out of range. The same bits on every machine.
/// Costs some thousand searches for the nearest facet and the product of a thousand balls and some thousand points of
/// the surface. Allocates as much as these.
/// Source: for balls from points of the surface, J. Ma, S. W. Bae, S. Choi, 3D medial axis point approximation using
/// nearest neighbors and the normal field, 2012.
[[nodiscard]] FIRMA_EXPORT Result<SphereFit> fit_spheres(const Solid& solid, const FitOptions& options = {});

/// A sphere around a set, near the smallest: the middle of its box, and as far as it reaches. Of an empty set of radius
/// 0 around the origin.
[[nodiscard]] FIRMA_EXPORT Sphere sphere_around(const SphereSet& spheres);

}  // namespace firma
