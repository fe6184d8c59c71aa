// SPDX-License-Identifier: MIT
// From a glTF level to a World: one room, or those that its portals divide it into.
#include <algorithm>
#include <map>
#include <optional>
#include <string>
#include <utility>

#include "firma/polygon.h"
#include "firma/read_gltf.h"
#include "geometry/exact_plane.h"
#include "geometry/polygon_shape.h"
#include "gltf/divide_mesh.h"
#include "world/assemble_world.h"

namespace firma {
namespace {

class WorldMaker {
public:
    WorldMaker(const GltfLevel& gltf, gltf::DividedMesh& divided, bool rock_outside, const WorldOptions& options)
        : gltf_(gltf), divided_(divided) {
        parts_.name = gltf.level.name;
        parts_.options = options;
        parts_.materials = gltf.level.materials;
        parts_.rock_outside = rock_outside;
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
        for (std::uint32_t k = 0; k < divided_.portals.size(); ++k) {
            const std::uint32_t front = divided_.rooms.of_side[faces + 2 * k],
                                back = divided_.rooms.of_side[faces + 2 * k + 1], source = divided_.portals[k].source;
            if (front == back) {
                if (idle.empty() || idle.back() != source) idle.push_back(source);
                continue;
            }
            PortalPart& part = made[{source, front, back}];
            part.rooms = {RoomId{front}, RoomId{back}};
            part.name = gltf_.portals[source].name;
            for (std::uint32_t f = divided_.facets.first[faces + k]; f < divided_.facets.first[faces + k + 1]; ++f)
                part.polygons.push_back(divided_.facets.corners[f]);
        }
        for (auto& [key, part] : made) parts_.portals.push_back(std::move(part));
    }

    WorldParts take() { return std::move(parts_); }

private:
    FaceSet::Entry entry_of(std::uint32_t index) const {
        const LevelFace& from = gltf_.level.faces[index];
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
        JoinFaceMaker maker(divided_.tables, divided_.faces, divided_.arrangement, divided_.facets);
        for (std::uint32_t k = 0; k < divided_.faces.size(); ++k) {
            const std::uint32_t room = divided_.rooms.of_side[k];
            const Ref<const SolidFace> exact = maker.make(k);
            if (exact) parts_.rooms[room].faces.owners.emplace_back(exact.get());
            FaceSet::Entry face = entry_of(divided_.faces[k].source);
            face.solid = true;
            face.owner = exact.get();
            for (std::uint32_t f = divided_.facets.first[k]; f < divided_.facets.first[k + 1]; ++f)
                add_facet(room, divided_.facets.corners[f], face);
        }
    }

    const GltfLevel& gltf_;
    gltf::DividedMesh& divided_;
    WorldParts parts_;
    std::uint32_t next_face_ = 0;
};

std::optional<Error> judge_portals(const GltfLevel& gltf) {
    for (std::size_t k = 0; k < gltf.portals.size(); ++k)
        for (const std::vector<GridPoint>& polygon : gltf.portals[k].polygons) {
            const bool on_grid = std::all_of(polygon.begin(), polygon.end(), on_input_grid);
            std::vector<Vec3> corners;
            for (const GridPoint& point : polygon) corners.push_back(to_metres(point));
            if (on_grid && corners.size() <= std::size_t(kMaxCorners) && check_polygon(corners) == PolygonFault::kNone)
                continue;
            const std::string place = "portal " + std::to_string(k);
            return Error{ErrorCode::kInvalid, gltf.level.name.empty() ? place : gltf.level.name + ": " + place,
                         "a polygon of it is not convex and planar, of 3 to 64 corners on the input grid"};
        }
    return std::nullopt;
}

}  // namespace

Result<World> make_world(const GltfLevel& gltf, const WorldOptions& options, GltfRooms* report) {
    Result<World> plain = make_world(gltf.level, options);
    if (!plain || gltf.portals.empty()) return plain;
    if (auto error = judge_portals(gltf)) return *std::move(error);
    GltfRooms own;
    GltfRooms& rooms = report ? *report : own;
    const LevelSolids solids = find_solids(gltf.level);
    if (std::find(solids.solid.begin(), solids.solid.end(), true) == solids.solid.end()) {
        rooms.undivided = "none of its faces bounds a solid";
        return plain;
    }
    const std::unique_ptr<gltf::DividedMesh> divided = gltf::divide_mesh(gltf, solids, plain.value());
    rooms.undivided = divided->fault;
    if (!rooms.undivided.empty()) return plain;
    WorldMaker maker(gltf, *divided, solids.rock_outside, options);
    maker.add_portals(rooms.idle);
    return assemble_world(maker.take());
}

}  // namespace firma
