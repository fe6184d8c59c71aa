// SPDX-License-Identifier: MIT
// From the bytes of a .firma file to a world: the container, the parts, then the world as a whole.
#include "firma/save.h"
#include "firma/solid.h"
#include "save/entries.h"
#include "save/sections.h"
#include "save/unpack_blocks.h"
#include "save/unpack_data.h"
#include "save/unpack_exact.h"
#include "save/unpack_portals.h"

namespace firma {
namespace {

/// What no part can see by itself.
void check_whole(const World& world, bool exact, Damage& damage) {
    const auto face_place = [](FaceId face) {
        return face.valid() ? ": face " + std::to_string(face.value) : std::string();
    };
    if (const std::optional<WorldFault> fault = check_world(world)) {
        damage.report(ErrorCode::kMalformed, face_place(fault->face), "the world is broken: " + fault->what);
    } else if (exact) {
        if (const std::optional<SolidFault> solid = check_solid(world))
            damage.report(ErrorCode::kMalformed, face_place(solid->face), "the solid is broken: " + solid->what);
    }
}

}  // namespace

Result<World> unpack_world(std::span<const std::byte> bytes, std::string name) {
    Result<std::vector<Section>> read = read_container(bytes, name);
    if (!read) return read.error();
    Damage damage(name);
    Sections sections(std::move(read).value(), damage);
    sections.refuse_unknown(kKnownSections);
    if (damage.error()) return *damage.error();
    UnpackedData unpacked = unpack_data(sections, damage);
    if (damage.error()) return *damage.error();
    std::vector<Ref<SolidFace>> exact;
    if (unpacked.exact) exact = unpack_exact(sections, damage);
    if (damage.error()) return *damage.error();
    unpacked.data.rooms = unpack_rooms(sections, unpacked.rooms, unpacked.exact, exact, damage);
    if (!damage.error()) unpack_portals(sections, unpacked, damage);
    sections.refuse_unused(kKnownSections);
    if (damage.error()) return *damage.error();
    finish_rooms(unpacked.data);
    World world(std::make_shared<const WorldData>(std::move(unpacked.data)));
    check_whole(world, unpacked.exact, damage);
    if (damage.error()) return *damage.error();
    return world;
}

}  // namespace firma
