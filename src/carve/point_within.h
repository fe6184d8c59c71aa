// SPDX-License-Identifier: MIT
// A point of a face that lies within it, exactly in its plane: what tells on which side of something the face lies.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "geometry/exact_point.h"
#include "solid/make_facets.h"

namespace firma {

/// Finds such points, one after another.
class WithinFinder {
public:
    /// In the widest of its triangles.
    /// @param plane    the face's; kept alive by the caller, as long as the point
    /// @param corners  of all its loops in a row
    /// @param ends     of each loop; the outer one is first
    /// @return good until the next call; nothing where the face is so thin that rounding could put it outside
    std::optional<ExactPoint> find(const Plane& plane, const std::vector<ExactPoint>& corners,
                                   std::span<const std::uint32_t> ends);

private:
    Plane u_, v_;
    std::vector<GridPoint> points_;
    std::vector<Vec3> exact_;
    FacetMaker facet_maker_;
    Facets facets_;
};

}  // namespace firma
