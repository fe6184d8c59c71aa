// SPDX-License-Identifier: MIT
// Levels after real blasts, the rubble of these, and flat places on their floors: where what holds on one plane has to
// hold as well.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <tuple>
#include <vector>

#include "firma/carve.h"
#include "firma/hull.h"
#include "firma/rooms.h"
#include "scenes/level_cuts.h"
#include "tests/body/simple_bodies.h"
#include "tests/fracture/rubble.h"
#include "tests/openarena_maps.h"
#include "tests/reference/rooms_outside.h"

namespace firma::test {

inline constexpr double kTick = 1.0 / 60;  ///< seconds

/// A level that was blasted all over, and what came loose.
struct BlastedLevel {
    World world;
    std::vector<Chunk> chunks;  ///< largest first
};

/// Blasts that open no way out of the level.
inline BlastedLevel blasted(const World& level, int blasts) {
    BlastedLevel made{with_anchors(level), {}};
    const scenes::CutPlaces places = scenes::cut_places(level);
    CarveOptions options;
    options.chunks = ChunkOptions{};
    int done = 0;
    for (std::uint64_t index = 0; index < 20 && done < blasts; ++index)
        for (const scenes::CutOrder& order : scenes::level_cuts(places, scenes::LevelCuts::kSpread, 7, index)) {
            Pose pose = order.pose;
            pose.scale *= 2;
            const CarveResult cut = carve(made.world, order.cutter, pose, options);
            if (!cut.done() || reference::opens_way_out(made.world, cut.world)) continue;
            made.world = cut.world;
            made.chunks.insert(made.chunks.end(), cut.chunks.begin(), cut.chunks.end());
            if (++done == blasts) break;
        }
    std::sort(made.chunks.begin(), made.chunks.end(), [](const Chunk& a, const Chunk& b) {
        return std::tuple(-a.mass.volume, a.origin.x, a.origin.y) < std::tuple(-b.mass.volume, b.origin.x, b.origin.y);
    });
    return made;
}

inline constexpr const char* kBlastedLevels[] = {"depot", "kaos2", "oa_koth1"};

/// Made once. The maps have to be there (openarena_maps()).
inline const BlastedLevel& blasted_level(const std::string& name) {
    static std::map<std::string, BlastedLevel> all;
    const auto found = all.find(name);
    if (found != all.end()) return found->second;
    return all.emplace(name, blasted(name == "depot" ? depot_world() : openarena_world(name.c_str()), 60))
        .first->second;
}

/// Tests that go through kBlastedLevels by number.
class InBlastedLevels : public testing::TestWithParam<int> {
protected:
    void SetUp() override {
        if (GetParam() > 0 && openarena_maps().empty()) GTEST_SKIP() << kNoOpenArena;
    }
    const BlastedLevel& level() const { return blasted_level(kBlastedLevels[GetParam()]); }
};
inline std::string name_of_blasted_level(const testing::TestParamInfo<int>& level) {
    return kBlastedLevels[level.param];
}

/// A flat part of a floor, with air above it.
struct FloorPlace {
    Vec3 at;            ///< its middle
    Vec3 along;         ///< its long way: x or y
    std::size_t faces;  ///< that it lies on
    friend bool operator<(const FloorPlace& a, const FloorPlace& b) {
        const auto key = [](const FloorPlace& p) {
            return std::tuple(-long(p.faces), p.at.x, p.at.y, p.at.z, p.along.x);
        };
        return key(a) < key(b);
    }
};

class FloorSearch {
public:
    /// @param half    metres, along and across
    /// @param height  metres of air
    FloorSearch(const World& world, double half_along, double half_across, double height)
        : world_(world), half_{half_along, half_across, height / 2}, outside_(reference::rooms_outside(world)) {
        boxes_[0] = make_box(half_).value();
        boxes_[1] = make_box({half_.y, half_.x, half_.z}).value();
    }

    /// At most so many, none within another, those on the most faces first.
    std::vector<FloorPlace> find(std::size_t count) {
        std::vector<FloorPlace> all;
        for (const Face& face : world_.faces()) {
            if (!face.solid || face.normal.z != 1) continue;
            Vec3 middle;
            for (const Vec3& corner : face.corners) middle += corner * (1.0 / double(face.corners.size()));
            look_at(middle, all);
            for (std::size_t k = 0; k < face.corners.size(); ++k)
                look_at((face.corners[k] + face.corners[(k + 1) % face.corners.size()]) * 0.5, all);
        }
        std::sort(all.begin(), all.end());
        std::vector<FloorPlace> chosen;
        for (const FloorPlace& place : all) {
            const bool apart = std::all_of(chosen.begin(), chosen.end(), [&](const FloorPlace& other) {
                return length(other.at - place.at) > 2 * (half_.x + half_.y);
            });
            if (apart && chosen.size() < count) chosen.push_back(place);
        }
        return chosen;
    }

private:
    void look_at(const Vec3& at, std::vector<FloorPlace>& all) const {
        const Location where = locate(world_, at + Vec3{0, 0, half_.z});
        if (where.where != Where::kAir || outside_[where.room.value]) return;
        for (const int turned : {0, 1}) {
            const Vec3 up{0, 0, half_.z + 1.0 / 256};
            if (overlap_each(world_, boxes_[turned], at + up, [](const Overlap&) { return false; }) != Status::kMiss)
                continue;
            const Vec3 along = turned ? Vec3{0, 1, 0} : Vec3{1, 0, 0};
            if (const std::size_t faces = faces_under(at, along)) all.push_back({at, along, faces});
        }
    }

    /// 0 where it is not flat.
    std::size_t faces_under(const Vec3& at, const Vec3& along) const {
        constexpr double kEvery = 0.1, kFrom = 0.0625;
        const Vec3 across{along.y, along.x, 0};
        std::vector<FaceId> faces;
        const int i_most = int(half_.x / kEvery), j_most = int(half_.y / kEvery);
        for (int i = -i_most; i <= i_most; ++i)
            for (int j = -j_most; j <= j_most; ++j) {
                const Vec3 from = at + along * (i * kEvery) + across * (j * kEvery) + Vec3{0, 0, kFrom};
                const Hit hit = cast(world_, Ray{from, {0, 0, -2 * kFrom}});
                if (!hit || hit.face_normal.z != 1 || std::fabs(hit.point.z - at.z) > 1e-9) return 0;
                faces.push_back(hit.face.id);
            }
        std::sort(faces.begin(), faces.end());
        return std::size_t(std::unique(faces.begin(), faces.end()) - faces.begin());
    }

    const World& world_;
    const Vec3 half_;
    const std::vector<bool> outside_;
    Hull boxes_[2];
};

/// Two or more of them are there in each of kBlastedLevels.
inline std::vector<FloorPlace> floor_places(const World& world, double half_along, double half_across, double height,
                                            std::size_t count) {
    return FloorSearch(world, half_along, half_across, height).find(count);
}

/// A chunk as a body in a pose, its mass times a factor.
inline Result<Body> chunk_body(const Chunk& chunk, std::size_t spheres, const Pose& pose, double factor = 1) {
    Result<Body> made = body_of(chunk, {.max_error = 1e-3, .max_spheres = spheres});
    if (!made) return made.error();
    MassProperties mass = chunk.mass;
    mass.mass *= factor;
    for (Vec3& row : mass.inertia) row = row * factor;
    const Result<BodyShape> shape = make_body_shape(made.value().shape.spheres(), mass);
    if (!shape) return shape.error();
    Body body = body_at(shape.value(), pose);
    body.rolling = made.value().rolling;
    return body;
}

/// A chunk whose middle is there, turned at random.
inline Result<Body> chunk_over(const Chunk& chunk, std::size_t spheres, const Vec3& middle, std::uint64_t turn,
                               double factor = 1) {
    Pose pose;
    pose.rotation = random_turn(turn);
    pose.position = middle - matrix_of(pose.rotation) * chunk.mass.centre;
    return chunk_body(chunk, spheres, pose, factor);
}

/// Of chunks as large as this: no point is farther from the centre of mass than `most`, and some are farther than
/// `least`.
inline std::vector<const Chunk*> chunks_of_size(const std::vector<Chunk>& chunks, double least, double most) {
    std::vector<const Chunk*> chosen;
    for (const Chunk& chunk : chunks) {
        const Box box = chunk.solid.bounds();
        const double reach = length(box.high - box.low) / 2;
        if (reach >= least && reach <= most) chosen.push_back(&chunk);
    }
    return chosen;
}

}  // namespace firma::test
