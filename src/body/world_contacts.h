// SPDX-License-Identifier: MIT
// What of the world is near the spheres of a body.
#pragma once

#include <utility>
#include <vector>

#include "body/mover.h"
#include "body/step_parts.h"
#include "firma/world.h"
#include "geometry/polygon_shape.h"

namespace firma {

class WorldContacts {
public:
    WorldContacts(const World& world, double skin) : world_(world), skin_(skin) {}

    /// Adds what is within `margin` of its spheres: of faces that a sphere reaches only behind the plane of another
    /// contact, none. Sets Mover::clear, and what the mover knows of planes.
    /// @param index  of the mover, for NearContact::a
    /// @param far    at least `margin`: so far planes are noted
    void find(Mover& mover, std::uint32_t index, const Body& body, double margin, double far,
              std::vector<NearContact>& found);
    /// Of all movers so far.
    std::vector<NearPlane> take_planes() { return std::move(planes_); }
    /// The same of parts where they are as the step begins; sets Mover::part_clear.
    /// @param most  of the margin; what a part goes counts besides
    void find_on_parts(const StepParts& parts, Mover& mover, std::uint32_t index, const Body& body, double margin,
                       double most, std::vector<NearContact>& found);

private:
    struct Touch {
        std::uint32_t sphere;
        double gap;
        Vec3 point, normal;
        double side;  ///< of the sphere's centre, in front of the face's plane
        Vec3 plane;   ///< its normal, toward the sphere
        FaceRef face;
        PortalId portal;
    };
    void look_at(const Mover& mover, double margin, const PolygonShape& polygon, bool two_sided, FaceRef face,
                 PortalId portal);
    void look_around(const World& world, const Mover& mover, std::uint32_t mask, double margin);
    void keep_apart(std::vector<NearContact>& found, const Mover& mover, std::uint32_t index, std::uint32_t part,
                    double margin);
    double least_clear(const Mover& mover) const;

    const World& world_;
    const double skin_;
    std::vector<Touch> touches_;
    double behind_ = 0;  ///< metres: the nearest plane that a sphere is behind
    std::vector<NearPlane> planes_;
};

}  // namespace firma
