// SPDX-License-Identifier: MIT
// What `firma info` and `firma check` tell of a .firma file.
#include "cli/saved_world.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <optional>
#include <vector>

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

std::string saved_info_json(const LoadedLevel& loaded) {
    const WorldData& data = loaded.world.data();
    const FaceCounts counts = count_faces(loaded.world);
    JsonWriter json;
    json.open_object();
    json.add("level", loaded.level.name);
    json.add("bytes", file_bytes(loaded));
    json.add("version", data.version);
    json.add("edits", data.edits());
    json.add("exact", counts.solid > 0);
    json.open_object("faces");
    json.add("total", counts.total);
    json.add("solid", counts.solid);
    json.add("exact", counts.exact);
    json.close();
    json.open_array("materials");
    for (const std::string& name : material_names(loaded.world)) json.add({}, name);
    json.close();
    add_world(json, loaded.world);
    json.open_object("rules");
    json.add("zones", data.rules ? data.rules->zones.size() : 0);
    json.add("hard_materials", hard_materials(data));
    json.close();
    json.add("read_seconds", loaded.read_seconds);
    json.close();
    return json.text();
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
    text += world_text(loaded.world);
    return text + info_row("time", seconds_text(loaded.read_seconds) + " to read and check");
}

}  // namespace

int tell_saved_world(const LoadedLevel& loaded, bool json) {
    print(json ? saved_info_json(loaded) : saved_info_text(loaded));
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
        print(text + fmt::format("{}: {}; a saved world of {}, {} and {} after {}; {} of the faces bound solids{}\n",
                                 loaded.level.name, fault || solid ? "faulty" : "sound", counted(counts.total, "face"),
                                 counted(world.room_count(), "room"), counted(portal_count(world), "portal"),
                                 counted(world.data().edits(), "edit"), grouped(counts.solid),
                                 world.data().rock_outside() ? ", rock outside" : ""));
        return fault || solid ? 1 : 0;
    }
    JsonWriter json;
    const auto add = [&](const char* key, const auto& found) {
        if (found)
            json.add(key, found->what);
        else
            json.add_null(key);
    };
    json.open_object();
    json.add("level", loaded.level.name);
    json.add("sound", !fault && !solid);
    json.add("faces", counts.total);
    json.add("rooms", world.room_count());
    json.add("portals", portal_count(world));
    add("world_fault", fault);
    add("solid_fault", solid);
    json.add("solid_faces", counts.solid);
    json.add("exact_faces", counts.exact);
    json.add("rock_outside", world.data().rock_outside());
    json.add("version", world.data().version);
    json.add("edits", world.data().edits());
    json.close();
    print(json.text());
    return fault || solid ? 1 : 0;
}

}  // namespace firma::cli
