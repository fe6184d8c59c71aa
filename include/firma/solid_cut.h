// SPDX-License-Identifier: MIT
// A closed cutter taken away from a Solid, or added to it, exactly; no World is needed. Carving in a World is carve.h.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

#include "firma/carve_rules.h"
#include "firma/cutter.h"
#include "firma/export.h"
#include "firma/result.h"
#include "firma/solid.h"

namespace firma {

enum class CarveKind : std::uint8_t { kCarve, kFill };

enum class CarveStatus : std::uint8_t {
    kDone,
    kNothing,  ///< the cutter met nothing to take away (or, filling, nothing to fill): all is as it was.
               ///< CarveReport::faces_castable_only says whether it met faces that no edit changes
    kRefused,  ///< `error` says why; all is as it was
};

/// What an edit did, and what it cost.
struct CarveReport {
    std::size_t faces_looked_at = 0;      ///< exact faces near the cutter: in its box, without what is clear of it
    std::size_t faces_cut = 0;            ///< of these, how many the cutter's surface crosses
    std::size_t faces_gone = 0;           ///< facets that casts met before and meet no more
    std::size_t faces_new = 0;            ///< facets that casts meet from now on
    std::size_t faces_castable_only = 0;  ///< that reach into the cutter and are left as they are: they bound no solid
    int retries = 0;    ///< how often the cutter, or some of it, was moved by steps of the grid, as it touched
    double scale = 1;   ///< what zones and materials left of the cutter's scale
    double volume = 0;  ///< cubic metres taken from the solid; negative when it was added to

    /// Where the time went, microseconds.
    struct Times {
        double place = 0;   ///< cutter turned, snapped, checked
        double gather = 0;  ///< faces taken out of the tree
        double cut = 0;     ///< faces against triangles
        double label = 0;   ///< inside and outside
        double trace = 0;   ///< loops of new faces
        double facets = 0;  ///< what casts meet
        double tree = 0;    ///< new blocks
        FIRMA_INLINE double total() const { return place + gather + cut + label + trace + facets + tree; }
    } times;
};

/// What became of a solid.
struct SolidResult {
    CarveStatus status = CarveStatus::kRefused;
    Solid solid;         ///< after the edit; the one before unless kDone
    Error error;         ///< for kRefused
    CarveReport report;  ///< as of a world
    std::string
        reproduction;  ///< for a refusal that should not be possible: an .obj with what it takes to see it again

    bool done() const { return status == CarveStatus::kDone; }
};

struct SolidCutOptions {
    std::uint32_t material = 0;         ///< of the faces that the cutter leaves
    const CarveRules* rules = nullptr;  ///< null: none
};

/// Takes a placed cutter away from a solid, by the rules of carve(): the faces of the result are those that a world
/// around the solid would have. Costs what the cut costs.
FIRMA_EXPORT SolidResult subtract(const Solid& solid, const Cutter& cutter, const Pose& pose,
                                  const SolidCutOptions& options = {});

/// Adds a placed cutter to a solid, by the same rules.
FIRMA_EXPORT SolidResult unite(const Solid& solid, const Cutter& cutter, const Pose& pose,
                               const SolidCutOptions& options = {});

}  // namespace firma
