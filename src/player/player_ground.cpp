// SPDX-License-Identifier: MIT
// Ground: the faces at a touch, and what lies below a middle that is beyond an edge.
#include "player/player_ground.h"

#include "firma/turn.h"

namespace firma {
namespace {

/// Rounding, a cosine: a face as steep as the rule says is walked on.
constexpr double kSlopeRounding = 1e-9;
/// Slop, metres: faces as near to a touch have part in it. Facets of cuts lie as far beside their edges (grid.h).
constexpr double kAtTouch = 1e-5;
/// Slop, a cosine: what is touched steeper than that is beside a player, not under it.
constexpr double kUnder = 0.01;

}  // namespace

GroundRules::GroundRules(const Scene& scene, const PlayerShapeData& shape, const PlayerRules& rules, std::uint32_t mask,
                         double offset)
    : scene_(scene),
      shape_(shape),
      rules_(rules),
      mask_(mask),
      least_up_(sine_cosine(rules.max_slope).cosine - kSlopeRounding),
      offset_(offset) {}

Vec3 GroundRules::flattest_at(const PartHit& hit) const {
    const auto outward = [&](const Vec3& normal, bool two_sided) {
        return two_sided && dot(normal, hit.normal) < 0 ? -normal : normal;
    };
    Vec3 best = outward(hit.face_normal, hit.portal.valid());
    if (hit.feature == Feature::kFace && walkable(best)) return best;
    NearOptions near;
    near.mask = mask_;
    overlap_each(
        scene_, Sphere{hit.point, kAtTouch},
        [&](const PartOverlap& overlap) {
            const std::optional<FaceThere> face = face_there(scene_, overlap.part, overlap.face);
            if (!face) return true;
            const Vec3 normal = outward(face->normal, face->two_sided);
            if (dot(normal, shape_.up) > dot(best, shape_.up)) best = normal;
            return true;
        },
        0, near);
    return best;
}

bool GroundRules::ground_below(const Vec3& feet) const {
    CastOptions options;
    options.mask = mask_;
    const double far = shape_.radius + rules_.step_height + 2 * offset_;
    const Hit hit = cast(scene_, Ray{feet + shape_.up * shape_.radius, shape_.up * -far}, options);
    return hit && walkable(hit.normal);
}

Ground GroundRules::under(const PartHit& hit, const Vec3& feet) const {
    Ground ground;
    if (!hit.touched() || !(dot(hit.normal, shape_.up) > kUnder)) return ground;
    ground.normal = flattest_at(hit);
    if (!walkable(ground.normal)) return ground;
    const Vec3 beside = hit.point - feet, across = beside - shape_.up * dot(beside, shape_.up);
    ground.carries = length(across) <= rules_.overhang * shape_.radius || ground_below(feet);
    return ground;
}

}  // namespace firma
