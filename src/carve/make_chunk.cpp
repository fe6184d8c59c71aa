// SPDX-License-Identifier: MIT
// A loose piece as a solid in a frame of its own.
#include "carve/make_chunk.h"

#include <limits>

#include "solid/append_faces.h"
#include "solid/measure_boundary.h"
#include "solid/part_of_solid.h"

namespace firma {

Chunk make_chunk(const CutPiece& piece, const Solid& solid, double density) {
    FaceSet set;
    append_facets(piece.removed, set);
    set.owners.insert(set.owners.end(), piece.made.owners.begin(), piece.made.owners.end());
    for (const FaceSet::Entry& face : piece.made.faces) append_face(piece.made, face, set);
    std::uint32_t id = 0;
    for (FaceSet::Entry& face : set.faces) face.id = {id++};
    const InputPoint middle = middle_of(piece.box);
    InputPoint back;
    for (int axis = 0; axis < 3; ++axis) back[axis] = -middle[axis];
    move_faces(back, set);
    SolidData like = solid.data();
    ++like.edits;  // the cut that made it loose
    Chunk chunk;
    chunk.solid = solid_of_faces(std::move(set), id, like);
    chunk.origin = to_metres(to_surface(middle));
    chunk.mass = mass_properties(chunk.solid, density);
    return chunk;
}

}  // namespace firma
