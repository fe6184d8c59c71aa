// SPDX-License-Identifier: MIT
// Bodies thrown through a level, with the rubble of blasts among them: none in its walls, none lost.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "firma/bodies.h"
#include "firma/level.h"
#include "scenes/rng.h"

namespace firma::reference {

/// In the air of rooms that are not outside, clear of all, of 1 to 200 spheres, at 1 to 1,000 m/s and up to 200 rad/s.
/// @param walls  one of its faces is near
firma::Body random_body(const World& world, const Level& walls, scenes::Rng& rng);

/// How deep spheres are in what bounds solid, body by body, frame by frame.
class BodyDepths {
public:
    /// @param kept_in  a body is lost in a room that is outside; else it may be anywhere
    explicit BodyDepths(bool kept_in = false) : kept_in_(kept_in) {}

    /// Looks again at what moved, and at all where the world is another one than last time.
    /// @return "" where no sphere is deeper than the contact offset, no centre is in solid and no body is lost
    std::string fault(const World& world, const Bodies& bodies);

    double deepest() const { return deepest_; }  ///< metres, of all that was looked at
    std::uint64_t looked_at() const { return looked_at_; }

private:
    bool is_lost(const World& world, const Vec3& centre) const;
    double depth_in_solid(const World& world, const Sphere& sphere) const;
    std::string fault_of(const World& world, const firma::Body& body);

    const bool kept_in_;
    std::vector<bool> slept_, outside_;
    std::uint64_t version_ = ~std::uint64_t{};
    double deepest_ = 0;
    std::uint64_t looked_at_ = 0;
};

struct BodyRun {
    std::uint32_t bodies = 1000;
    double seconds = 60, rate = 60;
    bool cut = false;  ///< while they fly, twice a second; else before
    std::uint64_t seed = 1;
};

struct BodyVerdict {
    std::string fault;
    std::size_t bodies = 0, chunks = 0, frames = 0, cuts = 0, bounces = 0, asleep = 0;
    std::uint64_t looked_at = 0;      ///< spheres
    double deepest = 0, seconds = 0;  ///< metres; in step() alone
};

/// Bodies are thrown again about every ten seconds. What cuts take loose becomes bodies, too, up to a few hundred.
/// A cut that opens a way out of the level is not made.
/// @param level  with rooms that are not outside
BodyVerdict judge_bodies(const World& level, const BodyRun& run);

}  // namespace firma::reference
