// SPDX-License-Identifier: MIT
// The brushes of a level as convex bodies, and what those of the solid hide.
#pragma once

#include <cstdint>
#include <vector>

#include "firma/brush_level.h"
#include "index/box_tree.h"
#include "join/hide_faces.h"

namespace firma {

inline constexpr std::uint32_t kNoBrush = ~0u;

/// Whether brushes of a kind are joined into the solid.
inline bool is_solid(BrushKind kind) {
    return kind == BrushKind::kSolid || kind == BrushKind::kSky;
}

class BrushBodies {
public:
    BrushBodies(const BrushLevel& level, ExactTables& tables) : level_(level), hider_(tables) {}

    /// By brush; without faces where a brush has no body.
    std::vector<BrushShape> shapes;
    std::vector<bool> used;  ///< by brush: others are no part of anything

    bool in_solid(std::uint32_t brush) const { return used[brush] && is_solid(level_.brushes[brush].kind); }

    /// Takes note of which brushes are of the solid, and where.
    void list_solids();
    const std::vector<std::uint32_t>& solids() const { return solids_; }

    /// Calls `function(brush)` for each of the solid whose box meets this one.
    template <class Function>
    void for_each_solid(const GridBox& box, const Function& function) const {
        solid_tree_.for_each_meeting(box, [&](std::uint32_t k) {
            function(solids_[k]);
            return false;
        });
    }

    /// Takes off pieces what brushes of the solid hide. Of faces of two brushes that look the same way, that of the
    /// lower number stays; of faces that lie against each other neither.
    /// @param box    around the pieces
    /// @param brush  the pieces are of this one; of none, kNoBrush: then what lies on the solid goes as well
    void hide_in_solids(const GridBox& box, std::uint32_t brush, std::vector<ConvexPiece>& pieces);

    FaceHider& hider() { return hider_; }

private:
    const BrushLevel& level_;
    FaceHider hider_;
    std::vector<std::uint32_t> solids_;  ///< ascending
    BoxTree solid_tree_;
    std::vector<std::uint32_t> near_;
};

}  // namespace firma
