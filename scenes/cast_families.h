// SPDX-License-Identifier: MIT
// Seeded families of small scenes with casts at them: each is about one way in which sweeps go wrong.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "firma/polygon.h"
#include "scenes/grid_polygons.h"

namespace firma::scenes {

struct CastQuery {
    Sphere sphere;
    Vec3 path;
};

struct CastScene {
    std::vector<GridPolygon> polygons;
    std::vector<bool> two_sided;  ///< a flag a polygon, or empty
    std::vector<CastQuery> casts;
};

struct CastFamily {
    std::string_view name;
    void (*make)(Rng& rng, CastScene& scene);
};

/// Names are kept; new families are added at the end, so that a seed goes on naming the same scenes.
const std::vector<CastFamily>& cast_families();

/// Scene number `index` of a family: some 6 to 130 polygons and 40 to 60 casts.
CastScene make_cast_scene(const CastFamily& family, std::uint64_t seed, std::uint64_t index);

/// Radius and length of the path evenly from their ranges (metres), directions evenly over the sphere.
struct CastRange {
    double radius_low = 0, radius_high = 0;
    double length_low = 0, length_high = 0;
};

inline constexpr CastRange kShortSpheres{0.3, 0.5, 0.1, 2};
inline constexpr CastRange kLongSpheres{0.3, 0.5, 50, 50};
inline constexpr CastRange kShortRays{0, 0, 1, 2};
inline constexpr CastRange kLongRays{0, 0, 5, 100};

}  // namespace firma::scenes
