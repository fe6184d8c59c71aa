// SPDX-License-Identifier: MIT
// Where faces of the world and the cutter's triangles cross: points on edges, and segments between them.
#pragma once

#include <cstdint>
#include <vector>

#include "carve/cut_input.h"

namespace firma {

/// Where an edge of the world crosses a cutter triangle's plane, or an edge of the cutter a world face's plane.
struct CutPoint {
    ExactPoint point;
    const SolidPlane* planes[3] = {nullptr, nullptr, nullptr};  ///< the patch's and the cutter's
    std::uint32_t edge = 0;                                     ///< of the patch, or of the cutter
    std::uint32_t face = 0;                                     ///< the triangle, or the patch's face, that it crosses
    std::uint32_t vertex = ~0u;  ///< its number, once it proved to be on both; see Crossings::real
    bool of_world = false;       ///< whether `edge` is one of the patch
};

struct Segment {
    std::uint32_t face, triangle;
    std::uint32_t from, to;  ///< vertices; see cut_view.h
};

struct Crossings {
    std::vector<CutPoint> points;
    std::vector<std::uint32_t> met;   ///< points that are on both, edge and face, as they were met
    std::vector<std::uint32_t> real;  ///< points that are vertices, in order of their numbers: of `met` those but
                                      ///< where copies of an edge cross at the same place
    std::vector<Segment> segments;
    std::vector<std::uint8_t> face_cut;  ///< whether a patch face has a segment
};

}  // namespace firma
