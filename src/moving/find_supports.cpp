// SPDX-License-Identifier: MIT
// What holds things, and what an edit took of it.
#include <algorithm>
#include <string>
#include <tuple>
#include <utility>

#include "firma/support.h"
#include "moving/part_frame.h"
#include "moving/touch_sides.h"

namespace firma {
namespace {

bool is_length(double metres) {
    return is_finite(metres) && metres >= 0;
}

/// What is wrong with a thing: a clause; null for nothing.
const char* fault_of(const SupportedThing& thing) {
    if (!is_length(thing.reach)) return "its reach is not finite, or negative";
    if (thing.kind > SupportKind::kHangs) return "its kind is none";
    if (thing.sides.empty())
        return thing.box.empty() || !is_finite(thing.box.low) || !is_finite(thing.box.high)
                   ? "its box is empty or not finite"
                   : nullptr;
    for (const SupportSide& side : thing.sides) {
        if (side.corners.size() < 3) return "a side has less than three corners";
        for (const Vec3& corner : side.corners)
            if (!is_finite(corner)) return "a corner is not finite";
        const double size = length(side.normal);
        if (!(size > 0.999 && size < 1.001)) return "the normal of a side is not of length 1";
        if (!is_length(side.depth)) return "the depth of a side is not finite, or negative";
    }
    return nullptr;
}

/// The sides that count, where they are.
std::vector<SupportSide> sides_of(const SupportedThing& thing, double lowered) {
    std::vector<SupportSide> sides = thing.sides.empty() ? sides_of_box(thing.box) : thing.sides;
    if (thing.kind != SupportKind::kStands) return sides;
    // What it may stand on looks up.
    std::erase_if(sides, [](const SupportSide& side) { return !(side.normal.z < -0.5); });
    for (SupportSide& side : sides)
        for (Vec3& corner : side.corners) corner.z -= lowered;
    return sides;
}

/// The least height in front of a side of what is there; more than `reach` where nothing is.
double least_height(const std::vector<TouchedPart>& parts, double reach) {
    double lowest = reach + 1;
    for (const TouchedPart& part : parts) lowest = std::min(lowest, part.lowest);
    return lowest;
}

/// How far behind a side faces count: what is placed has as much room that way, what is put down or hangs has none.
double behind(const Support& support, double offset) {
    return support.thing.kind == SupportKind::kTouches ? support.reach : offset;
}

/// What holds it where it stands or hangs.
void find_faces(const World& world, Support& support) {
    support.faces.clear();
    support.area = 0;
    const std::vector<SupportSide> sides = sides_of(support.thing, support.lowered);
    const double back = behind(support, world.tolerance().contact_offset);
    for (const TouchedPart& part : touched_parts(world, sides, support.reach, back, support.thing.mask)) {
        support.faces.push_back({part.face, part.hash, part.area});
        support.area += part.area;
    }
    std::sort(support.faces.begin(), support.faces.end(), [](const SupportFace& a, const SupportFace& b) {
        return std::tuple(a.face.id, a.hash, a.area) < std::tuple(b.face.id, b.hash, b.area);
    });
    // A face that lies at several sides is told once.
    std::vector<SupportFace> merged;
    for (const SupportFace& face : support.faces) {
        const bool again = !merged.empty() && merged.back().face.id == face.face.id && merged.back().hash == face.hash;
        if (again)
            merged.back().area += face.area;
        else
            merged.push_back(face);
    }
    support.faces = std::move(merged);
}

Support support_of(const World& world, const SupportedThing& thing) {
    Support support;
    support.thing = thing;
    const double offset = world.tolerance().contact_offset;
    support.reach = thing.kind == SupportKind::kTouches ? std::max(offset, thing.reach) : offset;
    if (thing.kind != SupportKind::kTouches && thing.reach > offset) {
        const std::vector<TouchedPart> around =
            touched_parts(world, sides_of(thing, 0), thing.reach, offset, thing.mask);
        const double near = least_height(around, thing.reach);
        if (near <= thing.reach && near > 0) {
            if (thing.kind == SupportKind::kStands)
                support.lowered = near;
            else
                support.reach = near + offset;
        }
    }
    find_faces(world, support);
    return support;
}

std::vector<FaceRef> lost_faces(const Support& before, const Support& after) {
    std::vector<FaceRef> lost;
    for (const SupportFace& face : before.faces) {
        const bool stays = std::any_of(after.faces.begin(), after.faces.end(), [&](const SupportFace& it) {
            return it.face == face.face && it.hash == face.hash;
        });
        if (!stays) lost.push_back(face.face);
    }
    return lost;
}

Vec3 middle_of(const SupportedThing& thing, double lowered) {
    Box box = thing.box;
    for (const SupportSide& side : thing.sides)
        for (const Vec3& corner : side.corners) box.add(corner);
    return (box.low + box.high) * 0.5 - Vec3{0, 0, lowered};
}

/// Of what holds a thing: less is rounding.
constexpr double kShareOfRounding = 1e-9;

SupportLoss loss_of(double before, double after) {
    if (before > 0 && after == 0) return SupportLoss::kAll;
    return after < before * (1 - kShareOfRounding) ? SupportLoss::kSome : SupportLoss::kNone;
}

template <class IsNear>
SupportDiff diff_where(const Supports& before, const World& after, const IsNear& is_near) {
    SupportDiff diff;
    diff.after = before;
    diff.after.world_hash = hash_world(after);
    for (std::size_t k = 0; k < before.things.size(); ++k) {
        const Support& old = before.things[k];
        if (!is_near(old)) continue;
        Support& now = diff.after.things[k];
        find_faces(after, now);
        if (now.faces == old.faces) continue;
        SupportChange change;
        change.thing = k;
        change.entity = old.thing.entity;
        change.loss = loss_of(old.area, now.area);
        change.lost = lost_faces(old, now);
        change.before = old.area;
        change.after = now.area;
        change.buried = locate(after.solid(), middle_of(old.thing, old.lowered)) == Where::kSolid;
        diff.changes.push_back(std::move(change));
    }
    return diff;
}

bool share_a_point(const Box& a, const Box& b) {
    for (int axis = 0; axis < 3; ++axis)
        if (!(a.low[axis] <= b.high[axis] && b.low[axis] <= a.high[axis])) return false;
    return true;
}

}  // namespace

Result<Supports> find_supports(const World& world, const std::vector<SupportedThing>& things) {
    Supports supports;
    for (std::size_t k = 0; k < things.size(); ++k)
        if (const char* fault = fault_of(things[k]))
            return Error{ErrorCode::kInvalid, {}, "thing " + std::to_string(k) + ": " + fault};
    supports.things.reserve(things.size());
    for (const SupportedThing& thing : things) supports.things.push_back(support_of(world, thing));
    supports.world_hash = hash_world(world);
    return supports;
}

SupportDiff diff_supports(const Supports& before, const WorldDiff& diff, const World& after) {
    const double offset = after.tolerance().contact_offset;
    return diff_where(before, after, [&](const Support& support) {
        const std::vector<SupportSide> sides = sides_of(support.thing, support.lowered);
        return share_a_point(box_of_sides(sides, support.reach, behind(support, offset)), diff.bounds);
    });
}

SupportDiff diff_supports(const Supports& before, const World& after) {
    const bool same = hash_world(after) == before.world_hash;
    return diff_where(before, after, [&](const Support&) { return !same; });
}

std::vector<SupportSide> support_sides(const MovingPart& part, double fraction) {
    std::vector<SupportSide> sides;
    if (!is_usable_part(part)) return sides;
    const PartFrame frame(part.motion, fraction);
    // In order of id: each_face() has none.
    for (const Face& face : part.world().faces()) {
        if (!face.solid) continue;
        SupportSide side;
        for (const Vec3& corner : face.corners) side.corners.push_back(frame.out(corner));
        side.normal = frame.direction_out(face.normal);
        sides.push_back(std::move(side));
    }
    return sides;
}

}  // namespace firma
