// SPDX-License-Identifier: MIT
// Seeded families of levels with cuts to be made in them: each is about one way in which carving goes wrong.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "firma/carve.h"
#include "scenes/cut_levels.h"

namespace firma::scenes {

struct CutOrder {
    Cutter cutter;
    Pose pose;
    CarveKind kind = CarveKind::kCarve;
};

struct CutCase {
    Level level;
    std::vector<CutOrder> cuts;
};

struct CutFamily {
    std::string_view name;
    void (*make)(Rng& rng, const Level& ours, CutCase& it);
};

/// Names are kept; new families are added at the end, so that a seed goes on naming the same cases.
const std::vector<CutFamily>& cut_families();

/// Case number `index` of a family: a level and about 24 cuts.
/// @param ours  levels/first.obj, for the families that carve it
CutCase make_cut_case(const CutFamily& family, std::uint64_t seed, std::uint64_t index, const Level& ours);

/// One of the five shapes from a random seed, or now and then a ring, a hollow ball, or two balls in one mesh.
Cutter any_cutter(Rng& rng);
/// The vertices scaled, then moved to multiples of `step` metres; not valid() when that leaves no cutter.
Cutter snapped_cutter(const Cutter& cutter, double scale, double step);
/// A box of these half sides.
Cutter box_cutter(const Vec3& half);

}  // namespace firma::scenes
