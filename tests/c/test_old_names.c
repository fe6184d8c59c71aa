/* SPDX-License-Identifier: MIT */
/* A program of version 0.1 as to its names: of members, too. */
#define FIRMA_NAMES_0_1
#include "tests/c/check.h"

void test_old_names(void) {
    firma_world_options options;
    firma_world_options_defaults(&options);
    CHECK(options.skin == 0.001 && options.faces_per_bin == 4 && options.min_bin_volume == 0);
    firma_cast_options cast_options;
    firma_cast_options_defaults(&cast_options);
    CHECK(cast_options.skin == -1);
    firma_rules rules = {.size = sizeof rules, .most_faces = 1, .most_faces_looked_at = 2};
    rules.most_new_faces = rules.most_cutter_triangles = rules.most_pairs = rules.most_corners = 3;
    rules.largest_cutter = 4;
    firma_cast_counts counts = {.bins = 5};
    firma_carve_report report = {.size = sizeof report, .faces_looked_at = 6, .faces_gone = 7, .faces_new = 8};
    firma_diff_view diff = {.size = sizeof diff, .gone_count = 9, .come_count = 10};
    CHECK(diff.gone == NULL && diff.come == NULL && counts.bins + report.faces_gone + rules.most_corners == 15);
    firma_room info = {.size = sizeof info, .part_of = 11};
    CHECK(info.merged_into == 11);
    CHECK(FIRMA_TOUCHING == 2 && FIRMA_ROOM == 0 && FIRMA_UNSURE == 3);

    const firma_world room = make_room();
    firma_world_facts facts = {.size = sizeof facts};
    CHECK_OK(firma_world_get_facts(room, &facts));
    CHECK(facts.skin == 0.001);
    CHECK_OK(firma_world_room(room, 0, &info));
    CHECK(info.part_of == 0);
    CHECK_OK(firma_world_release(room));
}
