// SPDX-License-Identifier: MIT
// Debris put in, found and taken out.
#include "firma/debris.h"

#include <utility>

#include "base/hasher.h"
#include "fracture/piece_of_chunk.h"

namespace firma {
namespace {

DebrisPiece* piece_of(std::vector<DebrisPiece>& slots, const Bodies& bodies, BodyId id) {
    if (!bodies.find(id) || id.slot >= slots.size()) return nullptr;
    DebrisPiece& piece = slots[id.slot];
    return piece.use == id.use && piece.solid.face_count() > 0 ? &piece : nullptr;
}

}  // namespace

DebrisPiece* Debris::find(const Bodies& bodies, BodyId id) {
    return piece_of(slots, bodies, id);
}
const DebrisPiece* Debris::find(const Bodies& bodies, BodyId id) const {
    return piece_of(const_cast<std::vector<DebrisPiece>&>(slots), bodies, id);
}

BodyId add_debris(Bodies& bodies, Debris& debris, Body body, DebrisPiece piece) {
    const BodyId id = add_body(bodies, std::move(body));
    if (debris.slots.size() <= id.slot) debris.slots.resize(id.slot + std::size_t(1));
    piece.use = id.use;
    debris.slots[id.slot] = std::move(piece);
    return id;
}

Result<BodyId> add_debris(Bodies& bodies, Debris& debris, const Chunk& chunk, const FitOptions& fit) {
    Result<Body> body = body_of(chunk, fit);
    if (!body) return body.error();
    return add_debris(bodies, debris, std::move(body).value(), piece_of_chunk(chunk));
}

void remove_debris(Bodies& bodies, Debris& debris, BodyId id) {
    if (DebrisPiece* piece = debris.find(bodies, id)) *piece = {};
    remove_body(bodies, id);
}

std::uint64_t hash_debris(const Debris& debris) {
    Hasher hash;
    for (std::size_t slot = 0; slot < debris.slots.size(); ++slot) {
        const DebrisPiece& piece = debris.slots[slot];
        if (piece.solid.face_count() == 0) continue;
        hash.add(slot);
        hash.add(hash_solid(piece.solid));
        hash.add(piece.use, piece.matter);
        hash.add(piece.broken, std::uint32_t(piece.never_ground) | std::uint32_t(piece.of_part) << 1);
        for (int axis = 0; axis < 3; ++axis) hash.add(piece.origin[axis]);
        hash.add(piece.age);
        hash.add(piece.asleep_for);
    }
    return hash.value();
}

}  // namespace firma
