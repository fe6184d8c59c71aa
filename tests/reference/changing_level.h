// SPDX-License-Identifier: MIT
// A level that is cut, filled, undone and whose doors are shut around a place, at random.
#pragma once

#include <cstddef>
#include <deque>
#include <vector>

#include "firma/world.h"
#include "scenes/rng.h"

namespace firma::reference {

class ChangingLevel {
public:
    explicit ChangingLevel(const World& level);

    /// What was done so far.
    struct Counts {
        std::size_t cuts = 0, fills = 0, undone = 0, doors = 0;
    };

    /// One change, or none where it is refused or would open a way out of the level.
    /// @param feet    fills are made near it
    /// @param middle  from where a ray leads to what is cut
    void change(const Vec3& feet, const Vec3& middle, scenes::Rng& rng);

    const World& world() const { return world_; }
    bool is_inside(const Vec3& point) const;  ///< in air of a room that is not outside
    const Counts& counts() const { return counts_; }

private:
    void put(World world);
    void cut(const Vec3& from, scenes::Rng& rng);
    void fill_near(const Vec3& feet, scenes::Rng& rng);
    void toggle_door(scenes::Rng& rng);

    World begun_, world_;
    std::deque<World> past_;
    std::vector<bool> outside_;
    Counts counts_;
};

}  // namespace firma::reference
