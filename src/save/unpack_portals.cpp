// SPDX-License-Identifier: MIT
// Records of rooms, and portals, of a saved world. Counts are compared with what is there before memory is taken.
#include "save/sections.h"
#include "save/unpack_data.h"

namespace firma {
namespace {

bool unpack_records(const Entries& section, UnpackedData& unpacked, Damage& damage) {
    if (unpacked.rooms > section.count() / kRoomRecordBytes)
        return damage.report(section.type(), "has not as many entries as rooms");
    const std::size_t fixed = unpacked.rooms * kRoomRecordBytes;
    Texts names({section.at(fixed), section.count() - fixed});
    std::vector<RoomRecord> records(unpacked.rooms);
    for (std::size_t k = 0; k < records.size(); ++k) {
        const std::byte* at = section.at(k * kRoomRecordBytes);
        const std::uint32_t flags = read_u32(at + 4);
        records[k].exterior = flags & kExteriorRoom;
        records[k].merged_into = read_u32(at + 8);
        if (flags & ~kExteriorRoom) return damage.report(section.type(), k, "has flags that mean nothing");
        if (records[k].merged_into > k) return damage.report(section.type(), k, "is part of a higher room");
        if (!names.take(read_u32(at), records[k].name)) return damage.report(section.type(), k, "ends before its name");
    }
    if (!names.all_taken()) return damage.report(section.type(), "has bytes behind its last name");
    unpacked.world.records = std::move(records);
    return true;
}

class PortalReader {
public:
    PortalReader(Sections& sections, UnpackedData& unpacked, Damage& damage) : unpacked_(unpacked), damage_(damage) {
        portals_ = sections.entries(kPortalsSection, 1);
        polygons_ = sections.entries(kPortalPolygonsSection, 4);
        corners_ = sections.entries(kPortalCornersSection, kPointBytes);
    }

    void read() {
        if (damage_.error()) return;
        if (portals_.count() < 4) return fault("ends before its count");
        const std::uint64_t count = read_u32(portals_.at(0));
        if (count > (portals_.count() - 4) / kPortalBytes) return fault("ends before its portals");
        const std::size_t fixed = std::size_t(4 + count * kPortalBytes);
        Texts names({portals_.at(fixed), portals_.count() - fixed});
        std::vector<PortalPart> parts(static_cast<std::size_t>(count));
        for (at_ = 0; at_ < count; ++at_) {
            const std::byte* at = portals_.at(std::size_t(4 + at_ * kPortalBytes));
            if (!read_portal(at, parts[at_])) return;
            if (!names.take(read_u32(at + 24), parts[at_].name)) return fault_here("ends before its name");
        }
        if (!names.all_taken()) return fault("has bytes behind its last name");
        for (const Entries* part : {&polygons_, &corners_})
            if (part->left() > 0) {
                damage_.report(part->type(), part->taken(), "belongs to no portal");
                return;
            }
        unpacked_.world.portals = std::move(parts);
    }

private:
    void fault(const char* reason) { damage_.report(portals_.type(), reason); }
    void fault_here(const char* reason) { damage_.report(portals_.type(), at_, reason); }

    bool read_portal(const std::byte* at, PortalPart& part) {
        part.rooms = {RoomId{read_u32(at)}, RoomId{read_u32(at + 4)}};
        part.material = read_u32(at + 8);
        part.mask = read_u32(at + 12);
        const std::uint32_t flags = read_u32(at + 16), polygons = read_u32(at + 20);
        part.open = !(flags & kClosedPortal);
        for (const RoomId room : part.rooms)
            if (room.value >= unpacked_.rooms) return fault_here("leads to a room that is not there"), false;
        if (flags & ~kClosedPortal || read_u32(at + 28) != 0) return fault_here("has flags that mean nothing"), false;
        if (polygons > polygons_.left()) return fault_here("has more polygons than there are"), false;
        for (std::uint32_t k = 0; k < polygons; ++k)
            if (!read_polygon(part)) return false;
        return true;
    }

    bool read_polygon(PortalPart& part) {
        const std::uint32_t corners = read_u32(polygons_.take(1));
        const auto fault_of_polygon = [&](const char* reason) {
            return damage_.report(polygons_.type(), polygons_.taken() - 1, reason);
        };
        if (corners < 3 || corners > std::uint32_t(kMaxCorners))
            return fault_of_polygon("does not have 3 to 64 corners");
        if (corners > corners_.left()) return fault_of_polygon("has more corners than there are");
        std::vector<GridPoint>& polygon = part.polygons.emplace_back();
        const std::byte* at = corners_.take(corners);
        for (std::uint32_t k = 0; k < corners; ++k, at += kPointBytes)
            polygon.push_back({read_i32(at), read_i32(at + 4), read_i32(at + 8)});
        return true;
    }

    UnpackedData& unpacked_;
    Damage& damage_;
    Entries portals_, polygons_, corners_;
    std::uint64_t at_ = 0;
};

}  // namespace

void unpack_portals(Sections& sections, UnpackedData& unpacked, Damage& damage) {
    unpacked.world.records.resize(1);
    if (!unpacked.has_records) return;
    const Entries records = sections.entries(kRoomRecordsSection, 1);
    if (damage.error() || !unpack_records(records, unpacked, damage)) return;
    if (unpacked.has_portals) PortalReader(sections, unpacked, damage).read();
}

}  // namespace firma
