// SPDX-License-Identifier: MIT
// What a BodyShape is a handle to.
#pragma once

#include <vector>

#include "firma/bodies.h"

namespace firma {

struct BodyShapeData {
    SphereSet given;  ///< in the frame that they were given in
    MassProperties given_mass;
    SphereSet spheres;  ///< with the centre of mass as the origin and the principal axes as axes
    double mass = 0;
    Vec3 centre, moments;
    Quaternion axes{0, 0, 0, 1};
    double reach = 0;
    double thinnest = 0;  ///< the least radius
};

}  // namespace firma
