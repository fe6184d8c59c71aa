// SPDX-License-Identifier: MIT
// A world's hash: every number that makes it what it is, in the order it stands in.
#include "base/hasher.h"
#include "firma/world.h"
#include "world/world_data.h"

namespace firma {
namespace {

void add(Hasher& hasher, const std::string& text) {
    hasher.add(text.size());
    std::uint64_t word = 0;
    for (std::size_t k = 0; k < text.size(); ++k) {
        word = word << 8 | static_cast<unsigned char>(text[k]);
        if (k % 8 == 7 || k + 1 == text.size()) {
            hasher.add(word);
            word = 0;
        }
    }
}

/// Four in a word.
void add(Hasher& hasher, const PoolVector<std::uint16_t>& numbers) {
    std::size_t k = 0;
    for (; k + 4 <= numbers.size(); k += 4)
        hasher.add(std::uint64_t(numbers[k]) << 48 | std::uint64_t(numbers[k + 1]) << 32 |
                   std::uint64_t(numbers[k + 2]) << 16 | numbers[k + 3]);
    for (; k < numbers.size(); ++k) hasher.add(numbers[k]);
}

void add(Hasher& hasher, const Bin& bin) {
    for (int axis = 0; axis < 3; ++axis) hasher.add(bin.box.low[axis], bin.box.high[axis]);
    hasher.add(bin.first, bin.count);
}

void add(Hasher& hasher, const FaceRecord& face) {
    hasher.add(face.id.value, face.source);
    hasher.add(face.edit, face.material);
    const std::uint32_t flags = std::uint32_t(face.two_sided) | std::uint32_t(face.solid) << 1;
    hasher.add(face.mask, std::uint32_t(face.corner_count) << 8 | flags);
    hasher.add(face.first_corner, face.owner);
}

void add(Hasher& hasher, const Block& block) {
    hasher.add(block.bins.size(), block.children.size());
    hasher.add(block.faces.size(), block.vertices.size());
    hasher.add(block.corner_vertices.size(), block.owners.size());
    for (const Bin& bin : block.bins) add(hasher, bin);
    for (const FaceRecord& face : block.faces) add(hasher, face);
    for (const GridPoint& p : block.vertices) {
        hasher.add(p.x, p.y);
        hasher.add(std::uint32_t(p.z));
    }
    add(hasher, block.corner_vertices);
    for (const Ref<const FaceOwner>& owner : block.owners) owner->add_to(hasher);
    for (const Ref<const Block>& child : block.children) add(hasher, *child);
}

void add(Hasher& hasher, const std::vector<RoomRecord>& records) {
    for (const RoomRecord& record : records) {
        add(hasher, record.name);
        hasher.add(std::uint32_t(record.exterior), record.merged_into);
    }
}

void add(Hasher& hasher, const PortalSet& portals, const ClosedPortals* closed) {
    hasher.add(portals.portals().size());
    for (std::size_t k = 0; k < portals.portals().size(); ++k) {
        const Portal& portal = portals.portals()[k];
        hasher.add(portal.rooms[0].value, portal.rooms[1].value);
        add(hasher, portal.name);
        hasher.add(portal.material, portal.mask);
        hasher.add(portal.polygon_count, std::uint32_t(closed && closed->is_closed[k]));
        for (const PortalPolygon& polygon : portals.polygons_of(portal)) {
            hasher.add(polygon.corners.size());
            for (const GridPoint& p : polygon.corners) {
                hasher.add(p.x, p.y);
                hasher.add(std::uint32_t(p.z));
            }
        }
    }
}

}  // namespace

std::uint64_t hash_world(const World& world) {
    const WorldData& data = world.data();
    Hasher hasher;
    hasher.add(data.version);
    hasher.add(data.face_count);
    hasher.add(data.next_face, data.edits);
    hasher.add(data.rock_outside);
    hasher.add(data.tolerance.skin);
    hasher.add(data.materials ? data.materials->size() : std::size_t(0));
    if (data.materials)
        for (const std::string& name : *data.materials) add(hasher, name);
    hasher.add(data.rooms.size());
    for (const Ref<const Room>& room : data.rooms) {
        hasher.add(bool(room->tree));
        if (room->tree) add(hasher, *room->tree);
    }
    if (data.room_records) add(hasher, *data.room_records);
    if (data.portals) add(hasher, *data.portals, data.closed.get());
    return hasher.value();
}

}  // namespace firma
