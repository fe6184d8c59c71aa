// SPDX-License-Identifier: MIT
// Few of many balls such that each of many points is near one of them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "firma/polygon.h"

namespace firma {

class BallChoice {
public:
    void add_point(const Vec3& point);
    void add_ball(const Sphere& ball);
    const std::vector<Sphere>& balls() const { return balls_; }

    struct Chosen {
        double error = 0;                  ///< metres: each point is so near the surface of one of them, or inside
        std::vector<std::uint32_t> balls;  ///< in the order in which they were taken
    };
    /// At most so many balls, such that each point is no farther from one than `error`, or than it is from the nearest
    /// of all balls; or with the least error that so many reach, within some hundredths.
    /// @param most   1 or more
    /// @param error  metres, above zero
    /// @param guess  metres: about what it will come to; 0: `error`
    Chosen choose(std::size_t most, double error, double guess) const;

private:
    std::vector<float> least_gaps() const;
    /// Taken one by one, each the one that is near most of the points that none so far is near. Of several the first.
    std::vector<std::uint32_t> cover(double error, const std::vector<float>& least, std::size_t most) const;

    std::vector<Sphere> balls_;
    std::vector<Vec3> points_;
    std::vector<std::vector<float>> gaps_;  ///< of a ball: how far each point is from it
};

}  // namespace firma
