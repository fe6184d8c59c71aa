/* SPDX-License-Identifier: MIT */
/* A bridge shot at both ends: its middle comes loose, is asked and cut as a world of its own, and becomes ground. */
#include <math.h>
#include <stddef.h>

#include "tests/c/check.h"

static const firma_pose kHere = {{0, 0, 0}, {0, 0, 0, 1}, 1};

/* The room with a bridge of plaster from wall to wall, 2 m wide and half a metre thick. */
static firma_world make_bridge(void) {
    const firma_world room = make_room();
    const firma_cutter bar = make_box(-0.5, 3, 2, 8.5, 5, 2.5);
    const firma_carve_options fill = {.size = sizeof fill, .fill = 1, .material = "plaster"};
    firma_world bridge = {0};
    CHECK_OK(firma_carve(room, bar, &kHere, &fill, &bridge, NULL));
    CHECK_OK(firma_cutter_release(bar));
    CHECK_OK(firma_world_release(room));
    return bridge;
}

static firma_carve_options asking(void) {
    const firma_carve_options options = {.size = sizeof options, .chunks = 1, .density = 1000};
    return options;
}

/* One end of it gone. */
static firma_world cut_one_end(firma_world bridge) {
    const firma_cutter blade = make_box(0.5, 2, 1, 1, 6, 3);
    const firma_carve_options options = asking();
    firma_carve_report report = {.size = sizeof report};
    firma_world after = {0};
    CHECK_OK(firma_carve(bridge, blade, &kHere, &options, &after, &report));
    CHECK(report.status == FIRMA_CARVE_DONE && report.chunks == 0 && report.loose.id == 0);
    CHECK_OK(firma_cutter_release(blade));
    return after;
}

static void check_middle(const firma_chunk* middle) {
    const double where[3] = {4, 4, 2.25};
    for (int axis = 0; axis < 3; ++axis) {
        CHECK(fabs(middle->origin[axis] + middle->mass.centre[axis] - where[axis]) < 1e-12);
        CHECK(middle->low[axis] < middle->high[axis]);
    }
    CHECK(middle->mass.volume == 6 && middle->mass.mass == 6000 && middle->face_count == 6);
    CHECK(middle->low[0] + middle->origin[0] == 1 && middle->high[0] + middle->origin[0] == 7);
    const double about_x = 6000.0 / 12 * (2 * 2 + 0.5 * 0.5), about_z = 6000.0 / 12 * (6 * 6 + 2 * 2);
    CHECK(fabs(middle->mass.inertia[0] - about_x) < 1e-9 && fabs(middle->mass.inertia[8] - about_z) < 1e-9);
    CHECK(middle->mass.inertia[1] == middle->mass.inertia[3]);
}

/* The piece as a world: cast at, drawn, cut in two. */
static void use_as_world(firma_world piece) {
    const firma_cast_input down = {{0, 0, 2}, 0, {0, 0, -4}};
    firma_hit hit;
    CHECK_OK(firma_cast(piece, &down, NULL, &hit, NULL));
    CHECK(hit.status == FIRMA_HIT && fabs(hit.point[2] - 0.25) < 1e-9);
    const char* name = NULL;
    CHECK_OK(firma_world_material(piece, hit.material, &name));
    CHECK(strcmp(name, "plaster") == 0);
    firma_triangles triangles = {0};
    firma_triangles_view view = {.size = sizeof view};
    CHECK_OK(firma_world_triangles(piece, NULL, &triangles));
    CHECK_OK(firma_triangles_get_view(triangles, &view));
    CHECK(view.triangle_count == 12);
    CHECK_OK(firma_triangles_release(triangles));

    const firma_cutter saw = make_box(-1, -3, -3, 1, 3, 3);
    firma_world broken = {0};
    firma_chunks halves = {0};
    firma_chunk half = {.size = sizeof half};
    size_t count = 0;
    CHECK_OK(firma_carve(piece, saw, &kHere, NULL, &broken, NULL));
    CHECK_OK(firma_world_pieces(broken, 500, &halves));
    CHECK_OK(firma_chunks_get_count(halves, &count));
    CHECK(count == 2);
    for (size_t k = 0; k < count; ++k) {
        firma_world alone = {0};
        firma_mass mass;
        CHECK_OK(firma_chunks_get(halves, k, &half));
        CHECK(half.mass.volume == 2 && half.mass.mass == 1000 && half.origin[0] == 0);
        CHECK_OK(firma_chunks_world(halves, k, &alone));
        CHECK_OK(firma_world_mass(alone, 500, &mass));
        CHECK(memcmp(&mass, &half.mass, sizeof mass) == 0);
        CHECK_OK(firma_world_check(alone));
        CHECK_OK(firma_world_release(alone));
    }
    CHECK_FAILS(firma_world_pieces(broken, NAN, &halves), FIRMA_ERROR_OUT_OF_RANGE, "density");
    CHECK_OK(firma_chunks_release(halves));
    CHECK_OK(firma_world_release(broken));
    CHECK_OK(firma_cutter_release(saw));
}

/* Where it lay it is the ground that a cut without chunks leaves; turned by any angle it changes little. */
static void put_back(firma_world piece, const firma_chunk* middle, firma_world after, firma_world hanging) {
    firma_pose pose = kHere;
    memcpy(pose.position, middle->origin, sizeof pose.position);
    firma_rest rest = {.size = sizeof rest};
    firma_cutter cutter = {0};
    firma_world ground = {0};
    const firma_carve_options fill = {.size = sizeof fill, .fill = 1};
    firma_carve_report report = {.size = sizeof report};
    uint32_t same = 0;
    CHECK_OK(firma_cutter_at_rest(piece, &pose, "middle", &cutter, &rest));
    CHECK(rest.volume_change == 0 && rest.mended == 0);
    CHECK_OK(firma_carve(after, cutter, &rest.pose, &fill, &ground, &report));
    CHECK(report.status == FIRMA_CARVE_DONE && report.volume == -6);
    CHECK_OK(firma_world_same_solid(ground, hanging, &same));
    CHECK(same == 1);
    CHECK_OK(firma_world_release(ground));
    CHECK_OK(firma_cutter_release(cutter));

    pose.position[2] -= 1;
    pose.rotation[2] = 0.1;
    CHECK_OK(firma_cutter_at_rest(piece, &pose, NULL, &cutter, &rest));
    CHECK(fabs(rest.volume_change) < 0.01 && rest.pose.scale == 1);
    CHECK_OK(firma_carve(after, cutter, &rest.pose, &fill, &ground, &report));
    CHECK(report.status == FIRMA_CARVE_DONE && fabs(report.volume + 6 + rest.volume_change) < 1e-9);
    CHECK_OK(firma_world_check(ground));
    CHECK_OK(firma_world_release(ground));
    CHECK_OK(firma_cutter_release(cutter));
    pose.position[0] = INFINITY;
    CHECK_FAILS(firma_cutter_at_rest(piece, &pose, "middle", &cutter, &rest), FIRMA_ERROR_OUT_OF_RANGE, "");
    CHECK_FAILS(firma_cutter_at_rest(after, &kHere, NULL, &cutter, &rest), FIRMA_ERROR_INVALID, "infinity");
    rest.size = 0;
    CHECK_FAILS(firma_cutter_at_rest(piece, &kHere, NULL, &cutter, &rest), FIRMA_ERROR_BAD_CALL, "size");
}

static void test_loose(firma_world cut, firma_cutter blade) {
    const firma_carve_options options = asking();
    firma_carve_report report = {.size = sizeof report};
    firma_world after = {0}, hanging = {0}, piece = {0};
    firma_chunk middle = {.size = sizeof middle};
    size_t count = 0;
    CHECK_OK(firma_carve(cut, blade, &kHere, NULL, &hanging, &report));
    CHECK(report.chunks == 0 && report.loose.id == 0);
    const double blown = report.volume;
    CHECK_OK(firma_carve(cut, blade, &kHere, &options, &after, &report));
    CHECK(report.chunks == 1 && report.chunk_volume == 6 && report.crumbs == 0 && report.volume == blown);
    CHECK_OK(firma_world_check(after));
    CHECK_OK(firma_chunks_get_count(report.loose, &count));
    CHECK(count == 1);
    CHECK_OK(firma_chunks_get(report.loose, 0, &middle));
    check_middle(&middle);
    CHECK_FAILS(firma_chunks_get(report.loose, 1, &middle), FIRMA_ERROR_OUT_OF_RANGE, "no such chunk");
    CHECK_FAILS(firma_chunks_world(report.loose, 1, &piece), FIRMA_ERROR_OUT_OF_RANGE, "no such chunk");
    CHECK_OK(firma_chunks_world(report.loose, 0, &piece));
    CHECK_OK(firma_chunks_release(report.loose));
    CHECK_FAILS(firma_chunks_get_count(report.loose, &count), FIRMA_ERROR_BAD_HANDLE, "list of chunks");
    use_as_world(piece);
    put_back(piece, &middle, after, hanging);
    CHECK_OK(firma_world_release(piece));
    CHECK_OK(firma_world_release(hanging));
    CHECK_OK(firma_world_release(after));
}

/* The same from a job and from an edit; without a report, or into one of an older program, they are lost. */
static void test_other_ways(firma_world cut, firma_cutter blade) {
    const firma_carve_options options = asking();
    firma_carve_report report = {.size = sizeof report};
    firma_world at_once = {0}, other = {0};
    firma_job job = {0};
    firma_edit edit = {0};
    uint32_t finished = 0;
    const size_t held = firma_live_handles();
    CHECK_OK(firma_carve(cut, blade, &kHere, &options, &at_once, NULL));
    CHECK(firma_live_handles() == held + 1);
    CHECK_OK(firma_job_start(cut, blade, &kHere, &options, &job));
    while (!finished) CHECK_OK(firma_job_run(job, 0, &finished));
    for (int twice = 0; twice < 2; ++twice) {
        CHECK_OK(firma_job_result(job, &other, &report));
        CHECK(report.chunks == 1 && report.loose.id != 0 && hash_of(other) == hash_of(at_once));
        CHECK_OK(firma_chunks_release(report.loose));
        CHECK_OK(firma_world_release(other));
    }
    CHECK_OK(firma_job_release(job));
    CHECK_OK(firma_edit_begin(cut, &edit));
    CHECK_OK(firma_edit_carve(edit, blade, &kHere, &options, &report));
    CHECK(report.chunks == 1 && report.loose.id != 0);
    CHECK_OK(firma_edit_finish(edit, &other));
    CHECK(hash_of(other) == hash_of(at_once));
    CHECK_OK(firma_chunks_release(report.loose));
    CHECK_OK(firma_edit_release(edit));
    CHECK_OK(firma_world_release(other));
    report.size = offsetof(firma_carve_report, loose);
    CHECK_OK(firma_carve(cut, blade, &kHere, &options, &other, &report));
    CHECK(report.chunks == 1 && firma_live_handles() == held + 2);
    CHECK_OK(firma_world_release(other));
    CHECK_OK(firma_world_release(at_once));
}

static void test_options(firma_world cut, firma_cutter blade) {
    firma_carve_options options = asking();
    firma_carve_report report = {.size = sizeof report};
    firma_world after = {0};
    options.min_chunk_volume = 7;
    CHECK_OK(firma_carve(cut, blade, &kHere, &options, &after, &report));
    CHECK(report.chunks == 0 && report.crumbs == 1 && report.crumb_volume == 6 && report.loose.id == 0);
    CHECK_OK(firma_world_release(after));
    options.min_chunk_volume = -1;
    CHECK_FAILS(firma_carve(cut, blade, &kHere, &options, &after, &report), FIRMA_ERROR_INVALID, "min_chunk_volume");
    options.min_chunk_volume = 0;
    options.density = INFINITY;
    CHECK_FAILS(firma_carve(cut, blade, &kHere, &options, &after, &report), FIRMA_ERROR_INVALID, "density");
    options.density = 0;
    options.chunks = 2;
    CHECK_FAILS(firma_carve(cut, blade, &kHere, &options, &after, &report), FIRMA_ERROR_INVALID, "chunks");
    options.chunks = 0;
    options.edit = 2; /* two edits made it */
    CHECK_OK(firma_carve(cut, blade, &kHere, &options, &after, &report));
    CHECK(report.status == FIRMA_CARVE_REFUSED);
    CHECK_OK(firma_world_release(after));
    options.edit = 90;
    firma_world_facts facts = {.size = sizeof facts};
    CHECK_OK(firma_carve(cut, blade, &kHere, &options, &after, &report));
    CHECK_OK(firma_world_get_facts(after, &facts));
    CHECK(facts.edits == 90);
    CHECK_OK(firma_world_release(after));
}

/* Plaster holds: nothing comes loose. */
static void test_anchors(firma_world cut, firma_cutter blade) {
    const firma_carve_options options = asking();
    const char* const names[] = {"plaster", "no such material"};
    firma_anchors anchors = {.size = sizeof anchors, .materials = names, .material_count = 2};
    firma_carve_report report = {.size = sizeof report};
    firma_world held = {0}, after = {0};
    CHECK_OK(firma_world_with_anchors(cut, &anchors, &held));
    CHECK(hash_of(held) == hash_of(cut));
    CHECK_OK(firma_carve(held, blade, &kHere, &options, &after, &report));
    CHECK(report.status == FIRMA_CARVE_DONE && report.chunks == 0 && report.crumbs == 0);
    CHECK_OK(firma_world_release(after));
    CHECK_OK(firma_world_release(held));
    CHECK_OK(firma_world_with_anchors(cut, NULL, &held));
    CHECK_OK(firma_carve(held, blade, &kHere, &options, &after, &report));
    CHECK(report.chunks == 1);
    CHECK_OK(firma_chunks_release(report.loose));
    CHECK_OK(firma_world_release(after));
    CHECK_OK(firma_world_release(held));
    const firma_box volumes[] = {{{0, 0, 80}, {1, 1, 81}}, {{-99, -99, -99}, {99, 99, 99}}};
    anchors = (firma_anchors){.size = sizeof anchors, .volumes = volumes};
    for (anchors.volume_count = 1; anchors.volume_count <= 2; ++anchors.volume_count) {
        CHECK_OK(firma_world_with_anchors(cut, &anchors, &held));
        CHECK_OK(firma_carve(held, blade, &kHere, &options, &after, &report));
        CHECK(report.chunks == 2 - anchors.volume_count);
        CHECK_OK(firma_chunks_release(report.loose));
        CHECK_OK(firma_world_release(after));
        CHECK_OK(firma_world_release(held));
    }
    anchors.volumes = NULL;
    CHECK_FAILS(firma_world_with_anchors(cut, &anchors, &held), FIRMA_ERROR_BAD_CALL, "array");
    anchors = (firma_anchors){.size = offsetof(firma_anchors, volumes), .volumes = NULL, .volume_count = 1};
    CHECK_OK(firma_world_with_anchors(cut, &anchors, &held)); /* a program of before */
    CHECK_OK(firma_world_release(held));
    anchors = (firma_anchors){.size = sizeof anchors};
    anchors.no_hanging = 2;
    CHECK_FAILS(firma_world_with_anchors(cut, &anchors, &held), FIRMA_ERROR_INVALID, "no_hanging");
    anchors.no_hanging = 1;
    anchors.source_count = 1;
    CHECK_FAILS(firma_world_with_anchors(cut, &anchors, &held), FIRMA_ERROR_BAD_CALL, "array");
    anchors.size = 0;
    CHECK_FAILS(firma_world_with_anchors(cut, &anchors, &held), FIRMA_ERROR_BAD_CALL, "size");
    CHECK_FAILS(firma_world_with_anchors(cut, NULL, NULL), FIRMA_ERROR_BAD_CALL, "null");
}

static void test_mass(firma_world bridge) {
    firma_mass mass = {.volume = 1};
    CHECK_OK(firma_world_mass(bridge, 1, &mass));
    CHECK(mass.volume == 0 && mass.mass == 0); /* rock that reaches to infinity */
    CHECK_FAILS(firma_world_mass(bridge, -1, &mass), FIRMA_ERROR_OUT_OF_RANGE, "density");
    CHECK_FAILS(firma_world_mass(bridge, 1, NULL), FIRMA_ERROR_BAD_CALL, "null");
}

void test_chunks(void) {
    const firma_world bridge = make_bridge();
    const firma_world cut = cut_one_end(bridge);
    const firma_cutter blade = make_box(7, 2, 1, 7.5, 6, 3);
    test_loose(cut, blade);
    test_other_ways(cut, blade);
    test_options(cut, blade);
    test_anchors(cut, blade);
    test_mass(bridge);
    CHECK_OK(firma_cutter_release(blade));
    CHECK_OK(firma_world_release(cut));
    CHECK_OK(firma_world_release(bridge));
}
