// SPDX-License-Identifier: MIT
// Puts a cutter that is a Solid into the world.
#include "carve/place_solid.h"

#include <unordered_map>

#include "base/assert.h"
#include "base/point_numbers.h"
#include "carve/cutter_data.h"
#include "carve/gather.h"
#include "solid/solid_data.h"

namespace firma {
namespace {

/// The vertex of a patch at each place; the first of several.
class VertexPlaces {
public:
    explicit VertexPlaces(const SolidPatch& patch) {
        for (std::uint32_t vertex = 0; vertex < patch.vertices.size(); ++vertex)
            if (numbers_.number(patch.vertices[vertex].point.rounded()) == first_.size()) first_.push_back(vertex);
    }
    std::uint32_t at(const GridPoint& corner) {
        const std::uint32_t number = numbers_.number(corner);
        FIRMA_ASSERT(number < first_.size(), "corners of facets are vertices, rounded");
        return first_[number];
    }

private:
    PointNumbers numbers_;
    std::vector<std::uint32_t> first_;
};

/// Each plane once, turned.
class TurnedPlanes {
public:
    TurnedPlanes(const GridTurn& turn, SolidPatch& patch) : turn_(turn), patch_(patch) {}
    const SolidPlane* operator()(const Plane& plane) {
        const SolidPlane*& known = turned_[&plane];
        if (!known) known = patch_.keep(Ref<const SolidPlane>(new SolidPlane(turn_(plane))));
        return known;
    }

private:
    const GridTurn& turn_;
    SolidPatch& patch_;
    std::unordered_map<const Plane*, const SolidPlane*> turned_;  ///< looked up, never walked
};

void turn_boundary(const GridTurn& turn, SolidPatch& patch) {
    TurnedPlanes planes(turn, patch);
    for (PatchVertex& vertex : patch.vertices) {
        vertex.stored = nullptr;
        const ExactPoint before = vertex.point;
        if (before.on_grid()) {
            vertex.point = ExactPoint(to_input(*turn(before.rounded())));
            continue;
        }
        for (int k = 0; k < 3; ++k) vertex.planes[k] = Ref<const SolidPlane>(planes(*before.plane(k)));
        vertex.point = ExactPoint(vertex.planes[0]->plane, vertex.planes[1]->plane, vertex.planes[2]->plane);
    }
    for (PatchEdge& edge : patch.edges) {
        edge.stored = nullptr;
        for (const SolidPlane*& plane : edge.plane) plane = planes(plane->plane);
    }
    for (PatchFace& face : patch.faces) {
        face.plane = planes(face.plane->plane);
        face.stored = nullptr;
        face.box = {};
        for (const PatchUse& use : patch.uses(face)) face.box.add(patch.vertices[patch.from(use)].point.rounded());
    }
}

std::optional<Error> place_exactly(const Solid& solid, const GridTurn& turn, const std::string& name,
                                   CutterSolid& placed) {
    auto made = std::make_unique<TurnedSolid>();
    made->solid = solid;
    made->turn = turn;
    SolidPatch& patch = made->boundary;
    const std::vector<FacetPlace> facets = all_facets(solid.data().faces.root.get());
    patch.add(facets);
    for (std::uint32_t edge = 0; edge < patch.edges.size(); ++edge) patch.settle_planes(edge);
    for (std::uint32_t vertex = 0; vertex < patch.vertices.size(); ++vertex)
        if (!turn(patch.vertices[vertex].point.rounded())) return outside_world(name, vertex);

    placed.placed = {};
    placed.placed.name = name;
    VertexPlaces places(patch);
    for (const FacetPlace& facet : facets) {
        const FaceRecord& record = facet.record();
        for (std::size_t k = 2; k < record.corner_count; ++k) {
            const CutterTriangle triangle{places.at(facet.block->corner(record, 0)),
                                          places.at(facet.block->corner(record, k - 1)),
                                          places.at(facet.block->corner(record, k))};
            placed.placed.triangles.push_back(triangle);
            made->face_of.push_back(patch.find(facet));
        }
    }
    turn_boundary(turn, patch);
    placed.points.clear();
    for (const PatchVertex& vertex : patch.vertices) placed.points.push_back(vertex.point);
    placed.planes.clear();
    placed.edges.clear();
    placed.polygons.clear();
    placed.turned = std::move(made);
    index_triangles(placed);
    return std::nullopt;
}

}  // namespace

std::optional<Error> place_solid(const Cutter& cutter, const Pose& pose, CutterSolid& placed) {
    if (const Result<PoseTurn> turn = judge_pose(cutter, pose); !turn) return turn.error();
    if (const std::optional<GridTurn> turn = grid_turn(pose))
        return place_exactly(*cutter.data()->solid, *turn, cutter.name(), placed);
    const Result<Solid> snapped = snap_solid(cutter, pose);
    if (!snapped) return snapped.error();
    return place_exactly(snapped.value(), {}, cutter.name(), placed);
}

std::optional<Error> place_any_cutter(const Cutter& cutter, const Pose& pose, CutterSolid& placed) {
    if (cutter.valid() && cutter.data()->solid) return place_solid(cutter, pose, placed);
    Result<PlacedCutter> mesh = place_cutter(cutter, pose);
    if (!mesh) return mesh.error();
    make_cutter_solid(std::move(mesh).value(), placed);
    return std::nullopt;
}

}  // namespace firma
