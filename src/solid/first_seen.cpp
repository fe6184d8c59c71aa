// SPDX-License-Identifier: MIT
// What a ray from a point sees first, and so where the point lies.
#include "solid/first_seen.h"

#include <algorithm>
#include <cmath>

#include "cast/cast_sphere_polygon.h"
#include "cast/side_met.h"
#include "geometry/rounding.h"
#include "index/traverse.h"
#include "solid/face_shape.h"
#include "solid/near_facets.h"

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

/// Corners are rounded by up to 0.87 steps: what is thinner than this may have its faces the wrong way around, metres.
constexpr double kThin = 2 / kSurfaceSteps;

}  // namespace

FirstSeen::FirstSeen(const Sweep& sweep)
    : sweep_(sweep),
      boxes_(sweep),
      window_(kThin / (kGrazingSine * sweep.direction_length)),
      latest_(sweep.end),
      first_side_{INFINITY, INFINITY},
      first_polygon_(INFINITY) {}

void FirstSeen::keep(const Contact& contact) {
    best_ = contact;
    latest_ = std::min(latest_, contact.t + window_);
}

bool FirstSeen::facets(const IndexedFacets& facets, std::uint32_t first, std::uint32_t count) {
    const Block& block = as_block(facets);
    for (std::uint32_t k = first; k < first + count; ++k) {
        const FaceShape shape(block, block.faces[k]);
        if (!shape.polygon.has_area()) continue;
        const Contact contact = cast_sweep_polygon(sweep_, shape.polygon, Sides::kBoth, latest_, nullptr);
        if (!contact.touched()) continue;
        double& first_so = first_side_[dot(sweep_.direction, shape.polygon.normal) > 0];
        first_so = std::min(first_so, contact.t);
        if (best_.touched() && contact.t >= best_.t) continue;
        keep(contact);
        block_ = &block;
        slot_ = k;
    }
    return false;
}

void FirstSeen::look_at(const PolygonShape& polygon, std::uint32_t number) {
    const Contact contact = cast_sweep_polygon(sweep_, polygon, Sides::kBoth, latest_, nullptr);
    if (!contact.touched()) return;
    first_polygon_ = std::min(first_polygon_, contact.t);
    const bool tie = best_.touched() && contact.t == best_.t;
    if (best_.touched() && contact.t >= best_.t && !(tie && !block_ && number < number_)) return;
    keep(contact);
    block_ = nullptr;
    number_ = number;
    polygon_ = &polygon;
}

Seen FirstSeen::judge() const {
    if (!best_.touched()) return {.kind = Seen::Kind::kNothing};
    const auto is_thin = [&](const PolygonShape& seen, double a, double b) {
        return std::fabs(a - b) * std::fabs(dot(sweep_.direction, seen.unit_normal())) < kThin;
    };
    // Air that is so thin between a face and a polygon may be on either side of both.
    const double first_face = std::min(first_side_[0], first_side_[1]);
    if (!block_) {
        const bool touching = best_.status == Status::kInitialOverlap;
        const int side = touching ? 1 : side_met(sweep_, *polygon_, best_, kRim);
        if (side == 0 || (!touching && is_thin(*polygon_, first_face, first_polygon_))) return {};
        return {.kind = Seen::Kind::kPolygon, .number = number_, .front = side > 0};
    }
    if (best_.status != Status::kHit) return {};
    const FaceRecord& record = block_->faces[slot_];
    const FaceShape shape(*block_, record);
    const int side = side_met(sweep_, shape.polygon, best_, kRim);
    if (side == 0 || is_thin(shape.polygon, first_side_[0], first_side_[1]) ||
        is_thin(shape.polygon, first_face, first_polygon_))
        return {};
    // A sliver's own plane may look anywhere: it must agree with the exact one.
    const FaceOwner* owner = block_->owner_of(record);
    if (owner && dot(owner->normal, shape.polygon.unit_normal()) < 0.9) return {};
    return {.kind = side > 0 ? Seen::Kind::kAir : Seen::Kind::kSolid, .part = block_->part};
}

Seen see_first(const Node* root, const Vec3& point, const SeePolygons* polygons) {
    for (const Vec3& way : kRayWays) {
        Sweep sweep;
        if (make_sweep({point, 0}, way * kRayLength, sweep) != Status::kHit) return {};
        FirstSeen first(sweep);
        if (root) traverse(*root, first);
        if (polygons) polygons->look(first);
        const Seen seen = first.judge();
        if (seen.kind != Seen::Kind::kUnsure) return seen;
    }
    if (root && on_some_facet(*root, point)) return {.kind = Seen::Kind::kSurface};
    return {};
}

}  // namespace firma
