// SPDX-License-Identifier: MIT
// A sphere that bounces about a closed room and gets everywhere: one straight move a frame, by its own casts.
//
// The sphere flies straight until it meets a face and leaves it in a random direction, much as light leaves chalk (the
// cosine law), which fills a room of any shape evenly. Of many such directions it takes the one that leads over the
// least visited ground, so that narrow doors and long corridors need not be found by luck.
#pragma once

#include <cstdint>
#include <unordered_map>
#include <vector>

#include "firma/hit.h"
#include "firma/polygon.h"
#include "firma/vec.h"
#include "firma/world.h"
#include "scenes/rng.h"

namespace firma::cli {

class Bouncer {
public:
    /// @param world   must outlive the bouncer
    /// @param frames  how many moves are to come: the more, the shorter each, so that the rows cover the room as well
    /// as they can
    /// @throws Failure when the sphere lies nearer to a face than its radius, or is larger than the world
    Bouncer(const World& world, const Sphere& start, std::uint64_t frames, std::uint64_t seed);

    const Vec3& place() const { return place_; }

    /// One straight move. It stays where it is only where the sphere has no room to move at all.
    /// @throws Failure when nothing would stop the sphere: the level is not closed
    void step();

private:
    /// A straight line to the next face.
    struct Flight {
        Vec3 direction;             ///< unit
        double length = 0;          ///< metres that can be flown with the contact offset kept
        double contact_offset = 0;  ///< metres
        double worth = -1;          ///< how little visited the ground is that it leads over
    };

    bool choose_flight();
    void look_for_a_way_out();
    bool fly();
    Flight look(const Vec3& direction, double contact_offset) const;
    double worth_of(const Flight& flight) const;
    Vec3 chalk_direction(const Vec3& normal);
    Vec3 even_direction(const Vec3& normal);
    Vec3 direction_near(const Vec3& direction);
    std::vector<Vec3> normals_in_reach() const;

    struct Cell {
        std::int64_t x = 0, y = 0, z = 0;
        friend bool operator==(const Cell&, const Cell&) = default;
    };
    struct CellHash {
        std::size_t operator()(const Cell& cell) const;
    };
    Cell cell_at(const Vec3& point) const;

    const World& world_;
    scenes::Rng rng_;
    Vec3 place_;
    double radius_;
    double span_;       ///< longer than any flight within the world, metres
    double cell_size_;  ///< of the ground that visits are counted on, metres
    bool flying_ = false;
    Flight flight_;  ///< the one we are on, while flying_
    Vec3 normal_;    ///< of the last contact; zero before the first
    std::unordered_map<Cell, std::uint32_t, CellHash> visits_;
};

}  // namespace firma::cli
