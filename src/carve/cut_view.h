// SPDX-License-Identifier: MIT
// Reads vertices and edges by number, whichever phase made them.
//
// Vertices are numbered through: first the patch's, then the cutter's, then points where an edge crosses a face.
// Edges likewise: first the patch's, then those that the cut makes.
#pragma once

#include <cstdint>
#include <span>

#include "carve/crossings.h"
#include "carve/new_loops.h"

namespace firma {

/// Of what it was made from, which must live as long as it.
class CutView {
public:
    /// @param loops  its edges may still be added to
    CutView(const CutInput& in, const Crossings& crossings, const NewLoops& loops)
        : patch_(in.patch), cutter_(in.cutter), crossings_(crossings), new_edges_(loops.edges) {}

    const SolidPatch& patch() const { return patch_; }
    const CutterSolid& cutter() const { return cutter_; }

    std::uint32_t first_cutter_vertex() const { return std::uint32_t(patch_.vertices.size()); }
    std::uint32_t first_real() const { return first_cutter_vertex() + std::uint32_t(cutter_.points.size()); }
    std::uint32_t vertex_count() const { return first_real() + std::uint32_t(crossings_.real.size()); }
    std::uint32_t first_new_edge() const { return std::uint32_t(patch_.edges.size()); }
    std::uint32_t edge_count() const { return first_new_edge() + std::uint32_t(new_edges_.size()); }

    const ExactPoint& point(std::uint32_t vertex) const {
        if (vertex < first_cutter_vertex()) return patch_.vertices[vertex].point;
        if (vertex < first_real()) return cutter_.points[vertex - first_cutter_vertex()];
        return crossing(vertex).point;
    }
    /// Of a vertex from first_real() on.
    const CutPoint& crossing(std::uint32_t vertex) const {
        return crossings_.points[crossings_.real[vertex - first_real()]];
    }
    /// From first_new_edge() on.
    const NewEdge& new_edge(std::uint32_t edge) const { return new_edges_[edge - first_new_edge()]; }

    std::uint32_t from(const PatchUse& use) const { return end(use, false); }
    std::uint32_t to(const PatchUse& use) const { return end(use, true); }

private:
    std::uint32_t end(const PatchUse& use, bool last) const {
        const bool second = use.reversed != last;
        if (use.edge < first_new_edge()) return patch_.edges[use.edge].vertex[second];
        const NewEdge& edge = new_edge(use.edge);
        return second ? edge.to : edge.from;
    }

    const SolidPatch& patch_;
    const CutterSolid& cutter_;
    const Crossings& crossings_;
    const std::vector<NewEdge>& new_edges_;
};

}  // namespace firma
