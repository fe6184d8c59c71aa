// SPDX-License-Identifier: MIT
// What of a polygon lies in a convex body, taken off it, exactly.
#pragma once

#include <vector>

#include "join/brush_shape.h"

namespace firma {

/// What becomes of the part of a polygon that lies in a face of the body, rather than inside it.
struct CoplanarRule {
    bool same_way = false;  ///< the body's face looks the same way: whether that part is hidden
    bool against = true;    ///< the other way: likewise
};

/// Keeps its scratch from call to call.
class FaceHider {
public:
    explicit FaceHider(ExactTables& tables) : tables_(tables) {}

    /// Takes what the body hides off each of the pieces, which are replaced by what is left.
    /// What the body only stands on with an edge is divided there.
    void hide(const BrushShape& body, const CoplanarRule& rule, std::vector<ConvexPiece>& pieces);

private:
    bool hide_one(const BrushShape& body, const CoplanarRule& rule, const ConvexPiece& piece);

    ExactTables& tables_;
    std::vector<ConvexPiece> left_, outside_;
    ConvexPiece rest_, behind_, front_;
};

}  // namespace firma
