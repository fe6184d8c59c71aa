// SPDX-License-Identifier: MIT
// From a level of brushes to a World: what join_brushes() made, room by room.
#include <algorithm>
#include <unordered_map>

#include "brush/brush_matters.h"
#include "brush/judge_brush_level.h"
#include "brush/name_rooms.h"
#include "firma/brush_world.h"
#include "firma/level.h"
#include "join/join_brushes.h"
#include "level/judge_level.h"
#include "level/message.h"
#include "solid/append_faces.h"
#include "world/assemble_world.h"
#include "world/judge_options.h"

namespace firma {
namespace {

/// The brush that a side is of.
std::uint32_t brush_of(const BrushLevel& level, std::uint32_t side) {
    const auto after = std::upper_bound(level.brushes.begin(), level.brushes.end(), side,
                                        [](std::uint32_t s, const Brush& b) { return s < b.first_side; });
    return std::uint32_t(after - level.brushes.begin() - 1);
}

class WorldMaker {
public:
    WorldMaker(const BrushLevel& level, const JoinedLevel& joined, const WorldOptions& options)
        : level_(level), joined_(joined), face_maker_(joined.tables, joined.faces, joined.arrangement, joined.facets) {
        parts_.name = level.name;
        parts_.options = options;
        parts_.rooms.resize(joined.rooms.count);
        parts_.rooms.back().exterior = true;
        parts_.rooms.back().name = "exterior";
        add_materials();
        parts_.matters = matters_of_brushes(level, joined, options.matters ? *options.matters : default_matters());
        add_faces();
        add_loose();
        add_portals();
        add_textures();
    }

    WorldParts take() { return std::move(parts_); }

private:
    /// Surfaces have a list of their own: what both name is one.
    void add_materials() {
        parts_.materials = level_.materials;
        if (parts_.materials.empty()) parts_.materials.emplace_back();
        std::unordered_map<std::string, std::uint32_t> known;
        for (std::uint32_t k = 0; k < parts_.materials.size(); ++k)
            known.try_emplace(std::string(parts_.materials[k]), k);
        for (const std::string& name : level_.surfaces.materials) {
            const auto [it, is_new] = known.try_emplace(std::string(name), std::uint32_t(parts_.materials.size()));
            if (is_new) parts_.materials.push_back(name);
            surface_material_.push_back(it->second);
        }
        if (surface_material_.empty()) surface_material_.push_back(0);
    }

    void add_facet(std::uint32_t room, std::span<const GridPoint> corners, FaceSet::Entry face) {
        face.id = {next_face_++};
        firma::add_facet(parts_.rooms[room].faces, corners, face);
    }

    void add_faces() {
        for (std::uint32_t k = 0; k < joined_.faces.size(); ++k) {
            const std::uint32_t room = joined_.rooms.of_side[k];
            const Ref<const SolidFace> exact = face_maker_.make(k);
            if (exact) parts_.rooms[room].faces.owners.emplace_back(exact.get());
            FaceSet::Entry face;
            face.source = joined_.faces[k].source;
            face.material = joined_.faces[k].material;
            face.mask = joined_.faces[k].mask;
            face.solid = true;
            face.owner = exact.get();
            for (std::uint32_t f = joined_.facets.first[k]; f < joined_.facets.first[k + 1]; ++f)
                add_facet(room, joined_.facets.corners[f], face);
        }
    }

    void add_loose() {
        for (const LooseFacet& facet : joined_.loose) {
            FaceSet::Entry face;
            face.source = facet.source;
            face.material = facet.source < level_.sides.size() ? facet.material : surface_material_[facet.material];
            face.mask = facet.mask;
            face.two_sided = facet.two_sided;
            add_facet(facet.room, facet.corners, face);
        }
    }

    void add_portals() {
        const std::size_t faces = joined_.faces.size();
        for (const JoinPortal& portal : joined_.portals) {
            PortalPart part;
            part.rooms = {RoomId{portal.room[0]}, RoomId{portal.room[1]}};
            part.material = level_.sides[portal.source].material;
            const std::uint32_t entity = level_.brushes[brush_of(level_, portal.source)].entity;
            if (entity < level_.entities.size()) part.name = level_.entities[entity].value("targetname");
            for (const std::uint32_t piece : portal.polygons) {
                const std::size_t polygon = faces + piece;
                const Ref<const SolidFace> exact =
                    face_maker_.make_portal(std::uint32_t(polygon), joined_.portal_pieces[piece].piece.plane);
                for (std::uint32_t f = joined_.facets.first[polygon]; f < joined_.facets.first[polygon + 1]; ++f) {
                    part.polygons.push_back(joined_.facets.corners[f]);
                    part.exact.push_back(exact);
                }
            }
            parts_.portals.push_back(std::move(part));
        }
    }

    /// By source: sides, then faces of the surfaces; of those that there are faces of.
    void add_textures() {
        const std::size_t sides = level_.sides.size();
        std::vector<bool> used(sides + level_.surfaces.faces.size());
        for (const JoinPiece& face : joined_.faces) used[face.source] = true;
        for (const LooseFacet& facet : joined_.loose) used[facet.source] = true;
        FaceTextureBuilder textures;
        textures.add_projections(level_.textures);
        const std::uint32_t first = textures.add_projections(level_.surfaces.textures);
        for (std::uint32_t source = 0; source < used.size(); ++source) {
            if (!used[source]) continue;
            const bool of_side = source < sides;
            const std::uint32_t texture =
                of_side ? level_.sides[source].texture : level_.surfaces.faces[source - sides].texture;
            if (texture != kNoTexture) textures.add(source, of_side ? texture : first + texture);
        }
        parts_.textures = textures.take();
    }

    const BrushLevel& level_;
    const JoinedLevel& joined_;
    JoinFaceMaker face_maker_;
    WorldParts parts_;
    std::vector<std::uint32_t> surface_material_;
    std::uint32_t next_face_ = 0;
};

BrushWorldReport report_of(const BrushLevel& level, const JoinedLevel& joined) {
    BrushWorldReport report;
    for (const Brush& brush : level.brushes)
        report.solid_brushes += brush.kind == BrushKind::kSolid || brush.kind == BrushKind::kSky;
    for (const LeftOut& left : joined.left_out) {
        const BrushKind kind = level.brushes[left.brush].kind;
        report.solid_brushes -= kind == BrushKind::kSolid || kind == BrushKind::kSky;
        report.notes.push_back(
            {left.no_volume ? BrushNote::What::kNoVolume : BrushNote::What::kNotJoined, left.brush, left.reason});
    }
    for (const std::uint32_t source : joined.idle_portals) {
        report.notes.push_back(
            {BrushNote::What::kIdlePortal, brush_of(level, source), "there is one room on both sides of it"});
    }
    for (const std::uint32_t brush : joined.hidden_portals)
        report.notes.push_back(
            {BrushNote::What::kIdlePortal, brush, "it lies in the solid, or where another portal is"});
    std::sort(report.notes.begin(), report.notes.end(), [](const BrushNote& a, const BrushNote& b) {
        return a.what != b.what ? a.what < b.what : a.brush < b.brush;
    });
    const auto same = [](const BrushNote& a, const BrushNote& b) { return a.what == b.what && a.brush == b.brush; };
    report.notes.erase(std::unique(report.notes.begin(), report.notes.end(), same), report.notes.end());
    report.solid_faces = joined.faces.size();
    report.planes_moved = joined.planes_moved;
    report.lost_shells = joined.rooms.lost;
    return report;
}

/// "3 brushes, 1 of them portals or data", what was left out, and why of the first brush.
Error nothing_left(const BrushLevel& level, const BrushWorldReport& report) {
    const auto data = std::count_if(level.brushes.begin(), level.brushes.end(), [](const Brush& brush) {
        return brush.kind == BrushKind::kData || brush.kind == BrushKind::kPortal;
    });
    const std::size_t count = level.brushes.size();
    const std::string detail = std::to_string(count) + (count == 1 ? " brush, " : " brushes, ") + std::to_string(data) +
                               " of them portals or data";
    std::vector<Omission> omissions = level.omissions;
    omissions.insert(omissions.end(), level.surfaces.omissions.begin(), level.surfaces.omissions.end());
    const auto empty = std::count_if(report.notes.begin(), report.notes.end(),
                                     [](const BrushNote& note) { return note.what == BrushNote::What::kNoVolume; });
    if (empty > 0) omissions.push_back({"brushes without volume", std::uint64_t(empty), ""});
    Error error = nothing_left(level.name, detail, omissions);
    if (!report.notes.empty())
        error.reason += " (brush " + std::to_string(report.notes[0].brush) + ": " + report.notes[0].reason + ")";
    return error;
}

}  // namespace

Result<World> make_world(const BrushLevel& level, const WorldOptions& options, BrushWorldReport* report) {
    if (auto error = judge_brush_level(level)) return *std::move(error);
    if (auto error = judge_options(options, level.name)) return *std::move(error);
    const Result<std::unique_ptr<JoinedLevel>> joined = join_brushes(level);
    if (!joined.ok()) return joined.error();
    if (report) *report = report_of(level, *joined.value());
    Result<World> world = assemble_world(WorldMaker(level, *joined.value(), options).take());
    if (!world.ok()) return world;
    if (world.value().face_count() == 0) return nothing_left(level, report_of(level, *joined.value()));
    return name_rooms(world.value(), level, report ? &report->entity_notes : nullptr);
}

}  // namespace firma
