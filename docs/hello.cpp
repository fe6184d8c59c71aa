// SPDX-License-Identifier: MIT
// The program of docs/hello.md: reads a level, moves a sphere through it, says what it met.
#include <cstdio>

#include "firma/firma.h"

int main() {
    firma::Result<firma::Level> level = firma::read_level("levels/first.obj");
    if (!level) return std::puts(level.error().text().c_str()), 1;
    firma::Result<firma::World> made = firma::make_world(level.value());
    if (!made) return std::puts(made.error().text().c_str()), 1;
    const firma::World& world = made.value();

    const firma::Sphere ball{.centre = {35, 29, 2}, .radius = 0.5};  // in the hall, under the bridge
    const firma::Vec3 path{0, 0, 10};                                // straight up
    const firma::Hit hit = firma::cast(world, ball, path);
    if (!hit.touched()) return std::puts("nothing in the way"), 0;
    const firma::Vec3 stop = ball.centre + path * hit.safe_fraction;  // a millimetre short of it
    std::printf("met %s after %.3f of the path; stops at z = %.3f\n", world.material_name(hit.material).c_str(),
                hit.fraction, stop.z);
}
