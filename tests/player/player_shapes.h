// SPDX-License-Identifier: MIT
// A player of each kind.
#pragma once

#include <array>
#include <vector>

#include "firma/players.h"

namespace firma::test {

inline constexpr std::array kPlayerShapeNames{"Capsule", "Box", "Spheres"};

/// As named above, 1.8 m high and 0.6 m wide.
inline std::vector<PlayerShape> player_shapes() {
    const std::vector<Sphere> tall{{{0, 0, 0.3}, 0.3}, {{0, 0, 0.7}, 0.3}, {{0, 0, 1.1}, 0.3}, {{0, 0, 1.5}, 0.3}};
    return {make_player_capsule().value(), make_player_box().value(),
            make_player_spheres(tall, std::span(tall).first(2)).value()};
}

}  // namespace firma::test
