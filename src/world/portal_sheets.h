// SPDX-License-Identifier: MIT
// Portals' polygons, made of exact faces; and what an edit does to them where it divides edges that they end at.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "carve/cut_job.h"
#include "solid/make_facets.h"
#include "world/cells.h"

namespace firma {

/// Puts exact faces and their facets into a portal. Keeps its scratch.
class SheetMaker {
public:
    /// Makes the facets of a face.
    /// @param uses  of all loops in a row, `ends` where each ends; as in SolidFace
    void add(const Ref<const SolidPlane>& plane, std::span<const SolidUse> uses, std::span<const std::uint32_t> ends,
             PortalPart& part);

private:
    FacetMaker facet_maker_;
    Facets facets_;
    std::vector<GridPoint> points_;
    std::vector<Vec3> exact_;
};

/// The polygons of a portal, with edges, as a fill takes them.
/// @param air  the rooms in front of it, and behind
/// @param portal  Portal::is_exact()
void append_sheets(const Portal& portal, std::uint32_t number, std::array<RoomId, 2> air,
                   std::vector<CutSheet>& sheets);

/// A portal after a cut: each edge that the cut divided is its parts. Nothing where it divided none. What is seen of
/// the portal stays as it was, but for corners along its rim.
/// @param portal  Portal::is_exact()
std::optional<PortalPart> divide_portal(const Portal& portal, CutJob& cut, SheetMaker& maker);

}  // namespace firma
