// SPDX-License-Identifier: MIT
// What a projectile meets: the level, or a part where it is at that time.
#pragma once

#include <cstdint>
#include <optional>

#include "firma/moving_parts.h"
#include "moving/part_frame.h"

namespace firma {

struct ShotSolid {
    const World* world = nullptr;      ///< in the part's frame
    std::uint32_t part = kNoPart;      ///< kNoPart: the level, which stands
    std::optional<PartFrame> frame{};  ///< of the part
    Vec3 surface{};                    ///< of the part, metres a second, where it was met

    bool of_part() const { return part != kNoPart; }
    Vec3 in(const Vec3& point) const { return frame ? frame->in(point) : point; }
    Vec3 out(const Vec3& point) const { return frame ? frame->out(point) : point; }
    Vec3 direction_in(const Vec3& v) const { return frame ? frame->direction_in(v) : v; }
    Vec3 direction_out(const Vec3& v) const { return frame ? frame->direction_out(v) : v; }

    /// A velocity as the surface sees it, and back. Of the level not a bit of it changes.
    Vec3 seen(const Vec3& velocity) const { return of_part() ? velocity - surface : velocity; }
    Vec3 unseen(const Vec3& velocity) const { return of_part() ? velocity + surface : velocity; }
};

}  // namespace firma
