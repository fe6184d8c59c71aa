// SPDX-License-Identifier: MIT
// One library that moves bodies, as the benchmark drives it.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "firma/bodies.h"

namespace firma::bench {

struct BodyScene {
    std::string name, what;
    World world;
    std::vector<Body> bodies;  ///< as they start
    double seconds = 10;
    double half = 0;  ///< metres: of all bodies, where they are cubes
};

class BodyPeer {
public:
    virtual ~BodyPeer() = default;
    virtual std::string name() const = 0;
    virtual std::string describe() const = 0;
    virtual void start(const BodyScene& scene) = 0;
    /// A sixtieth of a second.
    virtual void step() = 0;
    /// Where they are now, how they move, and whether they sleep, in the order of the scene.
    virtual void read(std::vector<Body>& bodies) const = 0;
};

std::unique_ptr<BodyPeer> make_firma_bodies();
// Where it was found.
std::unique_ptr<BodyPeer> make_bullet_bodies();
std::unique_ptr<BodyPeer> make_bullet_bodies_with_margin();  ///< as it comes: walls 4 cm thicker

}  // namespace firma::bench
