// SPDX-License-Identifier: MIT
// Players in the blasted depot and in blasted maps: flat floors, walls and corners that are found there, and blocks
// that are put there.
#pragma once

#include <gtest/gtest.h>

#include <map>
#include <string>
#include <tuple>
#include <vector>

#include "firma/turn.h"
#include "tests/body/level_floors.h"
#include "tests/carve/cutters.h"
#include "tests/player/level_features.h"
#include "tests/player/player_walk.h"

namespace firma::test {

inline constexpr double kDegree = 3.14159265358979 / 180;

/// Metres of flat floor with air over it: along and across from its middle, and up.
struct Room {
    double along, across, height;
};
inline constexpr Room kSquare{1.4, 1.4, 3}, kRun{2.2, 0.9, 3};

/// The foot of a wall that is upright and flat, on a flat floor; of a corner, where a second one meets it.
struct WallPlace {
    Vec3 foot;
    Vec3 normal;  ///< along an axis
    Vec3 along;   ///< along the wall; away from the second wall, of a corner its normal
};

class WallSearch {
public:
    explicit WallSearch(const World& level) : world_(level), outside_(reference::rooms_outside(level)) {}

    /// At most so many, none within 4 m of another.
    std::vector<WallPlace> find(std::size_t count, bool corners) const {
        std::vector<WallPlace> found;
        for (const Face& face : world_.faces()) {
            if (found.size() == count) break;
            const bool upright = std::fabs(face.normal.x) == 1 || std::fabs(face.normal.y) == 1;
            if (!face.solid || !upright) continue;
            Vec3 middle;
            for (const Vec3& corner : face.corners) middle += corner * (1.0 / double(face.corners.size()));
            const Vec3 along{-face.normal.y, face.normal.x, 0};
            for (const Vec3& way : {along, along * -1.0}) {
                WallPlace place{floor_below(middle + face.normal * kAway) - face.normal * kAway, face.normal, way};
                if (corners && !move_to_corner(place)) continue;
                const bool apart = std::all_of(found.begin(), found.end(), [&](const WallPlace& other) {
                    return length(other.foot - place.foot) > 4;
                });
                if (found.size() == count || !apart || !is_good(place, corners ? 0 : -kHalf)) continue;
                found.push_back(place);
            }
        }
        return found;
    }

private:
    static constexpr double kAway = 0.75, kHalf = 1.25;  // metres: flat floor before the wall, and along it

    Vec3 floor_below(const Vec3& at) const {
        const Hit hit = cast(world_, Ray{at, {0, 0, -4}});
        return hit ? hit.point : at;
    }
    bool meets(const Vec3& from, const Vec3& path, const Vec3& normal, const Vec3& plane_point) const {
        const Hit hit = cast(world_, Ray{from, path});
        return hit && hit.face_normal == normal && std::fabs(dot(hit.point - plane_point, normal)) < 1e-9;
    }
    bool move_to_corner(WallPlace& place) const {
        const Vec3 from = place.foot + place.normal * kAway + Vec3{0, 0, 0.9};
        const Hit hit = cast(world_, Ray{from, place.along * -6});
        if (!hit || !(hit.face_normal == place.along)) return false;
        place.foot += place.along * dot(hit.point - from, place.along);
        return true;
    }
    /// From `first` to kHalf along the wall; of a corner from 0 on.
    bool is_good(const WallPlace& place, double first) const {
        const Vec3 up{0, 0, 1};
        const Vec3 inside = place.foot + place.normal * (kAway / 2) + place.along * (kHalf / 2) + up;
        const Location at = locate(world_, inside);
        if (at.where != Where::kAir || outside_[at.room.value]) return false;
        constexpr double kGap = 1.0 / 256;
        const bool corner = first == 0;
        for (double far = first + (corner ? 0.05 : 0); far < kHalf; far += 0.1) {
            const Vec3 beside = place.foot + place.along * far + place.normal * kAway;
            for (double high = 0.05; high < 1.9; high += 0.3)
                if (!meets(beside + up * high, place.normal * -1.0, place.normal, place.foot)) return false;
            for (double off = 0.05; off < kAway; off += 0.1)
                if (!meets(beside - place.normal * off + up * 0.5, up * -1.0, up, place.foot)) return false;
        }
        if (corner)
            for (double off = 0.05; off < kAway; off += 0.1)
                for (double high = 0.05; high < 1.9; high += 0.3)
                    if (!meets(place.foot + place.normal * off + place.along * 0.5 + up * high, place.along * -1.0,
                               place.along, place.foot))
                        return false;
        const double low = corner ? kGap : first;
        Vec3 half = place.normal * (kAway / 2 - kGap) + place.along * ((kHalf - low) / 2) + up * 0.95;
        for (int axis = 0; axis < 3; ++axis) half[axis] = std::fabs(half[axis]);
        const Vec3 middle =
            place.foot + place.normal * (kAway / 2) + place.along * ((kHalf + low) / 2) + up * (0.95 + kGap);
        return overlap_each(world_, make_box(half).value(), middle, [](const Overlap&) { return false; }) ==
               Status::kMiss;
    }

    const World& world_;
    const std::vector<bool> outside_;
};

/// A mesh whose x goes along a place, on its floor.
inline World edited_at(const World& world, const FloorPlace& place, TriangleMesh mesh, CarveKind kind) {
    if (place.along.y == 1) {
        for (Vec3& v : mesh.vertices) std::swap(v.x, v.y);
        mesh.turn_over();
    }
    Pose pose;
    pose.position = place.at;
    const Cutter cutter = mesh.cutter().value();
    const CarveResult made = kind == CarveKind::kFill ? fill(world, cutter, pose) : carve(world, cutter, pose);
    EXPECT_TRUE(made.done());
    return made.world;
}
inline World block_at(const World& world, const FloorPlace& place, const Vec3& low, const Vec3& high) {
    return edited_at(world, place, box_mesh(low, high), CarveKind::kFill);
}
inline Vec3 side_of(const FloorPlace& place) {
    return {place.along.y, place.along.x, 0};
}
/// Of the floor below, metres.
inline double floor_under(const World& world, const Vec3& at) {
    const Hit hit = cast(world, Ray{at, {0, 0, -64}});
    return hit ? hit.point.z : -INFINITY;
}

/// Goes through kBlastedLevels and player_shapes() by number.
class InPlayerLevels : public testing::TestWithParam<std::tuple<int, int>> {
protected:
    void SetUp() override {
        if (level() > 0 && openarena_maps().empty()) GTEST_SKIP() << kNoOpenArena;
    }
    int level() const { return std::get<0>(GetParam()); }
    const World& world() const { return blasted_level(kBlastedLevels[level()]).world; }
    bool is_box() const { return std::get<1>(GetParam()) == 1; }
    PlayerShape shape() const { return player_shapes()[std::size_t(std::get<1>(GetParam()))]; }

    static bool is_inside(const World& now, const Vec3& feet) {
        const Location at = locate(now, feet + Vec3{0, 0, 0.9});
        return at.where == Where::kAir && !reference::rooms_outside(now)[at.room.value];
    }
    static bool is_inside(const World& now, const Walk& walk) { return is_inside(now, walk.at()); }
    /// For each of at most so many places, one at least; those with the most seams first.
    template <class Judge>
    void at_places(const Room& room, std::size_t count, const Judge& judge) const {
        const std::vector<FloorPlace>& places = floors(room);
        ASSERT_GE(places.size(), 1u);
        for (std::size_t k = 0; k < std::min(count, places.size()); ++k) {
            const FloorPlace& place = places[k];
            SCOPED_TRACE("at " + where(place.at) + ", " + std::to_string(place.faces) + " faces");
            judge(place);
        }
    }
    /// Of three walls, or corners, that are found.
    template <class Judge>
    void at_walls(bool corners, const Judge& judge) const {
        const std::vector<WallPlace>& places = walls(corners);
        ASSERT_GE(places.size(), 1u);
        for (const WallPlace& place : places) {
            SCOPED_TRACE("at " + where(place.foot));
            judge(place);
        }
    }
    /// Of at most so many that are found, one at least.
    template <class Judge>
    void at_features(FeatureKind kind, std::size_t count, const Judge& judge) const {
        const std::vector<Feature>& found = features(kind);
        ASSERT_GE(found.size(), 1u);
        for (std::size_t k = 0; k < std::min(count, found.size()); ++k) {
            SCOPED_TRACE("at " + where(found[k].at) + ", " + std::to_string(found[k].size));
            judge(found[k]);
        }
    }
    /// A player who stands there, and comes to the speed that it wishes at once.
    Walk stands(const World& world, const Vec3& feet, int ticks = 10) const {
        Walk walk(world, shape(), feet + Vec3{0, 0, 0.002});
        walk.rules.ground_acceleration = 1e6;
        walk.wait(ticks);
        walk.airborne = 0;
        EXPECT_TRUE(walk.player.on_ground);
        return walk;
    }

private:
    const std::vector<FloorPlace>& floors(const Room& room) const {
        static std::map<std::tuple<int, double, double>, std::vector<FloorPlace>> all;
        const auto [found, is_new] = all.try_emplace({level(), room.along, room.height});
        if (is_new) found->second = floor_places(world(), room.along, room.across, room.height, 6);
        return found->second;
    }
    const std::vector<WallPlace>& walls(bool corners) const {
        static std::map<std::pair<int, bool>, std::vector<WallPlace>> all;
        const auto [found, is_new] = all.try_emplace({level(), corners});
        if (is_new) found->second = WallSearch(world()).find(3, corners);
        return found->second;
    }
    const std::vector<Feature>& features(FeatureKind kind) const {
        static std::map<std::pair<int, FeatureKind>, std::vector<Feature>> all;
        const auto [found, is_new] = all.try_emplace({level(), kind});
        if (is_new) found->second = FeatureSearch(world()).find(kind);
        return found->second;
    }
    static std::string where(const Vec3& at) {
        return std::to_string(at.x) + ' ' + std::to_string(at.y) + ' ' + std::to_string(at.z);
    }
};
inline std::string name_of_player_level(const testing::TestParamInfo<std::tuple<int, int>>& info) {
    return std::string(kBlastedLevels[std::get<0>(info.param)]) +
           kPlayerShapeNames[std::size_t(std::get<1>(info.param))];
}

}  // namespace firma::test
