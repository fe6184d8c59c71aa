// SPDX-License-Identifier: MIT
// Part of a solid's boundary, taken out of blocks to be worked on.
#include "solid/solid_patch.h"

#include "base/fetch_ahead.h"

namespace firma {
namespace {

std::uint64_t key_of(const void* object, std::uint64_t tag) {
    return reinterpret_cast<std::uintptr_t>(object) ^ (tag << 56);  // addresses leave the top byte alone
}
constexpr std::uint64_t kWhole = 255;  // blocks have no such slot

/// Faces, their edges and vertices lie scattered: asks for all of a kind before the first is needed.
void fetch_faces_ahead(std::span<const FacetPlace> facets) {
    std::vector<const SolidFace*> faces;
    faces.reserve(facets.size());
    for (const FacetPlace& facet : facets) {
        const auto* face = static_cast<const SolidFace*>(facet.block->owner_of(facet.record()));
        if (!face || (!faces.empty() && faces.back() == face)) continue;
        fetch_ahead(face);
        fetch_ahead(&face->uses);
        faces.push_back(face);
    }
    constexpr std::size_t kUsesOfALine = 8;
    for (const SolidFace* face : faces) {
        fetch_ahead(face->plane.get());
        for (std::size_t k = 0; k < face->uses.size(); k += kUsesOfALine) fetch_ahead(face->uses.data() + k);
    }
    for (const SolidFace* face : faces)
        for (const SolidUse& use : face->uses) fetch_ahead(&use.edge());
    for (const SolidFace* face : faces)
        for (const SolidUse& use : face->uses) {
            fetch_ahead(&use.from());  // each is the start of some use
        }
}

}  // namespace

void SolidPatch::clear() {
    vertices.clear();
    edges.clear();
    faces.clear();
    all_uses.clear();
    loop_ends.clear();
    kept_planes_.clear();
    for (FlatMap* map : {&face_of_, &vertex_of_point_, &vertex_of_place_, &edge_of_pair_, &edge_of_stored_})
        map->clear();
}

std::uint32_t SolidPatch::find(const FacetPlace& facet) const {
    const FaceOwner* owner = facet.block->owner_of(facet.record());
    return face_of_.find(owner ? key_of(owner, kWhole) : key_of(facet.block, facet.slot));
}

std::uint32_t SolidPatch::find_grid_vertex(const InputPoint& point) const {
    for (std::uint64_t key = point_key(point);; key = next_key(key)) {
        const std::uint32_t known = vertex_of_point_.find(key);
        if (known == FlatMap::kNone || vertices[known].point.grid() == point) return known;
    }
}

std::optional<PatchUse> SolidPatch::find(const InputPoint& from, const InputPoint& to) const {
    const std::uint32_t a = find_grid_vertex(from), b = find_grid_vertex(to);
    if (a == FlatMap::kNone || b == FlatMap::kNone) return {};
    const std::uint64_t low = a < b ? a : b, high = a < b ? b : a;
    const std::uint32_t edge = edge_of_pair_.find(low << 32 | high);
    if (edge == FlatMap::kNone) return {};
    return PatchUse{edge, edges[edge].vertex[0] != a};
}

std::optional<PatchUse> SolidPatch::find(const SolidUse& use) const {
    const SolidEdge& stored = use.edge();
    const ExactPoint &from = use.from().point, &to = stored.vertex[!use.reversed()]->point;
    if (from.on_grid() && to.on_grid() && !stored.doubled) return find(from.grid(), to.grid());
    const std::uint32_t edge = edge_of_stored_.find(key_of(&stored, 0));
    if (edge == FlatMap::kNone) return {};
    return PatchUse{edge, use.reversed()};
}

std::uint32_t SolidPatch::add(const FacetPlace& facet) {
    const FaceOwner* owner = facet.block->owner_of(facet.record());
    std::uint32_t& known = face_of_.at(owner ? key_of(owner, kWhole) : key_of(facet.block, facet.slot));
    if (known != FlatMap::kNone) return known;
    known = std::uint32_t(faces.size());
    return owner ? add_stored(facet, static_cast<const SolidFace&>(*owner)) : add_untouched(facet);
}

void SolidPatch::reserve(std::size_t face_count) {
    faces.reserve(face_count);
    vertices.reserve(2 * face_count);
    edges.reserve(3 * face_count);
    all_uses.reserve(4 * face_count);
    face_of_.reserve(face_count);
    for (FlatMap* map : {&vertex_of_point_, &vertex_of_place_, &edge_of_pair_, &edge_of_stored_})
        map->reserve(face_count);
}

void SolidPatch::add(std::span<const FacetPlace> facets) {
    fetch_faces_ahead(facets);
    reserve(facets.size());
    for (const FacetPlace& facet : facets) add(facet);
}

std::uint32_t SolidPatch::grid_vertex(const InputPoint& point) {
    for (std::uint64_t key = point_key(point);; key = next_key(key)) {
        std::uint32_t& known = vertex_of_point_.at(key);
        if (known == FlatMap::kNone) {
            known = std::uint32_t(vertices.size());
            vertices.push_back({ExactPoint(point), {}, {}});
            return known;
        }
        if (vertices[known].point.grid() == point) return known;
    }
}

namespace {

bool is_point(const ExactPoint& point, const ExactPoint& of_planes) {
    for (int k = 0; k < 3; ++k)
        if (exact_side(*of_planes.plane(k), point) != 0) return false;
    return true;
}

}  // namespace

/// Cuts may have stored one point as several vertices, some of them as three planes that meet in a point of the grid.
std::uint32_t SolidPatch::stored_vertex(const SolidVertex& vertex) {
    const ExactPoint& point = vertex.point;
    const GridPoint place = point.rounded();
    if (on_input_grid(place) && (point.on_grid() || is_point(ExactPoint(to_input(place)), point))) {
        const std::uint32_t known = grid_vertex(to_input(place));
        if (!vertices[known].stored) vertices[known].stored = &vertex;
        return known;
    }
    for (std::uint64_t key = point_key(place);; key = next_key(key)) {
        std::uint32_t& known = vertex_of_place_.at(key);
        if (known == FlatMap::kNone) {
            known = std::uint32_t(vertices.size());
            vertices.push_back({point, &vertex, {}});
            return known;
        }
        const PatchVertex& other = vertices[known];
        if (other.stored == &vertex || (other.point.rounded() == place && is_point(other.point, point))) return known;
    }
}

std::uint32_t SolidPatch::edge_between(std::uint32_t a, std::uint32_t b) {
    const std::uint64_t low = a < b ? a : b, high = a < b ? b : a;
    std::uint32_t& known = edge_of_pair_.at(low << 32 | high);
    if (known == FlatMap::kNone) {
        known = std::uint32_t(edges.size());
        PatchEdge edge;
        edge.vertex[0] = a;
        edge.vertex[1] = b;
        edges.push_back(std::move(edge));
    }
    return known;
}

PatchUse SolidPatch::stored_edge(const SolidUse& use) {
    const SolidEdge& stored = use.edge();
    // An edge of the grid may have a neighbour that no cut has touched: the two vertices say which edge it is.
    if (stored.vertex[0]->point.on_grid() && stored.vertex[1]->point.on_grid() && !stored.doubled) {
        const std::uint32_t a = stored_vertex(*stored.vertex[0]), b = stored_vertex(*stored.vertex[1]);
        const std::uint32_t edge = edge_between(a, b);
        PatchEdge& it = edges[edge];
        if (!it.stored) {
            it.stored = &stored;
            it.plane[0] = stored.plane[0].get();
            it.plane[1] = stored.plane[1].get();
        }
        return {edge, (it.vertex[0] == a) == use.reversed()};
    }
    std::uint32_t& known = edge_of_stored_.at(key_of(&stored, 0));
    if (known == FlatMap::kNone) {
        known = std::uint32_t(edges.size());
        PatchEdge edge;
        edge.vertex[0] = stored_vertex(*stored.vertex[0]);
        edge.vertex[1] = stored_vertex(*stored.vertex[1]);
        edge.plane[0] = stored.plane[0].get();
        edge.plane[1] = stored.plane[1].get();
        edge.stored = &stored;
        edge.doubled = stored.doubled;
        edges.push_back(std::move(edge));
    }
    return {known, use.reversed()};
}

void SolidPatch::finish(std::uint32_t index) {
    PatchFace& face = faces[index];
    face.use_count = std::uint32_t(all_uses.size()) - face.first_use;
    face.loop_count = std::uint32_t(loop_ends.size()) - face.first_loop;
    for (const PatchUse& use : uses(face)) {
        edges[use.edge].face[use.reversed] = index;
        face.box.add(vertices[from(use)].point.rounded());
    }
}

std::uint32_t SolidPatch::add_untouched(const FacetPlace& facet) {
    const FaceRecord& record = facet.record();
    const std::uint32_t index = std::uint32_t(faces.size());
    faces.emplace_back();
    faces[index].facet = facet;
    faces[index].first_use = std::uint32_t(all_uses.size());
    faces[index].first_loop = std::uint32_t(loop_ends.size());

    const std::size_t corners = record.corner_count;
    const auto corner = [&](std::size_t k) { return to_input(facet.block->corner(record, k)); };
    Plane plane;
    for (std::size_t k = 2; k < corners && !plane.valid(); ++k)  // the first ones may lie on a line
        plane = plane_through(corner(0), corner(k - 1), corner(k));
    faces[index].plane = keep(Ref<const SolidPlane>(new SolidPlane(plane)));

    const std::uint32_t first = grid_vertex(corner(0));
    std::uint32_t last = first;
    for (std::size_t k = 1; k <= corners; ++k) {
        const std::uint32_t next = k < corners ? grid_vertex(corner(k)) : first;
        const std::uint32_t edge = edge_between(last, next);
        all_uses.push_back({edge, edges[edge].vertex[0] != last});
        last = next;
    }
    loop_ends.push_back(std::uint32_t(corners));
    finish(index);
    return index;
}

std::uint32_t SolidPatch::add_stored(const FacetPlace& facet, const SolidFace& stored) {
    const std::uint32_t index = std::uint32_t(faces.size());
    faces.emplace_back();
    faces[index].facet = facet;
    faces[index].stored = &stored;
    faces[index].plane = stored.plane.get();
    faces[index].first_use = std::uint32_t(all_uses.size());
    faces[index].first_loop = std::uint32_t(loop_ends.size());
    for (const SolidUse& use : stored.uses) all_uses.push_back(stored_edge(use));
    loop_ends.insert(loop_ends.end(), stored.loop_ends().begin(), stored.loop_ends().end());
    finish(index);
    return index;
}

std::uint32_t SolidPatch::add_piece(std::uint32_t parent, std::span<const PatchUse> uses_of_piece,
                                    std::span<const std::uint32_t> ends_of_piece) {
    const std::uint32_t index = std::uint32_t(faces.size());
    PatchFace piece;
    piece.plane = faces[parent].plane;
    piece.facet = faces[parent].facet;
    piece.parent = parent;
    piece.first_use = std::uint32_t(all_uses.size());
    piece.first_loop = std::uint32_t(loop_ends.size());
    faces.push_back(std::move(piece));
    all_uses.insert(all_uses.end(), uses_of_piece.begin(), uses_of_piece.end());
    loop_ends.insert(loop_ends.end(), ends_of_piece.begin(), ends_of_piece.end());
    finish(index);
    return index;
}

LineDirection SolidPatch::direction_of(std::uint32_t index) const {
    const PatchEdge& edge = edges[index];
    const ExactPoint &a = vertices[edge.vertex[0]].point, &b = vertices[edge.vertex[1]].point;
    if (a.on_grid() && b.on_grid()) return LineDirection::along(a.rounded(), b.rounded());
    return LineDirection::of(edge.plane[0]->plane, edge.plane[1]->plane);
}

void SolidPatch::settle_planes(std::uint32_t index) {
    PatchEdge& edge = edges[index];
    if (edge.plane[0]) return;
    for (const std::uint32_t face : edge.face) {
        if (face == ~0u) continue;
        const SolidPlane* plane = faces[face].plane;
        if (!edge.plane[0])
            edge.plane[0] = plane;
        else if (!exact_parallel(edge.plane[0]->plane, plane->plane))
            edge.plane[1] = plane;
    }
    if (edge.plane[1]) return;
    const InputPoint a = vertices[edge.vertex[0]].point.grid();
    const InputPoint b = vertices[edge.vertex[1]].point.grid();
    edge.plane[1] = keep(Ref<const SolidPlane>(new SolidPlane(edge_plane(a, b, edge.plane[0]->plane))));
}

}  // namespace firma
