// SPDX-License-Identifier: MIT
// What a scene with parts costs beside its level alone, and what the sphere around a set saves.
//
//   bench_scenes [--quick] [--rounds N] [--csv DIR] [CONTENDER]
//
// With the name of a contender (a line of a table: `table/row`) that one runs once, for a program that counts
// instructions: valgrind --tool=callgrind --toggle-collect='firma::bench::counted_run*' bench_scenes NAME
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <string>
#include <vector>

#include "firma/brush_world.h"
#include "firma/cast_set.h"
#include "firma/moving_parts.h"
#include "firma/projectiles.h"
#include "firma/rooms.h"
#include "moving/arc.h"
#include "scenes/rng.h"
#include "support/depot_rubble.h"
#include "support/race.h"
#include "support/settings.h"
#include "support/table.h"
#include "tests/moving/part_worlds.h"

namespace firma::bench {
namespace {

using scenes::Rng;

/// A point in the air of a level.
Vec3 place_in_air(const World& level, Rng& rng) {
    const Box box = level.bounds();
    for (;;) {
        Vec3 at;
        for (int axis = 0; axis < 3; ++axis) at[axis] = rng.uniform(box.low[axis], box.high[axis]);
        if (locate(level, at).where == Where::kAir) return at;
    }
}

/// Leaves of 1 x 0.125 x 2 m: a third stands, a third slides at 2 m/s, a third turns at 2 radians a second.
std::vector<MovingPart> parts_in(const World& level, std::size_t count) {
    const World leaf = test::leaf_world();
    Rng rng(5);
    std::vector<MovingPart> parts;
    while (parts.size() < count) {
        MovingPart part(leaf);
        part.motion.position = place_in_air(level, rng);
        part.motion.rotation = turn_by({0, 0, rng.uniform(0, 6)});
        if (parts.size() % 3 == 1) part.motion.path = {2.0 / 60, 0, 0};
        if (parts.size() % 3 == 2) part.motion.turn = {0, 0, 2.0 / 60};
        parts.push_back(part);
    }
    return parts;
}

/// One thing that is timed.
struct Work {
    std::string table, row;
    std::function<std::size_t()> run;  ///< returns how many touched
};

/// Motions of the cast shapes, metres.
struct Way {
    Vec3 from, path;
};

std::vector<Way> ways_in(const World& level, std::size_t count, double longest) {
    Rng rng(7);
    std::vector<Way> ways;
    for (std::size_t k = 0; k < count; ++k)
        ways.push_back({place_in_air(level, rng), rng.direction() * rng.uniform(0.1, longest)});
    return ways;
}

std::vector<Projectile> shots_along(const std::vector<Way>& ways) {
    std::vector<Projectile> shots(ways.size());
    for (std::size_t k = 0; k < ways.size(); ++k) {
        shots[k].position = ways[k].from;
        shots[k].velocity = ways[k].path * 60;
    }
    return shots;
}

/// Casts of a particle, a sphere and a capsule, and a step of projectiles: through the level, and through scenes.
void add_scene_work(const World& level, const std::vector<std::vector<MovingPart>>& lists, const std::vector<Way>& ways,
                    std::vector<Work>& all) {
    const auto over_ways = [&ways](const auto& cast_one) {
        return [&ways, cast_one] {
            std::size_t touched = 0;
            for (const Way& way : ways) touched += cast_one(way).touched();
            return touched;
        };
    };
    const auto capsule_at = [](const Vec3& at) { return Capsule{at, at + Vec3{0, 0, 1}, 0.3}; };
    const auto flown = [&ways](const auto& fly_all) {
        return [fly_all, shots = shots_along(ways)] {
            std::vector<Projectile> now = shots;
            ShotEvents events;
            if (!fly_all(now, events)) std::abort();
            return events.events.size();
        };
    };
    const FlyOptions straight{.gravity = {}};
    all.push_back(
        {"particle", "level", over_ways([&level](const Way& w) { return cast(level, Ray{w.from, w.path}); })});
    all.push_back(
        {"sphere", "level", over_ways([&level](const Way& w) { return cast(level, {w.from, 0.25}, w.path); })});
    all.push_back({"capsule", "level",
                   over_ways([&level, capsule_at](const Way& w) { return cast(level, capsule_at(w.from), w.path); })});
    all.push_back({"projectiles", "level", flown([&level, straight](std::vector<Projectile>& now, ShotEvents& events) {
                       return fly(now, level, 1.0 / 60, events, straight).ok();
                   })});
    for (const std::vector<MovingPart>& parts : lists) {
        const std::string row = std::to_string(parts.size()) + "_parts";
        const Scene scene{level, parts};
        all.push_back({"particle", row, over_ways([scene](const Way& w) { return cast(scene, Ray{w.from, w.path}); })});
        all.push_back(
            {"sphere", row, over_ways([scene](const Way& w) { return cast(scene, Sphere{w.from, 0.25}, w.path); })});
        all.push_back({"capsule", row, over_ways([scene, capsule_at](const Way& w) {
                           return cast(scene, capsule_at(w.from), w.path);
                       })});
        all.push_back({"projectiles", row, flown([scene, straight](std::vector<Projectile>& now, ShotEvents& events) {
                           return fly(now, scene, 1.0 / 60, events, straight).ok();
                       })});
    }
}

/// cast() of a set without a look at what is near the sphere around all of it.
class WithoutBound {
public:
    WithoutBound(const World& level, const Arc& arc, double radius) : level_(level), arc_(arc), radius_(radius) {}

    Hit between(double from, double to) const {
        const double bulge = arc_.bulge(from, to);
        const Vec3 start = arc_.at(from), path = arc_.at(to) - start;
        if (bulge > kMaxBulge) {
            const Capsule around{start, start + path, radius_ + bulge};
            if (overlap_each(level_, around, [](const Overlap&) { return false; }) == Status::kMiss) return {};
            const double middle = (from + to) * 0.5;
            const Hit first = between(from, middle);
            return first.status != Status::kMiss ? first : between(middle, to);
        }
        Hit hit = cast(level_, {start, radius_ + bulge}, path);
        if (!hit.touched()) return hit;
        hit.fraction = from + hit.fraction * (to - from);
        return hit;
    }

    static SetHit cast_all(const World& level, const SphereSet& set, const RigidMotion& motion) {
        SetHit first;
        const TurnMatrix rotation = matrix_of(normalised(motion.rotation));
        const TurnRate rate(motion.turn);
        for (std::uint32_t k = 0; k < set.size(); ++k) {
            const Arc arc(motion.position, motion.path, rate, rotation * set[k].centre);
            const Hit hit = arc.bulge(0, 1) > 0 ? WithoutBound(level, arc, set[k].radius).between(0, first.fraction)
                                                : cast(level, {arc.at(0), set[k].radius}, motion.path);
            if (!hit.touched() || (first.touched() && !(hit.fraction < first.fraction))) continue;
            static_cast<Hit&>(first) = hit;
            first.sphere = k;
            if (first.fraction == 0) break;
        }
        return first;
    }

private:
    const World& level_;
    const Arc& arc_;
    const double radius_;
};

struct SetWay {
    const SphereSet* set = nullptr;
    RigidMotion motion;
};

/// Sets on their way for a sixtieth of a second. `bound` answers as `none` does: that is checked.
void add_set_work(const World& level, const std::vector<SphereSet>& sets, double speed, double spin, bool near,
                  std::size_t count, std::vector<std::vector<SetWay>>& kept, std::vector<Work>& all) {
    Rng rng(11);
    std::vector<SetWay>& ways = kept.emplace_back();
    std::size_t clear = 0;
    while (ways.size() < count) {
        SetWay way{&sets[ways.size() % sets.size()], {}};
        double reach = 0;
        for (const Sphere& sphere : *way.set) reach = std::max(reach, length(sphere.centre) + sphere.radius);
        way.motion.position = place_in_air(level, rng);
        way.motion.rotation = turn_by(rng.direction() * rng.uniform(0, 3));
        way.motion.path = rng.direction() * (speed / 60);
        way.motion.turn = rng.direction() * (spin / 60);
        const bool is_near = bool(closest(level, way.motion.position, reach));
        if (near && !is_near) continue;
        const SetHit hit = cast(level, *way.set, way.motion);
        if (hit.status == Status::kInitialOverlap) continue;  // where no body is
        const SetHit other = WithoutBound::cast_all(level, *way.set, way.motion);
        if (hit.fraction != other.fraction || hit.sphere != other.sphere) std::abort();
        clear += !is_near;
        ways.push_back(way);
    }
    char row[96];
    std::snprintf(row, sizeof row, "%s_%g_m/s_%g_rad/s", near ? "near" : "anywhere", speed, spin);
    std::printf("%s: %zu sets, %.0f%% with nothing in reach at the start\n", row, ways.size(),
                100.0 * double(clear) / double(ways.size()));
    const std::size_t at = kept.size() - 1;
    all.push_back({row, "none", [&level, &kept, at] {
                       std::size_t touched = 0;
                       for (const SetWay& way : kept[at])
                           touched += WithoutBound::cast_all(level, *way.set, way.motion).touched();
                       return touched;
                   }});
    all.push_back({row, "bound", [&level, &kept, at] {
                       std::size_t touched = 0;
                       for (const SetWay& way : kept[at]) touched += cast(level, *way.set, way.motion).touched();
                       return touched;
                   }});
}

/// So that a program that counts instructions can be told of it by name.
[[gnu::noinline]] std::size_t counted_run(const Work& work) {
    return work.run();
}

/// Each table's first row is what the others are compared with.
int time_all(const std::vector<Work>& all, std::size_t asked, const Settings& settings) {
    Table table("scenes", {"what", "how", "touched", "us each", "of the first"});
    for (std::size_t k = 0; k < all.size(); ++k) {
        bool told = false;
        for (std::size_t e = 0; e < k; ++e) told = told || all[e].table == all[k].table;
        if (told) continue;
        std::vector<Contender> contenders;
        std::vector<const Work*> works;
        for (const Work& work : all)
            if (work.table == all[k].table) {
                works.push_back(&work);
                contenders.push_back({work.row, [&work] { keep(work.run()); }});
            }
        const std::vector<Lap> laps = race(contenders, settings.rounds);
        for (std::size_t e = 0; e < laps.size(); ++e)
            table.add({works[e]->table, works[e]->row, count(works[e]->run()),
                       number(laps[e].seconds * 1e6 / double(asked)), times(laps[e].ratio)});
    }
    return table.finish(settings.csv) ? 0 : 1;
}

int measure(const Settings& settings) {
    const std::string map = settings.repository + "/build/openarena/kaos2.bsp";
    const bool is_map = settings.rest.rfind("kaos2:", 0) == 0;
    const std::string name = is_map ? settings.rest.substr(6) : settings.rest;
    const Result<World> read = read_world(is_map ? map : settings.repository + "/levels/depot.map");
    const Result<World> depot = read_world(settings.repository + "/levels/depot.map");
    if (!read || !depot) return std::fprintf(stderr, "%s\n", (read ? depot : read).error().text().c_str()), 1;
    const World& level = read.value();
    const std::size_t asked = settings.few(2000);
    std::vector<Work> all;
    const std::vector<std::vector<MovingPart>> lists{{}, parts_in(level, 10), parts_in(level, 100)};
    const std::vector<Way> ways = ways_in(level, asked, 8);
    add_scene_work(level, lists, ways, all);
    const DepotRubble rubble = depot_rubble(depot.value(), settings.quick ? 2 : 12);
    std::vector<SphereSet> sets;
    for (const Chunk& chunk : rubble.chunks) {
        Result<SphereFit> fit = fit_spheres(chunk.solid, {.max_spheres = 40});
        if (fit) sets.push_back(std::move(fit).value().spheres);
    }
    std::size_t spheres = 0;
    for (const SphereSet& set : sets) spheres += set.size();
    std::printf("%zu sets of %.1f spheres in the mean\n", sets.size(), double(spheres) / double(sets.size()));
    std::vector<std::vector<SetWay>> kept;
    kept.reserve(8);
    for (const bool near : {false, true}) {
        add_set_work(level, sets, 5, 0, near, asked, kept, all);
        add_set_work(level, sets, 5, 3, near, asked, kept, all);
        add_set_work(level, sets, 50, 20, near, asked, kept, all);
    }
    if (name.empty()) return time_all(all, asked, settings);
    for (const Work& work : all)
        if (work.table + "/" + work.row == name) return std::printf("%zu touched\n", counted_run(work)), 0;
    for (const Work& work : all) std::printf("%s/%s\n", work.table.c_str(), work.row.c_str());
    return 1;
}

}  // namespace
}  // namespace firma::bench

int main(int argc, char** argv) {
    using namespace firma::bench;
    return measure(read_settings(argc, argv, "What scenes with parts cost, and what the sphere around a set saves."));
}
