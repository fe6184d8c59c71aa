// SPDX-License-Identifier: MIT
// A body that is awake, as a step works on it.
#pragma once

#include <cstdint>

#include "body/body_shape.h"
#include "firma/bodies.h"

namespace firma {

/// A symmetric matrix that takes angular impulses to changes of spin.
struct InverseInertia {
    Vec3 rows[3];
    Vec3 operator*(const Vec3& v) const { return {dot(rows[0], v), dot(rows[1], v), dot(rows[2], v)}; }
};

struct Mover {
    std::uint32_t slot = 0;
    const BodyShapeData* shape = nullptr;
    // Rotations are those of the principal axes.
    Vec3 start;  ///< where it was when the step began
    Quaternion start_rotation{};
    Vec3 position;
    Quaternion rotation{};
    TurnMatrix matrix;  ///< of `rotation`
    Vec3 velocity, spin;
    /// Half of what a substep adds to the velocity, where nothing is near: the way in it is then that of a fall,
    /// exactly.
    Vec3 half_gain;
    double inverse_mass = 0;
    InverseInertia inverse_inertia;
    /// Metres: as far as any point may go before a sphere can be deeper in the world than the skin.
    double clear = 0;
    /// Metres: the same of parts, by how far both go together.
    double part_clear = 0;
    /// Metres: as far as any point may go and meet no other planes of the level than those noted of it, from the front.
    double known = 0;
    std::uint32_t first_plane = 0, planes = 0;  ///< of those noted, by sphere

    Vec3 centre_of(std::uint32_t sphere) const { return position + matrix * shape->spheres[sphere].centre; }
    Vec3 velocity_at(const Vec3& from_centre) const { return velocity + cross(spin, from_centre); }
    void push(const Vec3& impulse, const Vec3& from_centre) {
        velocity += impulse * inverse_mass;
        spin += inverse_inertia * cross(from_centre, impulse);
    }
    /// Elsewhere than it has come to. Its spin is as before seen from the body: so is its energy, however different its
    /// moments are.
    void put_at(const Vec3& where, const Quaternion& turned) {
        const Vec3 seen{dot(matrix.column(0), spin), dot(matrix.column(1), spin), dot(matrix.column(2), spin)};
        position = where;
        rotation = turned;
        turn_inertia();
        spin = matrix * seen;
    }
    /// Follows from the rotation.
    void turn_inertia() {
        matrix = matrix_of(rotation);
        const Vec3 inverse{1 / shape->moments.x, 1 / shape->moments.y, 1 / shape->moments.z};
        for (int row = 0; row < 3; ++row) {
            const Vec3 scaled{matrix.rows[row].x * inverse.x, matrix.rows[row].y * inverse.y,
                              matrix.rows[row].z * inverse.z};
            inverse_inertia.rows[row] = {dot(scaled, matrix.rows[0]), dot(scaled, matrix.rows[1]),
                                         dot(scaled, matrix.rows[2])};
        }
    }
    /// Changes of velocity along a direction, at a point, by one newton second along it.
    double yield(const Vec3& direction, const Vec3& from_centre) const {
        const Vec3 turning = cross(from_centre, direction);
        return inverse_mass + dot(turning, inverse_inertia * turning);
    }
};

/// The turn of a body's principal axes.
Quaternion principal_rotation(const Body& body);
Mover make_mover(const Body& body, std::uint32_t slot);
/// Metres: as far as any point of it has gone from where the step began, but for whole turns.
double way_of(const Mover& mover);
/// What the step made of it.
void put_back_mover(const Mover& mover, Body& body);

/// No mover: the world, or a body that sleeps.
inline constexpr std::uint32_t kFixed = ~0u;

/// The plane of a face near a sphere, which it is in front of as a step begins.
struct NearPlane {
    std::uint32_t sphere = 0;
    double side = 0;     ///< metres: of its centre, then
    Vec3 point, normal;  ///< the normal toward the sphere
};

/// Two spheres near each other, or a sphere near a face.
struct NearContact {
    BodyContact at;                   ///< what is kept from step to step
    std::uint32_t a = 0, b = kFixed;  ///< movers
    Vec3 centre_a, centre_b;          ///< of the spheres as the step begins
    double radius_a = 0, radius_b = 0;
    double gap = 0;  ///< metres between them as the step begins; negative in overlap
    double friction = 0, restitution = 0;
    double rolling = 0;  ///< metres: the lever of what resists rolling
};

}  // namespace firma
