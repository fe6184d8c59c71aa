// SPDX-License-Identifier: MIT
// How far a hull stands out from what it is the hull of.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "convex/grid_hull.h"
#include "convex/sides.h"
#include "firma/vec.h"

namespace firma {

/// The faces of a solid in metres, for distances from it.
class SidesDistance {
public:
    SidesDistance(const ConvexSpace& space, const SolidSides& solid);

    /// To the nearest face, metres; what is farther than `reach` may come out as that.
    [[nodiscard]] double distance(const Vec3& from, double reach) const;
    /// Whether a point lies in the solid; either for one that rounding leaves open, as near to a face.
    [[nodiscard]] bool contains(const Vec3& point) const;

private:
    struct Segment {
        Vec3 from, to;
    };
    struct Face {
        Vec3 normal;
        double offset = 0;
        Box box;
        std::uint32_t first = 0, end = 0;  ///< of its segments
        int u = 0, v = 1;                  ///< axes that are left, seen along the third
    };
    [[nodiscard]] bool within(const Face& face, const Vec3& at, int u, int v) const;
    [[nodiscard]] double distance(const Face& face, const Vec3& from) const;

    std::vector<Face> faces_;
    std::vector<Segment> segments_;
};

/// Whether no point of a hull is farther than `most` from the solid that it is the hull of.
/// @return a bound on the farthest, at most `most`; nothing where some is farther, or it would take too long to say
/// Halves boxes until each is near enough or outside.
std::optional<double> overhang_within(const SidesDistance& solid, const GridHull& hull, double most);

}  // namespace firma
