// SPDX-License-Identifier: MIT
// Pieces as bodies in place of one: they go on as one rigid body with its momentum and its angular momentum would.
#include <algorithm>
#include <string>
#include <utility>

#include "body/rolling.h"
#include "firma/debris.h"
#include "firma/solid.h"
#include "fracture/clear_spheres.h"
#include "fracture/piece_spheres.h"

namespace firma {
namespace {

/// A piece of a body, with what it is most of.
struct Part {
    FracturePiece piece;
    std::uint32_t matter = 0;
};

/// A point in a piece: its centre of mass, where that is not beside it, as an angle's is.
Vec3 point_in(const FracturePiece& piece) {
    if (locate(piece.solid, piece.mass.centre) == Where::kSolid) return piece.mass.centre;
    const SphereFit fit = piece_spheres(piece.solid, 1);
    return fit.spheres.empty() ? piece.mass.centre : fit.spheres.front().centre;
}

/// Pieces as dense as their matters, in proportion: together they are as heavy as before.
std::vector<Part> weighed(const std::vector<FracturePiece>& pieces, const DebrisPiece& whole, const World* world) {
    std::vector<Part> parts;
    double before = 0, after = 0;
    for (const FracturePiece& piece : pieces) {
        Part part{piece, whole.matter};
        if (world) part.matter = matter_at(*world, whole.origin + point_in(piece));
        before += piece.mass.mass;
        after += piece.mass.volume * (world ? matter(*world, part.matter).density : 1);
        parts.push_back(std::move(part));
    }
    if (!world) return parts;
    for (Part& part : parts) {
        MassProperties& mass = part.piece.mass;
        const double factor = mass.volume * matter(*world, part.matter).density / after * before / mass.mass;
        mass.mass *= factor;
        for (Vec3& row : mass.inertia) row = row * factor;
    }
    return parts;
}

/// All pieces as one rigid body, in their frame.
struct Assembly {
    double mass = 0;
    Vec3 centre;
    Vec3 inertia[3];  ///< about the centre, a row each
};

Assembly assembly_of(const std::vector<Part>& parts) {
    Assembly all;
    Vec3 first;
    for (const auto& [piece, matter] : parts) {
        all.mass += piece.mass.mass;
        first += piece.mass.centre * piece.mass.mass;
    }
    all.centre = first * (1 / all.mass);
    for (const auto& [piece, matter] : parts) {
        const Vec3 arm = piece.mass.centre - all.centre;
        const double square = dot(arm, arm);
        for (int row = 0; row < 3; ++row) {
            all.inertia[row] += piece.mass.inertia[std::size_t(row)] - arm * (arm[row] * piece.mass.mass);
            all.inertia[row][row] += square * piece.mass.mass;
        }
    }
    return all;
}

/// x of A x = b, by Cramer's rule; A symmetric and positive.
Vec3 solved(const Vec3 (&a)[3], const Vec3& b) {
    const Vec3 yz = cross(a[1], a[2]), zx = cross(a[2], a[0]), xy = cross(a[0], a[1]);
    const double determinant = dot(a[0], yz);
    return (yz * b.x + zx * b.y + xy * b.z) * (1 / determinant);
}

Vec3 times(const std::array<Vec3, 3>& rows, const Vec3& v) {
    return {dot(rows[0], v), dot(rows[1], v), dot(rows[2], v)};
}

/// How the pieces move, in the world.
struct MotionOfAll {
    Vec3 centre, velocity, spin;
    [[nodiscard]] Vec3 velocity_at(const Vec3& at) const { return velocity + cross(spin, at - centre); }
};

MotionOfAll motion_of(const Assembly& all, const Body& body, const Pose& pose, const TurnMatrix& turn) {
    MotionOfAll motion;
    motion.centre = pose.position + turn * all.centre;
    const Vec3 momentum = body.velocity * body.shape.mass();
    motion.velocity = momentum * (1 / all.mass);
    const Vec3 about_centre = angular_momentum(body) + cross(body.position - motion.centre, momentum);
    motion.spin = turn * solved(all.inertia, turn.back(about_centre));
    return motion;
}

Result<Body> body_of_piece(const FracturePiece& piece, const Body& whole, const Pose& pose,
                           const ShatterOptions& options) {
    SphereFit fit = piece_spheres(piece.solid, options.max_spheres);
    if (options.world) fit.spheres = clear_spheres(*options.world, fit.spheres, piece.mass.centre, pose, whole.mask);
    const Result<BodyShape> shape = make_body_shape(fit.spheres, piece.mass);
    if (!shape) return shape.error();
    Body body = body_at(shape.value(), pose);
    body.friction = whole.friction;
    body.restitution = whole.restitution;
    body.rolling = rolling_of(fit, whole.rolling);
    body.mask = whole.mask;
    body.force = whole.force * (piece.mass.mass / whole.shape.mass());
    return body;
}

}  // namespace

Result<Shattered> shatter(Bodies& bodies, Debris& debris, BodyId id, const FracturePattern& pattern,
                          const ShatterOptions& options) {
    const DebrisPiece* found = debris.find(bodies, id);
    if (!found) return Error{ErrorCode::kInvalid, {}, "there is no such body, or it has no solid"};
    if (options.max_spheres < 1 || options.max_spheres > kMaxSpheres)
        return Error{ErrorCode::kInvalid, {}, "max_spheres is not within 1 to " + std::to_string(kMaxSpheres)};
    const Body whole = *bodies.find(id);
    const DebrisPiece piece_of_whole = *found;
    const Pose pose = pose_of(whole);
    const TurnMatrix turn = matrix_of(pose.rotation);
    FractureOptions cracks = options.fracture;
    cracks.density = whole.shape.mass() / mass_properties(piece_of_whole.solid, 1).volume;
    if (cracks.impact) cracks.impact = turn.back(*cracks.impact - pose.position);
    const Result<Fracture> broken = fracture(piece_of_whole.solid, pattern, cracks);
    if (!broken) return broken.error();
    Shattered result;
    result.cracks = broken.value().cracks;
    result.refused = broken.value().refused;
    const std::vector<FracturePiece>& pieces = broken.value().pieces;
    if (pieces.size() == 1) {
        result.pieces.push_back(id);
        return result;
    }
    const World* level = piece_of_whole.of_part ? nullptr : options.world;
    const std::vector<Part> parts = weighed(pieces, piece_of_whole, options.part ? options.part : level);
    const MotionOfAll motion = motion_of(assembly_of(parts), whole, pose, turn);
    remove_debris(bodies, debris, id);
    for (const auto& [piece, matter] : parts) {
        const Vec3 centre = pose.position + turn * piece.mass.centre, velocity = motion.velocity_at(centre);
        if (piece.mass.volume >= cracks.min_volume) {
            if (Result<Body> body = body_of_piece(piece, whole, pose, options)) {
                body.value().velocity = velocity;
                body.value().spin = motion.spin;
                DebrisPiece part;
                part.solid = piece.solid;
                part.matter = matter;
                part.origin = piece_of_whole.origin;
                part.broken = piece_of_whole.broken + 1;
                part.of_part = piece_of_whole.of_part;
                result.pieces.push_back(add_debris(bodies, debris, std::move(body).value(), std::move(part)));
                continue;
            }
        }
        ++result.dust;
        result.dust_mass += piece.mass.mass;
        const Vec3 momentum = velocity * piece.mass.mass;
        result.dust_momentum += momentum;
        result.dust_angular_momentum +=
            turn * times(piece.mass.inertia, turn.back(motion.spin)) + cross(centre - whole.position, momentum);
    }
    return result;
}

}  // namespace firma
