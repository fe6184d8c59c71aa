// SPDX-License-Identifier: MIT
// A program of a user's: casts a ball through a level, makes a crater where it stops, saves and loads what came of it,
// and prints what all programs of this folder must print alike.
#include <cinttypes>
#include <cstdio>

#include "firma/firma.h"

int main(int argc, char** argv) {
    if (argc != 3) return std::puts("usage: crater LEVEL.obj SAVED.firma"), 2;
    firma::Result<firma::Level> level = firma::read_level(argv[1]);
    if (!level) return std::puts(level.error().text().c_str()), 1;
    firma::Result<firma::World> made = firma::make_world(level.value());
    if (!made) return std::puts(made.error().text().c_str()), 1;
    const firma::World& world = made.value();
    const firma::Hit hit = firma::cast(world, {.centre = {35, 29, 2}, .radius = 0.5}, {0, 0, 10});
    const firma::CarveResult cut =
        firma::carve(world, firma::make_crater(firma::CutterShape::kRocky, 1), {.position = hit.point, .scale = 1.5});
    if (!cut.done()) return std::puts(cut.error.text().c_str()), 1;
    const firma::Result<firma::FirmaWritten> saved = firma::save_world(cut.world, argv[2]);
    if (!saved) return std::puts(saved.error().text().c_str()), 1;
    const firma::Result<firma::World> loaded = firma::load_world(argv[2]);
    if (!loaded) return std::puts(loaded.error().text().c_str()), 1;
    std::printf("met %s after %.17g, hash %016" PRIx64 "\n", world.material_name(hit.material).c_str(), hit.fraction,
                firma::hash_world(loaded.value()));
}
