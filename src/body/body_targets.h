// SPDX-License-Identifier: MIT
// Bodies as rays meet them: where their spheres lie, in a tree.
#pragma once

#include <cstdint>
#include <vector>

#include "firma/bodies.h"
#include "firma/polygon.h"
#include "index/box_tree.h"

namespace firma {

/// The first sphere of a body on the way of a ray.
struct BodyMet {
    double fraction = 2;  ///< of the path; beyond 1: none
    std::uint32_t slot = ~0u;
    Vec3 point, normal;  ///< metres; unit, out of the sphere
};

class BodyTargets {
public:
    explicit BodyTargets(const Bodies& bodies);

    /// Of several at one fraction that of the lowest slot. A ray that starts in a sphere meets it at once where it
    /// leads farther in, else not at all.
    BodyMet first(const Ray& ray, std::uint32_t mask) const;

private:
    struct Target {
        Vec3 position;
        TurnMatrix matrix;
        const Body* body = nullptr;
        std::uint32_t slot = 0;
    };

    std::vector<Target> targets_;
    BoxTree tree_;
};

}  // namespace firma
