// SPDX-License-Identifier: MIT
// Convex pieces as they are handed out: a solid and numbers of an exact one, numbers alone of a hull.
#include "convex/convex_output.h"

#include <algorithm>
#include <map>

#include "join/body_solid.h"
#include "solid/measure_boundary.h"
#include "solid/moment_sum.h"

namespace firma {
namespace {

/// Corners that were rounded to one place are one.
class CornerNumbers {
public:
    explicit CornerNumbers(ConvexBody& piece) : piece_(piece) {}

    std::uint32_t of(const GridPoint& point) {
        const auto [known, fresh] = number_.try_emplace(point, std::uint32_t(piece_.corners.size()));
        if (fresh) piece_.corners.push_back(to_metres(point));
        return known->second;
    }

private:
    ConvexBody& piece_;
    std::map<GridPoint, std::uint32_t> number_;
};

MassProperties mass_of_sides(const ConvexSpace& space, const SolidSides& solid, double density) {
    GridBox box;
    for (const FaceSide& side : solid.sides) box.add(space.point(side.from).rounded());
    MomentSum sum(middle_of(box));
    std::vector<bool> seen(solid.size(), false);
    for (std::uint32_t start = 0; start < solid.size(); ++start) {
        std::vector<std::uint32_t> corners;
        for (std::uint32_t k = start; !seen[k]; k = solid.next[k]) {
            seen[k] = true;
            corners.push_back(solid.sides[k].from);
        }
        const auto end = std::uint32_t(corners.size());
        if (end > 0)
            sum.add_face(space.plane(solid.sides[start].plane), {&end, 1},
                         [&](std::uint32_t k) -> const ExactPoint& { return space.point(corners[k]); });
    }
    return mass_of(sum.sums(), sum.apex(), density);
}

}  // namespace

std::vector<GridPoint> corners_of_sides(const ConvexSpace& space, const FaceSides& sides) {
    std::vector<GridPoint> corners;
    for (const FaceSide& side : sides) corners.push_back(space.point(side.from).rounded());
    return corners;
}

std::optional<ConvexBody> piece_of_shape(ConvexSpace& space, const ConvexShape& shape, double density) {
    std::vector<Ref<const SolidPlane>> planes;
    for (const PlaneId plane : shape.planes) planes.push_back(space.tables.planes.stored(plane));
    const std::optional<Solid> solid = solid_of_planes(planes);
    if (!solid) return std::nullopt;
    ConvexBody piece;
    piece.solid = *solid;
    CornerNumbers numbers(piece);
    std::vector<GridPoint> points;
    for (const BrushShape::Face& face : shape.shape.faces) {
        const Plane& plane = space.plane(face.piece.plane);
        ConvexFace made{plane.unit_normal(), -plane.d / kInputSteps / length(plane.direction()),
                        std::uint32_t(piece.loops.size()), 0};
        for (const PieceSide& side : face.piece.sides) {
            points.push_back(space.point(side.corner).rounded());
            const std::uint32_t corner = numbers.of(points.back());
            if (piece.loops.size() == made.first || piece.loops.back() != corner) piece.loops.push_back(corner);
        }
        while (piece.loops.size() > made.first + 1 && piece.loops.back() == piece.loops[made.first])
            piece.loops.pop_back();
        made.count = std::uint32_t(piece.loops.size()) - made.first;
        if (made.count >= 3)
            piece.faces.push_back(made);
        else
            piece.loops.resize(made.first);
    }
    piece.mass = mass_properties(piece.solid, density);
    piece.hull_volume = hull_of(std::move(points)).volume();
    return piece;
}

ConvexBody piece_of_hull(const ConvexSpace& space, const SolidSides& solid, const GridHull& hull, double overhang,
                         double density) {
    ConvexBody piece;
    piece.exact = false;
    for (const GridPoint& point : hull.points) piece.corners.push_back(to_metres(point));
    for (const GridHull::Triangle& triangle : hull.triangles) {
        piece.faces.push_back({triangle.normal, triangle.offset, std::uint32_t(piece.loops.size()), 3});
        piece.loops.insert(piece.loops.end(), triangle.corner.begin(), triangle.corner.end());
    }
    piece.mass = mass_of_sides(space, solid, density);
    piece.hull_volume = hull.volume();
    piece.overhang = overhang;
    return piece;
}

}  // namespace firma
