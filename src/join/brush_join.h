// SPDX-License-Identifier: MIT
// A level's brushes, joined and kept: when brushes or planes change, only what they touch is joined again.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "join/brush_bodies.h"
#include "join/join_brushes.h"
#include "join/move_planes.h"
#include "join/portal_cutter.h"

namespace firma {

/// What was joined before stays: shapes of brushes, what is left of each face, what those pieces merge into, lines
/// where polygons meet, facets. A change to a brush redoes it and, by their boxes, the faces and portals that it
/// touches; of the pieces those that could merge with others than before; of the lines those on which sides changed.
/// The result is that of joining the brushes and planes as they are from scratch, but for the numbers of planes and
/// points.
class BrushJoin {
public:
    /// Nothing is joined yet; all brushes will be.
    /// @param level  stays as it is while this lives, but for brushes added at its end
    explicit BrushJoin(const BrushLevel& level);

    /// Whether a level's planes can be numbered.
    static bool fits(const BrushLevel& level);

    /// Takes in brushes that were added to the level. They are not in use.
    void grow();
    /// Whether a brush is part of the level: from the next update() on.
    void use(std::uint32_t brush, bool used);
    /// Takes brushes back into use that could not be joined: with others they may be.
    void take_back();

    /// Joins what has changed; moves planes or leaves out brushes until the faces are sound.
    void update();

    /// The join as it is, with its rooms and portals, and without `loose`. Good until the next call.
    const JoinedLevel& divide();
    /// The same with `loose`; this is used up.
    std::unique_ptr<JoinedLevel> finish();

private:
    /// What is left of a face, or of a brush's portals.
    using Cut = std::vector<std::uint32_t>;  ///< pieces of a PieceMerger

    struct Polygon {
        bool face = false;
        std::uint32_t piece = 0;  ///< of the PieceMerger for faces, or for portals
        std::vector<std::vector<GridPoint>> facets;
    };

    ExactTables& tables() { return made_->tables; }
    void change(std::uint32_t brush);
    void redo();
    void make_shapes();
    void make_shape(std::uint32_t brush);
    void cut_portals();
    std::vector<JoinPiece> cut_portal(std::uint32_t brush);
    void cut_faces();
    void cut_brush(std::uint32_t brush);
    void put(PieceMerger& merger, Cut& cut, std::uint64_t order, std::vector<JoinPiece>& pieces, bool all);
    void merge(PieceMerger& merger, std::vector<std::uint32_t>& polygon_of, bool face);
    void arrange();
    bool mend(bool may_move);
    void leave_out(std::uint32_t brush, const char* reason);
    void leave_out_of(std::uint32_t polygon, const char* reason);
    const JoinPiece& piece_of(std::uint32_t polygon) const;
    void sort_polygons(std::vector<std::uint32_t>& polygons) const;
    void assemble(bool last);
    RoomFinder find_rooms(bool last);
    void find_portals();
    bool are_one(std::uint32_t a, std::uint32_t b) const;

    const BrushLevel& level_;
    std::unique_ptr<JoinedLevel> made_;
    PlaneMover mover_;
    BrushBodies bodies_;
    PortalCutter cutter_;
    LineTable lines_;
    PieceMerger face_merger_, portal_merger_;
    Arranger arranger_;
    PolygonFacets faceter_;

    std::vector<std::uint32_t> brush_of_side_;
    std::vector<bool> changed_;                         ///< by brush: since the last redo()
    std::vector<std::uint32_t> changes_;                ///< these
    std::vector<bool> listed_;                          ///< by brush: of the solid in the last redo()
    std::vector<std::vector<Cut>> faces_;               ///< by brush, by face of its shape
    std::vector<std::vector<JoinPiece>> open_portals_;  ///< by brush: of a portal what lies in the air
    std::vector<Cut> portals_;                          ///< by brush: the same, divided where portals cross
    std::vector<std::uint32_t> portal_brushes_;         ///< of the level, ascending
    std::vector<std::uint32_t> polygon_of_face_, polygon_of_portal_;  ///< by piece
    std::vector<Polygon> polygons_;                                   ///< by their numbers in the Arranger
    std::vector<std::uint32_t> unsound_;                              ///< polygons that may have no facets

    // Of the redo() at hand.
    std::vector<GridBox> touched_;       ///< boxes of brushes of the solid that changed, as they were and as they are
    std::vector<GridBox> portal_boxes_;  ///< of portals, likewise
    BoxTree touched_tree_, portal_tree_;
    std::vector<PlaneId> portal_planes_;  ///< of portals of brushes that changed, looked at from the front
    std::vector<ConvexPiece> pieces_;
    JoinRound round_;
};

}  // namespace firma
