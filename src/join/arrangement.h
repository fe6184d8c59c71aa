// SPDX-License-Identifier: MIT
// How the polygons of a joined level meet: sides divided where others begin, edges with the two faces that bound the
// same air, and which sides of polygons see each other around an edge.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/disjoint_sets.h"
#include "geometry/around_edge.h"
#include "join/merge_pieces.h"

namespace firma {

/// Part of a line between neighbouring corners, and the two faces that bound one wedge of air there.
struct JoinEdge {
    std::uint32_t corner[2] = {0, 0};  ///< as the first face runs
    std::uint32_t face[2] = {0, 0};
    PlaneId across = kNoPlane;  ///< a plane other than the first face's that holds it
    bool doubled = false;       ///< there are more between the same corners
};

/// One step of a polygon's outline.
struct JoinStep {
    std::uint32_t corner = 0;  ///< where it begins
    std::uint32_t edge = 0;    ///< of faces only
};

/// Faces come first, by their numbers; a portal's two sides follow: side of the front `faces + 2 k`, of the back one
/// more.
struct Arrangement {
    std::vector<JoinStep> steps;            ///< of all polygons in a row, portals after faces
    std::vector<std::uint32_t> first_step;  ///< a polygon each, and the end
    std::vector<JoinEdge> edges;            ///< in the order in which the outlines come to them
    DisjointSets seen_together{0};  ///< sides of polygons between which there is nothing but air, around some edge

    std::span<const JoinStep> outline(std::uint32_t polygon) const {
        return {steps.data() + first_step[polygon], first_step[polygon + 1] - first_step[polygon]};
    }
};

/// Where polygons do not bound a solid: an edge around which air and solid do not alternate.
struct OpenEdge {
    std::uint32_t corner[2] = {0, 0};
    std::vector<std::uint32_t> polygons;  ///< that meet there
};

/// Arranges polygons that come and go: only lines on which a side was added or removed are arranged anew.
class Arranger {
public:
    Arranger(const ExactTables& tables, LineTable& lines) : lines_(lines), tables_(tables), sides_(lines) {}

    /// @param face  it bounds a solid, its front in the air, and overlaps no other face; else it is a portal, in the
    /// air
    /// @return its number, which is never used again
    std::uint32_t add(const ConvexPiece& piece, bool face);
    void remove(std::uint32_t polygon);

    /// @return the polygons that were added or whose outlines changed, each once
    std::span<const std::uint32_t> update();

    /// What keeps the faces from bounding a solid; polygons by number. Empty when they do.
    const std::vector<OpenEdge>& open() const { return open_; }
    bool has(std::uint32_t polygon) const { return polygons_[polygon].live; }
    void outline(std::uint32_t polygon, std::vector<std::uint32_t>& corners) const;

    /// All of it.
    /// @param order  of all polygons, faces first: they are numbered by it
    Arrangement arrangement(std::span<const std::uint32_t> order) const;

    /// Lines arranged so far, those that were arranged anew counted again.
    std::size_t work() const { return work_; }

private:
    struct Polygon {
        std::uint32_t first_side = 0, side_count = 0;  ///< of `sides_`
        bool face = false, live = true, noted = false;
    };
    /// What became of a side.
    struct Division {
        std::uint32_t corners = 0, pieces = 0;  ///< first of `corners_along_`, of `edge_of_piece_`; along the line
        std::uint32_t count = 0;                ///< of pieces; one corner more
        std::uint32_t first = 0;                ///< piece of the line, while that is arranged
    };
    struct Line {
        std::uint32_t first_seen = 0, seen_count = 0;  ///< of `seen_`
        bool dirty = false;
    };

    void note_lines(std::uint32_t polygon);
    void arrange_line(std::uint32_t line);
    void divide_side(std::uint32_t side, std::uint32_t first, std::uint32_t last);
    void note_outline(std::uint32_t polygon);
    void arrange_piece(std::uint32_t line, std::uint32_t piece);
    std::uint32_t side_after(const Spoke& spoke) const;
    std::uint32_t side_before(const Spoke& spoke) const;
    void pair_faces(std::uint32_t piece);
    void note_open(std::uint32_t line, std::uint32_t piece);

    LineTable& lines_;
    const ExactTables& tables_;
    SidesOnLines sides_;
    std::vector<Polygon> polygons_;
    std::vector<Division> divisions_;  ///< a side each
    std::vector<Line> line_;
    std::vector<std::uint32_t> dirty_;            ///< lines
    std::vector<std::uint32_t> noted_, changed_;  ///< polygons: since the last update(), in it
    std::vector<OpenEdge> open_;
    std::vector<std::uint32_t> line_of_open_;

    // What lines came to; what is no longer true of one stays behind.
    std::vector<JoinEdge> edges_;
    std::vector<std::uint32_t> edge_of_piece_, corners_along_;
    std::vector<std::pair<std::uint32_t, std::uint32_t>> seen_;  ///< sides of polygons: twice a number, one more: back
    std::size_t work_ = 0;

    // Of the line at hand.
    std::vector<std::uint32_t> on_line_, corners_;
    FlatMap place_of_;
    std::vector<std::pair<std::uint32_t, std::uint32_t>> in_piece_;
    std::vector<Spoke> spokes_;  ///< of sides
    std::vector<std::uint32_t> around_;
};

/// An Arranger's arrangement of polygons that stay as they are.
/// @param faces    polygons that bound a solid, their fronts in the air; none overlap
/// @param portals  polygons in the air
/// @param open     what keeps the faces from bounding a solid: empty when they do
Arrangement arrange(const ExactTables& tables, std::span<const JoinPiece> faces, std::span<const ConvexPiece> portals,
                    std::vector<OpenEdge>& open);

}  // namespace firma
