// SPDX-License-Identifier: MIT
// Judges a level of brushes made into a world.
#include "tests/reference/judge_joined.h"
#include "firma/queries.h"

#include <algorithm>
#include <cmath>
#include <random>

#include "firma/brush_world.h"
#include "firma/rooms.h"
#include "firma/solid.h"
#include "join/join_brushes.h"
#include "solid/measure_boundary.h"
#include "tests/reference/brush_oracle.h"
#include "tests/reference/judge_rooms.h"
#include "world/world_data.h"

namespace firma::reference {
namespace {

constexpr double kFarthestMoved = 0.001;

/// Of the exact solid, cubic input steps.
LongReal solid_volume(const World& world) {
    const DoubleDouble volume = measure_boundary(take_boundary(world.solid().data().faces.root.get())).volume;
    return LongReal(volume.high) + LongReal(volume.low);
}

class JoinedLevelJudge {
public:
    JoinedLevelJudge(const BrushLevel& level, std::uint64_t seed) : level_(level), random_(seed) {}

    JoinedVerdict judge(int points, bool volume) {
        BrushWorldReport report;
        const Result<World> made = make_world(level_, {}, &report);
        if (!made.ok()) return failed(made.error().text());
        const World& world = made.value();
        verdict_.rooms = world.room_count();
        verdict_.portals = portal_count(world);
        verdict_.planes_moved = report.planes_moved;
        if (const auto fault = check_world(world)) return failed(fault->what);
        if (const auto fault = check_solid(world)) return failed(fault->what);
        if (report.lost_shells > 0) return failed("a shell was lost");
        if (const std::string open = unclosed_room(world); !open.empty()) return failed(open);
        find_brushes();
        if (verdict_.farthest > kFarthestMoved) return failed("a plane was moved by more than a millimetre");
        if (volume) judge_volume(world);
        if (verdict_.fault.empty()) judge_points(world, points);
        if (verdict_.fault.empty()) judge_ways(world);
        return verdict_;
    }

private:
    JoinedVerdict failed(std::string what) {
        verdict_.fault = std::move(what);
        return verdict_;
    }

    /// Joined once more, for the planes.
    void find_brushes() {
        const std::unique_ptr<JoinedLevel> joined = join_brushes(level_).value();
        std::vector<bool> used(level_.brushes.size(), true);
        for (const LeftOut& left : joined->left_out) used[left.brush] = false;
        verdict_.left_out = joined->left_out.size();
        for (std::size_t b = 0; b < level_.brushes.size(); ++b) {
            const Brush& brush = level_.brushes[b];
            if (!used[b] || (brush.kind != BrushKind::kSolid && brush.kind != BrushKind::kSky)) continue;
            BrushBody& body = brushes_.emplace_back();
            BrushBody as_read;
            for (std::uint32_t side = brush.first_side; side < brush.first_side + brush.side_count; ++side) {
                body.push_back(half_space(joined->tables.planes.plane(joined->plane_of_side[side])));
                as_read.push_back(half_space(level_.sides[side]));
            }
            verdict_.farthest = std::max(verdict_.farthest, farthest_moved(body, as_read) / kInputSteps);
        }
    }

    void judge_volume(const World& world) {
        const LongReal want = joined_volume(brushes_), got = solid_volume(world), off = abs(got - want);
        verdict_.volume = static_cast<double>(want / (LongReal(kInputSteps) * kInputSteps * kInputSteps));
        // Of some hundred bits, as measure_boundary() says; sums are of up to some thousand terms as large as the
        // world.
        if (off > want * ldexp(LongReal(1), -80) + ldexp(LongReal(1), -20))
            failed("the volume is off by " + off.str(10) + " cubic steps of " + want.str(20));
    }

    double coordinate(double low, double high) {
        return std::floor((low + (high - low) * (double(random_() >> 11) * 0x1p-53)) * kInputSteps) / kInputSteps;
    }

    void judge_points(const World& world, int points) {
        const RoomBounds rooms(world);
        const Box bounds = world.bounds();
        Vec3 before;
        for (int k = 0; k < points && verdict_.fault.empty(); ++k) {
            Vec3 point;
            for (int axis = 0; axis < 3; ++axis)
                point[axis] = coordinate(bounds.low[axis] - 0.5, bounds.high[axis] + 0.5);
            if (std::string fault = judge_point(world, rooms, point); !fault.empty()) failed(std::move(fault));
            if (k > 0)
                if (std::string fault = judge_way(world, before, point); !fault.empty()) failed(std::move(fault));
            before = point;
        }
    }

    double uniform(double low, double high) { return low + (high - low) * (double(random_() >> 11) * 0x1p-53); }

    /// A point up to half a metre in front of a portal, or behind it.
    Vec3 point_near(const std::vector<Vec3>& polygon, bool behind) {
        Vec3 point;
        double sum = 0;
        for (const Vec3& corner : polygon) {
            const double share = uniform(0.01, 1);
            point = point + corner * share;
            sum += share;
        }
        const Vec3 normal = cross(polygon[1] - polygon[0], polygon[2] - polygon[0]);
        const double away = uniform(0.001, 0.5) / length(normal);
        return point * (1 / sum) + normal * (behind ? -away : away);
    }

    /// Points spread at random hardly ever see each other through a portal: these lie at both sides of one.
    void judge_ways(const World& world) {
        std::vector<Vec3> places;
        const auto judge = [&](const Vec3& from, const Vec3& to) {
            if (std::string fault = judge_way(world, from, to); !fault.empty()) failed(std::move(fault));
            const Location start = locate(world, from), end = locate(world, to);
            if (start.where != Where::kAir || end.where != Where::kAir) return;
            if (cast(world, {from, 0}, to - from).touched()) return;
            ++verdict_.ways;
            verdict_.crossings += start.room != end.room;
        };
        for (std::uint32_t portal = 0; portal < portal_count(world); ++portal)
            for (const std::vector<Vec3>& polygon : portal_polygons(world, {portal})) {
                const Vec3 front = point_near(polygon, false);
                const Vec3 behind = point_near(polygon, true);
                judge(front, behind);
                for (const Vec3& place : places) judge(behind, place);
                if (places.size() > 8) places.erase(places.begin());
                places.push_back(front);
            }
    }

    std::string judge_point(const World& world, const RoomBounds& rooms, const Vec3& point) {
        const Rational steps[3] = {Rational(point.x * kInputSteps), Rational(point.y * kInputSteps),
                                   Rational(point.z * kInputSteps)};
        const int side = side_of_brushes(brushes_, steps);
        const Where where = locate(world, point).where;
        if (side > 0 && where == Where::kAir) return "a point in a brush is said to lie in a room";
        if (side < 0 && where == Where::kSolid) return "a point in the air is said to lie in the solid";
        if (closest(world, point, 1e-4)) return "";
        ++verdict_.points;
        return rooms.judge(point);
    }

    const BrushLevel& level_;
    std::mt19937_64 random_;
    JoinedVerdict verdict_;
    std::vector<BrushBody> brushes_;
};

}  // namespace

JoinedVerdict judge_joined(const BrushLevel& level, std::uint64_t seed, int points, bool volume) {
    return JoinedLevelJudge(level, seed).judge(points, volume);
}

}  // namespace firma::reference
