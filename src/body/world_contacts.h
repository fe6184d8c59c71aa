// SPDX-License-Identifier: MIT
// What of the world is near the spheres of a body.
#pragma once

#include <vector>

#include "body/mover.h"
#include "firma/world.h"
#include "geometry/polygon_shape.h"

namespace firma {

class WorldContacts {
public:
    WorldContacts(const World& world, double skin) : world_(world), skin_(skin) {}

    /// Adds what is within `margin` of its spheres: of faces that a sphere reaches only behind the plane of another
    /// contact, none. Sets Mover::clear.
    /// @param index  of the mover, for NearContact::a
    void find(Mover& mover, std::uint32_t index, const Body& body, double margin, std::vector<NearContact>& found);

private:
    struct Touch {
        std::uint32_t sphere;
        double gap;
        Vec3 point, normal;
        FaceRef face;
        PortalId portal;
    };
    void look_at(const Mover& mover, double margin, const PolygonShape& polygon, bool two_sided, FaceRef face,
                 PortalId portal);
    void keep_apart(std::vector<NearContact>& found, Mover& mover, std::uint32_t index);

    const World& world_;
    const double skin_;
    std::vector<Touch> touches_;
};

}  // namespace firma
