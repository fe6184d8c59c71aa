// SPDX-License-Identifier: MIT
// A small building, and versions of it with one crater more each.
#pragma once

#include "firma/carve.h"
#include "firma/level.h"
#include "scenes/cut_levels.h"
#include "scenes/rng.h"

namespace firma::test {

/// Two by two rooms of 12 x 12 x 6 m, 13.5 m apart, in a block of rock.
inline World building(int panels = 6) {
    scenes::Rng rng(7);
    return make_world(scenes::level_of(scenes::bumpy_rooms(rng, 2, panels, {}).faces)).value();
}

/// Makes craters in walls, floors and ceilings of such a building; the same ones for the same seed.
class CraterMaker {
public:
    explicit CraterMaker(std::uint64_t seed) : rng_(seed) {}

    /// The next version: craters until one does something.
    World next(const World& world) {
        for (;;) {
            const CarveResult result = carve(world, cutter_, pose());
            if (result.done()) return result.world;
        }
    }

private:
    Pose pose() {
        Pose pose;
        const std::uint32_t axis = rng_.below(3);
        const bool high = rng_.chance(0.5);
        for (std::uint32_t k = 0; k < 3; ++k) {
            const double room = k == 2 ? 0 : 13.5 * rng_.below(2), size = k == 2 ? 6 : 12;
            const double along = rng_.uniform();
            pose.position[int(k)] = room + size * (k != axis ? along : high ? 1 : 0);
        }
        pose.rotation = random_turn(rng_.next());
        pose.scale = rng_.uniform(0.5, 1.6);
        return pose;
    }

    scenes::Rng rng_;
    const Cutter cutter_ = make_crater(CutterShape::kRocky, 3);
};

}  // namespace firma::test
