// SPDX-License-Identifier: MIT
// The program of docs/matter.md: what the depot is made of, a crater where two matters meet, a table of a game's own.
#include <cstdio>
#include <map>
#include <string>

#include "firma/firma.h"

/// How many square metres edits left of each material.
void tell_insides(const firma::World& world) {
    std::map<std::string, double> area;
    for (const firma::Face& face : world.faces()) {
        if (face.source_edit == 0) continue;
        firma::Vec3 sum;
        for (std::size_t k = 2; k < face.corners.size(); ++k)
            sum = sum + cross(face.corners[k - 1] - face.corners[0], face.corners[k] - face.corners[0]);
        area[world.material_name(face.material)] += 0.5 * length(sum);
    }
    for (const auto& [material, metres] : area) std::printf("  %s: %.1f m2\n", material.c_str(), metres);
}

int main() {
    // A brick wall on a floor of wood, both in rock.
    const char* map = R"({
"classname" "worldspawn"
{
( 0 0 0 ) ( 0 1 0 ) ( 0 0 1 ) old_brick 0 0 0 1 1
( 8 0 0 ) ( 8 0 1 ) ( 8 1 0 ) old_brick 0 0 0 1 1
( 0 0 0 ) ( 0 0 1 ) ( 1 0 0 ) old_brick 0 0 0 1 1
( 0 1 0 ) ( 1 1 0 ) ( 0 1 1 ) old_brick 0 0 0 1 1
( 0 0 0 ) ( 1 0 0 ) ( 0 1 0 ) old_brick 0 0 0 1 1
( 0 0 4 ) ( 0 1 4 ) ( 1 0 4 ) old_brick 0 0 0 1 1
}
{
( 0 -8 0 ) ( 0 1 0 ) ( 0 0 1 ) planks 0 0 0 1 1
( 8 -8 0 ) ( 8 0 1 ) ( 8 1 0 ) planks 0 0 0 1 1
( 0 -8 0 ) ( 0 -8 1 ) ( 1 -8 0 ) planks 0 0 0 1 1
( 0 8 0 ) ( 1 8 0 ) ( 0 8 1 ) planks 0 0 0 1 1
( 0 0 -2 ) ( 1 0 -2 ) ( 0 1 -2 ) planks 0 0 0 1 1
( 0 0 0 ) ( 0 1 0 ) ( 1 0 0 ) planks 0 0 0 1 1
}
}
)";
    const firma::BrushLevel level = firma::read_map(map, "wall.map", {.scale = 1}).value();
    const firma::World world = firma::make_world(level).value();
    const firma::Matter& wall = matter(world, matter_at(world, {4, 0.5, 2}));
    std::printf("the wall: %s, %.0f kg/m3\n", wall.name.c_str(), wall.density);

    // At the foot of the wall: brick above, wood below.
    const firma::Cutter crater = firma::make_crater(firma::CutterShape::kRocky, 3);
    const firma::Pose foot{.position = {4, 0, 0}, .scale = 1.5};
    std::puts("at its foot:");
    tell_insides(carve(world, crater, foot).world);

    // The game's own table: this brick may not be carved, so the crater is cut short at it.
    const firma::Result<firma::MatterTable> table = firma::read_matters(
        "matter vault brick\n  texture *brick*\n  hardness 1\nmatter oak\n  texture planks\n  inside oak/split\n",
        "game.matter");
    if (!table) return std::puts(table.error().text().c_str()), 1;
    firma::WorldOptions options;
    options.matters = table.value();
    const firma::World vault = firma::make_world(level, options).value();
    std::puts("of a vault:");
    const firma::CarveResult cut = carve(vault, crater, foot);
    tell_insides(cut.world);
    std::printf("cut short by %zu piece\n", cut.report.cut_short);
    const firma::Pose middle{.position = {4, 0.5, 2}, .scale = 0.3};
    std::puts(carve(vault, crater, middle).error.text().c_str());
}
