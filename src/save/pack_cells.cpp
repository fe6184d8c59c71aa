// SPDX-License-Identifier: MIT
// What a world has besides faces, into sections.
#include "save/pack_cells.h"

#include <algorithm>
#include <utility>

#include "save/face_packer.h"

namespace firma {
namespace {

CellsVersion add_records(const Cells& cells, std::vector<NewSection>& sections) {
    ByteWriter records;
    CellsVersion needed = CellsVersion::kTwo;
    for (std::uint32_t room = 0; room < cells.room_count(); ++room) {
        const RoomRecord& record = cells.room(room);
        records.u32(std::uint32_t(record.name.size()));
        records.u32(record.exterior ? kExteriorRoom : 0);
        records.u32(record.merged_into);
        if (record.merged_into > room) needed = CellsVersion::kThree;
    }
    for (std::uint32_t room = 0; room < cells.room_count(); ++room) put_text_bytes(records, cells.room(room).name);
    sections.push_back({kRoomRecordsSection, kRequiredSection, std::move(records)});
    return needed;
}

CellsVersion add_portals(const Cells& cells, ExactPacker* exact, std::vector<NewSection>& sections) {
    ByteWriter portals, polygons, corners, faces;
    CellsVersion needed = CellsVersion::kTwo;
    portals.u32(cells.portal_count());
    for (std::uint32_t k = 0; k < cells.portal_count(); ++k) {
        const Portal& portal = cells.portal(k);
        const auto all = portal.all_polygons();
        for (const RoomId room : cells.rooms_of(portal)) portals.u32(room.value);
        portals.u32(portal.material);
        portals.u32(portal.mask);
        portals.u32((cells.is_closed(k) ? kClosedPortal : 0) | (portal.made ? kMadePortal : 0));
        portals.u32(std::uint32_t(all.size()));
        portals.u32(std::uint32_t(portal.name.size()));
        portals.u32(0);
        if (portal.made) needed = CellsVersion::kThree;
        for (std::size_t p = 0; p < all.size(); ++p) {
            polygons.u32(std::uint32_t(all[p].corners.size()));
            for (const GridPoint& corner : all[p].corners) put_point(corners, corner);
            if (portal.exact(p)) needed = CellsVersion::kThree;
            if (exact) faces.u32(portal.exact(p) ? exact->number(portal.exact(p)) : kOwnFace);
        }
    }
    for (std::uint32_t k = 0; k < cells.portal_count(); ++k) put_text_bytes(portals, cells.portal(k).name);
    sections.push_back({kPortalsSection, kRequiredSection, std::move(portals)});
    sections.push_back({kPortalPolygonsSection, kRequiredSection, std::move(polygons)});
    sections.push_back({kPortalCornersSection, kRequiredSection, std::move(corners)});
    if (exact) sections.push_back({kPortalFacesSection, kRequiredSection, std::move(faces)});
    return needed;
}

}  // namespace

void put_text_bytes(ByteWriter& out, const std::string& text) {
    for (const char c : text) out.u8(static_cast<unsigned char>(c));
}

void add_materials(const WorldData& data, std::vector<NewSection>& sections) {
    static const std::vector<std::string> kNone;
    const std::vector<std::string>& names = data.materials ? *data.materials : kNone;
    ByteWriter materials;
    materials.u32(std::uint32_t(names.size()));
    for (const std::string& name : names) materials.u32(std::uint32_t(name.size()));
    for (const std::string& name : names) put_text_bytes(materials, name);
    sections.push_back({kMaterialsSection, kRequiredSection, std::move(materials)});
}

CellsVersion add_cells(const Cells& cells, ExactPacker* exact, std::vector<NewSection>& sections) {
    const CellsVersion records = cells.known() ? add_records(cells, sections) : CellsVersion::kTwo;
    const CellsVersion portals = cells.portal_count() > 0 ? add_portals(cells, exact, sections) : CellsVersion::kTwo;
    return std::max(records, portals);
}

}  // namespace firma
