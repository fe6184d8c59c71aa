// SPDX-License-Identifier: MIT
// From a level and portals to a World: one room, or those that the portals divide it into.
#include <algorithm>
#include <array>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "firma/polygon.h"
#include "firma/rooms.h"
#include "geometry/exact_plane.h"
#include "geometry/polygon_shape.h"
#include "level/divide_mesh.h"
#include "level/level_matters.h"
#include "level/level_textures.h"
#include "solid/append_faces.h"
#include "world/assemble_world.h"

namespace firma {
namespace {

class WorldMaker {
public:
    WorldMaker(const Level& level, std::span<const LevelPortal> portals, const DividedMesh& divided, bool rock_outside,
               const WorldOptions& options)
        : level_(level),
          portals_(portals),
          divided_(divided),
          face_maker_(divided.tables, divided.faces, divided.arrangement, divided.facets) {
        parts_.name = level.name;
        parts_.options = options;
        parts_.materials = level.materials;
        if (parts_.materials.empty()) parts_.materials.emplace_back();  // as make_world() does
        parts_.rock_outside = rock_outside;
        parts_.textures = textures_of(level);
        parts_.rooms.resize(divided.rooms.count);
        if (!rock_outside) {
            parts_.rooms.back().exterior = true;
            parts_.rooms.back().name = "exterior";
        }
        add_faces();
        for (const LooseFacet& facet : divided_.loose) {
            FaceSet::Entry face = entry_of(facet.source);
            face.two_sided = facet.two_sided;
            add_facet(facet.room, facet.corners, face);
        }
    }

    /// @param idle  gets the portals that have one room on both sides, or parts that do
    void add_portals(std::vector<std::uint32_t>& idle) {
        const std::size_t faces = divided_.faces.size();
        std::map<std::array<std::uint32_t, 3>, PortalPart> made;  // by portal and rooms
        // Portals have none: that without a name, which a mesh's materials may lack.
        const auto unnamed = std::find(parts_.materials.begin(), parts_.materials.end(), "");
        const std::uint32_t no_material = std::uint32_t(unnamed - parts_.materials.begin());
        if (unnamed == parts_.materials.end() && !divided_.portals.empty()) parts_.materials.emplace_back();
        for (std::uint32_t k = 0; k < divided_.portals.size(); ++k) {
            const std::uint32_t front = divided_.rooms.of_side[faces + 2 * k],
                                back = divided_.rooms.of_side[faces + 2 * k + 1], source = divided_.portals[k].source;
            if (front == back) {
                idle.push_back(source);
                continue;
            }
            PortalPart& part = made[{source, front, back}];
            part.rooms = {RoomId{front}, RoomId{back}};
            part.name = portals_[source].name;
            part.material = no_material;
            const Ref<const SolidFace> exact =
                face_maker_.make_portal(std::uint32_t(faces + k), divided_.portals[k].piece.plane);
            for (std::uint32_t f = divided_.facets.first[faces + k]; f < divided_.facets.first[faces + k + 1]; ++f) {
                part.polygons.push_back(divided_.facets.corners[f]);
                part.exact.push_back(exact);
            }
        }
        std::sort(idle.begin(), idle.end());
        idle.erase(std::unique(idle.begin(), idle.end()), idle.end());
        for (auto& [key, part] : made) parts_.portals.push_back(std::move(part));
    }

    WorldParts take() { return std::move(parts_); }

private:
    FaceSet::Entry entry_of(std::uint32_t index) const {
        const LevelFace& from = level_.faces[index];
        FaceSet::Entry face;
        face.source = from.source;
        face.material = from.material;
        face.mask = from.mask;
        return face;
    }

    void add_facet(std::uint32_t room, std::span<const GridPoint> corners, FaceSet::Entry face) {
        face.id = {next_face_++};
        firma::add_facet(parts_.rooms[room].faces, corners, face);
    }

    void add_faces() {
        for (std::uint32_t k = 0; k < divided_.faces.size(); ++k) {
            const std::uint32_t room = divided_.rooms.of_side[k];
            const Ref<const SolidFace> exact = face_maker_.make(k);
            if (exact) parts_.rooms[room].faces.owners.emplace_back(exact.get());
            FaceSet::Entry face = entry_of(divided_.faces[k].source);
            face.solid = true;
            face.owner = exact.get();
            for (std::uint32_t f = divided_.facets.first[k]; f < divided_.facets.first[k + 1]; ++f)
                add_facet(room, divided_.facets.corners[f], face);
        }
    }

    const Level& level_;
    const std::span<const LevelPortal> portals_;
    const DividedMesh& divided_;
    JoinFaceMaker face_maker_;
    WorldParts parts_;
    std::uint32_t next_face_ = 0;
};

std::optional<Error> judge_portals(std::span<const LevelPortal> portals, const std::string& name) {
    for (std::size_t k = 0; k < portals.size(); ++k)
        for (const std::vector<GridPoint>& polygon : portals[k].polygons) {
            const bool on_grid = std::all_of(polygon.begin(), polygon.end(), on_input_grid);
            std::vector<Vec3> corners;
            for (const GridPoint& point : polygon) corners.push_back(to_metres(point));
            if (on_grid && corners.size() <= std::size_t(kMaxCorners) && check_polygon(corners) == PolygonFault::kNone)
                continue;
            const std::string place = "portal " + std::to_string(k);
            return Error{ErrorCode::kInvalid, name.empty() ? place : name + ": " + place,
                         "a polygon of it is not convex and planar, of 3 to 64 corners on the input grid"};
        }
    return std::nullopt;
}

bool is_on_input_grid(const Level& level) {
    for (const LevelFace& face : level.faces)
        for (std::uint32_t k = 0; k < face.corner_count; ++k)
            if (!on_input_grid(level.vertices[level.corners[face.first_corner + k]])) return false;
    return true;
}

}  // namespace

Result<World> make_divided_world(const Level& level, std::span<const LevelPortal> portals, const WorldOptions& options,
                                 PortalReport* report) {
    PortalReport own;
    PortalReport& made = report ? *report : own;
    made = {};
    Result<World> plain = make_world(level, options);
    if (!plain || portals.empty()) return plain;
    if (auto error = judge_portals(portals, level.name)) return *std::move(error);
    const auto undivided = [&](std::string why) {
        made.undivided = std::move(why);
        return plain;
    };
    if (!is_on_input_grid(level)) return undivided("a corner of its faces is not on the input grid");
    const LevelSolids solids = find_solids(level);
    if (std::find(solids.solid.begin(), solids.solid.end(), true) == solids.solid.end())
        return undivided("none of its faces bounds a solid");
    const std::unique_ptr<DividedMesh> divided = divide_mesh(level, portals, solids, plain.value());
    if (!divided->fault.empty()) return undivided(divided->fault);
    WorldMaker maker(level, portals, *divided, solids.rock_outside, options);
    maker.add_portals(made.idle);
    WorldParts parts = maker.take();
    parts.matters = matters_of_level(level, solids, options.matters ? *options.matters : default_matters());
    return assemble_world(std::move(parts));
}

}  // namespace firma
