// SPDX-License-Identifier: MIT
// Which faces of a level bound closed solids: pieces are found, then judged; faces on doubled edges get exact ones.
#include "level/find_solids.h"

#include <algorithm>
#include <tuple>

#include "base/flat_map.h"
#include "base/sort.h"
#include "geometry/polygon_shape.h"
#include "level/judge_level.h"

namespace firma {
namespace {

/// Makes the exact faces of those on doubled edges, which their vertices alone do not name.
class FaceStorer {
public:
    FaceStorer(const SolidMesh& mesh, const SolidPieces& pieces) : mesh_(mesh), pieces_(pieces) {}

    std::vector<std::pair<std::uint32_t, Ref<const SolidFace>>> store() {
        std::vector<std::uint32_t> faces;
        for (std::uint32_t k = 0; k < pieces_.doubled.size(); ++k) {
            const DoubledEdge& edge = pieces_.doubled[k];
            if (!pieces_.good(edge.upward)) continue;
            for (const std::uint32_t face : {edge.upward, edge.downward}) {
                faces.push_back(face);
                doubled_of_.push_back({edge.low, edge.high, face, k});
            }
        }
        sort_range(faces);
        faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
        sort_range(doubled_of_);
        doubled_.resize(pieces_.doubled.size());
        std::vector<std::pair<std::uint32_t, Ref<const SolidFace>>> stored;
        for (const std::uint32_t face : faces) stored.emplace_back(face, make(face));
        return stored;
    }

private:
    using Use = std::tuple<std::uint32_t, std::uint32_t, std::uint32_t, std::uint32_t>;  // low, high, face, number

    Ref<const SolidFace> make(std::uint32_t face) {
        Ref<SolidFace> made(new SolidFace);
        made->plane = plane(face);
        const auto corners = mesh_.corners(face);
        for (std::size_t k = 0; k < corners.size(); ++k) {
            const std::uint32_t from = corners[k], to = corners[k + 1 < corners.size() ? k + 1 : 0];
            made->uses.emplace_back(edge(std::min(from, to), std::max(from, to), face), to < from);
            made->box.add(to_surface(mesh_.points[from]));
        }
        const auto end = std::uint32_t(corners.size());
        made->set_loop_ends({&end, 1});
        std::vector<Vec3> metres;  // the normal to the bit as a face without an owner has it
        for (const std::uint32_t corner : corners) metres.push_back(to_metres(to_surface(mesh_.points[corner])));
        made->normal = make_shape(metres).unit_normal();
        made->set_hash();
        return Ref<const SolidFace>(made.get());
    }

    const Ref<const SolidPlane>& plane(std::uint32_t face) {
        std::uint32_t& known = plane_of_.at(face);
        if (known == FlatMap::kNone) {
            known = std::uint32_t(planes_.size());
            const auto corners = mesh_.corners(face);
            Plane plane;
            for (std::size_t k = 2; k < corners.size() && !plane.valid(); ++k)
                plane = plane_through(mesh_.points[corners[0]], mesh_.points[corners[k - 1]], mesh_.points[corners[k]]);
            planes_.push_back(Ref<const SolidPlane>(new SolidPlane(plane)));
        }
        return planes_[known];
    }

    const Ref<const SolidVertex>& vertex(std::uint32_t point) {
        std::uint32_t& known = vertex_of_.at(point);
        if (known == FlatMap::kNone) {
            known = std::uint32_t(vertices_.size());
            vertices_.push_back(Ref<const SolidVertex>(new SolidVertex(mesh_.points[point])));
        }
        return vertices_[known];
    }

    Ref<const SolidEdge> edge(std::uint32_t low, std::uint32_t high, std::uint32_t face) {
        const auto it = std::lower_bound(doubled_of_.begin(), doubled_of_.end(), Use{low, high, face, 0});
        if (it != doubled_of_.end() && std::get<0>(*it) == low && std::get<1>(*it) == high &&
            std::get<2>(*it) == face) {
            const std::uint32_t number = std::get<3>(*it);
            const DoubledEdge& doubled = pieces_.doubled[number];
            if (!doubled_[number]) doubled_[number] = make_edge(low, high, doubled.upward, doubled.downward, true);
            return doubled_[number];
        }
        const auto use =
            std::lower_bound(mesh_.sides.begin(), mesh_.sides.end(), std::tie(low, high),
                             [](const EdgeSide& a, const std::tuple<const std::uint32_t&, const std::uint32_t&>& key) {
                                 return std::tie(a.low, a.high) < key;
                             });
        std::uint32_t& known = edge_of_.at(std::uint64_t(use - mesh_.sides.begin()));
        if (known == FlatMap::kNone) {
            known = std::uint32_t(edges_.size());
            edges_.push_back(make_edge(low, high, use[0].owner, use[1].owner, false));
        }
        return edges_[known];
    }

    Ref<const SolidEdge> make_edge(std::uint32_t low, std::uint32_t high, std::uint32_t one, std::uint32_t other,
                                   bool doubled) {
        Ref<SolidEdge> made(new SolidEdge);
        made->vertex[0] = vertex(low);
        made->vertex[1] = vertex(high);
        made->plane[0] = plane(one);
        const Ref<const SolidPlane> second = plane(other);
        made->plane[1] = exact_parallel(made->plane[0]->plane, second->plane)
                             ? Ref<const SolidPlane>(new SolidPlane(
                                   edge_plane(mesh_.points[low], mesh_.points[high], made->plane[0]->plane)))
                             : second;
        made->doubled = doubled;
        return Ref<const SolidEdge>(made.get());
    }

    const SolidMesh& mesh_;
    const SolidPieces& pieces_;
    std::vector<Use> doubled_of_;
    std::vector<Ref<const SolidEdge>> doubled_, edges_;
    std::vector<Ref<const SolidPlane>> planes_;
    std::vector<Ref<const SolidVertex>> vertices_;
    FlatMap plane_of_, vertex_of_, edge_of_;
};

}  // namespace

LevelSolids find_solids(const Level& level) {
    LevelSolids found;
    if (level.faces.empty()) return found;
    const SolidMesh mesh = solid_mesh(level);
    SolidPieces pieces = join_pieces(mesh);
    const FaceTree tree = good_faces(mesh, pieces);
    refuse_crossing(mesh, tree, pieces);
    found.rock_outside = refuse_wrong_way(mesh, tree, pieces);
    found.work = pieces.work;
    found.solid.resize(level.faces.size());
    for (std::uint32_t face = 0; face < level.faces.size(); ++face) found.solid[face] = pieces.good(face);
    found.stored = FaceStorer(mesh, pieces).store();
    found.piece = std::move(pieces.of_face);
    for (SolidPieces::Piece& piece : pieces.pieces) {
        if (!piece.note) continue;
        found.notes.push_back(*piece.note);
        found.notes.back().faces = piece.faces;
    }
    return found;
}

LevelSolidity level_solidity(const Level& level) {
    if (judge_level(level, level.name)) return {};
    LevelSolids found = find_solids(level);
    LevelSolidity solidity;
    solidity.solid_faces = std::size_t(std::count(found.solid.begin(), found.solid.end(), true));
    solidity.rock_outside = found.rock_outside;
    solidity.notes = std::move(found.notes);
    return solidity;
}

}  // namespace firma
