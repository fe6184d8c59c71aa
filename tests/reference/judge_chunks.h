// SPDX-License-Identifier: MIT
// Whether a cut with loose pieces taken out is what it should be: against the same cut without, flooded as a whole.
#pragma once

#include <cstddef>
#include <cstdint>
#include <set>
#include <string>
#include <utility>

#include "firma/carve.h"

namespace firma::reference {

/// Edit and source of faces of which none bounds anything else but bodies that hang free.
using HangingFaces = std::set<std::pair<std::uint32_t, std::uint32_t>>;
HangingFaces hanging_faces(const World& world);
/// Likewise, of bodies that the last edit made alone: what a fill put down where it touched nothing. What it joined to
/// a body is part of that, and may be shot off it.
HangingFaces put_down_faces(const World& world);

struct ChunkVerdict {
    std::string fault;  ///< "" for none
    std::size_t loose = 0;
};

/// @param before   a world of which every body is held
/// @param hanging  of the first world; nothing else holds
/// @param result   of a cut with CarveOptions::chunks and no crumbs
/// @param plain    of the same cut without
ChunkVerdict judge_chunks(const World& before, const HangingFaces& hanging, const CarveResult& result,
                          const CarveResult& plain);

/// Pillars, bridges across each other and a slab in a hall, shot at: each cut judged, the next one made of its world.
struct ChunkHallVerdict {
    std::string fault;  ///< "" for none; with the cut
    std::size_t done = 0, loose = 0;
};
ChunkHallVerdict judge_chunk_hall(std::uint64_t seed, int cuts);

}  // namespace firma::reference
