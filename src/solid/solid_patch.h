// SPDX-License-Identifier: MIT
// Part of a solid's boundary, taken out of blocks to be worked on: vertices, edges and faces by number.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "base/flat_map.h"
#include "solid/hash_points.h"
#include "solid/solid_face.h"

namespace firma {

/// How a loop uses an edge of a patch.
struct PatchUse {
    std::uint32_t edge = 0;
    bool reversed = false;
};

struct PatchVertex {
    ExactPoint point;
    const SolidVertex* stored = nullptr;  ///< null for one that no cut has touched
    Ref<const SolidPlane> planes[3];      ///< of a new one off the grid, until it is stored
};

struct PatchEdge {
    std::uint32_t vertex[2] = {0, 0};
    const SolidPlane* plane[2] = {nullptr, nullptr};  ///< see SolidPatch::settle_planes()
    const SolidEdge* stored = nullptr;
    std::uint32_t face[2] = {~0u, ~0u};  ///< the face that uses it forward, and the one that uses it back; none: ~0
    std::uint32_t half[2] = {~0u, ~0u};  ///< what it was split into, by halving a large face
    bool doubled = false;

    bool split() const { return half[0] != ~0u; }
};

struct PatchFace {
    const SolidPlane* plane = nullptr;
    const FaceOwner* stored = nullptr;  ///< the SolidFace; null for one that no cut has touched
    FacetPlace facet;                   ///< one of its facets
    std::uint32_t first_use = 0, use_count = 0;
    std::uint32_t first_loop = 0, loop_count = 0;  ///< ends in SolidPatch::loop_ends, counted from first_use
    GridBox box;                                   ///< of its corners, rounded
    std::uint32_t parent = ~0u;                    ///< the face of this patch that it is a piece of
    bool replaced = false;                         ///< by pieces, or by itself with split edges
};

/// Points into the blocks that it was taken from: whoever works on it keeps their world alive.
class SolidPatch {
public:
    void clear();

    /// Takes in the face that a facet belongs to, unless it is there already.
    /// @return its number
    std::uint32_t add(const FacetPlace& facet);
    /// Likewise the faces of several facets, in this order; quicker than one by one.
    void add(std::span<const FacetPlace> facets);
    /// Makes room for so many faces, before the first.
    void reserve(std::size_t face_count);
    /// The number of a facet's face, or kNone.
    static constexpr std::uint32_t kNone = ~0u;
    std::uint32_t find(const FacetPlace& facet) const;
    /// The edge that a loop uses, where it is here; nothing else.
    std::optional<PatchUse> find(const SolidUse& use) const;
    /// The one between two points of the grid that is not doubled.
    std::optional<PatchUse> find(const InputPoint& from, const InputPoint& to) const;

    std::span<const PatchUse> uses(const PatchFace& face) const {
        return {all_uses.data() + face.first_use, face.use_count};
    }
    std::span<const std::uint32_t> ends(const PatchFace& face) const {
        return {loop_ends.data() + face.first_loop, face.loop_count};
    }
    std::uint32_t from(const PatchUse& use) const { return edges[use.edge].vertex[use.reversed]; }
    std::uint32_t to(const PatchUse& use) const { return edges[use.edge].vertex[!use.reversed]; }

    /// Adds a piece of a face, in its plane.
    std::uint32_t add_piece(std::uint32_t parent, std::span<const PatchUse> uses, std::span<const std::uint32_t> ends);

    /// Gives an edge its two planes, if it has none yet: those of its faces, or one through it and a step aside where
    /// there is only one, or both lie in one plane.
    void settle_planes(std::uint32_t edge);

    /// A plane that holds an edge of a face, and is not parallel to that; once its planes are settled.
    const SolidPlane& across(std::uint32_t edge, const PatchFace& face) const {
        const PatchEdge& it = edges[edge];
        return *it.plane[it.plane[0] == face.plane || exact_parallel(it.plane[0]->plane, face.plane->plane)];
    }

    /// Of the line that an edge lies on.
    LineDirection direction_of(std::uint32_t edge) const;

    /// Keeps a plane that was made for the patch alive as long as the patch.
    const SolidPlane* keep(Ref<const SolidPlane> plane) { return kept_planes_.emplace_back(std::move(plane)).get(); }

    std::vector<PatchVertex> vertices;
    std::vector<PatchEdge> edges;
    std::vector<PatchFace> faces;
    std::vector<PatchUse> all_uses;
    std::vector<std::uint32_t> loop_ends;

private:
    std::uint32_t add_untouched(const FacetPlace& facet);
    std::uint32_t add_stored(const FacetPlace& facet, const SolidFace& face);
    std::uint32_t find_grid_vertex(const InputPoint& point) const;
    std::uint32_t grid_vertex(const InputPoint& point);
    std::uint32_t stored_vertex(const SolidVertex& vertex);
    std::uint32_t edge_between(std::uint32_t a, std::uint32_t b);
    PatchUse stored_edge(const SolidUse& use);
    void finish(std::uint32_t face);

    std::vector<Ref<const SolidPlane>> kept_planes_;
    FlatMap face_of_, vertex_of_point_, vertex_of_place_, edge_of_pair_, edge_of_stored_;
};

}  // namespace firma
