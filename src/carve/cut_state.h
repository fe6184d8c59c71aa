// SPDX-License-Identifier: MIT
// What the phases of a cut hand on to each other: points where edges and faces cross, segments, labels, new loops.
//
// Vertices are numbered through: first the patch's, then the cutter's, then points where an edge crosses a face.
// Edges likewise: first the patch's, then those that the cut makes.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/flat_map.h"
#include "carve/cutter_solid.h"
#include "solid/solid_patch.h"

namespace firma {

/// How a phase ended.
enum class Verdict : std::uint8_t {
    kFine,
    kDegenerate,  ///< a predicate answered zero, or a facet failed its check: move the cutter and start again
    kBroken,      ///< what cannot be, unless the cutter crosses itself or there is a bug: refuse
};

/// Where an edge of the world crosses a cutter triangle's plane, or an edge of the cutter a world face's plane.
struct CutPoint {
    ExactPoint point;
    const SolidPlane* planes[3] = {nullptr, nullptr, nullptr};  ///< the patch's and the cutter's
    std::uint32_t edge = 0;                                     ///< of the patch, or of the cutter
    std::uint32_t face = 0;                                     ///< the triangle, or the patch's face, that it crosses
    std::uint32_t vertex = ~0u;  ///< its number, once it proved to be on both; see Cut::real
    bool of_world = false;       ///< whether `edge` is one of the patch
};

struct Segment {
    std::uint32_t face, triangle;
    std::uint32_t from, to;  ///< vertices
};

/// An edge that the cut makes: part of one that it split, or a segment.
struct NewEdge {
    std::uint32_t from, to;
    const SolidPlane* plane[2];  ///< the patch's and the cutter's
};

/// A face that the cut makes.
struct NewFace {
    Ref<const SolidPlane> plane;
    std::uint32_t first_use = 0, use_count = 0;    ///< in Cut::uses
    std::uint32_t first_loop = 0, loop_count = 0;  ///< in Cut::loop_ends, counted from first_use
    std::uint32_t face = ~0u;                      ///< the patch's face that it is a piece of; ~0: of the cutter
    std::uint32_t triangle = ~0u;                  ///< the cutter's triangle that it is a piece of; ~0: of the world
};

enum class Where : std::int8_t { kInside = -1, kUnknown = 0, kOutside = 1 };

struct Cut {
    SolidPatch* patch = nullptr;
    CutterSolid* cutter = nullptr;
    bool fill = false;  ///< add the cutter to the solid rather than take it away

    std::vector<CutPoint> crossings;
    FlatMap world_crossing, cutter_crossing;  ///< by edge and face
    std::vector<std::uint32_t> met;           ///< crossings that are on both, edge and face, as they were met
    std::vector<std::uint32_t> real;  ///< crossings that are vertices, in order of their numbers: of `met` those
                                      ///< but where copies of an edge cross at the same place
    FlatMap met_at;                   ///< by triangle and place, those of world edges

    /// Whether phases go on after a degenerate position, to find all there are.
    bool collects = false;
    /// Vertices of the cutter's elements that were found in one, some more than once.
    std::vector<std::uint32_t> touching;
    std::vector<Segment> segments;
    std::vector<std::uint8_t> face_cut;  ///< whether a patch face has a segment

    /// Crossings along each edge that has some, in order from its first vertex: ranges of `along`.
    struct Range {
        std::uint32_t first = 0, count = 0;
    };
    std::vector<std::uint32_t> along;
    std::vector<Range> world_cuts, cutter_cuts;

    std::vector<Where> world_label;   ///< of patch vertices: against the cutter
    std::vector<Where> cutter_label;  ///< of cutter vertices: inside the solid, or outside of it

    std::vector<NewEdge> new_edges;
    std::vector<PatchUse> uses;  ///< edges numbered through
    std::vector<std::uint32_t> loop_ends;
    std::vector<NewFace> new_faces;
    std::vector<std::uint32_t> gone;  ///< patch faces that are no more, or were replaced
    std::size_t first_kept = 0;       ///< in new_faces: from here on pieces that the cut itself left whole

    std::uint32_t first_cutter_vertex() const { return std::uint32_t(patch->vertices.size()); }
    std::uint32_t first_real() const { return first_cutter_vertex() + std::uint32_t(cutter->points.size()); }
    std::uint32_t first_new_edge() const { return std::uint32_t(patch->edges.size()); }

    bool stops_at(Verdict verdict) const {
        return verdict == Verdict::kBroken || (verdict == Verdict::kDegenerate && !collects);
    }
    void touches(std::uint32_t cutter_vertex) { touching.push_back(cutter_vertex); }
    void triangle_touches(std::uint32_t triangle) {
        for (const std::uint32_t v : cutter->triangle(triangle)) touching.push_back(v);
    }
    /// The cutter's element that makes a crossing: a triangle that an edge of the world meets, or an edge.
    void crossing_touches(const CutPoint& crossing) {
        if (crossing.of_world) return triangle_touches(crossing.face);
        touches(cutter->edges[crossing.edge].a);
        touches(cutter->edges[crossing.edge].b);
    }

    /// What the cutter has to do with the corners of a new face.
    void face_touches(std::span<const PatchUse> loops) {
        for (const PatchUse& use : loops) {
            const std::uint32_t vertex = from(use);
            if (vertex >= first_real())
                crossing_touches(crossings[real[vertex - first_real()]]);
            else if (vertex >= first_cutter_vertex())
                touches(vertex - first_cutter_vertex());
        }
    }

    const ExactPoint& point(std::uint32_t vertex) const {
        if (vertex < first_cutter_vertex()) return patch->vertices[vertex].point;
        if (vertex < first_real()) return cutter->points[vertex - first_cutter_vertex()];
        return crossings[real[vertex - first_real()]].point;
    }
    std::uint32_t from(const PatchUse& use) const { return end(use, false); }
    std::uint32_t to(const PatchUse& use) const { return end(use, true); }

    void clear();

private:
    std::uint32_t end(const PatchUse& use, bool last) const {
        const bool second = use.reversed != last;
        if (use.edge < first_new_edge()) return patch->edges[use.edge].vertex[second];
        const NewEdge& edge = new_edges[use.edge - first_new_edge()];
        return second ? edge.to : edge.from;
    }
};

}  // namespace firma
