// SPDX-License-Identifier: MIT
// What a Solid is a handle to. Nothing in it changes once published.
#pragma once

#include <cstdint>
#include <initializer_list>
#include <vector>

#include "firma/solid.h"
#include "solid/face_store.h"

namespace firma {

struct SolidData {
    FaceStore faces;              ///< each marked as solid
    bool rock_outside = false;    ///< whether what no face separates from infinity is solid
    std::uint32_t next_face = 0;  ///< the id that the next new face gets, of an edit without a number: face_ids.h
    std::uint32_t edits = 0;      ///< the last one's number: as many as were made, unless some were given theirs
    TreeOptions tree_options;     ///< how indices are built
    /// Sums of PointHash by region.
    PersistentMap<std::uint64_t> points;
    std::uint64_t point_sum = 0;  ///< of all of them
};

/// Sets `points` and `point_sum`, from all faces: what edits keep up.
void hash_points_anew(SolidData& data);

/// A solid of these faces, its hash taken anew.
Solid solid_of(FaceStore faces, bool rock_outside, std::uint32_t next_face, std::uint32_t edits,
               const TreeOptions& options);

/// Sums by region, of several lists of faces together.
std::vector<RegionHash> region_hashes(std::initializer_list<const PersistentMap<std::uint64_t>*> faces,
                                      const PersistentMap<std::uint64_t>& points);

}  // namespace firma
