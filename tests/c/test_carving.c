/* SPDX-License-Identifier: MIT */
/* Craters at once, in slices, several as one version; rules; differences. */
#include <math.h>

#include "tests/c/check.h"

static const firma_pose kInFloor = {{4, 4, 0}, {0, 0, 0, 1}, 1.5};

static void test_cutters(void) {
    firma_cutter cutter = {0};
    CHECK_FAILS(firma_cutter_crater(5, 1, &cutter), FIRMA_ERROR_INVALID, "no shape 5");
    const double positions[] = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1};
    const uint32_t closed[] = {0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3};
    CHECK_FAILS(firma_cutter_from_mesh(positions, 4, closed, 3, "lid", &cutter), FIRMA_ERROR_MALFORMED, "lid");
    CHECK_FAILS(firma_cutter_from_mesh(NULL, 4, closed, 4, NULL, &cutter), FIRMA_ERROR_BAD_CALL, "null");
    CHECK_OK(firma_cutter_from_mesh(positions, 4, closed, 4, NULL, &cutter));
    CHECK_OK(firma_cutter_release(cutter));
    const char obj[] = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n";
    CHECK_OK(firma_cutter_from_obj(obj, sizeof obj - 1, "t.obj", &cutter));
    CHECK_OK(firma_cutter_release(cutter));
    CHECK_FAILS(firma_cutter_from_obj("f 1 2 3\n", 8, "f.obj", &cutter), FIRMA_ERROR_OUT_OF_RANGE, "f.obj:1");
    CHECK_FAILS(firma_cutter_release(cutter), FIRMA_ERROR_BAD_HANDLE, "cutter");
}

/* What a cut took, taken out and put back. */
static void test_solid_cutters(firma_world room, firma_cutter crater) {
    firma_cutter cutter = {0};
    firma_world block = {0}, after = {0}, chunk = {0}, again = {0};
    const firma_pose here = {{0, 0, 0}, {0, 0, 0, 1}, 1};
    const firma_pose on_top = {{2, 2, 2}, {0, 0, 0, 1}, 0.5};
    CHECK_FAILS(firma_cutter_from_world(room, "rock", &cutter), FIRMA_ERROR_INVALID, "reaches to infinity");
    CHECK_FAILS(firma_cutter_from_world(chunk, NULL, &cutter), FIRMA_ERROR_BAD_HANDLE, "no world");
    CHECK_FAILS(firma_cutter_from_world(room, NULL, NULL), FIRMA_ERROR_BAD_CALL, "null");
    const char obj[] =
        "v 0 0 0\nv 2 0 0\nv 2 2 0\nv 0 2 0\nv 0 0 2\nv 2 0 2\nv 2 2 2\nv 0 2 2\n"
        "f 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n";
    CHECK_OK(firma_world_from_obj(obj, sizeof obj - 1, "block", NULL, &block));
    firma_carve_report report = {.size = sizeof report};
    CHECK_OK(firma_carve(block, crater, &on_top, NULL, &after, &report));
    CHECK(report.status == FIRMA_CARVE_DONE && report.volume > 0);
    const double taken = report.volume;
    CHECK_OK(firma_cutter_from_world(after, "rest", &cutter));
    CHECK_OK(firma_carve(block, cutter, &here, NULL, &chunk, NULL));
    CHECK_OK(firma_cutter_release(cutter));
    double volume = 0;
    CHECK_OK(firma_world_measure(chunk, &volume, NULL));
    CHECK(fabs(volume - taken) < 1e-9);
    CHECK_OK(firma_cutter_from_world(chunk, "chunk", &cutter));
    firma_carve_options fill = {.size = sizeof fill, .fill = 1};
    CHECK_OK(firma_carve(after, cutter, &here, &fill, &again, &report));
    uint32_t same = 0;
    CHECK_OK(firma_world_same_solid(again, block, &same));
    CHECK(report.status == FIRMA_CARVE_DONE && same == 1);
    CHECK_OK(firma_cutter_release(cutter));
    CHECK_OK(firma_world_release(again));
    CHECK_OK(firma_world_release(chunk));
    CHECK_OK(firma_world_release(after));
    CHECK_OK(firma_world_release(block));
}

static void test_cut(firma_world room, firma_cutter cutter) {
    firma_world after = {0};
    firma_carve_report report = {.size = sizeof report};
    double before_volume = 0, after_volume = 0;
    CHECK_OK(firma_carve(room, cutter, &kInFloor, NULL, &after, &report));
    CHECK(report.status == FIRMA_CARVE_DONE && report.volume > 1 && report.faces_added > 20 &&
          report.faces_removed == 1);
    CHECK_OK(firma_world_check(after));
    CHECK_OK(firma_world_measure(room, &before_volume, NULL));
    CHECK_OK(firma_world_measure(after, &after_volume, NULL));
    CHECK(fabs(before_volume - after_volume - report.volume) < 1e-9);

    /* What changed. */
    firma_diff diff = {0};
    firma_diff_view view = {.size = sizeof view};
    CHECK_OK(firma_world_diff(room, after, 1, &diff));
    CHECK_OK(firma_diff_get_view(diff, &view));
    CHECK(view.removed_count == 1 && view.removed[0] == 0 && view.added_count == report.faces_added &&
          view.tile_count > 0);
    const firma_face* const removed = view.removed_faces;
    CHECK(removed[0].id == 0 && removed[0].room == 0 && removed[0].source == 0 && removed[0].source_edit == 0);
    CHECK(removed[0].normal[2] == 1 && removed[0].flags == FIRMA_FACE_SOLID && removed[0].corner_count == 0);
    firma_faces outline = {0};
    firma_faces_view shown = {.size = sizeof shown};
    CHECK_OK(firma_world_face(room, removed[0].id, removed[0].corner, &outline));
    CHECK_OK(firma_faces_get_view(outline, &shown));
    CHECK(shown.face_count == 1 && shown.corner_count == 4);
    CHECK_OK(firma_faces_release(outline));
    CHECK(view.added[0].first_corner == 0 && view.corner_count >= 3 * view.added_count && view.low[2] < -1);
    CHECK_OK(firma_diff_release(diff));
    CHECK_FAILS(firma_world_diff(room, after, 0.001, &diff), FIRMA_ERROR_INVALID, "tile");

    /* Filling what was cut; nothing to cut in the air; a pose that is none. */
    firma_carve_options options = {.size = sizeof options, .fill = 1, .material = "plaster"};
    firma_world filled = {0};
    CHECK_OK(firma_carve(after, cutter, &kInFloor, &options, &filled, &report));
    CHECK(report.status == FIRMA_CARVE_DONE && report.volume < 0);
    CHECK_OK(firma_world_release(filled));
    const firma_pose in_air = {{4, 4, 2}, {0, 0, 0, 1}, 0.5};
    firma_world same = {0};
    CHECK_OK(firma_carve(room, cutter, &in_air, NULL, &same, &report));
    CHECK(report.status == FIRMA_CARVE_NOTHING && hash_of(same) == hash_of(room));
    CHECK(report.faces_castable_only == 0);
    CHECK_OK(firma_world_release(same));
    const firma_pose nowhere = {{NAN, 4, 2}, {0, 0, 0, 1}, 0.5};
    CHECK_OK(firma_carve(room, cutter, &nowhere, NULL, &same, &report));
    CHECK(report.status == FIRMA_CARVE_REFUSED && strstr(firma_error_message(), "finite"));
    CHECK(hash_of(same) == hash_of(room));
    CHECK_OK(firma_world_release(same));
    options.has_from = 2;
    CHECK_FAILS(firma_carve(room, cutter, &kInFloor, &options, &same, NULL), FIRMA_ERROR_INVALID, "has_from");
    options.has_from = 1;
    options.from[1] = INFINITY;
    CHECK_FAILS(firma_carve(room, cutter, &kInFloor, &options, &same, NULL), FIRMA_ERROR_INVALID, "from");
    options.has_from = 0;
    options.fill = 2;
    CHECK_FAILS(firma_carve(room, cutter, &kInFloor, &options, &same, NULL), FIRMA_ERROR_INVALID, "fill");
    CHECK_FAILS(firma_carve(room, cutter, NULL, NULL, &same, NULL), FIRMA_ERROR_BAD_CALL, "null");
    CHECK_OK(firma_world_release(after));
}

/* A sheet without a back is castable only: cut into, it gets a hole; filled over, it stays. */
static void test_castable_only(firma_cutter cutter) {
    const char obj[] = "v 0 0 0\nv 8 0 0\nv 8 8 0\nv 0 8 0\nf 1 2 3 4\n";
    firma_world sheet = {0}, after = {0};
    firma_carve_report report = {.size = sizeof report};
    CHECK_OK(firma_world_from_obj(obj, sizeof obj - 1, "sheet.obj", NULL, &sheet));
    CHECK_OK(firma_carve(sheet, cutter, &kInFloor, NULL, &after, &report));
    CHECK(report.status == FIRMA_CARVE_DONE && report.faces_castable_only == 0 && report.volume == 0);
    CHECK(report.open_trimmed == 1 && report.open_removed == 0 && report.panes == 0 && report.clips == 0);
    CHECK(report.faces_removed == 1 && report.faces_added > 3);
    CHECK(hash_of(after) != hash_of(sheet));
    CHECK_OK(firma_world_release(after));
    /* By rules that let such faces be. */
    firma_rules rules = {.size = sizeof rules, .no_open_faces = 1};
    firma_world kept = {0};
    CHECK_OK(firma_world_with_rules(sheet, &rules, &kept));
    CHECK_OK(firma_carve(kept, cutter, &kInFloor, NULL, &after, &report));
    CHECK(report.status == FIRMA_CARVE_NOTHING && report.faces_castable_only == 1 && hash_of(after) == hash_of(kept));
    CHECK_OK(firma_world_release(after));
    CHECK_OK(firma_world_release(kept));
    rules.no_open_faces = 2;
    CHECK_FAILS(firma_world_with_rules(sheet, &rules, &kept), FIRMA_ERROR_INVALID, "no_open_faces");
    rules.no_open_faces = 0;
    rules.reserved2 = 1;
    CHECK_FAILS(firma_world_with_rules(sheet, &rules, &kept), FIRMA_ERROR_INVALID, "reserved");
    rules.reserved2 = 0;
    rules.size = offsetof(firma_rules, no_open_faces); /* a program of before */
    rules.no_open_faces = 1;
    CHECK_OK(firma_world_with_rules(sheet, &rules, &kept));
    CHECK_OK(firma_carve(kept, cutter, &kInFloor, NULL, &after, &report));
    CHECK(report.status == FIRMA_CARVE_DONE && report.open_trimmed == 1);
    CHECK_OK(firma_world_release(after));
    CHECK_OK(firma_world_release(kept));
    const firma_carve_options fills = {.size = sizeof fills, .fill = 1};
    CHECK_OK(firma_carve(sheet, cutter, &kInFloor, &fills, &after, &report));
    CHECK(report.faces_castable_only == 1 && report.open_trimmed == 0);
    CHECK_OK(firma_world_release(after));
    CHECK_OK(firma_world_release(sheet));
}

static void test_job(firma_world room, firma_cutter cutter) {
    firma_world at_once = {0}, in_slices = {0};
    CHECK_OK(firma_carve(room, cutter, &kInFloor, NULL, &at_once, NULL));
    firma_job job = {0};
    uint32_t finished = 0;
    int runs = 0;
    CHECK_OK(firma_job_start(room, cutter, &kInFloor, NULL, &job));
    CHECK_FAILS(firma_job_result(job, &in_slices, NULL), FIRMA_ERROR_BAD_CALL, "not finished");
    CHECK_FAILS(firma_job_run(job, NAN, &finished), FIRMA_ERROR_INVALID, "time");
    for (; !finished; ++runs) CHECK_OK(firma_job_run(job, 0, &finished));
    CHECK(runs > 5);
    firma_carve_report report = {.size = sizeof report};
    CHECK_OK(firma_job_result(job, &in_slices, &report));
    CHECK(report.status == FIRMA_CARVE_DONE && hash_of(at_once) == hash_of(in_slices));
    uint32_t same = 9;
    CHECK_OK(firma_world_same_solid(at_once, in_slices, &same));
    CHECK(same == 1);
    CHECK_OK(firma_world_same_solid(at_once, room, &same));
    CHECK(same == 0);
    CHECK_OK(firma_job_release(job));
    CHECK_OK(firma_world_release(in_slices));
    CHECK_OK(firma_world_release(at_once));
    CHECK_OK(firma_job_start(room, cutter, &kInFloor, NULL, &job));
    CHECK_OK(firma_job_release(job)); /* dropped half-way */
}

static void test_edit(firma_world room, firma_cutter cutter) {
    firma_edit edit = {0};
    firma_carve_report report = {.size = sizeof report};
    firma_pose pose = kInFloor;
    CHECK_OK(firma_edit_begin(room, &edit));
    for (int k = 0; k < 3; ++k) {
        pose.position[0] = 2 + 2 * k;
        firma_random_turn((uint64_t)k, pose.rotation);
        CHECK_OK(firma_edit_carve(edit, cutter, &pose, NULL, &report));
        CHECK(report.status == FIRMA_CARVE_DONE);
    }
    firma_world after = {0};
    firma_world_facts facts = {.size = sizeof facts};
    CHECK_OK(firma_edit_finish(edit, &after));
    CHECK_OK(firma_world_get_facts(after, &facts));
    CHECK(facts.version == 1 && facts.edits == 3);
    CHECK_OK(firma_edit_release(edit));
    CHECK_OK(firma_world_release(after));
}

static void test_rules(firma_world room, firma_cutter cutter) {
    const firma_zone zone = {"vault", {2, 2, -2}, {6, 6, 2}, 1};
    firma_rules rules = {0};
    firma_world guarded = {0}, after = {0};
    CHECK_FAILS(firma_world_with_rules(room, &rules, &guarded), FIRMA_ERROR_BAD_CALL, "size");
    rules.size = sizeof rules;
    /* Finding 12 (F12). */
    rules.reserved = 1;
    CHECK_FAILS(firma_world_with_rules(room, &rules, &guarded), FIRMA_ERROR_INVALID, "reserved");
    rules.reserved = 0;
    rules.zone_count = 1;
    CHECK_FAILS(firma_world_with_rules(room, &rules, &guarded), FIRMA_ERROR_BAD_CALL, "array");
    rules.zones = &zone;
    CHECK_OK(firma_world_with_rules(room, &rules, &guarded));
    firma_carve_report report = {.size = sizeof report};
    CHECK_OK(firma_carve(guarded, cutter, &kInFloor, NULL, &after, &report));
    CHECK(report.status == FIRMA_CARVE_REFUSED && strstr(firma_error_message(), "zone vault"));
    CHECK_OK(firma_world_release(after));
    CHECK_OK(firma_world_release(guarded));
    const double hard[] = {0, 2};
    rules.hardness = hard;
    rules.hardness_count = 2;
    CHECK_FAILS(firma_world_with_rules(room, &rules, &guarded), FIRMA_ERROR_INVALID, "material 1");
}

void test_carving(void) {
    const firma_world room = make_room();
    firma_cutter cutter = {0};
    CHECK_OK(firma_cutter_crater(FIRMA_ROCKY, 7, &cutter));
    test_cutters();
    test_solid_cutters(room, cutter);
    test_cut(room, cutter);
    test_castable_only(cutter);
    test_job(room, cutter);
    test_edit(room, cutter);
    test_rules(room, cutter);
    CHECK_OK(firma_cutter_release(cutter));
    CHECK_OK(firma_world_release(room));
}
