// SPDX-License-Identifier: MIT
// What a ray from a point sees first, and so where the point lies.
#include "solid/first_seen.h"

#include <cmath>

#include "cast/cast_sphere_polygon.h"
#include "geometry/rounding.h"
#include "index/traverse.h"
#include "solid/face_shape.h"

namespace firma {
namespace {

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

}  // namespace

bool FirstSeen::facets(const IndexedFacets& facets, std::uint32_t first, std::uint32_t count) {
    const Block& block = as_block(facets);
    for (std::uint32_t k = first; k < first + count; ++k) {
        const FaceShape shape(block, block.faces[k]);
        const Contact contact = cast_sweep_polygon(sweep_, shape.polygon, Sides::kBoth, latest_, nullptr);
        if (!contact.touched() || (best_.touched() && contact.t >= latest_)) continue;
        best_ = contact;
        latest_ = contact.t;
        block_ = &block;
        slot_ = k;
    }
    return false;
}

void FirstSeen::look_at(const PolygonShape& polygon, std::uint32_t number) {
    const Contact contact = cast_sweep_polygon(sweep_, polygon, Sides::kBoth, latest_, nullptr);
    if (!contact.touched()) return;
    const bool tie = best_.touched() && contact.t == latest_;
    if (best_.touched() && contact.t >= latest_ && !(tie && !block_ && number < number_)) return;
    best_ = contact;
    latest_ = contact.t;
    block_ = nullptr;
    number_ = number;
    polygon_ = &polygon;
}

Seen FirstSeen::judge(const Vec3& path) const {
    if (!best_.touched()) return {.kind = Seen::Kind::kNothing};
    if (best_.feature != Feature::kFace && best_.status == Status::kHit) return {};
    const auto facing_of = [&](const Vec3& normal) { return dot(path, normal) / length(path); };
    if (!block_) {
        const Seen in_front{.kind = Seen::Kind::kPolygon, .number = number_, .front = true};
        if (best_.status == Status::kTouching) return in_front;
        if (on_rim(*polygon_, sweep_.at(best_.t))) return {};
        const double facing = facing_of(polygon_->unit_normal());
        if (std::fabs(facing) < 0.01) return {};
        return {.kind = Seen::Kind::kPolygon, .number = number_, .front = facing < 0};
    }
    if (best_.status != Status::kHit) return {};
    // A sliver's own plane may look anywhere: it must agree with the exact one.
    const FaceRecord& record = block_->faces[slot_];
    const FaceShape shape(*block_, record);
    if (on_rim(shape.polygon, sweep_.at(best_.t))) return {};
    const Vec3 normal = shape.polygon.unit_normal();
    const FaceOwner* owner = block_->owner_of(record);
    if (owner && dot(owner->normal, normal) < 0.9) return {};
    const double facing = facing_of(normal);
    if (std::fabs(facing) < 0.01) return {};
    return {.kind = facing < 0 ? Seen::Kind::kAir : Seen::Kind::kSolid, .part = block_->part};
}

Seen see_first(const Node* root, const Vec3& point, const SeePolygons* polygons) {
    constexpr Vec3 kWays[] = {{0.36, 0.48, 0.80},  {-0.48, 0.64, -0.60}, {0.60, -0.64, 0.48},  {-0.28, -0.96, 0.02},
                              {0.96, 0.03, -0.28}, {0.02, 0.28, 0.96},   {-0.8, -0.36, -0.48}, {0.64, 0.6, -0.48}};
    for (const Vec3& way : kWays) {
        const Vec3 path = way * kRayLength;
        Sweep sweep;
        if (make_sweep({point, 0}, path, sweep) != Status::kHit) return {};
        FirstSeen first(sweep);
        if (root) traverse(*root, first);
        if (polygons) polygons->look(first);
        const Seen seen = first.judge(path);
        if (seen.kind != Seen::Kind::kUnsure) return seen;
    }
    return {};
}

}  // namespace firma
