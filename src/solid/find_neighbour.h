// SPDX-License-Identifier: MIT
// The face across an edge, looked for when it is asked for: nothing about neighbours is stored, so an edit touches
// none.
#pragma once

#include "firma/hit.h"
#include "solid/block.h"

namespace firma {

/// The face that shares the edge from corner `corner` of a face to the next, by exact comparison of both ends.
///
/// @param root  of an index that holds the face
/// @return the other face when exactly two faces below use that edge, in opposite directions; invalid otherwise.
/// Allocates nothing and counts no reference.
FaceId find_neighbour(const Node& root, const Block& block, const FaceRecord& face, std::uint32_t corner);

}  // namespace firma
