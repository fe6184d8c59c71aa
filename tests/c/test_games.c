/* SPDX-License-Identifier: MIT */
/* Games: what they go by, what happens in them, what is in them, saved and loaded; bad arguments. */
#include <math.h>
#include <stddef.h>

#include "tests/c/small_game.h"

static uint64_t game_hash(firma_game game) {
    uint64_t hash = 0;
    CHECK_OK(firma_game_hash(game, &hash));
    return hash;
}

static firma_game_facts facts_of(firma_game game) {
    firma_game_facts facts = {.size = sizeof facts};
    CHECK_OK(firma_game_get_facts(game, &facts));
    return facts;
}

static firma_game_report report_of(firma_game game) {
    firma_game_report report = {.size = sizeof report};
    CHECK_OK(firma_game_get_report(game, &report));
    return report;
}

static void test_begin(firma_world room) {
    firma_game game = {77}, copy = {0};
    CHECK_FAILS(firma_game_begin(room, 60, NULL), FIRMA_ERROR_BAD_CALL, "null");
    CHECK_FAILS(firma_game_begin((firma_world){0}, 60, &game), FIRMA_ERROR_BAD_HANDLE, "world");
    CHECK_FAILS(firma_game_begin(room, 3, &game), FIRMA_ERROR_INVALID, "rate");
    CHECK_FAILS(firma_game_begin(room, 1001, &game), FIRMA_ERROR_INVALID, "rate");
    CHECK(game.id == 77);
    CHECK_OK(firma_game_begin(room, 120, &game));
    firma_game_facts facts = facts_of(game);
    CHECK(facts.rate == 120 && facts.tick == 0 && facts.weapons == 3 && facts.parts == 0 && facts.players == 0);
    CHECK(facts.bodies == 0 && facts.projectiles == 0 && facts.explosions == 0 && !facts.recorded && !facts.replay);
    CHECK_OK(firma_game_step(game));
    CHECK_OK(firma_game_copy(game, &copy));
    CHECK(facts_of(copy).tick == 1 && game_hash(copy) == game_hash(game));
    CHECK_OK(firma_game_step(copy));
    CHECK(facts_of(copy).tick == 2 && facts_of(game).tick == 1 && game_hash(copy) != game_hash(game));
    facts.size = 4;
    CHECK_FAILS(firma_game_get_facts(game, &facts), FIRMA_ERROR_BAD_CALL, "size");
    CHECK_FAILS(firma_game_get_facts(game, NULL), FIRMA_ERROR_BAD_CALL, "null");
    CHECK_OK(firma_game_release(copy));
    CHECK_FAILS(firma_game_step(copy), FIRMA_ERROR_BAD_HANDLE, "game");
    CHECK_FAILS(firma_game_copy(game, NULL), FIRMA_ERROR_BAD_CALL, "null");
    CHECK_FAILS(firma_game_copy((firma_game){room.id}, &copy), FIRMA_ERROR_BAD_HANDLE, "game");
    CHECK_FAILS(firma_game_release((firma_game){room.id}), FIRMA_ERROR_BAD_HANDLE, "game");
    CHECK_OK(firma_game_release((firma_game){0}));
    CHECK_OK(firma_game_release(game));
}

static void test_rules(firma_world room) {
    firma_game game = {0};
    CHECK_OK(firma_game_begin(room, 60, &game));
    firma_game_rules rules, read = {.size = sizeof read};
    firma_game_rules_defaults(&rules);
    CHECK(rules.max_blast_speed == 30 && rules.seed == 1 && !rules.no_chunks && rules.min_chunk_volume == 0.001);
    CHECK(rules.bodies.substeps_a_second == 240 && rules.debris.max_bodies == 256 && rules.chunk_density == 0);
    const uint64_t before = game_hash(game);
    CHECK_OK(firma_game_set_rules(game, &rules));
    CHECK(game_hash(game) == before);
    rules.seed = 9;
    rules.no_chunks = 1;
    rules.bodies.gravity[2] = -3;
    rules.debris.to_ground = 1;
    CHECK_OK(firma_game_set_rules(game, &rules));
    CHECK(game_hash(game) != before);
    CHECK_OK(firma_game_get_rules(game, &read));
    CHECK(read.seed == 9 && read.no_chunks == 1 && read.bodies.gravity[2] == -3 && read.debris.to_ground == 1);
    CHECK(read.size == sizeof read && read.bodies.size == sizeof read.bodies);

    /* What a shorter struct lacks is as by default. */
    firma_game_rules shorter = {.size = offsetof(firma_game_rules, bodies), .max_blast_speed = 7};
    CHECK_OK(firma_game_set_rules(game, &shorter));
    CHECK_OK(firma_game_get_rules(game, &read));
    CHECK(read.max_blast_speed == 7 && read.bodies.gravity[2] == -9.81 && !read.no_chunks);

    const uint64_t now = game_hash(game);
    firma_game_rules_defaults(&rules);
    rules.no_chunks = 2;
    CHECK_FAILS(firma_game_set_rules(game, &rules), FIRMA_ERROR_INVALID, "no_chunks");
    firma_game_rules_defaults(&rules);
    rules.bodies.gravity[0] = NAN;
    CHECK_FAILS(firma_game_set_rules(game, &rules), FIRMA_ERROR_OUT_OF_RANGE, "option");
    firma_game_rules_defaults(&rules);
    rules.bodies.size = 0;
    CHECK_FAILS(firma_game_set_rules(game, &rules), FIRMA_ERROR_BAD_CALL, "size");
    firma_game_rules_defaults(&rules);
    rules.debris.max_age = -1;
    CHECK_FAILS(firma_game_set_rules(game, &rules), FIRMA_ERROR_OUT_OF_RANGE, "rule");
    firma_game_rules_defaults(&rules);
    rules.max_blast_speed = NAN;
    CHECK_FAILS(firma_game_set_rules(game, &rules), FIRMA_ERROR_INVALID, "max_blast_speed");
    firma_game_rules_defaults(&rules);
    rules.min_chunk_volume = -1;
    CHECK_FAILS(firma_game_set_rules(game, &rules), FIRMA_ERROR_INVALID, "loose");
    CHECK_FAILS(firma_game_set_rules(game, NULL), FIRMA_ERROR_BAD_CALL, "null");
    CHECK_FAILS(firma_game_get_rules((firma_game){0}, &read), FIRMA_ERROR_BAD_HANDLE, "game");
    CHECK(game_hash(game) == now);
    CHECK_OK(firma_game_release(game));
}

static void test_weapons(firma_world room) {
    firma_game game = {0};
    CHECK_OK(firma_game_begin(room, 60, &game));
    firma_weapon weapon = {.size = sizeof weapon};
    CHECK_OK(firma_game_get_weapon(game, 1, &weapon));
    CHECK(strcmp(weapon.name, "rocket") == 0 && weapon.mass == 2 && weapon.gravity[2] == 0 && weapon.has_charge);
    CHECK(weapon.charge.crater == 1.2 && weapon.charge.max_pieces == 12 && weapon.charge.material[0] == 0);
    CHECK_OK(firma_game_get_weapon(game, 0, &weapon));
    CHECK(strcmp(weapon.name, "bullet") == 0 && !weapon.has_charge && weapon.terms.resistance == 8000);
    /* What was told can be set. */
    const uint64_t before = game_hash(game);
    for (uint32_t k = 0; k < 3; ++k) {
        CHECK_OK(firma_game_get_weapon(game, k, &weapon));
        CHECK_OK(firma_game_set_weapon(game, k, &weapon));
    }
    CHECK(game_hash(game) == before);

    firma_weapon_defaults(&weapon);
    CHECK(weapon.mass == 0.01 && weapon.fuse == 10 && weapon.terms.ricochet_below == 0.25 && !weapon.has_charge);
    weapon.name = "mortar";
    weapon.has_charge = 1;
    weapon.charge.shape = FIRMA_SPIKY;
    weapon.charge.material = "soot";
    uint32_t index = 77;
    CHECK_OK(firma_game_add_weapon(game, &weapon, &index));
    CHECK(index == 3 && facts_of(game).weapons == 4);
    CHECK_OK(firma_game_add_weapon(game, &weapon, NULL));
    firma_weapon read = {.size = sizeof read};
    CHECK_OK(firma_game_get_weapon(game, 3, &read));
    CHECK(strcmp(read.name, "mortar") == 0 && strcmp(read.charge.material, "soot") == 0);
    CHECK(read.charge.shape == FIRMA_SPIKY);

    const uint64_t now = game_hash(game);
    index = 77;
    weapon.mass = 0;
    CHECK_FAILS(firma_game_add_weapon(game, &weapon, &index), FIRMA_ERROR_INVALID, "weapon mortar");
    CHECK_FAILS(firma_game_set_weapon(game, 3, &weapon), FIRMA_ERROR_INVALID, "mass");
    weapon.mass = 1;
    weapon.charge.shape = 256;
    CHECK_FAILS(firma_game_add_weapon(game, &weapon, &index), FIRMA_ERROR_INVALID, "shape");
    weapon.charge.shape = FIRMA_ROCKY;
    weapon.charge.crater = NAN;
    CHECK_FAILS(firma_game_add_weapon(game, &weapon, &index), FIRMA_ERROR_INVALID, "crater");
    weapon.charge.crater = 1;
    weapon.charge.size = 3;
    CHECK_FAILS(firma_game_add_weapon(game, &weapon, &index), FIRMA_ERROR_BAD_CALL, "size");
    weapon.has_charge = 2;
    CHECK_FAILS(firma_game_add_weapon(game, &weapon, &index), FIRMA_ERROR_INVALID, "0 or 1");
    CHECK_FAILS(firma_game_add_weapon(game, NULL, &index), FIRMA_ERROR_BAD_CALL, "null");
    CHECK_FAILS(firma_game_get_weapon(game, 5, &read), FIRMA_ERROR_OUT_OF_RANGE, "weapon 5");
    firma_weapon_defaults(&weapon);
    CHECK_FAILS(firma_game_set_weapon(game, 5, &weapon), FIRMA_ERROR_OUT_OF_RANGE, "weapon 5");
    CHECK(index == 77 && game_hash(game) == now);
    CHECK_OK(firma_game_release(game));
}

static void test_parts_of_games(firma_world room) {
    firma_game game = {0};
    CHECK_OK(firma_game_begin(room, 60, &game));
    const uint32_t door = add_door(game);
    CHECK(door == 0);
    firma_game_part_state state = {.size = sizeof state};
    CHECK_OK(firma_game_get_part(game, door, &state));
    CHECK(state.waits && state.at_first_stop && state.started == FIRMA_NO_TICK && strcmp(state.name, "door") == 0);
    CHECK(state.motion.position[2] == 0 && state.motion.path[2] == 0 && state.entity == FIRMA_NO_PART);
    CHECK_OK(firma_game_set_off(game, door));
    CHECK_OK(firma_game_step(game));
    CHECK_OK(firma_game_step(game));
    CHECK_OK(firma_game_get_part(game, door, &state));
    CHECK(!state.at_first_stop && state.started == 0 && fabs(state.motion.path[2] - 2.0 / 60) < 1e-9);

    /* A bullet meets it. */
    const double muzzle[3] = {6, 3, 1}, way[3] = {0, -100, 0};
    firma_shot_event event;
    size_t count = 0;
    CHECK_OK(firma_game_fire(game, 0, muzzle, way));
    CHECK_OK(firma_game_step(game));
    CHECK_OK(firma_game_shot_events(game, &event, NULL, 1, &count));
    CHECK(count >= 1 && event.part == door && fabs(event.in_part[1] - 0.125) < 1e-3);
    CHECK_OK(firma_game_get_part(game, door, &state));

    /* The parts as a list that is asked like one of a level. */
    firma_parts parts = {0};
    CHECK_OK(firma_game_parts(game, &parts));
    firma_part_info info = {.size = sizeof info};
    CHECK_OK(firma_parts_get(parts, 0, &info));
    CHECK(info.waits_for_trigger && info.face_count == 6 && info.motion.path[2] == state.motion.path[2]);
    firma_part_path path = {.size = sizeof path};
    CHECK_OK(firma_parts_path(parts, 0, &path));
    CHECK(path.stop_count == 2 && path.stops[1].position[2] == 2);
    firma_breakable bears = {.size = sizeof bears};
    CHECK_OK(firma_parts_breakable(parts, 0, &bears));
    CHECK(bears.health == 0 && fabs(bears.whole - 0.5) < 1e-9);
    CHECK_OK(firma_parts_release(parts));

    firma_game_part part;
    firma_game_part_defaults(&part);
    uint32_t index = 77;
    CHECK_FAILS(firma_game_add_part(game, &part, &index), FIRMA_ERROR_BAD_HANDLE, "world");
    const firma_world slab = make_leaf();
    part.world = slab;
    part.waits = 2;
    CHECK_FAILS(firma_game_add_part(game, &part, &index), FIRMA_ERROR_INVALID, "0 or 1");
    part.waits = 0;
    CHECK(part.when_blocked == FIRMA_BLOCKED_CRUSHES);
    part.when_blocked = 3;
    CHECK_FAILS(firma_game_add_part(game, &part, &index), FIRMA_ERROR_INVALID, "when_blocked");
    part.when_blocked = FIRMA_BLOCKED_RETURNS;
    part.portal_count = 1;
    CHECK_FAILS(firma_game_add_part(game, &part, &index), FIRMA_ERROR_BAD_CALL, "count");
    const uint32_t none = 99;
    part.portals = &none;
    firma_part_path bad;
    firma_part_path_defaults(&bad);
    bad.spin = 1e6;
    part.path = &bad;
    CHECK_FAILS(firma_game_add_part(game, &part, &index), FIRMA_ERROR_INVALID, "motion");
    bad.spin = NAN;
    CHECK_FAILS(firma_game_add_part(game, &part, &index), FIRMA_ERROR_OUT_OF_RANGE, "path");
    CHECK_FAILS(firma_game_add_part(game, NULL, &index), FIRMA_ERROR_BAD_CALL, "null");
    CHECK_FAILS(firma_game_get_part(game, 1, &state), FIRMA_ERROR_OUT_OF_RANGE, "part 1");
    CHECK(index == 77 && facts_of(game).parts == 1);
    part.path = NULL;
    CHECK_OK(firma_game_add_part(game, &part, &index));
    CHECK(index == 1);
    CHECK_OK(firma_game_get_part(game, 1, &state));
    CHECK(state.when_blocked == FIRMA_BLOCKED_RETURNS);
    CHECK_OK(firma_game_set_off(game, 1)); /* in vain: it does not wait */
    CHECK_OK(firma_game_step(game));       /* a portal that is not there is passed over */
    CHECK_OK(firma_world_release(slab));
    CHECK_OK(firma_game_release(game));
}

static void test_bad_events(firma_game game) {
    const uint64_t before = game_hash(game);
    const double at[3] = {4, 4, 2}, bad[3] = {NAN, 0, 0}, fast[3] = {0, 0, 1e6};
    firma_charge charge;
    firma_charge_defaults(&charge);
    uint32_t index = 77;
    CHECK_FAILS(firma_game_explode(game, bad, &charge), FIRMA_ERROR_OUT_OF_RANGE, "blast");
    CHECK_FAILS(firma_game_explode(game, NULL, &charge), FIRMA_ERROR_BAD_CALL, "null");
    CHECK_FAILS(firma_game_explode(game, at, NULL), FIRMA_ERROR_BAD_CALL, "null");
    charge.radius = 0;
    CHECK_FAILS(firma_game_explode(game, at, &charge), FIRMA_ERROR_INVALID, "firma_game_explode: a charge's radius");
    charge.reserved = 1;
    CHECK_FAILS(firma_game_explode(game, at, &charge), FIRMA_ERROR_INVALID, "reserved");
    CHECK_FAILS(firma_game_fire(game, 9, at, at), FIRMA_ERROR_INVALID, "weapon 9");
    CHECK_FAILS(firma_game_fire(game, 0, at, bad), FIRMA_ERROR_OUT_OF_RANGE, "projectile");
    CHECK_FAILS(firma_game_fire(game, 0, at, fast), FIRMA_ERROR_INVALID, "faster");
    CHECK_FAILS(firma_game_fire(game, 0, at, NULL), FIRMA_ERROR_BAD_CALL, "null");
    CHECK_FAILS(firma_game_set_off(game, 9), FIRMA_ERROR_INVALID, "part 9");
    CHECK_FAILS(firma_game_edit(game, (firma_command){0}, NULL), FIRMA_ERROR_BAD_HANDLE, "command");
    firma_player_wish wish = {.size = sizeof wish};
    CHECK_FAILS(firma_game_wish(game, 9, &wish), FIRMA_ERROR_INVALID, "player 9");
    CHECK_FAILS(firma_game_wish(game, 0, NULL), FIRMA_ERROR_BAD_CALL, "null");
    wish.jump = 2;
    CHECK_FAILS(firma_game_wish(game, 0, &wish), FIRMA_ERROR_INVALID, "0 or 1");
    wish.jump = 0;
    wish.velocity[1] = INFINITY;
    CHECK_FAILS(firma_game_wish(game, 0, &wish), FIRMA_ERROR_OUT_OF_RANGE, "wish");
    firma_game_player player;
    firma_game_player_defaults(&player);
    CHECK(player.mass == 80 && player.rules.gravity == 9.81 && player.shape.id == 0);
    CHECK_FAILS(firma_game_add_player(game, &player, &index), FIRMA_ERROR_BAD_HANDLE, "shape");
    CHECK_OK(firma_player_shape_capsule(NULL, &player.shape));
    player.mass = 0;
    CHECK_FAILS(firma_game_add_player(game, &player, &index), FIRMA_ERROR_INVALID, "mass");
    player.mass = 80;
    player.player.ground_part = 9;
    CHECK_FAILS(firma_game_add_player(game, &player, &index), FIRMA_ERROR_INVALID, "part 9");
    player.player.ground_part = FIRMA_NO_PART;
    player.player.stuck = 2;
    CHECK_FAILS(firma_game_add_player(game, &player, &index), FIRMA_ERROR_INVALID, "0 or 1");
    player.player.stuck = 0;
    player.rules.gravity = NAN;
    CHECK_FAILS(firma_game_add_player(game, &player, &index), FIRMA_ERROR_INVALID, "rules");
    player.wish.size = 0;
    CHECK_FAILS(firma_game_add_player(game, &player, &index), FIRMA_ERROR_BAD_CALL, "size");
    CHECK_FAILS(firma_game_add_player(game, NULL, &index), FIRMA_ERROR_BAD_CALL, "null");
    CHECK_OK(firma_player_shape_release(player.shape));
    firma_body_id id = {77, 7};
    const firma_body_shape ball = make_ball();
    firma_pose pose = {{4, 4, 2}, {0, 0, 0, 1}, 1};
    firma_body body;
    firma_body_defaults(&body);
    CHECK(body.friction == 0.6 && body.mask == UINT32_MAX && body.rotation[3] == 1 && body.mass == 0);
    body.restitution = 2;
    CHECK_FAILS(firma_game_add_body(game, ball, &pose, &body, &id), FIRMA_ERROR_OUT_OF_RANGE, "body");
    CHECK_FAILS(firma_game_add_body(game, ball, NULL, &body, &id), FIRMA_ERROR_BAD_CALL, "null");
    CHECK_FAILS(firma_game_add_body(game, (firma_body_shape){0}, &pose, NULL, &id), FIRMA_ERROR_BAD_HANDLE, "shape");
    pose.rotation[3] = 0;
    CHECK_FAILS(firma_game_add_body(game, ball, &pose, NULL, &id), FIRMA_ERROR_OUT_OF_RANGE, "pose");
    CHECK_OK(firma_body_shape_release(ball));
    CHECK(index == 77 && id.slot == 77 && game_hash(game) == before);
}

static void test_edits(firma_game game) {
    firma_cutter box = {0};
    CHECK_OK(firma_cutter_crater(FIRMA_BOX, 1, &box));
    firma_pose pose = {{2, 2, 0}, {0, 0, 0, 1}, 0.5};
    firma_command cut = {0}, far = {0}, door = {0}, nowhere = {0};
    CHECK_OK(firma_command_edit(1, box, &pose, NULL, &cut));
    pose.position[0] = 1e9;
    CHECK_OK(firma_command_edit(1, box, &pose, NULL, &far));
    pose.position[0] = 6;
    pose.position[1] = 4;
    pose.position[2] = 2;
    CHECK_OK(firma_command_edit(1, box, &pose, NULL, &nowhere));
    CHECK_OK(firma_command_door(1, 5, 1, &door));
    CHECK_OK(firma_game_step(game));
    uint32_t status = 77;
    CHECK_OK(firma_game_edit(game, door, &status));
    CHECK(status == FIRMA_CARVE_REFUSED && strstr(firma_error_message(), "portal"));
    CHECK_OK(firma_game_edit(game, cut, &status));
    CHECK(status == FIRMA_CARVE_DONE);
    CHECK_OK(firma_game_edit(game, far, &status));
    CHECK(status == FIRMA_CARVE_REFUSED && !strstr(firma_error_message(), "portal"));
    CHECK_OK(firma_game_edit(game, nowhere, &status));
    CHECK(status == FIRMA_CARVE_NOTHING);
    CHECK_OK(firma_game_edit(game, nowhere, NULL));
    firma_game_report report = report_of(game);
    CHECK(report.edits == 1 && report.refused == 2 && report.nothing == 2 && strstr(report.refusal, "portal"));
    firma_log log = {0};
    firma_log_facts facts = {.size = sizeof facts};
    CHECK_OK(firma_game_log(game, &log));
    CHECK_OK(firma_log_get_facts(log, &facts));
    CHECK(facts.command_count == 1 && facts.last_number == facts.level_edits + 1);
    CHECK_OK(firma_log_release(log));
    CHECK_OK(firma_command_release(cut));
    CHECK_OK(firma_command_release(far));
    CHECK_OK(firma_command_release(door));
    CHECK_OK(firma_command_release(nowhere));
    CHECK_OK(firma_cutter_release(box));
}

/* A column is shot off the ceiling: the report has what a game shows, the state has what it draws. */
static void test_what_happens(firma_world room) {
    firma_game game = make_game(room);
    test_bad_events(game);
    test_edits(game);
    CHECK(facts_of(game).players == 1 && facts_of(game).bodies == 1 && facts_of(game).parts == 1);
    CHECK_OK(firma_game_step(game));
    firma_game_report report = report_of(game);
    CHECK(report.moves == 1 && report.bodies.awake == 1 && report.edits == 1 && report.blasts == 0);
    firma_player_move move = {.size = sizeof move};
    CHECK_OK(firma_game_move(game, 0, &move));
    firma_game_player player = {.size = sizeof player};
    CHECK_OK(firma_game_get_player(game, 0, &player));
    CHECK(memcmp(&player.player, &move.player, sizeof move.player) == 0 && player.shape.id == 0);
    CHECK(player.wish.velocity[0] == 1 && player.wish.size == sizeof player.wish);
    CHECK_FAILS(firma_game_move(game, 1, &move), FIRMA_ERROR_OUT_OF_RANGE, "player 1");
    CHECK_FAILS(firma_game_get_player(game, 1, &player), FIRMA_ERROR_OUT_OF_RANGE, "player 1");
    firma_player_shape shape = {0};
    firma_player_size size = {.size = sizeof size};
    CHECK_OK(firma_game_player_shape(game, 0, &shape));
    CHECK_OK(firma_player_shape_get_size(shape, &size));
    CHECK(size.radius == 0.3 && size.height == 1.8 && size.crouched_height == 1.1 && size.up[2] == 1);
    CHECK_OK(firma_player_shape_release(shape));

    /* The column comes loose and breaks. */
    const double at[3] = {3.5, 2.9, 3.25};
    firma_charge charge;
    firma_charge_defaults(&charge);
    charge.crater = 1.6;
    CHECK_OK(firma_game_explode(game, at, &charge));
    report = report_of(game);
    CHECK(report.moves == 0 && report.blasts == 1 && report.loose > 2 && report.edits == 1); /* it alone */
    firma_explosion explosion = {.size = sizeof explosion, .carve = {.size = sizeof explosion.carve}};
    double place[3] = {0, 0, 0};
    CHECK_OK(firma_game_blast(game, 0, place, &explosion));
    CHECK(place[1] == 2.9 && explosion.status == FIRMA_CARVE_DONE && explosion.loose == report.loose);
    CHECK(explosion.carve.faces_cut > 0 && explosion.carve.loose.id == 0);
    firma_body_id ids[64];
    size_t count = 0;
    CHECK_OK(firma_game_blast_bodies(game, 0, FIRMA_DEBRIS_LOOSE, ids, 64, &count));
    CHECK(count == report.loose);
    CHECK_FAILS(firma_game_blast_bodies(game, 0, FIRMA_DEBRIS_REMOVED, ids, 64, &count), FIRMA_ERROR_INVALID, "list");
    CHECK_FAILS(firma_game_blast_bodies(game, 1, FIRMA_DEBRIS_LOOSE, ids, 64, &count), FIRMA_ERROR_OUT_OF_RANGE,
                "blast 1");
    CHECK_FAILS(firma_game_blast(game, 1, NULL, &explosion), FIRMA_ERROR_OUT_OF_RANGE, "blast 1");

    /* Bodies and debris as snapshots, asked by their own calls. */
    firma_bodies bodies = {0};
    firma_debris debris = {0};
    CHECK_OK(firma_game_bodies(game, &bodies));
    CHECK_OK(firma_game_debris(game, &debris));
    CHECK_OK(firma_bodies_get_count(bodies, &count));
    CHECK(count == facts_of(game).bodies && count == 1 + report.loose);
    firma_debris_piece piece = {.size = sizeof piece};
    CHECK_OK(firma_debris_get(debris, bodies, ids[0], &piece));
    CHECK(piece.face_count >= 4);
    firma_body_shape spheres = {0};
    double sphere[4] = {0, 0, 0, 0};
    CHECK_OK(firma_bodies_list(bodies, ids, 1, &count));
    CHECK_OK(firma_bodies_shape(bodies, ids[0], &spheres));
    CHECK_OK(firma_body_shape_get_spheres(spheres, sphere, 1, &count));
    CHECK(count == 1 && sphere[3] == 0.25);
    CHECK_FAILS(firma_body_shape_get_spheres(spheres, NULL, 1, &count), FIRMA_ERROR_BAD_CALL, "null");
    CHECK_OK(firma_body_shape_release(spheres));
    CHECK_FAILS(firma_bodies_shape(bodies, (firma_body_id){99, 0}, &spheres), FIRMA_ERROR_INVALID, "no such body");
    const uint64_t before = game_hash(game);
    CHECK_OK(firma_bodies_remove(bodies, ids[0]));
    CHECK(game_hash(game) == before);
    CHECK_OK(firma_bodies_release(bodies));
    CHECK_OK(firma_debris_release(debris));

    /* A bullet flies and ricochets or stops. */
    const double muzzle[3] = {6, 6, 2}, way[3] = {40, 10, 0};
    CHECK_OK(firma_game_fire(game, 0, muzzle, way));
    firma_projectile shot;
    CHECK_OK(firma_game_projectiles(game, 0, &shot, 1, &count));
    CHECK(count == 1 && shot.velocity[0] == 40 && shot.mass == 0.01 && facts_of(game).projectiles == 1);
    CHECK_OK(firma_game_projectiles(game, 1, NULL, 0, &count));
    CHECK(count == 0);
    CHECK_FAILS(firma_game_projectiles(game, 9, NULL, 0, &count), FIRMA_ERROR_OUT_OF_RANGE, "weapon 9");
    CHECK_FAILS(firma_game_projectiles(game, 0, NULL, 1, &count), FIRMA_ERROR_BAD_CALL, "null");
    firma_shot_event event;
    uint32_t weapon = 77;
    count = 0;
    for (int k = 0; k < 60 && count == 0; ++k) {
        CHECK_OK(firma_game_step(game));
        CHECK_OK(firma_game_shot_events(game, &event, &weapon, 1, &count));
    }
    CHECK(count >= 1 && weapon == 0 && event.length_count == 0 && report_of(game).shot_events == count);
    CHECK_OK(firma_game_shot_events(game, NULL, NULL, 0, &count));

    /* The world, and the hashes of what is in the game. */
    firma_world now = {0};
    CHECK_OK(firma_game_world(game, &now));
    CHECK(hash_of(now) != hash_of(room));
    CHECK_OK(firma_world_release(now));
    uint32_t one = 0;
    for (uint32_t item = 0; item <= FIRMA_ITEM_REST; ++item) {
        CHECK_OK(firma_game_hash_items(game, item, &one, 1, &count));
        CHECK(item == FIRMA_ITEM_PROJECTILE || count >= 1);
    }
    CHECK_FAILS(firma_game_hash_items(game, 7, NULL, 0, &count), FIRMA_ERROR_INVALID, "item");
    CHECK_OK(firma_game_release(game));
}

static void test_saved(firma_world room, const char* folder) {
    char path[512];
    snprintf(path, sizeof path, "%s/test_games.firma", folder);
    firma_game game = make_game(room), loaded = {0}, other = {77};
    fight(game, 0, 40);
    firma_bytes bytes = {0};
    const void* data = NULL;
    size_t length = 0;
    CHECK_OK(firma_game_pack(game, &bytes));
    CHECK_OK(firma_bytes_get_view(bytes, &data, &length));
    uint32_t kind = 77;
    CHECK_OK(firma_game_bytes_kind(data, length, &kind));
    CHECK(kind == FIRMA_BYTES_GAME);
    CHECK_OK(firma_game_bytes_kind(NULL, 0, &kind));
    CHECK(kind == FIRMA_BYTES_OTHER);
    CHECK_OK(firma_game_unpack(data, length, "bytes", &loaded));
    CHECK(game_hash(loaded) == game_hash(game));
    /* Whoever reads worlds reads this one's. */
    firma_world world = {0}, held = {0};
    CHECK_OK(firma_world_unpack(data, length, NULL, &world));
    CHECK_OK(firma_game_world(game, &held));
    CHECK(hash_of(world) == hash_of(held));
    CHECK_OK(firma_world_release(world));
    CHECK_OK(firma_world_release(held));
    CHECK_FAILS(firma_game_unpack(data, length / 2, "half", &other), FIRMA_ERROR_MALFORMED, "half");
    CHECK_FAILS(firma_game_unpack(NULL, 4, NULL, &other), FIRMA_ERROR_BAD_CALL, "null");
    CHECK_OK(firma_bytes_release(bytes));
    CHECK_OK(firma_world_pack(room, 0, &bytes));
    CHECK_OK(firma_bytes_get_view(bytes, &data, &length));
    CHECK_FAILS(firma_game_unpack(data, length, NULL, &other), FIRMA_ERROR_MALFORMED, "game");
    CHECK_OK(firma_bytes_release(bytes));

    CHECK_OK(firma_game_save(game, path));
    CHECK_OK(firma_game_release(loaded));
    CHECK_OK(firma_game_load(path, &loaded));
    fight(game, 40, 80);
    fight(loaded, 40, 80);
    CHECK(game_hash(loaded) == game_hash(game) && facts_of(loaded).tick == 80);
    CHECK_OK(firma_world_load(path, NULL, &world));
    CHECK_OK(firma_world_release(world));
    CHECK_FAILS(firma_game_save(game, "/no/such/folder/game.firma"), FIRMA_ERROR_CANNOT_WRITE, "/no/such/folder");
    CHECK_FAILS(firma_game_save(game, ""), FIRMA_ERROR_INVALID, "name");
    CHECK_FAILS(firma_game_save(game, NULL), FIRMA_ERROR_BAD_CALL, "null");
    CHECK_FAILS(firma_game_load("/no/such/game.firma", &other), FIRMA_ERROR_CANNOT_READ, "/no/such");
    CHECK_FAILS(firma_game_load(path, NULL), FIRMA_ERROR_BAD_CALL, "null");
    CHECK(other.id == 77);
    remove(path);
    CHECK_OK(firma_game_release(loaded));
    CHECK_OK(firma_game_release(game));
}

void test_games(const char* folder) {
    const size_t before = firma_live_handles();
    const firma_world room = make_hung_room();
    test_begin(room);
    test_rules(room);
    test_weapons(room);
    test_parts_of_games(room);
    test_what_happens(room);
    test_saved(room, folder);
    CHECK_OK(firma_world_release(room));
    CHECK(firma_live_handles() == before);
}
