// SPDX-License-Identifier: MIT
// Clips that stand on walls: what of them stands straight over a hole.
#include "world/clip_columns.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <tuple>
#include <utility>

#include "base/sort.h"
#include "carve/gather.h"
#include "world/share_corner.h"

namespace firma {
namespace {

/// Metres: corners were rounded to half a surface step along each axis, some of them twice.
constexpr double kCornerSlack = 4 / kSurfaceSteps;
/// Metres: a narrower face says nothing about its plane.
constexpr double kNarrowest = 16 / kSurfaceSteps;
/// Metres: so far a column reaches beyond the highest corner of its clips, whatever was rounded.
constexpr double kOverClips = 8 / kInputSteps;

/// A clip stops only one of both.
constexpr std::uint32_t kLackedByClips = kStopsWalk | kStopsShots;

Vec3 corner_of(const FacetPlace& facet, std::uint32_t k) {
    return to_metres(facet.block->corner(facet.record(), k));
}

std::vector<Vec3> corners_of(const FacetPlace& facet) {
    std::vector<Vec3> corners;
    for (std::uint32_t k = 0; k < facet.record().corner_count; ++k) corners.push_back(corner_of(facet, k));
    return corners;
}

Vec3 facing_of(const FacetPlace& facet) {
    if (const FaceOwner* owner = facet.block->owner_of(facet.record())) return owner->normal;
    Vec3 sum;
    for (std::uint32_t k = 2; k < facet.record().corner_count; ++k)
        sum = sum + cross(corner_of(facet, k - 1) - corner_of(facet, 0), corner_of(facet, k) - corner_of(facet, 0));
    const double area = length(sum);
    return area > 0 ? sum * (1 / area) : sum;
}

bool lies_in(const WallPlane& wall, const Vec3& p) {
    return std::fabs(wall.height(p)) <= kCornerSlack;
}

/// Of the edge from a corner to the next.
bool has_edge_in(const FacetPlace& facet, std::uint32_t k, const WallPlane& wall) {
    return lies_in(wall, corner_of(facet, k)) &&
           lies_in(wall, corner_of(facet, k + 1 < facet.record().corner_count ? k + 1 : 0));
}

bool has_edge_in(const FacetPlace& facet, const WallPlane& wall) {
    for (std::uint32_t k = 0; k < facet.record().corner_count; ++k)
        if (has_edge_in(facet, k, wall)) return true;
    return false;
}

/// To have walls of one plane side by side. Planes that differ by rounding may have different ones: then they are two
/// walls with the same columns.
using WallKey = std::array<double, 4>;

WallKey wall_key(const WallPlane& plane) {
    WallKey key;
    for (int axis = 0; axis < 3; ++axis) key[std::size_t(axis)] = std::floor(plane.normal[axis] * 65536 + 0.5);
    key[3] = std::floor(plane.offset * kInputSteps + 0.5);
    return key;
}

std::int32_t to_steps(double metres) {
    return std::int32_t(std::clamp(std::floor(metres * kSurfaceSteps + 0.5), double(INT32_MIN), double(INT32_MAX)));
}

/// A box, and what lies straight out from it.
GridBox reach_over(GridBox box, const Vec3& way) {
    GridPoint low, high;
    for (int axis = 0; axis < 3; ++axis) {
        low[axis] = to_steps(box.low[axis] / kSurfaceSteps + way[axis]);
        high[axis] = to_steps(box.high[axis] / kSurfaceSteps + way[axis]);
    }
    box.add(low);
    box.add(high);
    return box;
}

}  // namespace

ClipColumns::ClipColumns(const FaceStore& open, const FaceStore& solid, const CarveRules& rules,
                         const SolidChange& change, const CutterSolid& cutter,
                         std::function<bool(const FaceRecord&)> may_go)
    : open_(open),
      solid_(solid),
      rules_(rules),
      change_(change),
      cutter_(cutter),
      near_box_(grown(cutter.box, std::int32_t(kReach * kSurfaceSteps))),
      may_go_(std::move(may_go)) {}

bool ClipColumns::step() {
    switch (phase_) {
        case Phase::kClips:
            find_clips();
            phase_ = near_.empty() ? Phase::kEnd : Phase::kWalls;
            break;
        case Phase::kWalls:
            find_walls();
            phase_ = Phase::kNextWall;
            break;
        case Phase::kNextWall:
            if (next_wall_ < walls_.size())
                find_columns(next_wall_++);
            else
                phase_ = Phase::kEnd;
            break;
        case Phase::kEnd:
            break;
    }
    return phase_ != Phase::kEnd;
}

void ClipColumns::find_clips() {
    gather_facets(open_.root.get(), near_box_, near_, kLackedByClips);
    std::erase_if(near_, [&](const FacetPlace& facet) { return !is_clip(facet.record()) || !may_go_(facet.record()); });
}

void ClipColumns::find_walls() {
    struct Taken {
        WallKey key;
        FacetPlace facet;
    };
    std::vector<Taken> taken;
    const GridBox box = grown(cutter_.box, 1);
    for (const FacetPlace& facet : change_.removed)
        if (boxes_meet(box, facet.block->box_of(facet.record())))
            taken.push_back({wall_key(wall_plane(facing_of(facet), facet.block->corner(facet.record(), 0))), facet});
    sort_range(taken, [](const Taken& a, const Taken& b) {
        return std::tuple(a.key, a.facet.record().id) < std::tuple(b.key, b.facet.record().id);
    });
    for (std::size_t first = 0, end = 0; first < taken.size(); first = end) {
        Wall wall;
        for (end = first; end < taken.size() && taken[end].key == taken[first].key; ++end)
            wall.facets.push_back(taken[end].facet);
        const FacetPlace& facet = wall.facets[0];
        wall.plane = wall_plane(facing_of(facet), facet.block->corner(facet.record(), 0));
        if (std::any_of(near_.begin(), near_.end(),
                        [&](const FacetPlace& clip) { return has_edge_in(clip, wall.plane); }))
            walls_.push_back(std::move(wall));
    }
}

/// Where clips stand on a wall and the cutter takes any of it.
void ClipColumns::find_columns(std::uint32_t number) {
    Wall& wall = walls_[number];
    const GridBox box = reach_over(cutter_.box, wall.plane.normal * kReach);
    std::vector<FacetPlace> over;
    for (const FacetPlace& facet : near_)
        if (boxes_meet(box, facet.block->box_of(facet.record())) && dot(facing_of(facet), wall.plane.normal) > 0)
            over.push_back(facet);
    if (over.empty()) return;
    wall.hole = WallHole(section_of(cutter_, wall.plane), wall.plane);
    if (!takes_of(wall.hole, wall)) return;
    std::erase_if(over, [&](const FacetPlace& facet) { return !may_be_over(number, facet); });
    find_clips_on(wall, over);
    if (wall.clips.size() == 0) return;
    for (PlacedCutter& column : wall.hole.raise(wall.height + kOverClips))
        columns_.push_back({number, std::move(column)});
}

bool ClipColumns::takes_of(const WallHole& hole, const Wall& wall) {
    return !hole.empty() && std::any_of(wall.facets.begin(), wall.facets.end(),
                                        [&](const FacetPlace& facet) { return hole.takes_of(corners_of(facet)); });
}

bool ClipColumns::may_be_over(std::uint32_t wall, const FacetPlace& facet) const {
    return walls_[wall].hole.may_be_over(corners_of(facet));
}

/// @param over  their far sides, over the hole
void ClipColumns::find_clips_on(Wall& wall, std::span<const FacetPlace> over) {
    FlatMap seen;
    for (const FacetPlace& seed : over) {
        if (seen.find(seed.record().id.value) != FlatMap::kNone) continue;
        const Clip& clip = clip_from(seed);
        const double high = height_over(clip, wall.plane);
        for (const FacetPlace& facet : clip.faces) {
            seen.at(facet.record().id.value) = 0;
            if (high > 0 && may_lose(facet)) wall.clips.at(facet.record().id.value) = 0;
        }
        wall.height = std::max(wall.height, high);
    }
}

bool ClipColumns::ClipPlane::valid() const {
    return width >= kNarrowest;
}

double ClipColumns::ClipPlane::slack(const Vec3& p) const {
    return kCornerSlack * (1 + length(p - at) / width);
}

/// And its corners, in `loop_`.
ClipColumns::ClipPlane ClipColumns::plane_of(const FacetPlace& facet) {
    loop_.clear();
    for (std::uint32_t k = 0; k < facet.record().corner_count; ++k) loop_.push_back(corner_of(facet, k));
    Vec3 sum;
    double longest = 0;
    for (std::size_t k = 0; k < loop_.size(); ++k) {
        const Vec3 side = loop_[k + 1 < loop_.size() ? k + 1 : 0] - loop_[k];
        longest = std::max(longest, length(side));
        if (k >= 2) sum = sum + cross(loop_[k - 1] - loop_[0], loop_[k] - loop_[0]);
    }
    const double area = length(sum);
    ClipPlane plane;
    plane.at = loop_[0];
    if (!(area > 0)) return plane;
    plane.normal = sum * (1 / area);
    plane.width = area / longest;
    return plane;
}

/// The clip that a face is part of; another may find a little more of it or less.
const ClipColumns::Clip& ClipColumns::clip_from(const FacetPlace& seed) {
    std::uint32_t& number = clip_from_.at(seed.record().id.value);
    if (number == FlatMap::kNone) {
        number = std::uint32_t(clips_.size());
        grow(seed, clips_.emplace_back());
    }
    return clips_[number];
}

/// Face by face, neighbours in order of ids. Of a clip that cuts divided there may be hundreds of faces: far ones, as
/// they come, up to a number.
void ClipColumns::grow(const FacetPlace& seed, Clip& clip) {
    in_clip_.clear();
    planes_.clear();
    if (!take_in(seed, clip)) return;
    std::size_t far = 0;
    for (std::size_t next = 0; next < clip.faces.size(); ++next) {
        const FacetPlace facet = clip.faces[next];
        beside_.clear();
        gather_facets(open_.root.get(), facet.block->box_of(facet.record()), beside_, kLackedByClips);
        for (const FacetPlace& other : beside_) {
            if (in_clip_.find(other.record().id.value) != FlatMap::kNone) continue;
            if (!is_clip(other.record()) || !may_go_(other.record())) continue;
            const bool is_far = !boxes_meet(near_box_, other.block->box_of(other.record()));
            if (is_far && far == kMostFar) continue;
            if (share_a_corner(facet, other) && take_in(other, clip)) far += is_far;
        }
    }
}

/// Where it is not yet, and lies behind all others and they behind it.
bool ClipColumns::take_in(const FacetPlace& facet, Clip& clip) {
    const ClipPlane own = plane_of(facet);
    bool known = false;
    for (ClipPlane& plane : planes_) {
        bool flush = dot(plane.normal, own.normal) > 0.5;
        for (const Vec3& corner : loop_) {
            const double height = plane.height(corner), slack = plane.slack(corner);
            if (height > slack) return false;
            flush = flush && height >= -slack;
        }
        known |= flush;
        if (flush && own.width > plane.width) plane = own;
    }
    if (!known && own.valid()) {
        for (const Vec3& corner : clip.corners)
            if (own.height(corner) > own.slack(corner)) return false;
        planes_.push_back(own);
    }
    in_clip_.at(facet.record().id.value) = 0;
    clip.faces.push_back(facet);
    clip.corners.insert(clip.corners.end(), loop_.begin(), loop_.end());
    return true;
}

/// Metres; 0: the clip does not stand on the wall.
double ClipColumns::height_over(const Clip& clip, const WallPlane& wall) {
    double highest = kCornerSlack;
    for (const Vec3& corner : clip.corners) highest = std::max(highest, wall.height(corner));
    if (highest <= kCornerSlack) return 0;
    return std::any_of(clip.faces.begin(), clip.faces.end(),
                       [&](const FacetPlace& facet) { return touches(facet, wall); })
               ? highest
               : 0;
}

bool ClipColumns::touches(const FacetPlace& facet, const WallPlane& wall) {
    const std::uint32_t count = facet.record().corner_count;
    for (std::uint32_t k = 0; k < count; ++k) {
        const std::uint32_t next = k + 1 < count ? k + 1 : 0;
        if (has_edge_in(facet, k, wall) &&
            touches(facet.block->corner(facet.record(), k), facet.block->corner(facet.record(), next), wall))
            return true;
    }
    return false;
}

/// Whether some of an edge in the wall's plane lies on a face there.
bool ClipColumns::touches(const GridPoint& from, const GridPoint& to, const WallPlane& wall) {
    GridBox box;
    box.add(from);
    box.add(to);
    beside_.clear();
    gather_facets(solid_.root.get(), grown(box, 1), beside_);
    const Vec3 start = to_metres(from), way = to_metres(to) - start;
    return std::any_of(beside_.begin(), beside_.end(), [&](const FacetPlace& facet) {
        const std::uint32_t count = facet.record().corner_count;
        if (dot(facing_of(facet), wall.normal) < 0.999) return false;
        double enters = 0, leaves = 1;
        for (std::uint32_t k = 0; k < count; ++k) {
            const Vec3 corner = corner_of(facet, k), next = corner_of(facet, k + 1 < count ? k + 1 : 0);
            if (!lies_in(wall, corner)) return false;
            const Vec3 inward = cross(wall.normal, next - corner);
            const double at = dot(inward, start - corner) + kCornerSlack * length(inward), more = dot(inward, way);
            if (more > 0)
                enters = std::max(enters, -at / more);
            else if (more < 0)
                leaves = std::min(leaves, -at / more);
            else if (at < 0)
                return false;
        }
        return (leaves - enters) * length(way) > kNarrowest;
    });
}

bool ClipColumns::may_lose(const FacetPlace& facet) const {
    const GridBox box = grown(facet.block->box_of(facet.record()), kSurfacePerInput);
    const Vec3 low = to_metres(box.low), high = to_metres(box.high);
    return std::none_of(rules_.zones.begin(), rules_.zones.end(), [&](const CarveZone& zone) {
        if (zone.hardness < 1) return false;
        for (int axis = 0; axis < 3; ++axis)
            if (low[axis] > zone.box.high[axis] || high[axis] < zone.box.low[axis]) return false;
        return true;
    });
}

}  // namespace firma
