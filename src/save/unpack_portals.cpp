// SPDX-License-Identifier: MIT
// Records of rooms, and portals, of a saved world. Counts are compared with what is there before memory is taken.
#include "save/sections.h"
#include "save/unpack_data.h"

namespace firma {
namespace {

/// A room of which the way to what it is part of by now never ends; nothing where there is none.
std::optional<std::size_t> part_of_itself(const std::vector<RoomRecord>& records) {
    std::vector<std::size_t> passed_from(records.size(), records.size());  // the room that its way began at
    for (std::size_t room = 0; room < records.size(); ++room)
        for (std::size_t at = room; passed_from[at] == records.size(); at = records[at].merged_into) {
            passed_from[at] = room;
            const std::size_t next = records[at].merged_into;
            if (next != at && passed_from[next] == room) return room;
        }
    return {};
}

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
        if (records[k].merged_into >= records.size())
            return damage.report(section.type(), k, "is part of a room that is not there");
        if (!names.take(read_u32(at), records[k].name)) return damage.report(section.type(), k, "ends before its name");
    }
    if (!names.all_taken()) return damage.report(section.type(), "has bytes behind its last name");
    if (const auto room = part_of_itself(records))
        return damage.report(section.type(), *room, "is part of itself, by way of others");
    unpacked.world.records = std::move(records);
    return true;
}

class PortalReader {
public:
    PortalReader(Sections& sections, UnpackedData& unpacked, const std::vector<Ref<SolidFace>>* exact, Damage& damage)
        : unpacked_(unpacked), exact_(exact), damage_(damage) {
        portals_ = sections.entries(kPortalsSection, 1);
        polygons_ = sections.entries(kPortalPolygonsSection, 4);
        corners_ = sections.entries(kPortalCornersSection, kPointBytes);
        if (exact) faces_ = sections.entries(kPortalFacesSection, 4);
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
        for (const Entries* part : {&polygons_, &corners_, &faces_})
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
        part.made = flags & kMadePortal;
        for (const RoomId room : part.rooms)
            if (room.value >= unpacked_.rooms) return fault_here("leads to a room that is not there"), false;
        if (flags & ~(kClosedPortal | kMadePortal) || read_u32(at + 28) != 0)
            return fault_here("has flags that mean nothing"), false;
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
        return !exact_ || read_face(part);
    }

    bool read_face(PortalPart& part) {
        if (faces_.left() == 0) return damage_.report(faces_.type(), "has not as many entries as polygons");
        const std::size_t entry = faces_.taken();
        const std::uint32_t face = read_u32(faces_.take(1));
        if (face != kOwnFace && face >= exact_->size())
            return damage_.report(faces_.type(), entry, "names an exact face that is not there");
        if (face == kOwnFace) {
            part.exact.emplace_back();
        } else {
            const Ref<SolidFace>& named = (*exact_)[face];
            part.exact.emplace_back(named.get());
            ++named->facets;
        }
        return true;
    }

    UnpackedData& unpacked_;
    const std::vector<Ref<SolidFace>>* exact_;
    Damage& damage_;
    Entries portals_, polygons_, corners_, faces_;
    std::uint64_t at_ = 0;
};

}  // namespace

void unpack_portals(Sections& sections, UnpackedData& unpacked, const std::vector<Ref<SolidFace>>* exact,
                    Damage& damage) {
    unpacked.world.records.resize(1);
    if (!unpacked.has_records) return;
    const Entries records = sections.entries(kRoomRecordsSection, 1);
    if (damage.error() || !unpack_records(records, unpacked, damage)) return;
    if (unpacked.has_portals) PortalReader(sections, unpacked, exact, damage).read();
}

}  // namespace firma
