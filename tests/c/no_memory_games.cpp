// SPDX-License-Identifier: MIT
// The C API of what moves when memory runs out: bodies, players, parts, projectiles, debris, what faces hold, games.
// Nothing has changed, or what the call changes says that it is lost; nothing has leaked. A program of its own, as
// operator new fails on demand.
#include <gtest/gtest.h>

#include <cstdio>
#include <string>

#include "firma/firma_c.h"
#include "tests/failing_new.h"

namespace {

/// Calls with memory for ever more allocations until that is enough; at each it runs out, `failed` is asked whether all
/// is as it should be then.
/// @return how many allocations the call made, to within an eighth
template <class Call, class Failed>
long until_enough(const Call& call, const Failed& failed) {
    for (long allocations = 0;; allocations += 1 + allocations / 8) {
        firma_code code = FIRMA_ERROR_INTERNAL;
        const std::size_t held = firma_live_handles();
        if (!firma::tests::runs_out(allocations, [&] { code = call(); })) {
            EXPECT_EQ(code, FIRMA_OK) << firma_error_message();
            return allocations;
        }
        EXPECT_EQ(code, FIRMA_ERROR_NO_MEMORY) << allocations;
        EXPECT_EQ(firma_live_handles(), held) << allocations;
        failed(allocations);
        if (testing::Test::HasFailure()) return allocations;
    }
}

constexpr firma_pose kHere{{0, 0, 0}, {0, 0, 0, 1}, 1};

/// A ground, a column that fell in two as chunks, and a ball.
class GamesWithoutMemory : public testing::Test {
protected:
    GamesWithoutMemory() {
        const std::string map = "{\n\"classname\" \"worldspawn\"\n" + box(-16, -16, -4, 16, 16, 0, "rock") + "}\n" +
                                "{\n\"classname\" \"func_breakable\"\n" + box(-2, -2, 0, 2, 2, 4, "wood") + "}\n";
        EXPECT_EQ(firma_level_from_map(map.data(), map.size(), "map", 1, &level), FIRMA_OK);
        EXPECT_EQ(firma_world_from_level(level, nullptr, &world), FIRMA_OK);
        EXPECT_EQ(firma_parts_from_level(level, nullptr, &parts), FIRMA_OK);
        firma_world solid{};
        EXPECT_EQ(firma_parts_world(parts, 0, &solid), FIRMA_OK);
        EXPECT_EQ(firma_world_pieces(solid, 600, &chunks), FIRMA_OK);
        EXPECT_EQ(firma_world_release(solid), FIRMA_OK);
        const double sphere[4] = {0, 0, 0, 0.5};
        firma_mass mass{};
        EXPECT_EQ(firma_mass_of_ball(0.5, 1000, &mass), FIRMA_OK);
        EXPECT_EQ(firma_body_shape_spheres(sphere, 1, &mass, &ball), FIRMA_OK);
        EXPECT_EQ(firma_bodies_create(&bodies), FIRMA_OK);
        EXPECT_EQ(firma_debris_create(&debris), FIRMA_OK);
        const firma_fit_options fit{sizeof fit, 4, 0, 0};
        EXPECT_EQ(firma_debris_add_chunk(debris, bodies, chunks, 0, &fit, &chunk_body), FIRMA_OK);
        firma_body_id id{};
        firma_pose pose = kHere;
        for (int k = 0; k < 5; ++k) {
            pose.position[0] = -8 + k;
            pose.position[2] = 0.5 + k;
            EXPECT_EQ(firma_bodies_add(bodies, ball, &pose, &id), FIRMA_OK);
        }
        EXPECT_EQ(firma_cutter_crater(FIRMA_BOX, 0, &cutter), FIRMA_OK);
    }
    ~GamesWithoutMemory() override {
        EXPECT_EQ(firma_cutter_release(cutter), FIRMA_OK);
        EXPECT_EQ(firma_debris_release(debris), FIRMA_OK);
        EXPECT_EQ(firma_bodies_release(bodies), FIRMA_OK);
        EXPECT_EQ(firma_body_shape_release(ball), FIRMA_OK);
        EXPECT_EQ(firma_chunks_release(chunks), FIRMA_OK);
        EXPECT_EQ(firma_parts_release(parts), FIRMA_OK);
        EXPECT_EQ(firma_world_release(world), FIRMA_OK);
        EXPECT_EQ(firma_level_release(level), FIRMA_OK);
        EXPECT_EQ(firma_live_handles(), 0u);
    }

    static std::string box(int x0, int y0, int z0, int x1, int y1, int z1, const std::string& texture) {
        std::string text = "{\n";
        const auto side = [&](const char* form, int at) {
            char line[128];
            std::snprintf(line, sizeof line, form, at, at, at);
            text += line + texture + " 0 0 0 1 1\n";
        };
        side("( %d 0 0 ) ( %d 1 0 ) ( %d 0 1 ) ", x0);
        side("( %d 0 0 ) ( %d 0 1 ) ( %d 1 0 ) ", x1);
        side("( 0 %d 0 ) ( 0 %d 1 ) ( 1 %d 0 ) ", y0);
        side("( 0 %d 0 ) ( 1 %d 0 ) ( 0 %d 1 ) ", y1);
        side("( 0 0 %d ) ( 1 0 %d ) ( 0 1 %d ) ", z0);
        side("( 0 0 %d ) ( 0 1 %d ) ( 1 0 %d ) ", z1);
        return text + "}\n";
    }

    static std::uint64_t hash_of(firma_bodies of) {
        std::uint64_t hash = 0;
        EXPECT_EQ(firma_bodies_hash(of, &hash), FIRMA_OK);
        return hash;
    }

    /// Bodies and debris for a call that changes them: lost where memory ran out within it.
    struct Pair {
        firma_bodies bodies{};
        firma_debris debris{};

        Pair(firma_bodies from, firma_debris of) {
            EXPECT_EQ(firma_bodies_copy(from, &bodies), FIRMA_OK);
            EXPECT_EQ(firma_debris_copy(of, &debris), FIRMA_OK);
        }
        ~Pair() {
            EXPECT_EQ(firma_debris_release(debris), FIRMA_OK);
            EXPECT_EQ(firma_bodies_release(bodies), FIRMA_OK);
        }
        Pair(const Pair&) = delete;
        Pair& operator=(const Pair&) = delete;

        /// As they were, or lost, both.
        void expect_same_or_lost(const Pair& as) const {
            std::uint64_t now = 0, of_bodies = 0, before = 0;
            const firma_code code = firma_debris_hash(debris, &now);
            ASSERT_EQ(firma_bodies_hash(bodies, &of_bodies), code);
            if (code == FIRMA_ERROR_NO_MEMORY) return;
            ASSERT_EQ(code, FIRMA_OK);
            ASSERT_EQ(firma_debris_hash(as.debris, &before), FIRMA_OK);
            EXPECT_EQ(now, before);
            EXPECT_EQ(of_bodies, hash_of(as.bodies));
        }
    };

    /// A call that changes both, on a copy each time.
    template <class Call>
    long change_until_enough(const Call& call) {
        const Pair before(bodies, debris);
        for (long allocations = 0;; allocations += 1 + allocations / 8) {
            const Pair both(bodies, debris);
            firma_code code = FIRMA_ERROR_INTERNAL;
            const std::size_t held = firma_live_handles();
            if (!firma::tests::runs_out(allocations, [&] { code = call(both); })) {
                EXPECT_EQ(code, FIRMA_OK) << firma_error_message();
                return allocations;
            }
            EXPECT_EQ(code, FIRMA_ERROR_NO_MEMORY) << allocations;
            EXPECT_EQ(firma_live_handles(), held) << allocations;
            both.expect_same_or_lost(before);
            if (HasFailure()) return allocations;
        }
    }

    firma_level level{};
    firma_world world{};
    firma_parts parts{};
    firma_chunks chunks{};
    firma_body_shape ball{};
    firma_bodies bodies{};
    firma_debris debris{};
    firma_body_id chunk_body{};
    firma_cutter cutter{};
};

TEST_F(GamesWithoutMemory, BodiesAreMadeWholeOrNotAtAll) {
    const std::uint64_t before = hash_of(bodies);
    firma_bodies made{77};
    const auto same = [&](long) { EXPECT_EQ(made.id, 77u); };
    EXPECT_GT(until_enough([&] { return firma_bodies_create(&made); }, same), 0);
    firma_bodies_release(made);
    made.id = 77;
    EXPECT_GT(until_enough([&] { return firma_bodies_copy(bodies, &made); }, same), 1);
    EXPECT_EQ(hash_of(made), before);
    firma_bodies_release(made);
    const double spheres[8] = {0, 0, 0, 0.5, 1, 0, 0, 0.5};
    firma_mass mass{};
    EXPECT_EQ(firma_mass_of_ball(0.5, 1000, &mass), FIRMA_OK);
    firma_body_shape shape{77};
    EXPECT_GT(until_enough([&] { return firma_body_shape_spheres(spheres, 2, &mass, &shape); },
                           [&](long) { EXPECT_EQ(shape.id, 77u); }),
              1);
    firma_body_shape_release(shape);
    firma_body_id id{77, 7};
    const auto unchanged = [&](long) {
        EXPECT_EQ(id.slot, 77u);
        EXPECT_EQ(hash_of(bodies), before);
    };
    until_enough([&] { return firma_bodies_add(bodies, ball, &kHere, &id); }, unchanged);
    EXPECT_NE(id.slot, 77u);
}

TEST_F(GamesWithoutMemory, AStepWithoutMemoryLosesTheBodies) {
    const std::uint64_t before = hash_of(bodies);
    long allocations = 0;
    for (;; allocations += 1 + allocations / 8) {
        firma_bodies copy{};
        ASSERT_EQ(firma_bodies_copy(bodies, &copy), FIRMA_OK);
        firma_code code = FIRMA_OK;
        const auto step = [&] { code = firma_bodies_step(copy, world, 1.0 / 60, nullptr, nullptr); };
        const bool out = firma::tests::runs_out(allocations, step);
        std::uint64_t hash = 0;
        std::size_t count = 0;
        if (out) {
            EXPECT_EQ(code, FIRMA_ERROR_NO_MEMORY) << allocations;
            EXPECT_EQ(firma_bodies_hash(copy, &hash), FIRMA_ERROR_NO_MEMORY);
            EXPECT_EQ(firma_bodies_get_count(copy, &count), FIRMA_ERROR_NO_MEMORY);
            EXPECT_EQ(firma_bodies_step(copy, world, 1.0 / 60, nullptr, nullptr), FIRMA_ERROR_NO_MEMORY);
        } else {
            EXPECT_EQ(code, FIRMA_OK);
            EXPECT_EQ(firma_bodies_hash(copy, &hash), FIRMA_OK);
            EXPECT_NE(hash, before);
        }
        EXPECT_EQ(firma_bodies_release(copy), FIRMA_OK);
        if (!out || HasFailure()) break;
    }
    EXPECT_GT(allocations, 10);
    EXPECT_EQ(hash_of(bodies), before);
}

TEST_F(GamesWithoutMemory, PlayersStayWhereTheyAre) {
    firma_player_shape shape{77};
    firma_player_size size;
    firma_player_size_defaults(&size);
    for (const auto make : {firma_player_shape_capsule, firma_player_shape_box}) {
        shape.id = 77;
        EXPECT_GT(until_enough([&] { return make(&size, &shape); }, [&](long) { EXPECT_EQ(shape.id, 77u); }), 0);
        firma_player player, after;
        firma_player_defaults(&player);
        player.position[0] = 6;
        firma_player_defaults(&after);
        const firma_player unset = after;
        firma_player_wish wish{};
        wish.size = sizeof wish;
        wish.velocity[0] = -3;
        firma_scene scene;
        firma_scene_defaults(&scene);
        scene.world = world;
        scene.parts = parts;
        firma_player_move move{};
        move.size = sizeof move;
        move.player = unset;
        until_enough([&] { return firma_move_player(&scene, shape, &player, &wish, 1.0 / 60, nullptr, &move); },
                     [&](long) { EXPECT_EQ(move.player.position[0], unset.position[0]); });
        EXPECT_NE(move.player.position[0], unset.position[0]);
        EXPECT_EQ(firma_player_shape_release(shape), FIRMA_OK);
    }
}

TEST_F(GamesWithoutMemory, PartsAreAddedOrNot) {
    firma_parts made{77};
    const auto same = [&](long) { EXPECT_EQ(made.id, 77u); };
    EXPECT_GT(until_enough([&] { return firma_parts_from_level(level, nullptr, &made); }, same), 50);
    std::size_t count = 0;
    firma_part part;
    firma_part_defaults(&part);
    part.world = world;
    until_enough([&] { return firma_parts_add(made, &part, nullptr); },
                 [&](long) {
                     EXPECT_EQ(firma_parts_get_count(made, &count), FIRMA_OK);
                     EXPECT_EQ(count, 1u);
                 });
    EXPECT_EQ(firma_parts_get_count(made, &count), FIRMA_OK);
    EXPECT_EQ(count, 2u);
    firma_motion motions[2] = {part.motion, part.motion};
    EXPECT_EQ(until_enough([&] { return firma_parts_set_motions(made, motions, 2); }, [](long) {}), 0)
        << "it takes no memory";
    EXPECT_EQ(firma_parts_release(made), FIRMA_OK);
}

TEST_F(GamesWithoutMemory, ProjectilesStayWhereTheyAre) {
    firma_projectile shots[3];
    for (int k = 0; k < 3; ++k) {
        firma_projectile_defaults(&shots[k]);
        shots[k].position[0] = 5 + k;
        shots[k].position[2] = 1;
        shots[k].velocity[2] = -100;
    }
    firma_shot_events events{77};
    EXPECT_GT(until_enough([&] { return firma_shot_events_create(&events); }, [&](long) { EXPECT_EQ(events.id, 77u); }),
              0);
    const auto flown = [&] { return firma_fly(shots, 3, world, firma_bodies{}, 1.0 / 60, nullptr, events, nullptr); };
    const auto unmoved = [&](long) {
        EXPECT_EQ(shots[0].position[2], 1);
        firma_shot_view view{};
        view.size = sizeof view;
        EXPECT_EQ(firma_shot_events_get_view(events, &view), FIRMA_OK);
        EXPECT_EQ(view.event_count, 0u);
    };
    EXPECT_GT(until_enough(flown, unmoved), 3);
    EXPECT_LT(shots[0].position[2], 1);
    EXPECT_EQ(firma_shot_events_release(events), FIRMA_OK);
}

TEST_F(GamesWithoutMemory, CastsAtBodiesAndFits) {
    firma_body_index index{77};
    EXPECT_GT(until_enough([&] { return firma_body_index_create(bodies, 0.125, &index); },
                           [&](long) { EXPECT_EQ(index.id, 77u); }),
              3);
    const firma_cast_input down{{-8, 0, 8}, 0.125, {0, 0, -8}};
    firma_body_hit hit{};
    EXPECT_EQ(until_enough([&] { return firma_body_index_cast(index, &down, nullptr, &hit); }, [](long) {}), 0)
        << "it takes no memory";
    EXPECT_EQ(hit.status, std::uint32_t(FIRMA_HIT));
    const double set[8] = {0, 0, 0, 0.125, 1, 0, 0, 0.125};
    const firma_motion motion{{-8, 0, 8}, {0, 0, 0, 1}, {0, 0, -9}, {0, 0, 1}};
    hit.status = 99;
    const auto unasked = [&](long) { EXPECT_EQ(hit.status, 99u); };
    EXPECT_EQ(until_enough([&] { return firma_body_index_cast_set(index, set, 2, &motion, nullptr, &hit); }, unasked),
              1);
    firma_set_hit met{};
    met.sphere = 99;
    EXPECT_EQ(until_enough([&] { return firma_cast_set(world, set, 2, &motion, nullptr, &met); },
                           [&](long) { EXPECT_EQ(met.sphere, 99u); }),
              1);
    EXPECT_EQ(met.hit.status, std::uint32_t(FIRMA_HIT));
    firma_set_pair_hit pair{};
    pair.status = 99;
    EXPECT_EQ(until_enough([&] { return firma_cast_set_pair(set, 2, &motion, set, 1, &motion, &pair); },
                           [&](long) { EXPECT_EQ(pair.status, 99u); }),
              2);
    EXPECT_EQ(firma_body_index_release(index), FIRMA_OK);

    firma_world solid{};
    EXPECT_EQ(firma_parts_world(parts, 0, &solid), FIRMA_OK);
    const firma_fit_options fit{sizeof fit, 2, 0, 0};
    double spheres[8] = {};
    std::size_t count = 77;
    EXPECT_GT(until_enough([&] { return firma_world_fit_spheres(solid, &fit, spheres, 2, &count, nullptr); },
                           [&](long) { EXPECT_EQ(count, 77u); }),
              20);
    EXPECT_LE(count, 2u);
    EXPECT_NEAR(spheres[3], 2, 0.01) << "in a cube of 4 m";
    EXPECT_EQ(firma_world_release(solid), FIRMA_OK);
}

TEST_F(GamesWithoutMemory, PathsThroughSolid) {
    firma_piercing piercing{77};
    EXPECT_GT(
        until_enough([&] { return firma_piercing_create(&piercing); }, [&](long) { EXPECT_EQ(piercing.id, 77u); }), 0);
    const double start[3] = {1, 1, 3}, path[3] = {0, 0, -20};
    std::uint32_t status = 99;
    const auto pierce = [&] { return firma_pierce(world, start, path, nullptr, piercing, &status); };
    EXPECT_GT(until_enough(pierce, [&](long) { EXPECT_EQ(status, 99u); }), 2);
    EXPECT_EQ(status, std::uint32_t(FIRMA_HIT));
    EXPECT_EQ(firma_piercing_release(piercing), FIRMA_OK);
}

TEST_F(GamesWithoutMemory, Supports) {
    firma_supports held{77}, after{77};
    EXPECT_GT(until_enough([&] { return firma_supports_from_level(world, level, parts, &held); },
                           [&](long) { EXPECT_EQ(held.id, 77u); }),
              10);
    firma_world cut{};
    EXPECT_EQ(firma_carve(world, cutter, &kHere, nullptr, &cut, nullptr), FIRMA_OK);
    firma_support_change change{};
    std::size_t count = 99;
    const auto diff = [&] { return firma_supports_diff(held, world, cut, &change, 1, &count, &after); };
    EXPECT_GT(until_enough(diff,
                           [&](long) {
                               EXPECT_EQ(after.id, 77u);
                               EXPECT_EQ(count, 99u);
                           }),
              10);
    EXPECT_EQ(count, 1u);
    EXPECT_EQ(firma_supports_release(held), FIRMA_OK);
    EXPECT_EQ(firma_supports_release(after), FIRMA_OK);
    EXPECT_EQ(firma_world_release(cut), FIRMA_OK);
}

TEST_F(GamesWithoutMemory, DebrisIsUnchangedOrLost) {
    firma_fracture_pattern pattern{};
    pattern.size = sizeof pattern;
    EXPECT_EQ(firma_fracture_pattern_of(world, 0, &pattern), FIRMA_OK);
    for (double& size : pattern.size_of_piece) size = 2;
    firma_fracture_options few{};
    few.size = sizeof few;
    few.max_pieces = 3;
    const firma_shatter_options spheres{sizeof spheres, 2, {}};
    const auto shatter = [&](const Pair& both) {
        return firma_shatter(both.debris, both.bodies, chunk_body, &pattern, &few, &spheres, nullptr);
    };
    EXPECT_GT(change_until_enough(shatter), 100);

    firma_chunks pieces{77};
    firma_world solid{};
    EXPECT_EQ(firma_debris_world(debris, bodies, chunk_body, &solid), FIRMA_OK);
    EXPECT_GT(until_enough([&] { return firma_world_fracture(solid, &pattern, &few, &pieces); },
                           [&](long) { EXPECT_EQ(pieces.id, 77u); }),
              100);
    EXPECT_EQ(firma_chunks_release(pieces), FIRMA_OK);
    EXPECT_EQ(firma_world_release(solid), FIRMA_OK);

    firma_blast blast;
    firma_blast_defaults(&blast);
    blast.at[2] = 0.5;
    firma_explode_options options;
    firma_explode_options_defaults(&options);
    options.max_pieces = 2;
    options.max_spheres = 2;
    firma_world after{77};
    const auto explode = [&](const Pair& both) {
        return firma_explode(world, both.debris, both.bodies, &blast, cutter, &kHere, &options, &after, nullptr);
    };
    EXPECT_GT(change_until_enough(explode), 100);
    EXPECT_EQ(firma_world_release(after), FIRMA_OK);

    after.id = 77;
    const auto tend = [&](const Pair& both) {
        return firma_debris_tend(both.debris, both.bodies, world, 1.0 / 60, nullptr, &after, nullptr);
    };
    change_until_enough(tend);
    EXPECT_EQ(firma_world_release(after), FIRMA_OK);
}

TEST_F(GamesWithoutMemory, PartsThatBreakAreUnchangedOrLost) {
    firma_break_options few;
    firma_break_options_defaults(&few);
    few.max_pieces = 2;
    few.max_spheres = 2;
    firma_world after{};
    // Each on parts of its own: a part may be gone although what it broke into is lost.
    const auto run = [&](bool carves) {
        for (long allocations = 0;; allocations += 1 + allocations / 8) {
            const Pair before(bodies, debris), both(bodies, debris);
            firma_parts own{};
            ASSERT_EQ(firma_parts_from_level(level, nullptr, &own), FIRMA_OK);
            firma_part_cut_options cutting;
            firma_part_cut_options_defaults(&cutting);
            cutting.pieces = few;
            firma_pose high = kHere;
            high.position[2] = 2;
            high.scale = 0.5;
            firma_code code = FIRMA_ERROR_INTERNAL;
            const std::size_t held = firma_live_handles();
            const bool out = firma::tests::runs_out(allocations, [&] {
                code = carves
                           ? firma_parts_carve(own, 0, world, nullptr, cutter, &high, both.debris, both.bodies,
                                               &cutting, &after, nullptr)
                           : firma_parts_break(own, 0, world, nullptr, both.debris, both.bodies, &few, &after, nullptr);
            });
            EXPECT_EQ(code, out ? FIRMA_ERROR_NO_MEMORY : FIRMA_OK) << allocations;
            EXPECT_EQ(firma_live_handles(), held + (out ? 0 : 1)) << allocations;
            if (out) both.expect_same_or_lost(before);
            if (!out) {
                EXPECT_EQ(firma_world_release(after), FIRMA_OK);
            }
            EXPECT_EQ(firma_parts_release(own), FIRMA_OK);
            if (HasFailure()) return;
            if (!out) {
                EXPECT_GT(allocations, 100);
                return;
            }
        }
    };
    run(false);
    run(true);
}

/// A game in that level: a door, a player, a ball, and a rocket on its way.
class WholeGamesWithoutMemory : public GamesWithoutMemory {
protected:
    WholeGamesWithoutMemory() {
        EXPECT_EQ(firma_game_begin(world, 60, &game), FIRMA_OK);
        EXPECT_EQ(firma_parts_world(parts, 0, &leaf), FIRMA_OK);
        stops[0].position[0] = stops[1].position[0] = 8;
        stops[1].position[2] = 2;
        stops[0].seconds = stops[1].seconds = 1;
        firma_part_path_defaults(&path);
        path.stops = stops;
        path.stop_count = 2;
        firma_game_part_defaults(&part);
        part.world = leaf;
        part.path = &path;
        part.name = "a door with a name that no short text holds";
        part.waits = 1;
        EXPECT_EQ(firma_game_add_part(game, &part, nullptr), FIRMA_OK);
        firma_game_player_defaults(&player);
        EXPECT_EQ(firma_player_shape_capsule(nullptr, &player.shape), FIRMA_OK);
        player.player.position[1] = -8;
        EXPECT_EQ(firma_game_add_player(game, &player, nullptr), FIRMA_OK);
        EXPECT_EQ(firma_game_add_body(game, ball, &high, nullptr, nullptr), FIRMA_OK);
        firma_charge_defaults(&charge);
        charge.crater = 0.4;
        charge.material = "a material with a name that no short text holds";
    }
    ~WholeGamesWithoutMemory() override {
        EXPECT_EQ(firma_player_shape_release(player.shape), FIRMA_OK);
        EXPECT_EQ(firma_world_release(leaf), FIRMA_OK);
        EXPECT_EQ(firma_game_release(game), FIRMA_OK);
    }

    static std::uint64_t hash_of_game(firma_game of) {
        std::uint64_t hash = 0;
        EXPECT_EQ(firma_game_hash(of, &hash), FIRMA_OK) << firma_error_message();
        return hash;
    }

    /// A call that changes a game, on one that `make` makes each time: it is as it was, or lost.
    template <class Make, class Call>
    static long change_made(const Make& make, const Call& call) {
        for (long allocations = 0;; allocations += 1 + allocations / 8) {
            const firma_game own = make();
            const std::uint64_t before = hash_of_game(own);
            firma_code code = FIRMA_ERROR_INTERNAL;
            const std::size_t held = firma_live_handles();
            const bool out = firma::tests::runs_out(allocations, [&] { code = call(own); });
            EXPECT_EQ(code, out ? FIRMA_ERROR_NO_MEMORY : FIRMA_OK) << allocations << ": " << firma_error_message();
            EXPECT_EQ(firma_live_handles(), held) << allocations;
            std::uint64_t now = 0;
            const firma_code after = firma_game_hash(own, &now);
            if (out && after == FIRMA_OK) {
                EXPECT_EQ(now, before) << allocations;
            } else if (out) {
                EXPECT_EQ(after, FIRMA_ERROR_NO_MEMORY) << allocations;
                EXPECT_EQ(firma_game_step(own), FIRMA_ERROR_NO_MEMORY) << "what is lost stays lost";
            }
            EXPECT_EQ(firma_game_release(own), FIRMA_OK);
            if (!out || HasFailure()) return allocations;
        }
    }
    template <class Call>
    long change_game(const Call& call) const {
        return change_made([&] { return copy_of(false); }, call);
    }
    firma_game copy_of(bool recorded) const {
        firma_game copy{};
        EXPECT_EQ(firma_game_copy(game, &copy), FIRMA_OK);
        if (recorded) {
            EXPECT_EQ(firma_game_record(copy, "level"), FIRMA_OK);
        }
        return copy;
    }

    firma_game game{};
    firma_world leaf{};
    firma_part_stop stops[2]{};
    firma_part_path path{};
    firma_game_part part{};
    firma_game_player player{};
    firma_charge charge{};
    const firma_pose high{{-8, 8, 2}, {0, 0, 0, 1}, 1};
    const double at[3] = {-6, 8, 0.5}, way[3] = {0, 0, -40};
};

TEST_F(WholeGamesWithoutMemory, GamesAndSnapshotsAreMadeWholeOrNotAtAll) {
    const auto make = [](const auto& call, auto& handle, const auto& release) {
        handle.id = 77;
        EXPECT_GT(until_enough([&] { return call(&handle); }, [&](long) { EXPECT_EQ(handle.id, 77u); }), 0);
        EXPECT_EQ(release(handle), FIRMA_OK);
    };
    firma_game made{};
    make([&](firma_game* out) { return firma_game_begin(world, 60, out); }, made, firma_game_release);
    make([&](firma_game* out) { return firma_game_copy(game, out); }, made, firma_game_release);
    firma_world held{};
    make([&](firma_world* out) { return firma_game_world(game, out); }, held, firma_world_release);
    firma_log log{};
    make([&](firma_log* out) { return firma_game_log(game, out); }, log, firma_log_release);
    firma_parts list{};
    make([&](firma_parts* out) { return firma_game_parts(game, out); }, list, firma_parts_release);
    firma_bodies all{};
    make([&](firma_bodies* out) { return firma_game_bodies(game, out); }, all, firma_bodies_release);
    firma_debris some{};
    make([&](firma_debris* out) { return firma_game_debris(game, out); }, some, firma_debris_release);
    firma_player_shape shape{};
    make([&](firma_player_shape* out) { return firma_game_player_shape(game, 0, out); }, shape,
         firma_player_shape_release);
    firma_bytes bytes{77};
    EXPECT_GT(until_enough([&] { return firma_game_pack(game, &bytes); }, [&](long) { EXPECT_EQ(bytes.id, 77u); }), 50);
    const void* data = nullptr;
    std::size_t length = 0;
    EXPECT_EQ(firma_bytes_get_view(bytes, &data, &length), FIRMA_OK);
    make([&](firma_game* out) { return firma_game_unpack(data, length, "game", out); }, made, firma_game_release);
    EXPECT_EQ(firma_bytes_release(bytes), FIRMA_OK);
}

TEST_F(WholeGamesWithoutMemory, WhatHappensHappensOrTheGameIsLost) {
    firma_command cut{};
    EXPECT_EQ(firma_command_edit(1, cutter, &high, nullptr, &cut), FIRMA_OK);
    change_game([&](firma_game it) { return firma_game_edit(it, cut, nullptr); });
    firma_pose low = high;
    low.position[2] = 0;
    EXPECT_EQ(firma_command_release(cut), FIRMA_OK);
    EXPECT_EQ(firma_command_edit(1, cutter, &low, nullptr, &cut), FIRMA_OK);
    EXPECT_GT(change_game([&](firma_game it) { return firma_game_edit(it, cut, nullptr); }), 50);
    EXPECT_EQ(firma_command_release(cut), FIRMA_OK);
    EXPECT_GT(change_game([&](firma_game it) { return firma_game_explode(it, at, &charge); }), 100);
    EXPECT_GT(change_game([&](firma_game it) { return firma_game_fire(it, 1, at, way); }), 0);
    change_game([&](firma_game it) { return firma_game_add_body(it, ball, &high, nullptr, nullptr); });
    change_game([&](firma_game it) { return firma_game_add_player(it, &player, nullptr); });
    change_game([&](firma_game it) { return firma_game_wish(it, 0, &player.wish); });
    change_game([&](firma_game it) { return firma_game_set_off(it, 0); });
    EXPECT_GT(change_game([&](firma_game it) { return firma_game_add_part(it, &part, nullptr); }), 1);
    firma_weapon weapon;
    firma_weapon_defaults(&weapon);
    weapon.name = "a weapon with a name that no short text holds";
    weapon.has_charge = 1;
    weapon.charge = charge;
    EXPECT_GT(change_game([&](firma_game it) { return firma_game_add_weapon(it, &weapon, nullptr); }), 1);
    EXPECT_GT(change_game([&](firma_game it) { return firma_game_set_weapon(it, 1, &weapon); }), 1);
    firma_game_rules rules;
    firma_game_rules_defaults(&rules);
    change_game([&](firma_game it) { return firma_game_set_rules(it, &rules); });
    EXPECT_GT(change_game([&](firma_game it) { return firma_game_record(it, "level"); }), 1);
    // A rocket that goes off in the tick.
    EXPECT_EQ(firma_game_fire(game, 1, at, way), FIRMA_OK);
    EXPECT_GT(change_game([&](firma_game it) { return firma_game_step(it); }), 100);
}

TEST_F(WholeGamesWithoutMemory, RecordingsAreWholeOrNotThere) {
    EXPECT_EQ(firma_game_fire(game, 1, at, way), FIRMA_OK);
    const auto recorded = [&] { return copy_of(true); };
    EXPECT_GT(change_made(recorded, [&](firma_game it) { return firma_game_step(it); }), 100);
    EXPECT_GT(change_made(recorded, [&](firma_game it) { return firma_game_fire(it, 1, at, way); }), 1);

    const firma_game own = recorded();
    EXPECT_EQ(firma_game_step(own), FIRMA_OK);
    const std::uint64_t before = hash_of_game(own);
    firma_recording made{77}, read{77};
    const auto same = [&](long) {
        EXPECT_EQ(made.id, 77u);
        EXPECT_EQ(hash_of_game(own), before);
    };
    EXPECT_GT(until_enough([&] { return firma_game_recording(own, &made); }, same), 3);
    firma_bytes bytes{77};
    EXPECT_GT(until_enough([&] { return firma_recording_pack(made, &bytes); }, [&](long) { EXPECT_EQ(bytes.id, 77u); }),
              100);
    const void* data = nullptr;
    std::size_t length = 0;
    EXPECT_EQ(firma_bytes_get_view(bytes, &data, &length), FIRMA_OK);
    EXPECT_GT(until_enough([&] { return firma_recording_unpack(data, length, "recording", &read); },
                           [&](long) { EXPECT_EQ(read.id, 77u); }),
              100);
    EXPECT_EQ(firma_bytes_release(bytes), FIRMA_OK);
    for (const std::uint32_t at_end : {0u, 1u}) {
        firma_game held{77};
        EXPECT_GT(until_enough([&] { return firma_recording_game(read, at_end, &held); },
                               [&](long) { EXPECT_EQ(held.id, 77u); }),
                  1);
        EXPECT_EQ(firma_game_release(held), FIRMA_OK);
    }
    firma_game replay{77};
    EXPECT_GT(
        until_enough([&] { return firma_recording_replay(read, &replay); }, [&](long) { EXPECT_EQ(replay.id, 77u); }),
        2);
    EXPECT_EQ(firma_game_release(replay), FIRMA_OK);
    const auto make_replay = [&] {
        firma_game it{};
        EXPECT_EQ(firma_recording_replay(read, &it), FIRMA_OK);
        return it;
    };
    EXPECT_GT(change_made(make_replay, [&](firma_game it) { return firma_game_step(it); }), 100);
    EXPECT_EQ(firma_recording_release(read), FIRMA_OK);
    EXPECT_EQ(firma_recording_release(made), FIRMA_OK);
    EXPECT_EQ(firma_game_release(own), FIRMA_OK);
}

}  // namespace
