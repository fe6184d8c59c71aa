// SPDX-License-Identifier: MIT
// How parts of a level move by time: doors, lifts and trains between stops, blades that spin, what bobs and swings.
// Pure functions of the time: the same bits on every machine, and back in time as well as on.
#pragma once

#include <cstdint>
#include <vector>

#include "firma/export.h"
#include "firma/motion.h"
#include "firma/vec.h"

namespace firma {

/// A place on the way.
struct PartStop {
    Vec3 position{};   ///< of the part's frame, metres
    double angle = 0;  ///< radians about PartPath::axis
    double wait = 0;   ///< seconds that it stands here; infinite: it goes no further. At the first stop it comes first
    double seconds = 0;  ///< to the next stop, or from the last to the first; not above 0: it is there at once
};

/// To and fro about where the stops have it, as a sine of the time.
struct PartSwing {
    Vec3 reach{};       ///< metres, to each side of the middle
    double angle = 0;   ///< radians about the axis, likewise
    double period = 0;  ///< seconds of a whole cycle; not above 0: none
    double phase = 0;   ///< of a cycle, at time 0
};

/// What it adds up to: the stops in turn, evenly from each to the next, a swing, and a spin. Time 0 is when a door, a
/// lift or a button is set off; for what always moves it is any time that is kept.
struct PartPath {
    std::vector<PartStop> stops;      ///< none: it stands at the origin
    bool repeats = false;             ///< goes round for ever; else once round, and rests at the first stop
    Quaternion rotation{0, 0, 0, 1};  ///< at angle 0
    Vec3 axis{0, 0, 1};               ///< unit, in the world's axes, of all angles
    double spin = 0;                  ///< radians a second about it
    PartSwing swing{};
};

/// What becomes of a part that something is in the way of, and of that. step_game() does so; else it is for games.
enum class WhenBlocked : std::uint8_t {
    kStops,    ///< it waits where it is until the way is free: trains, blades
    kReturns,  ///< it goes back to where it came from: doors, lifts
    kCrushes,  ///< it goes on, and what is in the way is hurt, or out of the way
};

/// Where a part is at a time.
/// @param seconds  before 0 it stands at its first stop, but for swing and spin; finite
/// @return scale is 1. Of a time, place or spin that is not finite it is of no numbers: casts say kInvalid of that
/// Never allocates. Costs the stops.
[[nodiscard]] FIRMA_EXPORT Pose part_pose(const PartPath& path, double seconds);

/// The motion from one time to another: fraction 0 is the first, 1 the second. Both ends are as part_pose() says, but
/// for rounding; between them it goes evenly. On one leg between two stops that is the path itself. In a time with a
/// stop in it, it is off the path by at most what it goes in that time, as a path that turns back is cut short:
/// next_stop() tells where to divide the time. A swing bends by (2 pi / period)^2 times its reach, so that it is off by
/// an eighth of that times the square of the time.
[[nodiscard]] FIRMA_EXPORT RigidMotion part_motion(const PartPath& path, double from, double to);

/// The first time after `seconds` at which the part arrives at, or leaves, a stop; infinite where there is none.
[[nodiscard]] FIRMA_EXPORT double next_stop(const PartPath& path, double seconds);

/// Whether it stands at its first stop: a door that is shut. A swing or spin of its own is no part of that.
[[nodiscard]] FIRMA_EXPORT bool at_first_stop(const PartPath& path, double seconds);

}  // namespace firma
