// SPDX-License-Identifier: MIT
// Logs in, out, and told.
#include "cli/edit_log_file.h"

#include <fmt/format.h>

#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "cli/csv_reader.h"
#include "cli/failure.h"
#include "cli/load_level.h"
#include "cli/numbers.h"
#include "cli/verb.h"

namespace firma::cli {

namespace {

const char* kind_name(EditKind kind) {
    switch (kind) {
        case EditKind::kCarve:
            return "carve";
        case EditKind::kFill:
            return "fill";
        case EditKind::kDoor:
            return "door";
        case EditKind::kGroup:
            return "group";
    }
    return "";
}

bool cuts(const EditCommand& command) {
    return command.kind == EditKind::kCarve || command.kind == EditKind::kFill;
}

/// The shape of a crater, or the name of a cutter.
std::string cutter_text(const EditCommand& command) {
    if (const auto* crater = std::get_if<CraterSeed>(&command.cutter))
        return std::string(cutter_shape_name(crater->shape));
    const Cutter& cutter = std::get<Cutter>(command.cutter);
    return fmt::format("{} ({} triangles)", cutter.name().empty() ? "mesh" : cutter.name(), cutter.triangles().size());
}

}  // namespace

bool names_edit_log(const std::string& path) {
    return has_ending(path, ".firmalog");
}

LoadedLog read_edit_log(const std::string& path) {
    const std::string text = read_file(path);
    const std::span<const std::byte> bytes = std::as_bytes(std::span(text));
    return {take(unpack_log(bytes, path)), text.size()};
}

void write_edit_log(const EditLog& log, AtomicFile& file) {
    const std::vector<std::byte> bytes = pack_log(log);
    file.write({reinterpret_cast<const char*>(bytes.data()), bytes.size()});
}

std::string hash_digits(std::uint64_t hash) {
    return fmt::format("{:016x}", hash);
}

Json edit_log_json(const std::string& path, const LoadedLog& loaded) {
    const EditLog& log = loaded.log;
    Json json;
    json["log"] = path;
    json["bytes"] = loaded.bytes;
    json["version"] = kEditLogVersion;
    json["level_hash"] = hash_digits(log.level_hash());
    json["rules_hash"] = hash_digits(log.rules_hash());
    json["level_edits"] = log.level_edits();
    json["last_number"] = log.last_number();
    json["patched_number"] = log.patch().empty() ? Json() : Json(log.patched_number());
    json["patch_bytes"] = log.patch().size();
    json["command_count"] = log.commands().size();
    json["checkpoint_count"] = log.checkpoints().size();
    return json;
}

std::string edit_log_text(const std::string& path, const LoadedLog& loaded) {
    const EditLog& log = loaded.log;
    const std::string patch = log.patch().empty() ? ""
                                                  : fmt::format("a patch of {} up to edit {}, ",
                                                                bytes_text(log.patch().size()), log.patched_number());
    return fmt::format("{}: an edit log of {}: {}{} and {}; it begins from the world of hash {}\n", path,
                       bytes_text(loaded.bytes), patch, counted(log.commands().size(), "command"),
                       counted(log.checkpoints().size(), "checkpoint"), hash_digits(log.level_hash()));
}

Json command_json(const EditCommand& command) {
    Json json;
    json["number"] = last_number(command);
    json["kind"] = kind_name(command.kind);
    if (command.kind == EditKind::kGroup) {
        json["parts"] = Json::array();
        for (const EditCommand& part : command.parts) json["parts"].push_back(command_json(part));
    }
    if (command.kind == EditKind::kDoor) {
        json["portal"] = command.portal.value;
        json["open"] = command.open;
    }
    if (!cuts(command)) return json;
    const auto* crater = std::get_if<CraterSeed>(&command.cutter);
    json["cutter"] = cutter_text(command);
    json["seed"] = crater ? Json(crater->seed) : Json();
    json["position"] = command.pose.position;
    json["rotation"] = command.pose.rotation;
    json["scale"] = command.pose.scale;
    json["material"] = command.options.material;
    const std::optional<ChunkOptions>& chunks = command.options.chunks;
    json["chunks"] = Json();
    if (!chunks) return json;
    json["chunks"]["min_volume"] = chunks->min_volume;
    json["chunks"]["density"] = chunks->density > 0 ? Json(chunks->density) : Json();
    return json;
}

std::string command_text(const EditCommand& command) {
    std::string text = fmt::format("{} {}", last_number(command), kind_name(command.kind));
    if (command.kind == EditKind::kDoor)
        text += fmt::format(" portal {} {}", command.portal.value, command.open ? "open" : "closed");
    for (const EditCommand& part : command.parts) text += "; " + command_text(part);
    if (!cuts(command)) return text;
    text += " " + cutter_text(command);
    if (const auto* crater = std::get_if<CraterSeed>(&command.cutter)) text += fmt::format(" of seed {}", crater->seed);
    text += fmt::format(" at {}, scale {}", point_text(command.pose.position), command.pose.scale);
    if (!command.options.material.empty()) text += ", material " + command.options.material;
    if (const std::optional<ChunkOptions>& chunks = command.options.chunks)
        text += fmt::format(", with chunks of {} m3", chunks->min_volume) +
                (chunks->density > 0 ? fmt::format(" and {} kg/m3", chunks->density) : "");
    return text;
}

int check_edit_log(const std::string& path, bool as_json) {
    const LoadedLog loaded = read_edit_log(path);
    if (!as_json) {
        print(edit_log_text(path, loaded));
        return 0;
    }
    Json json = edit_log_json(path, loaded);
    json["sound"] = true;
    print(json_text(std::move(json)));
    return 0;
}

}  // namespace firma::cli
