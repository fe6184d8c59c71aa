// SPDX-License-Identifier: MIT
// What casts meet beside the solid, cut to the air and to its rooms.
#include "join/cut_loose.h"

#include <algorithm>

namespace firma {
namespace {

bool same_outline(const ConvexPiece& a, const ConvexPiece& b) {
    return std::equal(a.sides.begin(), a.sides.end(), b.sides.begin(), b.sides.end(),
                      [](const PieceSide& x, const PieceSide& y) { return x.corner == y.corner; });
}

}  // namespace

std::vector<LooseFacet> LooseCutter::cut(std::span<const std::uint32_t> left_out) {
    constexpr BrushKind kKinds[] = {BrushKind::kGlass, BrushKind::kPlayerClip, BrushKind::kShotClip,
                                    BrushKind::kLiquid};
    made_.clear();
    for (const BrushKind kind : kKinds) {
        std::vector<std::uint32_t> brushes;
        for (std::uint32_t b = 0; b < bodies_.shapes.size(); ++b)
            if (bodies_.used[b] && level_.brushes[b].kind == kind) brushes.push_back(b);
        cut_brushes(brushes);
    }
    for (const std::uint32_t brush : left_out)  // by themselves: what keeps them apart may be each other
        cut_brushes({&brush, 1});
    cut_surfaces();
    return std::move(made_);
}

void LooseCutter::cut_brushes(std::span<const std::uint32_t> brushes) {
    std::vector<GridBox> boxes;
    for (const std::uint32_t b : brushes) boxes.push_back(bodies_.shapes[b].box);
    const BoxTree tree(boxes);
    std::vector<JoinPiece> pieces;
    for (const std::uint32_t b : brushes)
        for (const BrushShape::Face& face : bodies_.shapes[b].faces) {
            const GridBox box = face.piece.box(tables_.points);
            pieces_.assign(1, face.piece);
            bodies_.hide_in_solids(box, kNoBrush, pieces_);
            near_.clear();
            tree.for_each_meeting(box, [&](std::uint32_t k) {
                if (brushes[k] != b) near_.push_back(brushes[k]);
                return false;
            });
            std::sort(near_.begin(), near_.end());
            for (const std::uint32_t other : near_)
                bodies_.hider().hide(bodies_.shapes[other], {.same_way = other < b, .against = true}, pieces_);
            const std::uint32_t source = level_.brushes[b].first_side + face.side;
            const BrushSide& side = level_.sides[source];
            for (ConvexPiece& piece : pieces_)
                pieces.push_back({std::move(piece), source, side.material, side.mask, side.texture});
        }
    cutter_.divide_at_portals(pieces);
    cutter_.merge_between_portals(pieces);
    for (LooseFacet& facet : make_loose_facets(tables_, pieces)) made_.push_back(std::move(facet));
}

/// Surfaces stay as the file has them, but for those that reach through a portal or into the solid: no face lies in two
/// rooms.
void LooseCutter::cut_surfaces() {
    const Level& surfaces = level_.surfaces;
    std::vector<JoinPiece> pieces;
    std::vector<InputPoint> corners;
    for (std::uint32_t k = 0; k < surfaces.faces.size(); ++k) {
        const LevelFace& face = surfaces.faces[k];
        LooseFacet facet;
        facet.source = std::uint32_t(level_.sides.size()) + k;
        facet.material = face.material;
        facet.mask = face.mask;
        facet.two_sided = face.two_sided;
        GridBox box;
        corners.clear();
        for (std::uint32_t c = 0; c < face.corner_count; ++c) {
            const GridPoint& corner = surfaces.vertices[surfaces.corners[face.first_corner + c]];
            facet.corners.push_back(corner);
            corners.push_back(to_input(corner));
            box.add(corner);
        }
        pieces_.assign(1, piece_of_corners(tables_, corners));
        const ConvexPiece whole = pieces_[0];
        bodies_.hide_in_solids(box, kNoBrush, pieces_);
        pieces.clear();
        for (ConvexPiece& piece : pieces_) pieces.push_back({std::move(piece), facet.source, face.material, face.mask});
        cutter_.divide_at_portals(pieces);
        if (pieces.size() == 1 && same_outline(pieces[0].piece, whole)) {
            made_.push_back(std::move(facet));
            continue;
        }
        for (LooseFacet& part : make_loose_facets(tables_, pieces)) {
            part.two_sided = face.two_sided;
            made_.push_back(std::move(part));
        }
    }
}

}  // namespace firma
