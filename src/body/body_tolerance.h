// SPDX-License-Identifier: MIT
// Numbers of bodies that mean "close enough": what distances are rounded by, and slop that is accepted.
#pragma once

namespace firma {

/// Rounding, metres: far above what a distance within the world is off by, in double (2^13 m times some 2^-52).
inline constexpr double kDistanceRounding = 1e-9;
/// Rounding, a share of a distance: the same of searches that end at one.
inline constexpr double kSearchRounding = 1e-9;
/// Rounding, a share of the longest side of a solid: of distances to points in single precision, see point_cloud.h.
inline constexpr double kSampleRounding = 1e-6;
/// Slop, a share of the radius: a ball is as large as it can become.
inline constexpr double kBallSlop = 1e-6;
/// Slop, a share of the longest side of the solid: no ball worth having is smaller.
inline constexpr double kSmallestBall = 1e-4;
/// Slop, metres: what is less far in front of a plane lies in it, as far as spheres that touch it are concerned.
inline constexpr double kInPlaneSlop = 1e-6;
/// Slop, metres: what a part takes along goes along chords that are no farther from its arc.
inline constexpr double kMaxSag = 1e-4;
/// Slop, of a substep: a step of a whole number of substeps is one, however its seconds were rounded.
inline constexpr double kSubstepSlop = 1e-6;

}  // namespace firma
