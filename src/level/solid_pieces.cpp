// SPDX-License-Identifier: MIT
// Positions, edges, pieces; and which pieces cross.
#include "level/solid_pieces.h"

#include <algorithm>

#include "base/disjoint_sets.h"
#include "base/flat_map.h"
#include "level/pair_edges.h"
#include "level/slab_tree.h"

namespace firma {
namespace {

/// A number for each vertex's position, by the first vertex there; ascending with it.
std::vector<std::uint32_t> number_positions(const std::vector<GridPoint>& vertices, std::vector<InputPoint>& points) {
    FlatMap vertex_at;  // the first one
    vertex_at.reserve(vertices.size());
    std::vector<std::uint32_t> number(vertices.size());
    points.reserve(vertices.size());
    for (std::uint32_t v = 0; v < vertices.size(); ++v) {
        for (std::uint64_t key = point_key(vertices[v]);; key = next_key(key)) {
            std::uint32_t& first = vertex_at.at(key);
            if (first == FlatMap::kNone) {
                first = v;
                number[v] = std::uint32_t(points.size());
                points.push_back(to_input(vertices[v]));
                break;
            }
            if (vertices[first] != vertices[v]) continue;
            number[v] = number[first];
            break;
        }
    }
    return number;
}

/// A corner off the line of a side; any does.
std::uint32_t apex_of(const SolidMesh& mesh, const EdgeSide& side) {
    const InputPoint &a = mesh.points[side.low], &b = mesh.points[side.high];
    for (const std::uint32_t corner : mesh.corners(side.owner)) {
        const AreaVector n = area_vector(a, b, mesh.points[corner]);
        if (n.x != 0 || n.y != 0 || n.z != 0) return corner;
    }
    return side.low;
}

class PieceJoiner {
public:
    explicit PieceJoiner(const SolidMesh& mesh) : mesh_(mesh), sets_(mesh.level->faces.size()) {}

    SolidPieces join() {
        for_each_edge(mesh_.sides, [&](std::span<const EdgeSide> sides) { join_edge(sides); });
        number_pieces();
        for (const auto& [face, note] : faults_) found_.refuse(found_.of_face[face], note);
        for (std::uint32_t face = 0; face < mesh_.level->faces.size(); ++face) check_face(face);
        return std::move(found_);
    }

private:
    void join_edge(std::span<const EdgeSide> sides) {
        int balance = 0;
        for (const EdgeSide& side : sides) balance += side.upward ? 1 : -1;
        if (balance == 0 && sides.size() == 2) return sets_.join(sides[0].owner, sides[1].owner);
        if (balance == 0 && join_doubled(sides)) return;
        for (const EdgeSide& side : sides) sets_.join(sides[0].owner, side.owner);
        const EdgeSide& shown = sides[0];
        const std::uint32_t from = shown.upward ? shown.low : shown.high, to = shown.upward ? shown.high : shown.low;
        faults_.emplace_back(
            shown.owner, SolidNote{balance == 0 ? SolidNoteKind::kFoldedEdge : SolidNoteKind::kOpenEdge, 0,
                                   mesh_.level->faces[shown.owner].source, 0, mesh_.metres(from), mesh_.metres(to)});
    }

    bool join_doubled(std::span<const EdgeSide> sides) {
        apexes_.clear();
        for (const EdgeSide& side : sides) apexes_.push_back(apex_of(mesh_, side));
        const auto pairs = pair_sides(mesh_.points, sides, apexes_);
        for (const auto& [up, down] : pairs) {
            sets_.join(sides[up].owner, sides[down].owner);
            found_.doubled.push_back({sides[0].low, sides[0].high, sides[up].owner, sides[down].owner});
        }
        return !pairs.empty();
    }

    void number_pieces() {
        const std::size_t count = mesh_.level->faces.size();
        found_.of_face.resize(count);
        for (std::uint32_t face = 0; face < count; ++face) {
            const std::uint32_t first = sets_.find(face);
            if (first == face) {
                found_.of_face[face] = std::uint32_t(found_.pieces.size());
                found_.pieces.push_back({face, 0, {}});
            } else {
                found_.of_face[face] = found_.of_face[first];
            }
            ++found_.pieces[found_.of_face[face]].faces;
        }
    }

    void check_face(std::uint32_t index) {
        const LevelFace& face = mesh_.level->faces[index];
        const auto refuse = [&](SolidNoteKind what, const GridPoint& at) {
            found_.refuse(found_.of_face[index], {what, 0, face.source, 0, to_metres(at), to_metres(at)});
        };
        for (std::uint32_t c = 0; c < face.corner_count; ++c) {
            const GridPoint& at = mesh_.level->vertices[mesh_.level->corners[face.first_corner + c]];
            if (face.two_sided) return refuse(SolidNoteKind::kTwoSided, at);
            if (!on_input_grid(at)) return refuse(SolidNoteKind::kOffGrid, at);
        }
    }

    const SolidMesh& mesh_;
    DisjointSets sets_;
    SolidPieces found_;
    std::vector<std::pair<std::uint32_t, SolidNote>> faults_;  ///< with a face of the piece
    std::vector<std::uint32_t> apexes_;
};

/// Asks all pairs of faces of good pieces that may cross.
class PairJudge {
public:
    PairJudge(const SolidMesh& mesh, const FaceTree& good, SolidPieces& pieces)
        : mesh_(mesh), good_(good), pieces_(pieces) {
        polygons_.reserve(good.faces.size());
        for (const std::uint32_t face : good.faces) polygons_.push_back(mesh.polygon(face));
    }

    /// By boxes, which nearly always do.
    /// @return false when they leave too many pairs
    bool with_boxes() {
        const std::uint64_t most = pieces_.limits.pairs_with_boxes * (good_.faces.size() + 1024);
        return !good_.tree.for_each_pair([&](std::uint32_t number, std::uint32_t other) {
            judge(number, other);
            return pieces_.work.pairs > most;
        });
    }

    void with_slabs() {
        const SlabTree slabs(mesh_.points, polygons_);
        SolidWork& work = pieces_.work;
        const std::uint64_t most = pieces_.limits.most(good_.faces.size());
        for (std::uint32_t place = 0; place < slabs.order().size(); ++place) {
            const std::uint32_t number = slabs.order()[place];
            // A pair is found from the lower number: whoever is not asked any more must not be carved.
            if (work.of_pairs() > most)
                refuse(number, number, SolidNoteKind::kTooComplex);
            else
                work.compared += slabs.for_each_meeting(place, [&](std::uint32_t other) {
                    if (other > number) judge(number, other);
                });
        }
    }

private:
    void judge(std::uint32_t number, std::uint32_t other) {
        if (!pieces_.good(good_.faces[number]) && !pieces_.good(good_.faces[other])) return;
        ++pieces_.work.pairs;
        if (!polygons_cross(mesh_.points, polygons_[number], polygons_[other])) return;
        refuse(number, other, SolidNoteKind::kCrossing);
        refuse(other, number, SolidNoteKind::kCrossing);
    }

    void refuse(std::uint32_t number, std::uint32_t other, SolidNoteKind what) {
        const std::uint32_t face = good_.faces[number];
        const Vec3 at = mesh_.metres(mesh_.corners(face)[0]);
        const auto& faces = mesh_.level->faces;
        pieces_.refuse(pieces_.of_face[face], {what, 0, faces[face].source, faces[good_.faces[other]].source, at, at});
    }

    const SolidMesh& mesh_;
    const FaceTree& good_;
    SolidPieces& pieces_;
    std::vector<MeshPolygon> polygons_;
};

}  // namespace

SolidMesh solid_mesh(const Level& level) {
    SolidMesh mesh;
    mesh.level = &level;
    const std::vector<std::uint32_t> number = number_positions(level.vertices, mesh.points);
    mesh.corner_point.reserve(level.corners.size());
    for (const std::uint32_t vertex : level.corners) mesh.corner_point.push_back(number[vertex]);
    mesh.sides.reserve(level.corners.size());
    for (std::uint32_t face = 0; face < level.faces.size(); ++face) {
        const auto corners = mesh.corners(face);
        std::uint32_t last = corners.back();
        for (const std::uint32_t next : corners) {
            mesh.sides.emplace_back(last, next, face);
            last = next;
        }
    }
    sort_sides(mesh.sides, mesh.points.size());
    return mesh;
}

SolidPieces join_pieces(const SolidMesh& mesh) {
    return PieceJoiner(mesh).join();
}

FaceTree good_faces(const SolidMesh& mesh, const SolidPieces& pieces) {
    FaceTree good;
    std::vector<GridBox> boxes;
    for (std::uint32_t face = 0; face < mesh.level->faces.size(); ++face) {
        if (!pieces.good(face)) continue;
        good.faces.push_back(face);
        boxes.emplace_back();
        for (const std::uint32_t corner : mesh.corners(face)) boxes.back().add(to_surface(mesh.points[corner]));
    }
    good.tree = BoxTree(boxes);
    return good;
}

void refuse_crossing(const SolidMesh& mesh, const FaceTree& tree, SolidPieces& pieces) {
    PairJudge judge(mesh, tree, pieces);
    if (!judge.with_boxes()) judge.with_slabs();
}

}  // namespace firma
