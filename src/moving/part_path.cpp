// SPDX-License-Identifier: MIT
// How parts of a level move by time.
#include "firma/part_path.h"

#include <cmath>
#include <cstddef>

namespace firma {
namespace {

constexpr double kWholeTurn = 6.283185307179586;

/// Seconds, never below 0: NaN stays.
double time_of(double seconds) {
    return seconds < 0 ? 0 : seconds;
}

/// Where the stops have it.
struct StopPlace {
    Vec3 position;
    double angle = 0;
    bool first = false;       ///< it stands at the first stop
    double until = INFINITY;  ///< seconds from now to when that changes
};

StopPlace at_stop(const PartStop& stop, bool first, double until) {
    return {stop.position, stop.angle, first, until};
}

StopPlace on_leg(const PartStop& from, const PartStop& to, double part) {
    return {from.position + (to.position - from.position) * part, from.angle + (to.angle - from.angle) * part, false,
            from.seconds * (1 - part)};
}

double round_trip(const PartPath& path) {
    double sum = 0;
    for (const PartStop& stop : path.stops) sum += time_of(stop.wait) + time_of(stop.seconds);
    return sum;
}

StopPlace place_by_stops(const PartPath& path, double seconds) {
    const std::vector<PartStop>& stops = path.stops;
    if (stops.empty()) return {{}, 0, true, INFINITY};
    double left = seconds;
    if (path.repeats && seconds >= 0) {
        const double whole = round_trip(path);
        if (is_finite(whole) && whole > 0) left = seconds - whole * std::floor(seconds / whole);
    }
    if (left < 0) return at_stop(stops[0], true, -left);
    for (std::size_t k = 0; k < stops.size(); ++k) {
        const double wait = time_of(stops[k].wait), way = time_of(stops[k].seconds);
        if (left < wait) return at_stop(stops[k], k == 0, wait - left);
        left -= wait;
        if (left < way) return on_leg(stops[k], stops[k + 1 < stops.size() ? k + 1 : 0], left / way);
        left -= way;
    }
    return at_stop(stops[0], true, path.repeats ? 0 : INFINITY);
}

struct PlaceAtTime {
    Vec3 position;
    double angle = 0;
};

PlaceAtTime place_at_time(const PartPath& path, double seconds) {
    if (!is_finite(seconds)) return {{NAN, NAN, NAN}, NAN};
    const StopPlace stop = place_by_stops(path, seconds);
    PlaceAtTime place{stop.position, stop.angle + path.spin * seconds};
    const PartSwing& swing = path.swing;
    if (swing.period > 0) {
        const double cycles = seconds / swing.period + swing.phase;
        const double sine = sine_cosine(kWholeTurn * (cycles - std::floor(cycles))).sine;
        place.position += swing.reach * sine;
        place.angle += swing.angle * sine;
    }
    return place;
}

/// The angle within a turn: it may have spun for days.
Quaternion rotation_by(const PartPath& path, double angle) {
    const double within = angle - kWholeTurn * std::floor(angle / kWholeTurn);
    return normalised(compose(turn_by(path.axis * within), normalised(path.rotation)));
}

}  // namespace

Pose part_pose(const PartPath& path, double seconds) {
    const PlaceAtTime place = place_at_time(path, seconds);
    Pose pose;
    pose.position = place.position;
    if (!is_finite(place.angle))
        pose.rotation = {place.angle, place.angle, place.angle, place.angle};
    else if (place.angle != 0 || path.rotation != Quaternion{0, 0, 0, 1})
        pose.rotation = rotation_by(path, place.angle);
    return pose;
}

RigidMotion part_motion(const PartPath& path, double from, double to) {
    const PlaceAtTime start = place_at_time(path, from), end = place_at_time(path, to);
    const Pose pose = part_pose(path, from);
    RigidMotion motion;
    motion.position = pose.position;
    motion.rotation = pose.rotation;
    motion.path = end.position - start.position;
    motion.turn = path.axis * (end.angle - start.angle);
    return motion;
}

double next_stop(const PartPath& path, double seconds) {
    const double next = seconds + place_by_stops(path, seconds).until;
    // A rest smaller than rounding: the stop is now.
    return next > seconds ? next : std::nextafter(seconds, INFINITY);
}

bool at_first_stop(const PartPath& path, double seconds) {
    return place_by_stops(path, seconds).first;
}

}  // namespace firma
