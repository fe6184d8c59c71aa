// SPDX-License-Identifier: MIT
// A world's bounds, rooms, solid and tree, for programs and for people.
#include "cli/describe_world.h"

#include <fmt/format.h>

#include <cmath>

#include "cli/numbers.h"
#include "firma/solid.h"

namespace firma::cli {

void add_world(JsonWriter& json, const World& world) {
    if (const Box bounds = world.bounds(); bounds.empty()) {
        json.add_null("bounds");
    } else {
        json.open_object("bounds");
        json.add("low", bounds.low);
        json.add("high", bounds.high);
        json.close();
    }
    json.add("rooms", world.room_count());
    const TreeStatistics tree = world.statistics();
    json.open_object("tree");
    json.add("faces", tree.faces);
    json.add("blocks", tree.blocks);
    json.add("bins", tree.bins);
    json.add("leaf_bins", tree.leaf_bins);
    json.add("depth", tree.depth);
    json.add("largest_bin", tree.largest_bin);
    json.add("overlap", tree.overlap);
    json.add("bytes", tree.bytes);
    json.add("bytes_per_face", tree.bytes_per_face());
    json.close();
    const SolidMeasures solid = measure_solid(world);
    json.open_object("solid");
    json.add("faces", solid.facets);
    json.add("volume", solid.volume);
    json.add("area", solid.area);
    json.close();
}

std::string info_row(const char* what, const std::string& value) {
    return fmt::format("{:<16}{}\n", what, value);
}

std::string world_text(const World& world) {
    std::string text;
    if (const Box bounds = world.bounds(); !bounds.empty()) {
        const Vec3 size = bounds.high - bounds.low;
        text += info_row("bounds", fmt::format("({}, {}, {}) .. ({}, {}, {}) m", bounds.low.x, bounds.low.y,
                                               bounds.low.z, bounds.high.x, bounds.high.y, bounds.high.z));
        text += info_row("size", fmt::format("{} x {} x {} m", size.x, size.y, size.z));
    }
    text += info_row("rooms", grouped(world.room_count()));
    const SolidMeasures solid = measure_solid(world);
    text += info_row("solid", solid.facets == 0 ? "no face bounds a solid"
                                                : fmt::format("{} faces bound {:.6g} m3 of {}, by {:.6g} m2",
                                                              grouped(solid.facets), std::fabs(solid.volume),
                                                              solid.volume < 0 ? "air" : "rock", solid.area));
    const TreeStatistics tree = world.statistics();
    text += info_row(
        "tree", fmt::format("{} bins, {} of them leaves, in {} blocks; depth {}; fullest leaf {} faces; overlap {:.3f}",
                            grouped(tree.bins), grouped(tree.leaf_bins), grouped(tree.blocks), tree.depth,
                            grouped(tree.largest_bin), tree.overlap));
    text += info_row("memory", fmt::format("{}, {:.0f} bytes a face", bytes_text(tree.bytes), tree.bytes_per_face()));
    return text;
}

}  // namespace firma::cli
