/* SPDX-License-Identifier: MIT */
/* The program of README.md in C: a sphere meets a bridge, and a crater is carved there. */
#include <stdio.h>

#include "firma/firma_c.h"

int main(void) {
    firma_world world = {0}, after = {0};
    if (firma_world_load("levels/first.obj", NULL, &world) != FIRMA_OK) return puts(firma_error_message()), 1;
    firma_hit hit;
    firma_cast(world, &(firma_cast_input){{35, 29, 2}, 0.5, {0, 0, 10}}, NULL, &hit, NULL);
    firma_cutter crater = {0};
    firma_cutter_crater(FIRMA_ROCKY, 1, &crater);
    const firma_pose pose = {{hit.point[0], hit.point[1], hit.point[2]}, {0, 0, 0, 1}, 0.5};
    firma_carve_report report = {.size = sizeof report};
    firma_carve(world, crater, &pose, NULL, &after, &report);
    const char* material = "";
    firma_world_material(world, hit.material, &material);
    printf("met %s after %.3f m, carved %.3f m3\n", material, 10 * hit.fraction, report.volume);
}
