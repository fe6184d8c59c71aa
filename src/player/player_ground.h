// SPDX-License-Identifier: MIT
// What carries a player: faces, by their own normals, not by those of the edges between them.
#pragma once

#include "firma/queries.h"
#include "player/player_shape.h"

namespace firma {

/// The ground under a touch.
struct Ground {
    bool carries = false;
    Vec3 normal;  ///< of the flattest face there
};

class GroundRules {
public:
    GroundRules(const Scene& scene, const PlayerShapeData& shape, const PlayerRules& rules, std::uint32_t mask,
                double offset);

    /// Whether a player who touches this from above stands there: a face at that point is no steeper than max_slope,
    /// and the middle is not too far beyond it, or something to stand on is below it.
    Ground under(const PartHit& hit, const Vec3& feet) const;
    bool walkable(const Vec3& normal) const { return dot(normal, shape_.up) >= least_up_; }
    /// Of a fall of one, how much of it is left where it goes along a line as steep as what is walkable.
    double walkable_fall() const { return 1 - least_up_ * least_up_; }

private:
    Vec3 flattest_at(const PartHit& hit) const;
    bool ground_below(const Vec3& feet) const;

    const Scene& scene_;
    const PlayerShapeData& shape_;
    const PlayerRules& rules_;
    const std::uint32_t mask_;
    const double least_up_, offset_;
};

}  // namespace firma
