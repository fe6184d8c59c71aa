// SPDX-License-Identifier: MIT
// Pieces of a part as bodies.
#include "fracture/part_pieces.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "body/rolling.h"
#include "fracture/clear_spheres.h"
#include "fracture/piece_spheres.h"

namespace firma {
namespace {

double area_of(const Face& face) {
    Vec3 sum;
    for (std::size_t k = 1; k + 1 < face.corners.size(); ++k)
        sum += cross(face.corners[k] - face.corners[0], face.corners[k + 1] - face.corners[0]);
    return 0.5 * length(sum);
}

}  // namespace

std::uint32_t matter_of_surface(const World& world) {
    std::vector<double> areas(matters_of(world).matters.size());
    for (const Face& face : world.faces())
        if (const std::optional<std::uint32_t> of = matter_of(world, face.ref());
            of && face.solid && *of < areas.size())
            areas[*of] += area_of(face);
    return std::uint32_t(std::max_element(areas.begin(), areas.end()) - areas.begin());
}

std::optional<BodyId> PartPieces::add(Bodies& bodies, Debris& debris, DebrisPiece piece,
                                      const MassProperties& mass) const {
    const Pose frame = pose_at(part_.motion, options_.fraction);
    Pose pose = frame;
    pose.position = frame.position + matrix_of(frame.rotation) * piece.origin;
    const std::size_t most = std::clamp<std::size_t>(options_.max_spheres, 1, kMaxSpheres);
    SphereFit fit = piece_spheres(piece.solid, most);
    fit.spheres = clear_spheres(level_, fit.spheres, mass.centre, pose, ~0u);
    const Result<BodyShape> shape = make_body_shape(fit.spheres, mass);
    if (!shape) return std::nullopt;
    Body body = body_at(shape.value(), pose);
    body.rolling = rolling_of(fit, body.rolling);
    if (options_.seconds > 0 && is_finite(options_.seconds)) {
        body.velocity = velocity_at(part_.motion, options_.fraction, body.position) * (1 / options_.seconds);
        body.spin = part_.motion.turn * (1 / options_.seconds);
    }
    piece.of_part = true;
    return add_debris(bodies, debris, std::move(body), std::move(piece));
}

}  // namespace firma
