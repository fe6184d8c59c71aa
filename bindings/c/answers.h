// SPDX-License-Identifier: MIT
// What questions to a world have in common: counts, lists of answers, why nothing could be asked.
#pragma once

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

#include "bindings/c/calls.h"
#include "firma/queries.h"

namespace firma::c {

inline constexpr const char* kBadSphere = "a number is not finite or too large, or the radius negative";

inline void add(const CastCounts& counts, firma_cast_counts& out) {
    out.nodes += counts.nodes;
    out.boxes += counts.boxes;
    out.faces += counts.faces;
    out.precise += counts.precise;
}

/// Says why nothing could be asked: the room, or else the numbers.
inline firma_code not_asked(const World& world, RoomId room, const char* numbers, const char* function) {
    if (room != kAnyRoom && room.value >= world.room_count())
        return fail(FIRMA_ERROR_INVALID, function, "the world has no room " + std::to_string(room.value));
    return fail(FIRMA_ERROR_OUT_OF_RANGE, function, numbers);
}

/// Of a cast, which may find its room out.
inline firma_code not_cast(const World& world, RoomId room, const char* function) {
    return not_asked(world, room == kLocateRoom ? kAnyRoom : room, kBadSphere, function);
}

template <class From, class To>
void put_some(const std::vector<From>& found, To* out, std::size_t capacity, std::size_t* count,
              void (*put_one)(const From&, To&)) {
    *count = found.size();
    for (std::size_t k = 0; k < std::min(capacity, found.size()); ++k) put_one(found[k], out[k]);
}

}  // namespace firma::c
