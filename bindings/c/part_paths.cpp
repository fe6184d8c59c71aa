// SPDX-License-Identifier: MIT
// How parts move by time: pure functions of a path that the caller has.
#include "firma/part_path.h"

#include <algorithm>
#include <vector>

#include "bindings/c/numbers.h"
#include "bindings/c/scenes.h"

namespace firma::c {
namespace {

constexpr std::size_t kMostPathStops = 65'536;

bool is_good_stop(const firma_part_stop& stop) {
    const bool waits = is_finite(stop.wait) || stop.wait > 0;
    return is_finite(vec(stop.position)) && is_finite(stop.angle) && waits && is_finite(stop.seconds);
}

bool is_good_path(const firma_part_path& path) {
    return is_rotation(path.rotation) && is_finite(vec(path.axis)) && is_finite(path.spin) &&
           is_finite(vec(path.swing_reach)) && is_finite(path.swing_angle) && is_finite(path.swing_period) &&
           is_finite(path.swing_phase);
}

}  // namespace

firma_code read_path(const firma_part_path* given, PartPath& path, const char* function) {
    if (!given) return bad_call(function, kNull);
    if (!sized(given)) return bad_call(function, kWrongSize);
    firma_part_path whole;
    firma_part_path_defaults(&whole);
    take_sized(given, whole);
    if (whole.stop_count && !whole.stops) return bad_call(function, "a count without its array");
    if (whole.repeats > 1) return fail(FIRMA_ERROR_INVALID, function, "repeats must be 0 or 1");
    if (whole.stop_count > kMostPathStops) return fail(FIRMA_ERROR_TOO_LARGE, function, "more than 65,536 stops");
    if (!is_good_path(whole))
        return fail(FIRMA_ERROR_OUT_OF_RANGE, function, "a number of the path is not finite, or it has no rotation");
    for (std::size_t k = 0; k < whole.stop_count; ++k) {
        const firma_part_stop& stop = whole.stops[k];
        if (!is_good_stop(stop))
            return fail(FIRMA_ERROR_OUT_OF_RANGE, function, "stop " + std::to_string(k) + " is not finite");
        path.stops.push_back({vec(stop.position), stop.angle, stop.wait, stop.seconds});
    }
    path.repeats = whole.repeats != 0;
    for (std::size_t k = 0; k < 4; ++k) path.rotation[k] = whole.rotation[k];
    path.axis = vec(whole.axis);
    path.spin = whole.spin;
    path.swing = {vec(whole.swing_reach), whole.swing_angle, whole.swing_period, whole.swing_phase};
    return FIRMA_OK;
}

namespace {

template <class Work>
firma_code ask_of_path(const firma_part_path* given, double seconds, const char* function, const Work& work) {
    PartPath path;
    if (const firma_code code = read_path(given, path, function)) return code;
    if (!is_finite(seconds)) return fail(FIRMA_ERROR_OUT_OF_RANGE, function, "the seconds are not finite");
    return work(path);
}

}  // namespace

firma_motion motion_told(const RigidMotion& from) {
    firma_motion out{};
    put(from.position, out.position);
    for (std::size_t k = 0; k < 4; ++k) out.rotation[k] = from.rotation[k];
    put(from.path, out.path);
    put(from.turn, out.turn);
    return out;
}

firma_part_path path_told(const PartPath& from, const std::vector<firma_part_stop>& stops) {
    firma_part_path out;
    firma_part_path_defaults(&out);
    out.repeats = from.repeats;
    out.stops = stops.data();
    out.stop_count = stops.size();
    for (std::size_t k = 0; k < 4; ++k) out.rotation[k] = from.rotation[k];
    put(from.axis, out.axis);
    out.spin = from.spin;
    put(from.swing.reach, out.swing_reach);
    out.swing_angle = from.swing.angle;
    out.swing_period = from.swing.period;
    out.swing_phase = from.swing.phase;
    return out;
}

std::vector<firma_part_stop> stops_told(const PartPath& path) {
    std::vector<firma_part_stop> stops;
    for (const PartStop& stop : path.stops) {
        firma_part_stop& out = stops.emplace_back();
        put(stop.position, out.position);
        out.angle = stop.angle;
        out.wait = stop.wait;
        out.seconds = stop.seconds;
    }
    return stops;
}

}  // namespace firma::c

using namespace firma;
using namespace firma::c;

void firma_part_path_defaults(firma_part_path* path) {
    if (!path) return;
    *path = {};
    path->size = sizeof *path;
    path->rotation[3] = 1;
    path->axis[2] = 1;
}

firma_code firma_part_path_pose(const firma_part_path* path, double seconds, firma_pose* pose) {
    return guarded(__func__, [&, function = __func__] {
        if (!pose) return bad_call(function, kNull);
        return ask_of_path(path, seconds, function, [&](const PartPath& it) {
            put_pose(part_pose(it, seconds), *pose);
            return FIRMA_OK;
        });
    });
}

firma_code firma_part_path_motion(const firma_part_path* path, double from, double to, firma_motion* motion) {
    return guarded(__func__, [&, function = __func__] {
        if (!motion) return bad_call(function, kNull);
        return ask_of_path(path, from, function, [&](const PartPath& it) {
            if (!is_finite(to)) return fail(FIRMA_ERROR_OUT_OF_RANGE, function, "the seconds are not finite");
            *motion = motion_told(part_motion(it, from, to));
            return FIRMA_OK;
        });
    });
}

firma_code firma_part_path_next_stop(const firma_part_path* path, double seconds, double* next) {
    return guarded(__func__, [&, function = __func__] {
        if (!next) return bad_call(function, kNull);
        return ask_of_path(path, seconds, function, [&](const PartPath& it) {
            *next = next_stop(it, seconds);
            return FIRMA_OK;
        });
    });
}

firma_code firma_part_path_at_first_stop(const firma_part_path* path, double seconds, uint32_t* is_there) {
    return guarded(__func__, [&, function = __func__] {
        if (!is_there) return bad_call(function, kNull);
        return ask_of_path(path, seconds, function, [&](const PartPath& it) {
            *is_there = at_first_stop(it, seconds);
            return FIRMA_OK;
        });
    });
}
