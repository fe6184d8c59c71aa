/* SPDX-License-Identifier: MIT */
/* crater.cpp in C. */
#include <inttypes.h>
#include <stdio.h>

#include "firma/firma_c.h"

static int fail(void) {
    puts(firma_error_message());
    return 1;
}

int main(int argc, char** argv) {
    if (argc != 3) return puts("usage: crater LEVEL.obj SAVED.firma"), 2;
    firma_world world = {0}, after = {0}, loaded = {0};
    if (firma_world_load(argv[1], NULL, &world) != FIRMA_OK) return fail();

    const firma_cast_input ball = {{35, 29, 2}, 0.5, {0, 0, 10}};
    firma_hit hit = {0};
    if (firma_cast(world, &ball, NULL, &hit, NULL) != FIRMA_OK) return fail();
    const char* material = "";
    if (firma_world_material(world, hit.material, &material) != FIRMA_OK) return fail();

    firma_cutter cutter = {0};
    if (firma_cutter_crater(FIRMA_ROCKY, 1, &cutter) != FIRMA_OK) return fail();
    const firma_pose pose = {{hit.point[0], hit.point[1], hit.point[2]}, {0, 0, 0, 1}, 1.5};
    firma_carve_report report = {.size = sizeof report};
    if (firma_carve(world, cutter, &pose, NULL, &after, &report) != FIRMA_OK) return fail();
    if (report.status != FIRMA_CARVE_DONE) return fail();

    uint64_t hash = 0;
    if (firma_world_save(after, argv[2], 1) != FIRMA_OK) return fail();
    if (firma_world_load(argv[2], NULL, &loaded) != FIRMA_OK) return fail();
    if (firma_world_hash(loaded, &hash) != FIRMA_OK) return fail();
    printf("met %s after %.17g, hash %016" PRIx64 "\n", material, hit.fraction, hash);
    firma_world_release(loaded);
    firma_world_release(after);
    firma_cutter_release(cutter);
    firma_world_release(world);
    return firma_live_handles() == 0 ? 0 : 1;
}
