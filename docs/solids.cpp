// SPDX-License-Identifier: MIT
// The program of docs/solids.md: a level's rock without a world, two cuts in either order, and where two solids differ.
#include <cstdio>

#include "firma/level.h"
#include "firma/solid.h"

int main() {
    const firma::Result<firma::Level> level = firma::read_level("levels/first.obj");
    if (!level) return std::puts(level.error().text().c_str()), 1;
    const firma::Solid rock = firma::make_solid(level.value()).value();
    std::printf("%zu faces bound %.2f cubic metres of air\n", rock.face_count(), -firma::measure_solid(rock).volume);

    // Two craters that do not meet: the same solid in either order.
    const firma::Cutter crater = firma::make_crater(firma::CutterShape::kRocky, 1);
    const firma::Pose hall{.position = {35, 29, 0.2}, .scale = 1.6}, corner{.position = {20, 20, 0}, .scale = 1};
    const firma::SolidResult first = firma::subtract(rock, crater, hall);
    if (!first.done()) return std::puts(first.error.text().c_str()), 1;
    const firma::Solid one = firma::subtract(first.solid, crater, corner).solid;
    const firma::Solid other = firma::subtract(firma::subtract(rock, crater, corner).solid, crater, hall).solid;
    std::printf("%.2f cubic metres less; in either order the same: %s\n", first.report.volume,
                firma::hash_solid(one) == firma::hash_solid(other) ? "yes" : "no");
    std::printf("2 m below the hall's floor is rock: %s\n",
                firma::locate(one, {35, 29, -2}) == firma::Where::kSolid ? "yes" : "no");

    // Where do two solids differ? Cubes of 32 m, by their hashes.
    const std::vector<firma::RegionHash> before = firma::hash_regions(rock), after = firma::hash_regions(first.solid);
    for (std::size_t k = 0; k < before.size() && before.size() == after.size(); ++k)
        if (!(before[k] == after[k]))
            std::printf("they differ from (%d, %d, %d) m on\n", 32 * before[k].region.x, 32 * before[k].region.y,
                        32 * before[k].region.z);
}
