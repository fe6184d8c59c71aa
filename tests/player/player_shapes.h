// SPDX-License-Identifier: MIT
// A player of each kind.
#pragma once

#include <array>
#include <vector>

#include "firma/players.h"

namespace firma::test {

inline constexpr std::array kPlayerShapeNames{"Capsule", "Box", "Spheres"};

/// As named above, 1.8 m high and 0.6 m wide; on all sides by so many metres more, with the feet so much lower.
inline std::vector<PlayerShape> player_shapes(double more = 0) {
    const double radius = 0.3 + more;
    const PlayerSize size{.radius = radius, .height = 1.8 + 2 * more, .crouched_height = 1.1 + 2 * more};
    std::vector<Sphere> tall;
    for (const double up : {0.3, 0.7, 1.1, 1.5}) tall.push_back({{0, 0, up + more}, radius});
    return {make_player_capsule(size).value(), make_player_box(size).value(),
            make_player_spheres(tall, std::span(tall).first(2)).value()};
}

}  // namespace firma::test
