// SPDX-License-Identifier: MIT
// A change to a solid as a value, and the solid after it.
#pragma once

#include <cstdint>
#include <vector>

#include "firma/solid.h"
#include "solid/face_store.h"
#include "solid/solid_data.h"

namespace firma {

struct SolidChange {
    std::vector<FacetPlace> removed;  ///< each facet once
    FaceSet added;                    ///< ids as FaceIds gives them, in a canonical order; parts may be set
    SumsByKey points;                 ///< what comes to SolidData::points
    std::uint32_t edit = 0;           ///< its number; 0: the one after the last
    std::uint32_t next_face = 0;      ///< SolidData::next_face after it; 0: behind as many ids as faces were added
};

/// Makes a solid of the one before, step by step.
class SolidEdit {
public:
    /// @param solid  kept alive
    SolidEdit(const Solid& solid, SolidChange change);

    /// Does one piece of work, some 10 us; false once there is none left.
    bool step();

    /// Once step() said false: one edit on.
    const Solid& result() const { return result_; }
    /// What it did to the faces' blocks.
    const StoreEdit& store() const { return edit_; }

private:
    const Solid before_;
    Solid result_;
    SumsByKey points_;
    std::uint32_t next_face_, number_;
    StoreEdit edit_;
};

}  // namespace firma
