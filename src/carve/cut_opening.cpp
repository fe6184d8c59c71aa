// SPDX-License-Identifier: MIT
// What a carving opens, and what leaves with it.
#include "carve/cut_opening.h"

#include "base/disjoint_sets.h"
#include "carve/make_faces.h"
#include "solid/append_faces.h"
#include "solid/own_face.h"

namespace firma {

bool several_airs(std::span<const std::uint32_t> parts, const AirOfPart& air_of) {
    std::optional<std::uint32_t> first, last_part;
    for (const std::uint32_t part : parts) {
        if (last_part == part) continue;
        last_part = part;
        const std::uint32_t air = air_of(part);
        if (first && *first != air) return true;
        first = air;
    }
    return false;
}

bool has_several_shells(const CutterSolid& cutter) {
    if (cutter.turned) return true;
    DisjointSets sets(cutter.points.size());
    for (const CutterSolid::Edge& edge : cutter.edges) sets.join(edge.a, edge.b);
    for (const CutterSolid::Edge& edge : cutter.edges)
        if (sets.find(edge.a) != 0) return true;
    return false;
}

Pockets one_pocket(const NewLoops& loops) {
    Pockets pockets;
    pockets.count = 1;
    for (const NewFace& face : loops.faces) pockets.of_face.push_back(face.triangle != ~0u ? 0 : Pockets::kNone);
    return pockets;
}

std::vector<std::uint32_t> join_pockets(std::span<const std::vector<std::uint32_t>> made_of_piece, Pockets& pockets) {
    DisjointSets sets(pockets.count);
    std::vector<std::uint32_t> of_piece;
    for (const std::vector<std::uint32_t>& made : made_of_piece) {
        std::uint32_t first = Pockets::kNone;
        for (const std::uint32_t owner : made) {
            const std::uint32_t pocket = owner < pockets.of_face.size() ? pockets.of_face[owner] : Pockets::kNone;
            if (pocket == Pockets::kNone) continue;
            if (first == Pockets::kNone) first = pocket;
            sets.join(first, pocket);
        }
        of_piece.push_back(first == Pockets::kNone ? 0 : first);
    }
    std::vector<std::uint32_t> number(pockets.count, Pockets::kNone);
    std::uint32_t next = 0;
    for (std::uint32_t k = 0; k < number.size(); ++k)
        if (sets.find(k) == k) number[k] = next++;
    for (std::vector<std::uint32_t>* all : {&pockets.of_face, &pockets.of_taken, &of_piece})
        for (std::uint32_t& pocket : *all)
            if (pocket != Pockets::kNone) pocket = number[sets.find(pocket)];
    pockets.count = next;
    return of_piece;
}

void append_walls(const CutPiece& piece, FaceSet& walls) {
    for (const FaceSet::Entry& face : piece.made.faces) {
        if (face.part == kUnsetPart) continue;
        append_face(piece.made, face, walls);
        walls.faces.back().owner = face.owner;
        walls.owners.emplace_back(face.owner);
    }
    std::vector<GridPoint> corners;
    for (const FacetPlace& facet : piece.removed) {
        const FaceRecord& record = facet.record();
        corners.clear();
        for (std::uint32_t k = 0; k < record.corner_count; ++k) corners.push_back(facet.block->corner(record, k));
        Ref<const FaceOwner> owner(facet.block->owner_of(record));
        if (!owner) owner = Ref<const FaceOwner>(face_of_corners(corners).get());
        FaceSet::Entry entry;
        entry.material = record.material;
        entry.part = facet.block->part;
        entry.first_corner = std::uint32_t(walls.corners.size());
        entry.corner_count = record.corner_count;
        entry.owner = owner.get();
        for (const GridPoint& corner : corners) {
            walls.corners.push_back(std::uint32_t(walls.vertices.size()));
            walls.vertices.push_back(corner);
        }
        walls.faces.push_back(entry);
        walls.owners.push_back(std::move(owner));
    }
}

}  // namespace firma
