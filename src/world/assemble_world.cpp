// SPDX-License-Identifier: MIT
// From rooms, portals and options to a World.
#include "world/assemble_world.h"

#include <algorithm>

#include "index/join_nodes.h"
#include "solid/append_faces.h"
#include "world/judge_options.h"

namespace firma {
namespace {

constexpr std::size_t kMost = std::size_t(1) << 31;

Error portal_error(const WorldParts& parts, std::size_t portal, const char* reason) {
    std::string which = "portal " + std::to_string(portal);
    if (!parts.portals[portal].name.empty()) which += " (" + parts.portals[portal].name + ")";
    return {ErrorCode::kInvalid, parts.name.empty() ? which : parts.name + ": " + which, reason};
}

/// Why a portal cannot enter a world, or null.
const char* refusal(const PortalPart& portal, std::size_t rooms) {
    for (const RoomId room : portal.rooms)
        if (room.value >= rooms) return "it leads to a room that is not there";
    if (portal.polygons.empty()) return nullptr;
    if (portal.rooms[0] == portal.rooms[1]) return "it leads from a room to itself";
    for (const std::vector<GridPoint>& polygon : portal.polygons)
        if (polygon.size() < 3 || polygon.size() > std::size_t(kMaxCorners)) return "a polygon has not 3 to 64 corners";
    return nullptr;
}

std::optional<Error> check(const WorldParts& parts) {
    std::size_t faces = 0, exteriors = 0;
    for (const RoomPart& room : parts.rooms) {
        faces += room.faces.faces.size();
        exteriors += room.exterior;
    }
    if (faces >= kMost || parts.rooms.size() >= kMost || parts.portals.size() >= kMost)
        return Error{ErrorCode::kTooLarge, parts.name, "a world holds fewer than 2^31 faces, rooms and portals"};
    if (parts.rooms.empty()) return Error{ErrorCode::kInvalid, parts.name, "a world has at least one room"};
    if (exteriors + parts.rock_outside > 1)
        return Error{ErrorCode::kInvalid, parts.name, "more than one room, or rock as well, reaches to infinity"};
    for (std::size_t k = 0; k < parts.portals.size(); ++k)
        if (const char* reason = refusal(parts.portals[k], parts.rooms.size())) return portal_error(parts, k, reason);
    return {};
}

/// Nothing to say of the one room of a level that knows no rooms.
bool is_plain(const WorldParts& parts) {
    return parts.rooms.size() == 1 && parts.rooms[0].name.empty() && !parts.rooms[0].exterior && parts.portals.empty();
}

/// All faces of one kind, each with its room as its part.
FaceSet take_faces(std::vector<RoomPart>& rooms, bool solid) {
    const auto is_wanted = [&](const FaceSet::Entry& face) { return face.solid == solid; };
    FaceSet all;
    for (std::uint32_t room = 0; room < rooms.size(); ++room) {
        FaceSet& faces = rooms[room].faces;
        if (rooms.size() == 1 && std::all_of(faces.faces.begin(), faces.faces.end(), is_wanted)) {
            std::swap(all, faces);
            for (FaceSet::Entry& face : all.faces) face.part = 0;
            return all;
        }
        for (const FaceSet::Entry& face : faces.faces) {
            if (!is_wanted(face)) continue;
            append_face(faces, face, all);
            all.faces.back().part = room;
        }
    }
    return all;
}

std::vector<RoomRecord> records_of(std::vector<RoomPart>& parts) {
    std::vector<RoomRecord> records(parts.size());
    for (std::uint32_t k = 0; k < parts.size(); ++k) {
        records[k].name = std::move(parts[k].name);
        records[k].exterior = parts[k].exterior;
        records[k].merged_into = k;
    }
    return records;
}

/// The same solid, all of it part 0: one that was a world's of several rooms is in as many parts.
Solid in_one_part(const Solid& solid) {
    const Ref<const Node>& root = solid.data().faces.root;
    bool is_one = true;
    if (root) for_each_block(*root, [&](const Block& block) { is_one = is_one && block.part == 0; });
    if (is_one) return solid;
    FaceSet faces;
    append_all_faces(*root, faces);
    for (FaceSet::Entry& face : faces.faces) face.part = 0;
    // In order of id: what comes out follows from the faces alone.
    std::sort(faces.faces.begin(), faces.faces.end(),
              [](const FaceSet::Entry& a, const FaceSet::Entry& b) { return a.id < b.id; });
    auto data = std::make_shared<SolidData>(solid.data());
    data->faces = build_store(faces, data->tree_options).store;
    return Solid(std::move(data));
}

/// Without names, as many as the solid's faces have numbers for: a material that an edit adds gets one of its own.
std::vector<std::string> unnamed_materials(const Solid& solid) {
    std::size_t count = 1;
    if (const Node* root = solid.data().faces.root.get())
        for_each_block(*root, [&](const Block& block) {
            for (const FaceRecord& face : block.faces) count = std::max(count, std::size_t(face.material) + 1);
        });
    return std::vector<std::string>(count);
}

/// What each room is part of by now. No way there comes back to where it was.
std::vector<std::uint32_t> current_rooms(const std::vector<RoomRecord>& records) {
    std::vector<std::uint32_t> current(records.size());
    for (std::uint32_t k = 0; k < records.size(); ++k) current[k] = records[k].merged_into;
    for (std::uint32_t k = 0; k < records.size(); ++k)
        while (current[current[k]] != current[k]) current[k] = current[current[k]] = current[current[current[k]]];
    return current;
}

}  // namespace

Cells cells_of(StoredWorld& stored) {
    std::vector<RoomRecord>& records = stored.records;
    const std::vector<PortalPart>& portals = stored.portals;
    const std::vector<std::uint32_t> current = current_rooms(records);
    for (std::uint32_t k = 0; k < portals.size(); ++k) {
        if (portals[k].polygons.empty()) continue;
        for (const RoomId room : portals[k].rooms) {
            std::vector<PortalId>& of_room = records[current[room.value]].portals;
            if (of_room.empty() || of_room.back().value != k) of_room.push_back({k});
        }
    }
    Cells cells;
    if (stored.known) cells.set_known();
    std::vector<Ref<const Portal>> made;
    made.reserve(portals.size());
    for (const PortalPart& portal : portals) made.emplace_back(new Portal(portal));
    std::vector<PortalId> all;
    for (std::uint32_t k = 0; k < portals.size(); ++k) {
        cells.set_portal_between(k, std::move(made[k]), !portals[k].open);
        all.push_back({k});
    }
    cells.index_portals(all);
    for (std::uint32_t k = 0; k < records.size(); ++k) {
        cells.set_portal_boxes(records[k]);
        cells.set_room(k, std::make_shared<const RoomRecord>(std::move(records[k])));
    }
    cells.put_in(all);
    return cells;
}

World world_of(StoredWorld stored) {
    auto data = std::make_shared<WorldData>();
    data->cells = cells_of(stored);
    data->set_faces(faces_of_rooms(data->cells, {&stored.solid, &stored.castable}));
    data->castable = stored.castable.store;
    data->solid =
        solid_of(stored.solid.store, stored.rock_outside, stored.next_face, stored.edits, stored.tree_options);
    data->materials = std::move(stored.materials);
    data->tolerance = stored.tolerance;
    data->tree_options = stored.tree_options;
    data->version = stored.version;
    data->rules = std::move(stored.rules);
    data->anchors = std::move(stored.anchors);
    data->textures = std::move(stored.textures);
    data->matters = std::move(stored.matters);
    return World(std::move(data));
}

std::shared_ptr<const MatterPieces> kept_matters(MatterPieces matters) {
    if (says_nothing(matters)) return nullptr;
    matters.finish();
    return std::make_shared<const MatterPieces>(std::move(matters));
}

Result<World> make_world(const Solid& given, const WorldOptions& options) {
    if (auto error = judge_options(options, "")) return *std::move(error);
    const Solid solid = in_one_part(given);
    StoredWorld stored;
    stored.records.resize(1);
    auto data = std::make_shared<WorldData>();
    data->cells = cells_of(stored);
    const BuiltStore faces = parts_of(solid.data().faces);
    data->set_faces(faces_of_rooms(data->cells, {&faces}));
    data->solid = solid;
    data->materials = std::make_shared<std::vector<std::string>>(unnamed_materials(solid));
    data->tolerance = options.tolerance;
    data->tree_options = options.tree;
    data->rules = std::make_shared<const CarveRules>(options.rules);
    MatterPieces matters;
    matters.table = options.matters ? *options.matters : default_matters();
    data->matters = kept_matters(std::move(matters));
    return World(std::move(data));
}

std::optional<Error> stopped(const LongWork& work, const std::string& name) {
    if (work.failed()) return Error{ErrorCode::kInvalid, name, "Tasks::run returned before all its work had"};
    if (work.stopped()) return Error{ErrorCode::kCancelled, name, "cancelled"};
    return {};
}

Result<World> assemble_world(WorldParts parts) {
    if (std::optional<Error> error = check(parts)) return *error;
    StoredWorld stored;
    stored.known = !is_plain(parts);
    for (const RoomPart& room : parts.rooms)
        for (const FaceSet::Entry& face : room.faces.faces)
            stored.next_face = std::max(stored.next_face, face.id.value + 1);
    LongWork* work = parts.work;
    std::optional<LongWork> own;
    if (!work && LongWork::asked(parts.options.work)) {
        std::size_t faces = 0;
        for (const RoomPart& room : parts.rooms) faces += room.faces.faces.size();
        work = &own.emplace(parts.options.work, 3 * faces);
    }
    stored.solid = build_store(take_faces(parts.rooms, true), parts.options.tree, work);
    stored.castable = build_store(take_faces(parts.rooms, false), parts.options.tree, work);
    if (kHasLongWork && work)
        if (std::optional<Error> error = stopped(*work, parts.name)) return *error;
    stored.records = records_of(parts.rooms);
    stored.portals = std::move(parts.portals);
    stored.rock_outside = parts.rock_outside;
    stored.materials = std::make_shared<std::vector<std::string>>(std::move(parts.materials));
    stored.tolerance = parts.options.tolerance;
    stored.tree_options = parts.options.tree;
    stored.rules = std::make_shared<const CarveRules>(std::move(parts.options.rules));
    if (parts.options.textures) stored.textures = std::move(parts.textures);
    stored.matters = kept_matters(std::move(parts.matters));
    return world_of(std::move(stored));
}

}  // namespace firma
