// SPDX-License-Identifier: MIT
// The rooms of a joined level.
#include "join/find_rooms.h"

#include <algorithm>
#include <cmath>

#include "cast/cast_sphere_polygon.h"
#include "cast/side_met.h"
#include "firma/tree_options.h"
#include "geometry/mesh_shells.h"
#include "geometry/polygon_shape.h"
#include "index/sweep_box.h"
#include "index/traverse.h"
#include "solid/append_faces.h"
#include "solid/build_blocks.h"

namespace firma {
namespace {

constexpr double kLineLength = 8 * kWorldRim;  ///< from beyond the world to beyond it

/// Crossings nearer to each other, or to a facet's rim, may be told in the wrong order (metres).
constexpr double kTooNear = 1e-6;

/// Metres in front of a polygon, where one looks for the room that it is met from: it may lie on a portal.
constexpr double kBeforeFace = 0.001;

/// Of a facet's corners: somewhere inside it, for each try somewhere else.
Vec3 inside(std::span<const GridPoint> corners, std::size_t attempt) {
    Vec3 sum{0, 0, 0};
    double weights = 0;
    for (std::size_t k = 0; k < corners.size(); ++k) {
        const double weight = k == attempt % corners.size() ? 1 + double(attempt) / 2 : 1;
        sum = sum + to_metres(corners[k]) * weight;
        weights += weight;
    }
    return sum * (1 / weights);
}

struct Touch {
    double t;
    std::uint32_t facet;
    bool front;
};

/// Every facet that a line meets.
struct AllOnLine {
    const Sweep& sweep;
    const SweepBox boxes;
    std::vector<Touch>& touches;
    bool sure = true;

    bool enter(const BoxF& box, double& nearest) const { return boxes.enters(box, sweep.end, nearest); }
    bool still(double) const { return true; }
    bool facets(const IndexedFacets& facets, std::uint32_t first, std::uint32_t count) {
        const Block& in = as_block(facets);
        for (std::uint32_t k = first; k < first + count; ++k) {
            Vec3 corners[kMaxCorners];
            const FaceRecord& face = in.faces[k];
            for (std::size_t c = 0; c < face.corner_count; ++c) corners[c] = to_metres(in.corner(face, c));
            look({corners, face.corner_count}, face.source);
        }
        return !sure;
    }
    void look(std::span<const Vec3> corners, std::uint32_t facet) {
        const PolygonShape shape = make_shape(corners);
        const Contact contact = cast_sweep_polygon(sweep, shape, Sides::kBoth, sweep.end, nullptr);
        if (!contact.touched()) return;
        const int side = side_met(sweep, shape, contact, kTooNear);
        sure = sure && side != 0;
        touches.push_back({contact.t, facet, side > 0});
    }
};

}  // namespace

RoomFinder::RoomFinder(std::size_t face_count, std::size_t portal_count, const JoinFacets& facets, bool rock_outside)
    : faces_(face_count), portals_(portal_count), rock_outside_(rock_outside), facets_(facets) {
    FaceSet set;
    polygon_of_.resize(facets.corners.size());
    for (std::uint32_t polygon = 0; polygon + 1 < facets.first.size(); ++polygon)
        for (std::uint32_t k = facets.first[polygon]; k < facets.first[polygon + 1]; ++k) {
            polygon_of_[k] = polygon;
            FaceSet::Entry entry;
            entry.id = {k};
            entry.source = k;
            add_facet(set, facets.corners[k], entry);
        }
    TreeOptions options;
    options.split = Split::kSurfaceArea;
    tree_ = BlockBuilder().build(set, options);
}

/// @param at  where on the line the point lies
/// @return false when the order of what the line meets is in doubt
bool RoomFinder::cross_level(const Vec3& through, const Vec3& way, std::vector<Crossing>& crossings, double& at) const {
    crossings.clear();
    Sweep sweep;
    const Vec3 path = way * kLineLength;
    if (make_sweep({through - path * 0.5, 0}, path, sweep) != Status::kHit) return false;
    at = sweep.end * 0.5;
    if (!tree_) return true;
    std::vector<Touch> touches;
    AllOnLine all{sweep, SweepBox(sweep), touches};
    traverse(*tree_, all);
    if (!all.sure) return false;
    for (const Touch& touch : touches) crossings.push_back({touch.t, touch.facet, touch.front});
    std::sort(crossings.begin(), crossings.end(),
              [](const Crossing& a, const Crossing& b) { return a.t != b.t ? a.t < b.t : a.facet < b.facet; });
    const double near = kTooNear / sweep.direction_length;
    for (std::size_t k = 1; k < crossings.size(); ++k)
        if (crossings[k].t - crossings[k - 1].t < near) return false;
    return true;
}

/// Goes along a line from infinity to infinity.
/// @param join  (side, side): the two see each other through air. The exterior is the side after all others
/// @return false where the line passes from air into air, or from solid into solid
template <class Join>
bool RoomFinder::follow(std::span<const Crossing> crossings, const Join& join) const {
    const auto outside = std::uint32_t(faces_ + 2 * portals_);
    std::uint32_t last = rock_outside_ ? kSolid : outside;
    for (const Crossing& crossing : crossings) {
        const std::uint32_t polygon = polygon_of_[crossing.facet];
        if (polygon >= faces_) {
            const auto front = std::uint32_t(faces_ + 2 * (polygon - faces_));
            if (last == kSolid) return false;
            join(last, crossing.front ? front : front + 1);
            last = crossing.front ? front + 1 : front;
        } else if (crossing.front) {
            if (last == kSolid) return false;
            join(last, polygon);
            last = kSolid;
        } else {
            if (last != kSolid) return false;
            last = polygon;
        }
    }
    if ((last == kSolid) != rock_outside_) return false;
    if (!rock_outside_) join(last, outside);
    return true;
}

/// Joins what lines through a polygon tell.
bool RoomFinder::hang(std::uint32_t polygon, DisjointSets& sides) const {
    std::vector<Crossing> crossings;
    const auto nothing = [](std::uint32_t, std::uint32_t) {};
    for (std::size_t attempt = 0; attempt < 4; ++attempt)
        for (const Vec3& way : kRayWays)
            for (std::uint32_t k = facets_.first[polygon]; k < facets_.first[polygon + 1]; ++k) {
                double at;
                if (!cross_level(inside(facets_.corners[k], attempt), way, crossings, at)) continue;
                if (!follow(crossings, nothing)) continue;
                follow(crossings, [&](std::uint32_t a, std::uint32_t b) { sides.join(a, b); });
                return true;
            }
    return false;
}

JoinRooms RoomFinder::find(DisjointSets seen_together) const {
    const std::size_t sides = faces_ + 2 * portals_;
    DisjointSets all(sides + 1);
    for (std::uint32_t k = 0; k < sides; ++k) all.join(k, seen_together.find(k));

    // A shell whose fronts look outward hangs in the air of another, or in the exterior's.
    std::vector<Int128> volume(sides);
    std::vector<std::vector<std::pair<double, std::uint32_t>>> largest(
        sides);  // polygons, by what is left of their size
    constexpr std::size_t kTried = 8;
    for (std::uint32_t side = 0; side < sides; ++side) {
        const std::uint32_t polygon = side < faces_ ? side : std::uint32_t(faces_ + (side - faces_) / 2);
        const bool back = side >= faces_ && ((side - faces_) & 1);
        const std::uint32_t shell = seen_together.find(side);
        GridBox box;
        for (std::uint32_t k = facets_.first[polygon]; k < facets_.first[polygon + 1]; ++k) {
            const Int128 cone = six_times_cone(facets_.corners[k], {});
            volume[shell] += back ? -cone : cone;
            for (const GridPoint& corner : facets_.corners[k]) box.add(corner);
        }
        if (facets_.count(polygon) == 0) continue;
        std::vector<std::pair<double, std::uint32_t>>& list = largest[shell];
        list.push_back({-box.half_area(), polygon});
        std::sort(list.begin(), list.end());
        if (list.size() > kTried) list.pop_back();
    }
    JoinRooms rooms;
    for (std::uint32_t side = 0; side < sides; ++side) {
        if (largest[side].empty() || volume[side] < 0) continue;
        bool hung = false;
        for (const auto& [size, polygon] : largest[side]) hung = hung || hang(polygon, all);
        rooms.lost += !hung;
    }

    std::vector<std::uint32_t> number(sides + 1, ~0u);
    const std::uint32_t outside = all.find(std::uint32_t(sides));
    for (std::uint32_t side = 0; side < sides; ++side) {
        const std::uint32_t set = all.find(side);
        if (set != outside && number[set] == ~0u) number[set] = rooms.count++;
    }
    if (!rock_outside_) number[outside] = rooms.count++;
    for (std::uint32_t side = 0; side < sides; ++side) rooms.of_side.push_back(number[all.find(side)]);
    return rooms;
}

std::uint32_t RoomFinder::room_of(const JoinRooms& rooms, std::span<const GridPoint> corners) const {
    std::vector<Vec3> metres;
    for (const GridPoint& corner : corners) metres.push_back(to_metres(corner));
    const Vec3 normal = make_shape(metres).unit_normal();
    for (const double off : {kBeforeFace, 0.0, -kBeforeFace})
        for (std::size_t attempt = 0; attempt < 4; ++attempt) {
            const std::uint32_t room = room_at(rooms, inside(corners, attempt) + normal * off);
            if (room < rooms.count) return room;
        }
    return rooms.count - 1;
}

std::uint32_t RoomFinder::room_at(const JoinRooms& rooms, const Vec3& point) const {
    std::vector<Crossing> crossings;
    const auto nothing = [](std::uint32_t, std::uint32_t) {};
    for (const Vec3& way : kRayWays) {
        double at;
        if (!cross_level(point, way, crossings, at) || !follow(crossings, nothing)) continue;
        const Crossing* last = nullptr;
        bool sure = true;
        for (const Crossing& crossing : crossings) {
            if (std::fabs(crossing.t - at) < kTooNear) sure = false;
            if (crossing.t < at) last = &crossing;
        }
        if (!sure) continue;
        if (!last) return rock_outside_ ? kSolid : rooms.count - 1;
        const std::uint32_t polygon = polygon_of_[last->facet];
        if (polygon < faces_) return last->front ? kSolid : rooms.of_side[polygon];
        return rooms.of_side[faces_ + 2 * (polygon - faces_) + last->front];
    }
    return kUnsure;
}

}  // namespace firma
