// SPDX-License-Identifier: MIT
// Whether a mesh is closed, and whom to blame where it is not.
#include "level/check_edges.h"

#include <algorithm>
#include <tuple>

#include "level/find_t_joints.h"
#include "level/shared_edges.h"

namespace firma {
namespace {

constexpr std::uint32_t kNone = ~0u;

class EdgeChecker {
public:
    EdgeChecker(const ExactMesh& mesh, const WeldedPositions& welded)
        : mesh_(mesh), welded_(welded), edges_(mesh, welded), face_of_(mesh.corners.size()) {
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
    SharedEdges edges_;
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
    edges_.for_each([&](std::span<const FaceSide> sides) {
        if (sides.size() != 2 || face_of_[sides[0].corner] == face_of_[sides[1].corner]) return;
        for (std::size_t k = 0; k < 2; ++k) {
            partner_[sides[k].corner] = sides[1 - k].corner;
            same_way_[sides[k].corner] = sides[0].up == sides[1].up;
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
    edges_.for_each([&](std::span<const FaceSide> sides) {
        const auto up = [&](const FaceSide& side) { return side.up != turned_[face_of_[side.corner]]; };
        const auto ups = std::size_t(std::count_if(sides.begin(), sides.end(), up));
        const std::size_t downs = sides.size() - ups;
        std::size_t excess = ups > downs ? ups - downs : downs - ups;
        for (std::size_t k = sides.size(); excess > 0; --k) {
            if (up(sides[k - 1]) != (ups > downs)) continue;
            faults_.push_back({face_of_[sides[k - 1].corner], MeshFault::kOpenEdge, sides[k - 1].corner});
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
