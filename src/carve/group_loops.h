// SPDX-License-Identifier: MIT
// From loops in one plane to faces: one outer loop each, and the holes that lie in it.
#pragma once

#include <span>

#include "carve/cut_view.h"

namespace firma {

/// Adds a new face for each outer loop.
///
/// @param like       what the faces have in common
/// @param loops      uses of all loops in a row, `ends` where each ends
/// @param made       the faces, their uses and ends are added to it
/// @return kDegenerate where rounded corners leave it open which loop a hole lies in
Verdict group_loops(const CutView& view, const NewFace& like, std::span<const PatchUse> loops,
                    std::span<const std::uint32_t> ends, NewLoops& made);

}  // namespace firma
