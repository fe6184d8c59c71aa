// SPDX-License-Identifier: MIT
// What `firma info` and `firma check` tell of a .firma file.
#include "cli/saved_world.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <optional>
#include <utility>
#include <vector>

#include "cli/anchor_options.h"
#include "cli/describe_world.h"
#include "cli/json.h"
#include "cli/numbers.h"
#include "cli/verb.h"
#include "firma/rooms.h"
#include "firma/solid.h"
#include "world/world_data.h"

namespace firma::cli {

namespace {

struct FaceCounts {
    std::size_t total = 0;
    std::size_t solid = 0;  ///< that bound solids
    std::size_t exact = 0;  ///< facets of an exact face that a cut made
};

FaceCounts count_faces(const World& world) {
    FaceCounts counts;
    for_each_block_of(world.data(), [&](const Block& block) {
        for (const FaceRecord& face : block.faces) {
            ++counts.total;
            counts.solid += face.solid;
            counts.exact += face.owner != kNoOwner;
        }
    });
    return counts;
}

/// Without the empty one that stands for none.
std::vector<std::string> material_names(const World& world) {
    std::vector<std::string> names;
    for (const std::string& name : *world.data().materials)
        if (!name.empty()) names.push_back(name);
    return names;
}

std::size_t hard_materials(const WorldData& data) {
    if (!data.rules) return 0;
    const std::vector<double>& hardness = data.rules->hardness;
    return std::size_t(std::count_if(hardness.begin(), hardness.end(), [](double h) { return h > 0; }));
}

std::uintmax_t file_bytes(const LoadedLevel& loaded) {
    std::error_code none;
    const std::uintmax_t bytes = std::filesystem::file_size(loaded.level.name, none);
    return none ? 0 : bytes;
}

Json saved_info_json(const LoadedLevel& loaded) {
    const WorldData& data = loaded.world.data();
    const FaceCounts counts = count_faces(loaded.world);
    Json json;
    json["level"] = loaded.level.name;
    json["bytes"] = file_bytes(loaded);
    json["version"] = data.version;
    json["edits"] = data.edits();
    json["exact"] = counts.solid > 0;
    json["faces"] = {{"total", counts.total}, {"solid", counts.solid}, {"exact", counts.exact}};
    json["materials"] = material_names(loaded.world);
    add_world(json, loaded.world);
    json["rules"] = {{"zones", data.rules ? data.rules->zones.size() : 0}, {"hard_materials", hard_materials(data)}};
    json["anchors"] = anchors_json(loaded.world);
    json["read_seconds"] = loaded.read_seconds;
    return json;
}

std::string saved_info_text(const LoadedLevel& loaded) {
    const WorldData& data = loaded.world.data();
    const FaceCounts counts = count_faces(loaded.world);
    const std::uintmax_t bytes = file_bytes(loaded);
    const double faces = double(std::max<std::size_t>(counts.total, 1));
    std::string text = info_row("saved world", loaded.level.name);
    text += info_row("file", fmt::format("{}, {:.0f} bytes a face", bytes_text(bytes), double(bytes) / faces));
    text += info_row("version", fmt::format("{}, after {} edits", grouped(data.version), grouped(data.edits())));
    text += info_row("faces", grouped(counts.total));
    text +=
        info_row("exact part", counts.solid == 0 ? "none: it can be cast against, not carved"
                                                 : fmt::format("{} of the faces bound solids, {} of them made by cuts",
                                                               grouped(counts.solid), grouped(counts.exact)));
    text += info_row("materials", grouped(material_names(loaded.world).size()));
    text += info_row("rules", fmt::format("{} zones, {} hard materials", data.rules ? data.rules->zones.size() : 0,
                                          hard_materials(data)));
    if (const std::string held = anchors_text(loaded.world); !held.empty()) text += info_row("anchors", held);
    text += world_text(loaded.world);
    return text + info_row("time", seconds_text(loaded.read_seconds) + " to read and check");
}

}  // namespace

int tell_saved_world(const LoadedLevel& loaded, bool json) {
    print(json ? json_text(saved_info_json(loaded)) : saved_info_text(loaded));
    return 0;
}

int check_saved_world(const LoadedLevel& loaded, bool as_json) {
    const World& world = loaded.world;
    const std::optional<WorldFault> fault = check_world(world);
    const std::optional<SolidFault> solid = check_solid(world);
    const FaceCounts counts = count_faces(world);
    if (!as_json) {
        std::string text;
        if (fault) text += fmt::format("{}: the world is broken: {}\n", loaded.level.name, fault->what);
        if (solid) text += fmt::format("{}: the solid is broken: {}\n", loaded.level.name, solid->what);
        const std::string held = anchors_text(world);
        print(text + fmt::format("{}: {}; a saved world of {}, {} and {} after {}; {} of the faces bound solids{}{}\n",
                                 loaded.level.name, fault || solid ? "faulty" : "sound", counted(counts.total, "face"),
                                 counted(world.room_count(), "room"), counted(portal_count(world), "portal"),
                                 counted(world.data().edits(), "edit"), grouped(counts.solid),
                                 world.data().rock_outside() ? ", rock outside" : "", held.empty() ? "" : "; " + held));
        return fault || solid ? 1 : 0;
    }
    const auto reason = [](const auto& found) { return found ? Json(found->what) : Json(); };
    Json json;
    json["level"] = loaded.level.name;
    json["sound"] = !fault && !solid;
    json["faces"] = counts.total;
    json["rooms"] = world.room_count();
    json["portals"] = portal_count(world);
    json["world_fault"] = reason(fault);
    json["solid_fault"] = reason(solid);
    json["solid_faces"] = counts.solid;
    json["exact_faces"] = counts.exact;
    json["rock_outside"] = world.data().rock_outside();
    json["version"] = world.data().version;
    json["edits"] = world.data().edits();
    json["anchors"] = anchors_json(world);
    print(json_text(std::move(json)));
    return fault || solid ? 1 : 0;
}

}  // namespace firma::cli
