// SPDX-License-Identifier: MIT
// What a world is made of, as sections of a .firma file: the table, pieces, planes of bodies, polygons of meshes.
#include "save/pack_matters.h"

#include <algorithm>
#include <utility>

#include "save/sections.h"
#include "solid/append_faces.h"
#include "solid/solid_data.h"

namespace firma {
namespace {

void add_letters(ByteWriter& out, const std::string& text) {
    for (const char c : text) out.u8(static_cast<unsigned char>(c));
}

ByteWriter table_of(const MatterPieces& matters) {
    ByteWriter out;
    const MatterTable& table = matters.table;
    out.u32(std::uint32_t(table.matters.size()));
    out.u32(std::uint32_t(table.patterns.size()));
    out.u32(matters.rest);
    out.u32(matters.rest_look);
    for (const Matter& matter : table.matters) {
        for (const double number : {matter.density, matter.strength, matter.hardness}) out.f64(number);
        out.u32(std::uint32_t(matter.fracture));
        out.u16(std::uint16_t(matter.name.size()));
        out.u16(std::uint16_t(matter.inside.size()));
    }
    for (const MatterPattern& it : table.patterns) {
        out.u32(it.matter);
        out.u32(std::uint32_t(it.pattern.size()));
    }
    for (const Matter& matter : table.matters) {
        add_letters(out, matter.name);
        add_letters(out, matter.inside);
    }
    for (const MatterPattern& it : table.patterns) add_letters(out, it.pattern);
    return out;
}

/// The polygons of a mesh in order of id.
std::uint32_t add_mesh(const Solid& mesh, ByteWriter& polygons, ByteWriter& corners) {
    FaceSet faces;
    append_all_faces(*mesh.data().faces.root, faces);
    std::sort(faces.faces.begin(), faces.faces.end(),
              [](const FaceSet::Entry& a, const FaceSet::Entry& b) { return a.id < b.id; });
    for (const FaceSet::Entry& face : faces.faces) {
        polygons.u32(face.corner_count);
        for (std::uint32_t k = 0; k < face.corner_count; ++k)
            for (int axis = 0; axis < 3; ++axis) corners.i32(faces.corner(face, k)[axis]);
    }
    return std::uint32_t(faces.faces.size());
}

}  // namespace

std::vector<NewSection> pack_matters(const MatterPieces& matters) {
    ByteWriter pieces, planes, polygons, corners, materials, sources;
    for (const MatterPiece& piece : matters.pieces) {
        pieces.u32(piece.matter);
        pieces.u32(piece.look);
        pieces.u32(piece.sky ? kSkyPiece : 0);
        pieces.u32(piece.plane_count);
        pieces.u32(piece.mesh ? add_mesh(*piece.mesh, polygons, corners) : 0);
        pieces.u32(piece.material_count);
        for (const GridPoint& corner : {piece.box.low, piece.box.high})
            for (int axis = 0; axis < 3; ++axis) pieces.i32(corner[axis]);
        for (const Ref<const SolidPlane>& plane : matters.planes_of(piece)) {
            for (const std::int64_t n : plane->plane.normal) planes.u64(std::uint64_t(n));
            planes.u64(plane->plane.offset_low);
            planes.u64(std::uint64_t(plane->plane.offset_high));
        }
        for (const std::uint32_t material : matters.materials_of(piece)) materials.u32(material);
    }
    for (const MatterOfSources& it : matters.sources) {
        sources.u32(it.first);
        sources.u32(it.matter);
    }
    std::vector<NewSection> all;
    const auto add = [&](SectionType type, ByteWriter content) {
        all.push_back({type, kRequiredSection, std::move(content)});
    };
    add(kMattersSection, table_of(matters));
    add(kPiecesSection, std::move(pieces));
    add(kPiecePlanesSection, std::move(planes));
    add(kPiecePolygonsSection, std::move(polygons));
    add(kPieceCornersSection, std::move(corners));
    add(kPieceMaterialsSection, std::move(materials));
    add(kMatterSourcesSection, std::move(sources));
    return all;
}

}  // namespace firma
