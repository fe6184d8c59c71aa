// SPDX-License-Identifier: MIT
// Few of many balls such that each of many points is near one of them.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "body/point_cloud.h"
#include "firma/polygon.h"

namespace firma {

class BallChoice {
public:
    /// @param middle  near all points
    /// @param reach   metres, above zero: no point is farther from any ball
    BallChoice(const Vec3& middle, double reach) : unit_(reach / kMostUnits), points_(middle) {}

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
    /// @param guess  metres: about what it will come to; less than `error` is taken for that
    Chosen choose(std::size_t most, double error, double guess);

private:
    static constexpr double kMostUnits = 30000;
    using Row = std::array<std::int16_t, PointCloud::kRow>;

    /// How far the points of a row are from a ball: each by itself only where some are near enough to matter.
    struct Gaps {
        static constexpr std::uint32_t kNotMade = UINT32_MAX;
        std::int16_t bound = INT16_MAX;  ///< none is less
        std::uint32_t at = kNotMade;     ///< in made_
    };

    std::int16_t in_units(float gap) const;
    /// Of each point of a row from a ball.
    const Row& gaps(std::size_t ball, std::size_t row);
    /// Taken one by one, each the one that is near most of the points that none so far is near. Of several the first.
    std::vector<std::uint32_t> cover(double error, std::size_t most);

    double unit_;  ///< metres: gaps are whole numbers of it
    std::vector<Sphere> balls_;
    PointCloud points_;
    std::vector<std::vector<Gaps>> gaps_;  ///< of a ball, row by row
    std::vector<Row> made_;
    std::vector<Row> least_;  ///< of each point: from the nearest ball
};

}  // namespace firma
