// SPDX-License-Identifier: MIT
// The program of docs/chunks.md: a bridge shot at both ends falls, breaks, and becomes ground.
#include <cstdio>

#include "firma/firma.h"

int main() {
    const firma::Result<firma::World> read = firma::read_world("levels/first.obj");
    if (!read) return std::puts(read.error().text().c_str()), 1;
    firma::World world = firma::with_anchors(read.value());  // once: what hangs free now stays

    // The bridge across the hall is 24 m long, 4 m wide and half a metre thick.
    const firma::Cutter blast = firma::make_crater(firma::CutterShape::kRocky, 1);
    firma::CarveOptions options;
    options.chunks = firma::ChunkOptions{.min_volume = 0.01, .density = 2400};
    firma::CarveResult shot = firma::carve(world, blast, {.position = {22, 29, 4.75}, .scale = 3}, options);
    std::printf("shot at one end: %zu loose\n", shot.chunks.size());
    shot = firma::carve(shot.world, blast, {.position = {42, 29, 4.75}, .scale = 3}, options);
    if (shot.chunks.empty()) return std::puts("nothing came loose"), 1;
    world = shot.world;
    const firma::Chunk& bridge = shot.chunks[0];
    std::printf("at the other: %.2f m3, %.0f kg, around (%.2f, %.2f, %.2f) m; %zu faces were searched\n",
                bridge.mass.volume, bridge.mass.mass, bridge.origin.x + bridge.mass.centre.x,
                bridge.origin.y + bridge.mass.centre.y, bridge.origin.z + bridge.mass.centre.z,
                shot.report.faces_searched);
    std::printf("it turns about x, y, z by %.0f, %.0f, %.0f kg m2\n", bridge.mass.inertia[0].x,
                bridge.mass.inertia[1].y, bridge.mass.inertia[2].z);

    // A body now: it is cut in its own frame, into two.
    const firma::Vec3 middle = firma::Vec3{32, 29, 4.75} - bridge.origin;
    const firma::SolidResult broken = firma::subtract(bridge.solid, blast, {.position = middle, .scale = 3});
    const std::vector<firma::Solid> parts = firma::connected_pieces(broken.solid);
    std::printf("broken in the middle: %zu parts\n", parts.size());

    // Where the first comes to rest, turned by some angle, it becomes ground.
    firma::Pose rest;
    rest.position = {30, 29, 0.45};
    rest.rotation = {0.002, 0.003, 0.3, 0.95};
    const firma::Result<firma::RestingSolid> ground = firma::resting_solid(parts[0], rest, "bridge");
    if (!ground) return std::puts(ground.error().text().c_str()), 1;
    const firma::CarveResult put = firma::fill(world, ground.value().cutter, ground.value().pose);
    if (!put.done()) return std::puts(put.error.text().c_str()), 1;
    std::printf("%.2f m3 of ground more; snapping changed the part by %.1e m3\n", -put.report.volume,
                ground.value().volume_change);
    std::printf("sound: %s\n", firma::check_world(put.world) || firma::check_solid(put.world) ? "no" : "yes");
}
