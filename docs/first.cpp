// SPDX-License-Identifier: MIT
// The program of README.md: a sphere meets a bridge, and a crater is carved there.
#include <cstdio>

#include "firma/firma.h"

int main() {
    const firma::Result<firma::Level> level = firma::read_level("levels/first.obj");
    if (!level) return std::puts(level.error().text().c_str()), 1;
    const firma::World world = firma::make_world(level.value()).value();
    const firma::Hit hit = firma::cast(world, {.centre = {35, 29, 2}, .radius = 0.5}, {0, 0, 10});
    const firma::Cutter crater = firma::make_crater(firma::CutterShape::kRocky, 1);
    const firma::CarveResult blast = firma::carve(world, crater, {.position = hit.point, .scale = 0.5});
    std::printf("met %s after %.3f m, carved %.3f m3\n", world.material_name(hit.material).c_str(), 10 * hit.fraction,
                blast.report.volume);
}
