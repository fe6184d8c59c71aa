// SPDX-License-Identifier: MIT
// Shapes of players: made, swept, and what they overlap.
#include "player/player_shape.h"

#include <algorithm>
#include <string>
#include <tuple>

#include "firma/cast_set.h"
#include "moving/part_frame.h"

namespace firma {
namespace {

constexpr double kShortestUp = 1e-3;
/// In contact offsets: so far beyond the end of a path it is looked. What is come upon at an angle whose sine is below
/// 1 to as many may be met later, nearer than the offset.
constexpr double kAhead = 16;
/// Metres: what lies beyond a path shorter than that is not looked for.
constexpr double kLeastPath = 1e-12;

Error bad_shape(std::string reason) {
    return {ErrorCode::kInvalid, {}, std::move(reason)};
}

std::string fault_of(const PlayerSize& size) {
    if (!is_finite(size.radius) || !(size.radius > 0)) return "the radius of a player is not finite or not above zero";
    for (const double height : {size.height, size.crouched_height})
        if (!is_finite(height) || !(height > 0)) return "a height of a player is not finite or not above zero";
    if (size.crouched_height > size.height) return "a player is lower standing than crouched";
    if (!is_finite(size.up) || !(length(size.up) >= kShortestUp))
        return "the way up of a player is not finite or no way";
    return "";
}

std::shared_ptr<PlayerShapeData> shape_of(const PlayerSize& size, PlayerShapeData::Kind kind) {
    auto shape = std::make_shared<PlayerShapeData>();
    shape->kind = kind;
    shape->given = size;
    shape->radius = size.radius;
    shape->up = size.up * (1 / length(size.up));
    for (const bool crouched : {false, true}) {
        Posture& posture = shape->postures[crouched];
        posture.height = crouched ? size.crouched_height : size.height;
        posture.middle = shape->up * (posture.height * 0.5);
    }
    return shape;
}

/// Unit, perpendicular to each other, the third is `up`.
std::array<Vec3, 3> axes_along(const Vec3& up) {
    int least = 0;
    for (int axis = 1; axis < 3; ++axis)
        if (std::fabs(up[axis]) < std::fabs(up[least])) least = axis;
    Vec3 side;
    side[least] = 1;
    side = side - up * dot(side, up);
    side *= 1 / length(side);
    return {side, cross(up, side), up};
}

double reach_sideways(const SphereSet& spheres, const Vec3& up) {
    double reach = 0;
    for (const Sphere& sphere : spheres)
        reach = std::max(reach, length(sphere.centre - up * dot(sphere.centre, up)) + sphere.radius);
    return reach;
}

Sphere put(const Sphere& sphere, const Vec3& feet) {
    return {sphere.centre + feet, sphere.radius};
}

Capsule put(const Capsule& capsule, const Vec3& feet) {
    return {capsule.from + feet, capsule.to + feet, capsule.radius};
}

}  // namespace

PlayerShape::PlayerShape(std::shared_ptr<const PlayerShapeData> data) : data_(std::move(data)) {}
double PlayerShape::height(bool crouched) const {
    return data_->postures[crouched].height;
}
double PlayerShape::radius() const {
    return data_->radius;
}
const Vec3& PlayerShape::up() const {
    return data_->up;
}

Result<PlayerShape> make_player_capsule(const PlayerSize& size) {
    if (std::string fault = fault_of(size); !fault.empty()) return bad_shape(std::move(fault));
    if (size.crouched_height < size.radius * 2)
        return bad_shape("a capsule of radius " + std::to_string(size.radius) + " m is not as low as " +
                         std::to_string(size.crouched_height) + " m");
    const auto shape = shape_of(size, PlayerShapeData::Kind::kCapsule);
    for (Posture& posture : shape->postures)
        posture.capsule = {shape->up * size.radius, shape->up * (posture.height - size.radius), size.radius};
    return PlayerShape(shape);
}

Result<PlayerShape> make_player_box(const PlayerSize& size) {
    if (std::string fault = fault_of(size); !fault.empty()) return bad_shape(std::move(fault));
    const auto shape = shape_of(size, PlayerShapeData::Kind::kBox);
    for (Posture& posture : shape->postures) {
        const Result<Hull> box = make_box({size.radius, size.radius, posture.height * 0.5}, axes_along(shape->up));
        if (!box) return box.error();
        posture.box = box.value();
    }
    return PlayerShape(shape);
}

Result<PlayerShape> make_player_spheres(std::span<const Sphere> standing, std::span<const Sphere> crouched,
                                        const Vec3& up) {
    PlayerSize size;
    size.up = up;
    if (std::string fault = fault_of(size); !fault.empty()) return bad_shape(std::move(fault));
    if (standing.empty() || std::max(standing.size(), crouched.size()) > kMaxSpheres)
        return bad_shape("a player has 1 to " + std::to_string(kMaxSpheres) + " spheres");
    const auto shape = shape_of(size, PlayerShapeData::Kind::kSpheres);
    for (const bool low : {false, true}) {
        const std::span<const Sphere> spheres = low && !crouched.empty() ? crouched : standing;
        Posture& posture = shape->postures[low];
        posture.spheres.assign(spheres.begin(), spheres.end());
        posture.height = 0;
        for (const Sphere& sphere : spheres) {
            if (!is_finite(sphere.centre) || !is_finite(sphere.radius) || !(sphere.radius > 0))
                return bad_shape("a sphere of a player is not finite or has no radius");
            posture.height = std::max(posture.height, dot(sphere.centre, shape->up) + sphere.radius);
        }
        posture.middle = shape->up * (posture.height * 0.5);
    }
    shape->radius = reach_sideways(shape->postures[0].spheres, shape->up);
    return PlayerShape(shape);
}

std::optional<FaceThere> face_there(const Scene& scene, std::uint32_t part, const FaceRef& face) {
    const World& world = part == kNoPart ? scene.world : scene.parts[part].world();
    const std::optional<FaceInfo> info = world.face_info(face);
    if (!info) return std::nullopt;
    if (part == kNoPart) return FaceThere{info->normal, info->two_sided};
    return FaceThere{PartFrame(scene.parts[part].motion, scene.from).direction_out(info->normal), info->two_sided};
}

PostureIn::PostureIn(const Scene& scene, const PlayerShapeData& shape, bool crouched, std::uint32_t mask, double offset)
    : scene_(&scene), kind_(shape.kind), posture_(&shape.postures[crouched]) {
    options_.mask = near_.mask = mask;
    options_.contact_offset = offset;
}

PartHit PostureIn::sweep(const Vec3& feet, const Vec3& path) const {
    switch (kind_) {
        case PlayerShapeData::Kind::kCapsule:
            return cast(*scene_, put(posture_->capsule, feet), path, options_);
        case PlayerShapeData::Kind::kBox:
            return cast(*scene_, posture_->box, feet + posture_->middle, path, options_);
        case PlayerShapeData::Kind::kSpheres:
            break;
    }
    PartHit first;
    if (scene_->parts.empty()) {
        RigidMotion motion;
        motion.position = feet;
        motion.path = path;
        static_cast<Hit&>(first) = cast(scene_->world, posture_->spheres, motion, options_);
        return first;
    }
    for (const Sphere& sphere : posture_->spheres) {
        const PartHit hit = cast(*scene_, put(sphere, feet), path, options_);
        if (hit.touched() && (!first.touched() || hit.fraction < first.fraction)) first = hit;
    }
    return first;
}

// Else a way shorter than the offset would never meet what it leads to, and go on until that is touched.
PartHit PostureIn::sweep_ahead(const Vec3& feet, const Vec3& path) const {
    const double size = length(path);
    if (!(size > kLeastPath)) return sweep(feet, path);
    const double longer = 1 + kAhead * options_.contact_offset / size;
    PartHit hit = sweep(feet, path * longer);
    if (!hit.touched()) return hit;
    hit.fraction *= longer;
    hit.safe_fraction *= longer;
    if (hit.safe_fraction < 1) return hit;
    return {};
}

bool PostureIn::is_behind(const Vec3& middle, const PartOverlap& overlap) const {
    const std::optional<FaceThere> face = face_there(*scene_, overlap.part, overlap.face);
    return face && !face->two_sided && dot(middle - overlap.point, face->normal) < 0;
}

void PostureIn::each_overlap(const Vec3& feet, PartOverlapVisitor visit) const {
    const Vec3 middle = feet + posture_->middle;
    bool on = true;
    const auto met = [&](const PartOverlap& overlap) { return is_behind(middle, overlap) || (on = visit(overlap)); };
    switch (kind_) {
        case PlayerShapeData::Kind::kCapsule:
            overlap_each(*scene_, put(posture_->capsule, feet), met, 0, near_);
            return;
        case PlayerShapeData::Kind::kBox:
            overlap_each(*scene_, posture_->box, middle, met, 0, near_);
            return;
        case PlayerShapeData::Kind::kSpheres:
            break;
    }
    for (const Sphere& sphere : posture_->spheres) {
        overlap_each(*scene_, put(sphere, feet), met, 0, near_);
        if (!on) return;
    }
}

bool PostureIn::overlaps(const Vec3& feet) const {
    bool any = false;
    each_overlap(feet, [&](const PartOverlap&) {
        any = true;
        return false;
    });
    return any;
}

PartOverlap PostureIn::deepest_where(const Vec3& feet, PartOverlapVisitor counts) const {
    PartOverlap deepest;
    each_overlap(feet, [&](const PartOverlap& overlap) {
        if (!counts(overlap)) return true;
        const bool first = !deepest.found(), as_deep = overlap.depth == deepest.depth;
        const auto name = [](const PartOverlap& of) { return std::tuple(of.part, of.face.id, of.portal); };
        if (first || overlap.depth > deepest.depth || (as_deep && name(overlap) < name(deepest))) deepest = overlap;
        return true;
    });
    return deepest;
}

Location PostureIn::where(const Vec3& feet) const {
    return locate(scene_->world, feet + posture_->middle);
}

std::uint32_t PostureIn::part_around(const Vec3& feet) const {
    for (std::size_t k = 0; k < scene_->parts.size(); ++k) {
        const MovingPart& part = scene_->parts[k];
        if (!(part.mask & options_.mask)) continue;
        const Vec3 middle = PartFrame(part.motion, scene_->from).in(feet + posture_->middle);
        bool in_bounds = true;
        for (int axis = 0; axis < 3; ++axis)
            in_bounds =
                in_bounds && part.bounds().low[axis] <= middle[axis] && middle[axis] <= part.bounds().high[axis];
        if (in_bounds && locate(part.world(), middle).where == Where::kSolid) return std::uint32_t(k);
    }
    return kNoPart;
}

}  // namespace firma
