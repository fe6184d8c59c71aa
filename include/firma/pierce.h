// SPDX-License-Identifier: MIT
// What a straight path goes through: where it goes into solid and where it comes out, how thick that is, and of which
// matter.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "firma/export.h"
#include "firma/hit.h"
#include "firma/polygon.h"
#include "firma/solid.h"
#include "firma/vec.h"
#include "firma/world.h"

namespace firma {

/// Where a path goes into solid, or comes out.
struct PierceEnd {
    double fraction = 0;  ///< of the path
    Vec3 point;           ///< metres, on the path
    Vec3 normal;          ///< unit, of the face, out of the solid; zero where there is none
    FaceRef face;         ///< invalid where the path starts or ends in the solid, and of a closed portal
    std::uint32_t material = 0;
};

/// A stretch of solid that a path goes through; or a pane, which has no thickness.
struct PierceSpan {
    PierceEnd in, out;               ///< of a pane the same
    double thickness = 0;            ///< metres along the path
    std::uint32_t first_matter = 0;  ///< in Piercing::matters, in the order of the path
    std::uint32_t matter_count = 0;  ///< 0 of panes, and where they were not asked for
    PortalId portal;                 ///< of a closed portal
    bool pane = false;               ///< a face that bounds no solid, or a closed portal
    bool starts_inside = false;      ///< the path starts in this solid
    bool ends_inside = false;        ///< and ends in it
};

/// A part of a stretch that is of one matter.
struct MatterLength {
    std::uint32_t matter = 0;  ///< index into MatterTable::matters
    double from = 0, to = 0;   ///< fractions of the path
    double length = 0;         ///< metres
};

/// What pierce() works in: memory, and nothing that anyone could ask for. A copy is a new one.
class PierceScratch {
public:
    struct Data;

    FIRMA_EXPORT PierceScratch();
    FIRMA_EXPORT PierceScratch(const PierceScratch& other);
    FIRMA_EXPORT PierceScratch(PierceScratch&& other) noexcept;
    FIRMA_EXPORT PierceScratch& operator=(const PierceScratch& other);
    FIRMA_EXPORT PierceScratch& operator=(PierceScratch&& other) noexcept;
    FIRMA_EXPORT ~PierceScratch();

    FIRMA_EXPORT Data& data();

private:
    std::unique_ptr<Data> data_;  ///< null until it is used
};

/// What pierce() finds. It keeps its memory from call to call.
struct Piercing {
    /// By the fraction at which they begin; at one fraction panes first, by id, faces before portals.
    std::vector<PierceSpan> spans;
    std::vector<MatterLength> matters;  ///< of all stretches in a row
    double thickness = 0;               ///< metres of solid in all that is told
    PierceScratch scratch;
};

struct PierceOptions {
    /// Panes that share a bit are told, and stretches whose face where the path goes in does (where it starts inside,
    /// the face where it comes out; where it is inside all the way, always).
    std::uint32_t mask = ~0u;
    Sides sides = Sides::kFront;  ///< of panes, as CastOptions::sides
    bool panes = true;
    bool matters = true;
    /// Of the start, where it is known: kAir or kSolid. Saves looking for it where the path crosses no face.
    Where start = Where::kUnknown;
};

/// All solid that a straight path goes through, and the panes.
///
/// A stretch of solid is what lies behind faces that bound solid (FaceInfo::solid). Whether the path passes through
/// each is decided exactly, so in and out alternate, through edges and vertices too, and no path slips between faces.
/// Where that is, is rounded, within 1e-9 m of the face. What the path touches in a point or runs along, exactly, a
/// face or an edge, is not solid that it goes through; but along an edge around which more is solid than air it may be
/// told. A path that starts on a face and leads into the solid goes in at fraction 0; one that ends on the face where
/// it comes out does so at 1. Stretches shorter than 1e-9 m are not told, and gaps of air that are shorter do not
/// divide one. (Where rounding to the surface grid folded the surface, a few millionths of a metre wide, a stretch may
/// be longer or shorter by as much.)
///
/// A matter changes where the path passes a plane of one of the level's pieces, to 1e-9 m from that plane; which piece
/// counts says matter_at(). What no piece holds is of the rest. Pieces that are less than 1e-9 m of the path belong to
/// the one before. The lengths of a stretch add up to its thickness, to rounding.
///
/// Panes are faces that bound no solid, which are met as by cast(), and closed portals, from either side; told inside
/// of solid as well. Of a closed pane of glass whose faces look outward that is the one where the path goes in.
///
/// @param ray    its path may lead outside the world
/// @param found  replaced
/// @return kInitialOverlap when the path starts in solid that is told, kHit when it meets anything, kMiss when not and
///         for a zero path; kInvalid, with nothing found, for a number that is not finite or beyond 2^200
/// Allocates only to grow `found`. Costs cast_all() of the path, signs of the edges of each face that is met, and for
/// matters the pieces of the level near each stretch. What crosses no face also costs a locate().
FIRMA_EXPORT Status pierce(const World& world, const Ray& ray, Piercing& found, const PierceOptions& options = {});

}  // namespace firma
