// SPDX-License-Identifier: MIT
// Is a point in the solid: the first face that a ray from it meets says so.
#include <cmath>

#include "cast/cast_sphere_polygon.h"
#include "firma/world.h"
#include "geometry/rounding.h"
#include "tree/sweep_box.h"
#include "tree/visit.h"
#include "world/block_faces.h"
#include "world/world_data.h"

namespace firma {
namespace {

/// The first face of the solid along a ray, either side.
struct FirstSolid {
    const Sweep& sweep;
    const SweepBox boxes;
    double latest;
    Contact best;
    const Block* block = nullptr;
    std::uint32_t slot = 0;

    bool enter(const Bin& bin, double& nearest) const { return boxes.enters(bin.box, latest, nearest); }
    bool still(double nearest) const { return nearest <= latest; }
    bool faces(const Block& in, std::uint32_t first, std::uint32_t count) {
        for (std::uint32_t k = first; k < first + count; ++k) {
            if (!in.faces[k].solid) continue;
            const FaceShape shape(in, in.faces[k]);
            const Contact contact = cast_sweep_polygon(sweep, shape.polygon, Sides::kBoth, latest, nullptr);
            if (!contact.touched() || (best.touched() && contact.t >= latest)) continue;
            best = contact;
            latest = contact.t;
            block = &in;
            slot = k;
        }
        return false;
    }
};

constexpr double kRayLength = 4 * kWorldRim;  ///< from anywhere in the world to well outside

/// Bound on how far off the point is where such a ray is found to meet a face, metres. Height over the plane and
/// approach to it are off by rounding(16) of the sizes, and double is used down to an approach of an eighth: 128 of the
/// distance to a corner, and as much of the way there. Twice that covers the point's own sum.
constexpr double kMeetingError = rounding(512) * (kRayLength + 2 * kWorldRim);

/// Where two faces meet at an angle of 0.03 or more (radians), a ray that passes their edge at this distance meets them
/// farther apart than the error; nearer to the edge, or in a sharper corner, either may seem to be first.
constexpr double kRim = 1e-7;  // metres
static_assert(kRim * 0.03 > kMeetingError);

/// Whether a point of a polygon lies so near to its rim that rounding decides which of two neighbours is met first: of
/// a surface that a ray only grazes, either may be.
bool on_rim(const PolygonShape& polygon, const Vec3& point) {
    for (std::size_t k = 0; k < polygon.corners.size(); ++k) {
        const Vec3 edge = polygon.corners[polygon.next(k)] - polygon.corners[k];
        if (length(cross(edge, point - polygon.corners[k])) < kRim * length(edge)) return true;
    }
    return false;
}

enum class Answer { kAir, kSolid, kNothingMet, kUnsure, kBad };

Answer look(const World& world, const Vec3& point, const Vec3& path) {
    Sweep sweep;
    if (make_sweep({point, 0}, path, sweep) != Status::kHit) return Answer::kBad;
    FirstSolid first{sweep, SweepBox(sweep), sweep.end, {}};
    for (const Ref<const Room>& room : world.data().rooms)
        if (room->tree) visit(*room->tree, first);
    if (!first.best.touched()) return Answer::kNothingMet;
    if (first.best.feature != Feature::kFace || first.best.status != Status::kHit) return Answer::kUnsure;
    // A sliver's own plane may look anywhere: it must agree with the exact one.
    const FaceRecord& record = first.block->faces[first.slot];
    const FaceShape shape(*first.block, record);
    if (on_rim(shape.polygon, sweep.at(first.best.t))) return Answer::kUnsure;
    const Vec3 normal = shape.polygon.unit_normal();
    const FaceOwner* owner = first.block->owner_of(record);
    if (owner && dot(owner->normal, normal) < 0.9) return Answer::kUnsure;
    const double facing = dot(path, normal) / length(path);
    if (std::fabs(facing) < 0.01) return Answer::kUnsure;
    return facing < 0 ? Answer::kAir : Answer::kSolid;
}

}  // namespace

std::optional<bool> in_solid(const World& world, const Vec3& point) {
    constexpr Vec3 kWays[] = {{0.36, 0.48, 0.80},  {-0.48, 0.64, -0.60}, {0.60, -0.64, 0.48},  {-0.28, -0.96, 0.02},
                              {0.96, 0.03, -0.28}, {0.02, 0.28, 0.96},   {-0.8, -0.36, -0.48}, {0.64, 0.6, -0.48}};
    for (const Vec3& way : kWays) {
        switch (look(world, point, way * kRayLength)) {
            case Answer::kAir:
                return false;
            case Answer::kSolid:
                return true;
            case Answer::kNothingMet:
                return world.data().rock_outside;
            case Answer::kUnsure:
                break;
            case Answer::kBad:
                return {};
        }
    }
    return {};
}

}  // namespace firma
