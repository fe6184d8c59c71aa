// SPDX-License-Identifier: MIT
// Whether a mesh is closed, and whom to blame where it is not.
#include <algorithm>
#include <tuple>

#include "base/edge_sides.h"
#include "level/check_mesh_parts.h"
#include "level/find_t_joints.h"

namespace firma {
namespace {

constexpr std::uint32_t kNone = ~0u;

/// The corner after another one of the same face.
std::uint32_t corner_after(const ExactMesh::Face& face, std::uint32_t corner) {
    return corner + 1 < face.first_corner + face.corner_count ? corner + 1 : face.first_corner;
}

/// Of all faces; their owners are the corners where they begin. One without length belongs to no edge.
std::vector<EdgeSide> sides_of(const ExactMesh& mesh, const WeldedPositions& welded) {
    std::vector<EdgeSide> sides;
    sides.reserve(mesh.corners.size());
    for (const ExactMesh::Face& face : mesh.faces)
        for (std::uint32_t corner = face.first_corner; corner < face.first_corner + face.corner_count; ++corner) {
            const std::uint32_t from = welded.of_corner[corner];
            const std::uint32_t to = welded.of_corner[corner_after(face, corner)];
            if (from != to) sides.emplace_back(from, to, corner);
        }
    sort_sides(sides, welded.size());
    return sides;
}

class EdgeChecker {
public:
    EdgeChecker(const ExactMesh& mesh, const WeldedPositions& welded)
        : mesh_(mesh), welded_(welded), sides_(sides_of(mesh, welded)), face_of_(mesh.corners.size()) {
        for (std::uint32_t face = 0; face < mesh.faces.size(); ++face)
            for (std::uint32_t k = 0; k < mesh.faces[face].corner_count; ++k)
                face_of_[mesh.faces[face].first_corner + k] = face;
    }

    std::vector<MeshFaultPlace> faults() {
        find_reversed();
        find_open();
        return places();
    }

private:
    struct Fault {
        std::uint32_t face;
        MeshFault what;
        std::uint32_t corner;
    };

    void find_reversed();
    std::vector<std::uint32_t> flood(std::uint32_t seed, std::size_t& turned_count);
    std::uint32_t telling_corner(std::uint32_t face) const;
    void find_open();
    std::vector<MeshFaultPlace> places();

    const ExactMesh& mesh_;
    const WeldedPositions& welded_;
    const std::vector<EdgeSide> sides_;   ///< by edge
    std::vector<std::uint32_t> face_of_;  ///< of a corner
    std::vector<std::uint32_t> partner_;  ///< the other side, by its corner, of an edge with two
    std::vector<bool> same_way_;          ///< that side runs the same way
    std::vector<bool> reached_;           ///< by the flood
    std::vector<bool> turned_;            ///< wound against the face that the flood began with; in the end: reversed
    std::vector<Fault> faults_;
};

void EdgeChecker::find_reversed() {
    partner_.assign(mesh_.corners.size(), kNone);
    same_way_.assign(mesh_.corners.size(), false);
    for_each_edge(sides_, [&](std::span<const EdgeSide> sides) {
        if (sides.size() != 2 || face_of_[sides[0].owner] == face_of_[sides[1].owner]) return;
        for (std::size_t k = 0; k < 2; ++k) {
            partner_[sides[k].owner] = sides[1 - k].owner;
            same_way_[sides[k].owner] = sides[0].upward == sides[1].upward;
        }
    });
    reached_.assign(mesh_.faces.size(), false);
    turned_.assign(mesh_.faces.size(), false);
    for (std::uint32_t seed = 0; seed < mesh_.faces.size(); ++seed) {
        if (reached_[seed]) continue;
        std::size_t turned_count = 0;
        const std::vector<std::uint32_t> reached = flood(seed, turned_count);
        const bool first_is_right = turned_count * 2 <= reached.size();
        for (const std::uint32_t face : reached) {
            if (!first_is_right) turned_[face] = !turned_[face];
            if (turned_[face]) faults_.push_back({face, MeshFault::kReversedFace, telling_corner(face)});
        }
    }
}

/// All faces that hang together with one by edges of two faces; turned_ says which are wound against it.
std::vector<std::uint32_t> EdgeChecker::flood(std::uint32_t seed, std::size_t& turned_count) {
    std::vector<std::uint32_t> reached{seed};
    reached_[seed] = true;
    for (std::size_t k = 0; k < reached.size(); ++k) {
        const ExactMesh::Face& face = mesh_.faces[reached[k]];
        for (std::uint32_t corner = face.first_corner; corner < face.first_corner + face.corner_count; ++corner) {
            if (partner_[corner] == kNone) continue;
            const std::uint32_t neighbour = face_of_[partner_[corner]];
            if (reached_[neighbour]) continue;
            reached_[neighbour] = true;
            turned_[neighbour] = turned_[reached[k]] != same_way_[corner];
            turned_count += turned_[neighbour];
            reached.push_back(neighbour);
        }
    }
    return reached;
}

/// The first corner of a reversed face whose side a neighbour uses the same way; the first of all where its neighbours
/// are reversed as well.
std::uint32_t EdgeChecker::telling_corner(std::uint32_t face) const {
    const std::uint32_t first = mesh_.faces[face].first_corner;
    for (std::uint32_t corner = first; corner < first + mesh_.faces[face].corner_count; ++corner)
        if (partner_[corner] != kNone && same_way_[corner]) return corner;
    return first;
}

/// Counts the sides of each edge either way, reversed faces taken as turned over.
void EdgeChecker::find_open() {
    for_each_edge(sides_, [&](std::span<const EdgeSide> sides) {
        const auto up = [&](const EdgeSide& side) { return side.upward != turned_[face_of_[side.owner]]; };
        const auto ups = std::size_t(std::count_if(sides.begin(), sides.end(), up));
        const std::size_t downs = sides.size() - ups;
        std::size_t excess = ups > downs ? ups - downs : downs - ups;
        for (std::size_t k = sides.size(); excess > 0; --k) {
            if (up(sides[k - 1]) != (ups > downs)) continue;
            faults_.push_back({face_of_[sides[k - 1].owner], MeshFault::kOpenEdge, sides[k - 1].owner});
            --excess;
        }
    });
}

/// The faults in order, in words of the file.
std::vector<MeshFaultPlace> EdgeChecker::places() {
    std::sort(faults_.begin(), faults_.end(), [](const Fault& a, const Fault& b) {
        return std::tuple(a.face, a.what == MeshFault::kOpenEdge, a.corner) <
               std::tuple(b.face, b.what == MeshFault::kOpenEdge, b.corner);
    });
    std::vector<MeshFaultPlace> places;
    std::vector<PositionPair> open;
    places.reserve(faults_.size());
    for (const Fault& fault : faults_) {
        const ExactMesh::Face& face = mesh_.faces[fault.face];
        const std::uint32_t to = corner_after(face, fault.corner);
        places.push_back({fault.what, face.source, face.line, mesh_.nearest[mesh_.corners[fault.corner]],
                          mesh_.nearest[mesh_.corners[to]], false});
        if (fault.what == MeshFault::kOpenEdge)
            open.push_back({welded_.of_corner[fault.corner], welded_.of_corner[to]});
    }
    const std::vector<bool> t_joint = find_t_joints(mesh_, welded_, open);
    std::size_t k = 0;
    for (MeshFaultPlace& place : places)
        if (place.what == MeshFault::kOpenEdge) place.t_joint = t_joint[k++];
    return places;
}

}  // namespace

std::vector<MeshFaultPlace> check_edges(const ExactMesh& mesh, const WeldedPositions& welded) {
    return EdgeChecker(mesh, welded).faults();
}

}  // namespace firma
