// SPDX-License-Identifier: MIT
// What became of edges that a cut divided, for what else runs along them: rims of portals.
#pragma once

#include <cstdint>
#include <vector>

#include "carve/make_faces.h"
#include "carve/new_loops.h"
#include "geometry/grid_box.h"
#include "solid/solid_face.h"
#include "solid/solid_patch.h"

namespace firma {

class EdgeParts {
public:
    /// @param patch, loops, maker  those of a cut that is done; live as long as this
    EdgeParts(const SolidPatch& patch, const NewLoops& loops, FaceMaker& maker);

    /// @param parts  gets the edges that take its place, as it ran; as faces have them
    /// @return whether any do
    bool divide(const PatchUse& use, std::vector<SolidUse>& parts) const;
    /// An edge as faces have it.
    void append(const PatchUse& use, std::vector<SolidUse>& uses) const;
    /// Around all edges that are divided.
    const GridBox& box() const { return box_; }

private:
    const SolidPatch& patch_;
    const NewLoops& loops_;
    FaceMaker& maker_;
    std::vector<std::uint32_t> division_of_edge_;  ///< of the patch: NewLoops::divisions; ~0: none. Empty: none at all
    GridBox box_;
};

}  // namespace firma
