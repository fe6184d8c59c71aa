// SPDX-License-Identifier: MIT
// A loose piece as a solid in a frame of its own, with what it weighs.
#include "carve/make_chunk.h"

#include <utility>

#include "solid/append_faces.h"
#include "solid/measure_boundary.h"
#include "solid/part_of_solid.h"

namespace firma {
namespace {

/// Its faces, numbered from 0.
FaceSet faces_of_cut_piece(const CutPiece& piece) {
    FaceSet set;
    append_facets(piece.removed, set);
    set.owners.insert(set.owners.end(), piece.made.owners.begin(), piece.made.owners.end());
    for (const FaceSet::Entry& face : piece.made.faces) append_face(piece.made, face, set);
    std::uint32_t id = 0;
    for (FaceSet::Entry& face : set.faces) face.id = {id++};
    return set;
}

}  // namespace

Solid solid_of_cut_piece(const CutPiece& piece, const Solid& solid) {
    FaceSet set = faces_of_cut_piece(piece);
    const auto count = std::uint32_t(set.faces.size());
    return solid_of_faces(std::move(set), count, solid.data());
}

ChunkMaker::ChunkMaker(const CutPiece& piece, const Solid& solid, double density, const ChunkMatters& matters)
    : density_(density), matters_(matters) {
    FaceSet set = faces_of_cut_piece(piece);
    for (FaceSet::Entry& face : set.faces) face.material = matters_.material_of(face.material);
    const auto id = std::uint32_t(set.faces.size());
    SolidData like = solid.data();
    ++like.edits;  // the cut that made it loose
    const InputPoint middle = middle_of(piece.box);
    std::optional<std::uint32_t> only = 0;
    if (matters_.pieces) only = only_matter_in(*matters_.pieces, piece.box);
    if (!only)
        shares_ = std::make_unique<MatterShares>(solid_of_faces(set, id, like), piece.box, middle, *matters_.pieces,
                                                 matters_.rules, matters_.solid_of);
    InputPoint back;
    for (int axis = 0; axis < 3; ++axis) back[axis] = -middle[axis];
    move_faces(back, set);
    chunk_.solid = solid_of_faces(std::move(set), id, like);
    chunk_.origin = to_metres(to_surface(middle));
    const MatterTable& table = matters_.pieces ? matters_.pieces->table : default_matters();
    const double usual = table.matters[only.value_or(0)].density;
    const double weight = density_ > 0 ? density_ : usual;
    // The middle is its frame's origin.
    chunk_.mass = shares_ ? mass_of(shares_->total(), {}, weight) : mass_properties(chunk_.solid, weight);
    if (only) chunk_.matters = {{*only, chunk_.mass.volume}};
}

bool ChunkMaker::step() {
    if (!shares_) return false;
    if (shares_->step()) return true;
    Moments weighted{};
    for (const MatterShares::Share& share : shares_->shares()) {
        const double density = matters_.pieces->table.matters[share.matter].density;
        add_moments(weighted, share.moments, density);
        chunk_.matters.push_back({share.matter, mass_of(share.moments, {}, 1).volume});
    }
    shares_.reset();
    if (density_ > 0) return false;
    const double volume = chunk_.mass.volume;
    chunk_.mass = mass_of(weighted, {}, 1);
    chunk_.mass.volume = volume;
    return false;
}

}  // namespace firma
