// SPDX-License-Identifier: MIT
// Parts that move around a player: a lift under it, and a door's leaf that swings beside it.
#pragma once

#include <span>
#include <vector>

#include "firma/moving_parts.h"
#include "firma/part_path.h"
#include "scenes/rng.h"

namespace firma::reference {

class PartsNear {
public:
    PartsNear();

    /// Hangs both up anew on the floor below a place, at their time 0; none of them where no floor is near.
    void put(const World& world, const Vec3& feet, scenes::Rng& rng);
    void remove() { shown_ = false; }
    /// Goes on by so many seconds: the motions of the parts are those from before to after.
    void go_on(double seconds);
    /// The parts with their motions.
    std::span<const MovingPart> moving() const { return shown(moving_); }
    /// The same, standing where these motions end.
    std::span<const MovingPart> standing() const { return shown(standing_); }

private:
    std::span<const MovingPart> shown(const std::vector<MovingPart>& parts) const {
        return shown_ ? std::span(parts) : std::span<const MovingPart>();
    }
    void set_motions(double before, double after);

    std::vector<PartPath> paths_;
    std::vector<MovingPart> moving_, standing_;
    double time_ = 0;
    bool shown_ = false;
};

}  // namespace firma::reference
