// SPDX-License-Identifier: MIT
// An edit, a door, publishing and comparing in a world of few rooms and in one of very many of the same kind: what each
// costs, in turns, and whether any of it grows with the rooms. Then craters in a hall of few closets and in one of very
// many, some of which make two rooms one.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <vector>

#include "firma/carve.h"
#include "firma/rooms.h"
#include "firma/solid.h"
#include "firma/versions.h"
#include "scenes/divided_building.h"
#include "scenes/hub.h"
#include "scenes/rng.h"
#include "support/craters.h"
#include "support/race.h"
#include "support/settings.h"
#include "support/table.h"

namespace firma::bench {
namespace {

World assembled(WorldParts parts) {
    Result<World> world = assemble_world(std::move(parts));
    if (!world) {
        std::fprintf(stderr, "bench_many_rooms: %s\n", world.error().text().c_str());
        std::exit(2);
    }
    return std::move(world).value();
}

/// Microseconds of processor time.
template <class Work>
double timed(const Work& work) {
    const double start = thread_seconds();
    work();
    return (thread_seconds() - start) * 1e6;
}

/// Cells of 5 x 5 x 4 m, most of two or three rooms each, in a square of so many by so many.
World building(int side) {
    scenes::BuildingPlan plan;
    plan.rooms_x = plan.rooms_y = side;
    plan.jitter = 0.1;
    plan.closed = 0.3;
    plan.seed = 5;
    return assembled(scenes::DividedBuilding(plan).parts());
}

struct Numbers {
    std::vector<double> carve, hash, door, publish, publish_door, diff, diff_door, drop;
};

/// One world, and what is done in it: always the same, in the one corner that both worlds have.
class Site {
public:
    Site(int side, std::size_t edits) : first_(building(side)), cutter_(crater()), rng_(23) {
        for (std::size_t k = 0; k < edits; ++k) {
            Pose& pose = poses_.emplace_back();
            pose.rotation = random_turn(k);
            pose.position = {rng_.uniform(1, 15), rng_.uniform(1, 15), rng_.uniform(0.8, 1.2)};
            pose.scale = 0.7;
        }
    }

    const World& first() const { return first_; }

    /// Every edit is made in the world as it was at first, so that all rounds are about the same work.
    void round(std::size_t k, Numbers* numbers) {
        WorldStore store(first_);
        const PortalId portal{std::uint32_t(k * 7 % std::min<std::size_t>(portal_count(first_), 12))};
        CarveResult cut;
        const double carve_us = timed([&] { cut = carve(first_, cutter_, poses_[k % poses_.size()]); });
        const double hash_us = timed([&] { keep(hash_world(cut.world) + hash_solid(cut.world)); });
        if (!cut.done()) return;
        const double diff_us = timed([&] { keep(diff_worlds(first_, cut.world).added.size()); });
        const double publish_us = timed([&] { keep(store.publish(first_, cut.world)); });
        World door;
        const bool open = !portal_info(cut.world, portal)->open;
        const double door_us = timed([&] {
            door = *set_portal_open(cut.world, portal, open);
            keep(hash_world(door) + hash_solid(door));
        });
        const double diff_door_us = timed([&] { keep(diff_worlds(cut.world, door).rooms.size()); });
        const double publish_door_us = timed([&] { keep(store.publish(cut.world, door)); });
        store.undo();
        store.undo();
        door = World();
        cut.world = World();
        const double drop_us = timed([&] { store.set_history_bytes(0); });
        if (!numbers) return;
        numbers->carve.push_back(carve_us);
        numbers->hash.push_back(hash_us);
        numbers->door.push_back(door_us);
        numbers->diff.push_back(diff_us);
        numbers->publish.push_back(publish_us);
        numbers->diff_door.push_back(diff_door_us);
        numbers->publish_door.push_back(publish_door_us);
        numbers->drop.push_back(drop_us);
    }

private:
    World first_;
    Cutter cutter_;
    scenes::Rng rng_;
    std::vector<Pose> poses_;
};

/// Where craters go, from the middle of a closet's floor, and what they are there.
struct HubCrater {
    const char* what;
    Vec3 from_closet;
    double scale;
};
constexpr HubCrater kHubCraters[] = {{"carve inside the hall", {0.5, 2, 0}, 0.3},
                                     {"carve that joins two closets", {1, 0, 1}, 0.7},
                                     {"carve that joins a closet to the hall", {0, 1, 0}, 0.3}};

/// Every crater is cut into the world as it was at first, near its middle; the result is hashed, and dropped at once.
bool measure_hubs(const Settings& settings, bool hall_last, const char* name) {
    const int rounds = settings.quick ? 10 : 400;
    const scenes::Hub hubs[] = {{20, hall_last}, {settings.quick ? 60 : 9900, hall_last}};
    const World worlds[] = {assembled(scenes::hub_parts(hubs[0])), assembled(scenes::hub_parts(hubs[1]))};
    const Cutter cutter = crater();
    Table table(name, {"what", "20 closets us", "many closets us", "many to few"});
    for (const HubCrater& it : kHubCraters) {
        std::vector<double> costs[2];
        for (int k = -5; k < rounds; ++k)
            for (int turn = 0; turn < 2; ++turn) {
                const int which = (k + turn) & 1;
                const scenes::Hub& hub = hubs[which];
                Pose pose;
                pose.rotation = random_turn(std::size_t(k + 5));
                pose.position = scenes::floor_of_closet(hub, hub.closets / 4 * 2) + it.from_closet;
                pose.scale = it.scale;
                const double cost = timed([&] {
                    const CarveResult cut = carve(worlds[which], cutter, pose);
                    keep(hash_world(cut.world));
                    if (!cut.done()) std::exit(2);
                });
                if (k >= 0) costs[which].push_back(cost);
            }
        const double few = median(costs[0]), many = median(costs[1]);
        table.add({it.what, number(few), number(many), times(many / few)});
    }
    return table.finish(settings.csv);
}

int measure(const Settings& settings) {
    const std::size_t rounds = settings.quick ? 40 : 1000;
    const int many = settings.quick ? 12 : 60;
    Site few_site(3, rounds), many_site(many, rounds);
    Site* const sites[] = {&few_site, &many_site};
    Numbers numbers[2];
    for (std::size_t k = 0; k < std::min<std::size_t>(rounds, 20); ++k)
        for (Site* site : sites) site->round(k, nullptr);
    for (std::size_t k = 0; k < rounds; ++k)
        for (std::size_t turn = 0; turn < 2; ++turn) {
            const std::size_t which = (k + turn) % 2;
            sites[which]->round(k, &numbers[which]);
        }
    Table worlds("many_rooms_worlds", {"world", "rooms", "portals", "faces"});
    for (const Site* site : sites)
        worlds.add({site == sites[0] ? "few" : "many", count(site->first().room_count()),
                    count(portal_count(site->first())), count(site->first().face_count())});
    Table table("many_rooms", {"what", "few rooms us", "many rooms us", "many to few"});
    const auto row = [&](const char* what, std::vector<double> Numbers::* of) {
        const double few = median(numbers[0].*of), all = median(numbers[1].*of);
        table.add({what, number(few), number(all), times(all / few)});
    };
    row("carve", &Numbers::carve);
    row("hash_world and hash_solid after the carve", &Numbers::hash);
    row("diff_worlds of the carve", &Numbers::diff);
    row("publish the carve", &Numbers::publish);
    row("set_portal_open, with both hashes", &Numbers::door);
    row("diff_worlds of the door", &Numbers::diff_door);
    row("publish the door", &Numbers::publish_door);
    row("drop both versions", &Numbers::drop);
    const bool fine = worlds.finish(settings.csv);
    const bool hubs = measure_hubs(settings, false, "hub_hall_first") && measure_hubs(settings, true, "hub_hall_last");
    return table.finish(settings.csv) && fine && hubs ? 0 : 1;
}

}  // namespace
}  // namespace firma::bench

int main(int argc, char** argv) {
    using namespace firma::bench;
    return measure(read_settings(argc, argv, "Edits, doors, publishing and comparing in few rooms and in very many."));
}
