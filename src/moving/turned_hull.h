// SPDX-License-Identifier: MIT
// A hull as a part sees it that stands turned: which faces it overlaps, and how it gets out of each.
#pragma once

#include "cast/hull_shape.h"
#include "geometry/polygon_shape.h"
#include "moving/corner_list.h"
#include "moving/part_frame.h"

namespace firma {

/// In doubles: what overlaps, or does not, by less than a nanometre may be told either way.
class TurnedHull {
public:
    /// @param hull  valid
    TurnedHull(const PartFrame& frame, const Hull& hull, const Vec3& at);

    /// In the part's frame.
    void overlap_each(const MovingPart& part, const NearOptions& options, OverlapVisitor visit) const;

private:
    std::span<const Vec3> corners() const { return corner_.all(); }
    double out_along(const PolygonShape& face, const Vec3& direction) const;
    Overlap way_out(const PolygonShape& face, bool two_sided) const;
    void put_point(const PolygonShape& face, Overlap& overlap) const;

    const PartFrame& frame_;
    const HullShape& shape_;
    CornerList corner_;  ///< in the part's frame
    Vec3 place_;         ///< where the hull is put, in the part's frame
};

}  // namespace firma
