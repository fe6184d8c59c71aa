// SPDX-License-Identifier: MIT
// The program of docs/carving.md: a crater, what changed, a refusal, and the level as it is now.
#include <cstdio>

#include "firma/firma.h"

int main() {
    firma::Result<firma::Level> level = firma::read_level("levels/first.obj");
    if (!level) return std::puts(level.error().text().c_str()), 1;
    const firma::World before = firma::make_world(level.value()).value();

    // A rocky crater of about 1.6 m in the floor of the hall. The same seed makes the same shape on every machine.
    const firma::Cutter crater = firma::make_crater(firma::CutterShape::kRocky, 1);
    const firma::Pose floor{.position = {35, 29, 0.2}, .rotation = firma::random_turn(1), .scale = 1.6};
    const firma::CarveResult blast = firma::carve(before, crater, floor, {.material = "rubble"});
    if (!blast.done()) return std::puts(blast.error.text().c_str()), 1;
    const firma::World after = blast.world;  // `before` is still there, and answers as it did

    const firma::Sphere ball{.centre = {35, 29, 2}, .radius = 0.25};
    for (const firma::World& world : {before, after}) {
        const firma::Hit hit = firma::cast(world, ball, {0, 0, -10});
        std::printf("version %llu: the ball falls %.2f m, onto %s\n", static_cast<unsigned long long>(world.version()),
                    10 * hit.fraction, world.material_name(hit.material).c_str());
    }

    const firma::WorldDiff diff = firma::diff_worlds(before, after, 4.0);
    std::printf("%zu faces removed, %zu added, in %zu tiles of 4 m; %.2f cubic metres less\n", diff.removed.size(),
                diff.added.size(), diff.tiles.size(), blast.report.volume);

    // From here on the hall's west end may not be touched.
    firma::CarveRules rules;
    rules.zones.push_back({.name = "west end", .box = {{18, 18, -2}, {26, 40, 12}}, .hardness = 1});
    firma::Pose west = floor;
    west.position = {21, 29, 0};
    std::puts(firma::carve(firma::with_rules(after, rules).value(), crater, west).error.text().c_str());

    const firma::Result<firma::ObjWritten> written = firma::write_obj(after, "build/after.obj");
    if (!written) return std::puts(written.error().text().c_str()), 1;
    std::printf("build/after.obj: %zu faces\n", written.value().faces);
}
