// SPDX-License-Identifier: MIT
// Facets laid out for casts: triangles eight side by side, with their corners inside, so that a processor looks at
// eight at a time and fetches nothing else for those that are not met.
#pragma once

#include <cstdint>

#include "firma/grid.h"
#include "firma/vec.h"

namespace firma {

class Block;
struct FaceRecord;

/// Facets of one block. One of more than three corners is a fan of triangles, side by side, maybe in several of these.
struct FaceLanes {
    static constexpr std::uint32_t kLanes = 8;

    const Block* block = nullptr;
    const FaceRecord* faces = nullptr;  ///< of the block: one place less to wait for than by way of it
    float corner[3][3][kLanes];         ///< by corner and axis: metres from the origin
    GridPoint origin;
    std::int32_t fourth = 0;  ///< so that four numbers may be read in a row
    float size = 0;           ///< no corner is farther from the origin, by the sum of its coordinates
    float uneven = 0;         ///< nor farther from its facet's plane: not 0 where rounding bent one, metres
    float shifted = 0;      ///< nor from where the facet has it, in its plane, by more: not 0 where floats, or rounding
                            ///< in polygons, turn a triangle's normal away from its facet's, metres
    std::uint8_t used = 0;  ///< lanes that hold a triangle, a bit each; the others repeat the last one
    std::uint8_t whole = 0;  ///< lanes whose corners are all that the facet has, and exact
    std::uint8_t two_sided = 0;
    std::uint8_t slot[kLanes];      ///< in the block
    std::uint32_t mask_of_all = 0;  ///< bits that all facets have

    /// A corner of a whole lane, metres, exact.
    Vec3 corner_at(std::uint32_t k, std::uint32_t lane) const {
        const Vec3 from = to_metres(origin);
        return {from.x + double(corner[k][0][lane]), from.y + double(corner[k][1][lane]),
                from.z + double(corner[k][2][lane])};
    }
};

}  // namespace firma
