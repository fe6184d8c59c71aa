/* SPDX-License-Identifier: MIT */
/* The program of docs/hello.md in C: reads a level, moves a sphere through it, says what it met. */
#include <stdio.h>

#include "firma/firma_c.h"

int main(void) {
    firma_world world = {0};
    if (firma_world_load("levels/first.obj", NULL, &world) != FIRMA_OK) return puts(firma_error_message()), 1;

    const firma_cast_input ball = {{35, 29, 2}, 0.5, {0, 0, 10}}; /* centre, radius, path */
    firma_hit hit = {0};
    firma_cast(world, &ball, NULL, &hit, NULL);
    if (hit.status == FIRMA_MISS) return puts("nothing in the way"), 0;
    const double stop = ball.centre[2] + ball.path[2] * hit.safe_fraction;
    const char* material = "";
    firma_world_material(world, hit.material, &material);
    printf("met %s after %.3f of the path; stops at z = %.3f\n", material, hit.fraction, stop);
    firma_world_release(world);
}
