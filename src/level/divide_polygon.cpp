// SPDX-License-Identifier: MIT
// Divides an outline into triangles: judged first, clipped, and the pieces judged again.
#include "level/divide_polygon.h"

#include <algorithm>

#include "geometry/clip_ears.h"
#include "geometry/flat_point.h"
#include "geometry/judge_outline.h"
#include "geometry/polygon_shape.h"

namespace firma {
namespace {

using Judge = OutlineJudge<std::int64_t, Int128, std::span<const GridPoint>>;
using Triangle = std::array<std::uint32_t, 3>;

/// Where the outline runs counter-clockwise: along its normal; where that is zero, along the normal of any three
/// corners that are not on one line.
FlatView view_of(std::span<const GridPoint> outline, const Judge& judge) {
    if (judge.has_normal()) return judge.front_view();
    std::array<GridPoint, 3> corners{outline[0], outline[0], outline[0]};
    for (const GridPoint& corner : outline) {
        if (corners[1] == corners[0]) corners[1] = corner;
        corners[2] = corner;
        const Judge three(corners);
        if (three.has_normal()) return three.front_view();
    }
    return {};
}

bool has_area(std::span<const GridPoint> outline, const Triangle& triangle) {
    const std::array<GridPoint, 3> corners{outline[triangle[0]], outline[triangle[1]], outline[triangle[2]]};
    return Judge(corners).has_normal();
}

/// All but those without area.
std::vector<Triangle> clip_ears(std::span<const GridPoint> outline, std::span<const FlatPoint> flat) {
    std::vector<RingCorner> ring(outline.size());
    link_ring(flat, 0, std::uint32_t(flat.size()), ring);
    Triangles clipped;
    EarClipper().clip(outline, ring, EarClipper::Takes::kAnything, clipped);
    std::vector<Triangle> triangles;
    for (auto corner = clipped.corners.begin(); corner != clipped.corners.end(); corner += 3) {
        const Triangle triangle{corner[0], corner[1], corner[2]};
        if (has_area(outline, triangle)) triangles.push_back(triangle);
    }
    return triangles;
}

/// The pieces as seen, to tell whether they overlap. Those seen edge-on cover nothing and are left out.
class Pieces {
public:
    Pieces(std::span<const FlatPoint> outline, std::span<const Triangle> triangles) {
        pieces_.reserve(triangles.size());
        for (const Triangle& triangle : triangles) {
            const FlatPoint &a = outline[triangle[0]], &b = outline[triangle[1]], &c = outline[triangle[2]];
            if (turn(a, b, c) == 0) continue;
            pieces_.push_back({{a, b, c},
                               {std::min({a.u, b.u, c.u}), std::min({a.v, b.v, c.v})},
                               {std::max({a.u, b.u, c.u}), std::max({a.v, b.v, c.v})}});
        }
        std::sort(pieces_.begin(), pieces_.end(), [](const Piece& a, const Piece& b) { return a.low < b.low; });
    }

    /// Whether a piece is seen from behind.
    bool any_turned() const {
        return std::any_of(pieces_.begin(), pieces_.end(),
                           [](const Piece& p) { return turn(p.corners[0], p.corners[1], p.corners[2]) < 0; });
    }

    /// Whether the insides of two pieces share a point. Swept along the first axis.
    bool any_overlap() const {
        for (std::size_t a = 0; a < pieces_.size(); ++a)
            for (std::size_t b = a + 1; b < pieces_.size() && pieces_[b].low.u < pieces_[a].high.u; ++b)
                if (overlap(pieces_[a], pieces_[b])) return true;
        return false;
    }

private:
    struct Piece {
        std::array<FlatPoint, 3> corners;
        FlatPoint low, high;
    };

    /// Two convex shapes are apart when a side of one of them has the whole of the other outside.
    static bool divides(const Piece& a, const Piece& b) {
        for (std::size_t k = 0; k < 3; ++k) {
            const FlatPoint &from = a.corners[k], &to = a.corners[(k + 1) % 3];
            if (turn(from, to, b.corners[0]) <= 0 && turn(from, to, b.corners[1]) <= 0 &&
                turn(from, to, b.corners[2]) <= 0)
                return true;
        }
        return false;
    }
    static bool overlap(const Piece& a, const Piece& b) {
        if (a.low.v >= b.high.v || b.low.v >= a.high.v) return false;
        return !divides(a, b) && !divides(b, a);
    }

    std::vector<Piece> pieces_;
};

}  // namespace

Division divide_polygon(std::span<const GridPoint> outline) {
    Division division;
    if (outline.size() < 3) return division;
    const Judge judge(outline);
    const OutlineForm form = judge.form();
    if (form == OutlineForm::kNoArea) return division;
    if (form == OutlineForm::kConvex && outline.size() <= std::size_t(kMaxCorners)) {
        division.what = Division::What::kWhole;
        return division;
    }

    const FlatView view = view_of(outline, judge);
    std::vector<FlatPoint> flat;
    flat.reserve(outline.size());
    for (const GridPoint& corner : outline) flat.push_back(project(corner, view));
    division.triangles = clip_ears(outline, flat);
    if (division.triangles.empty()) return division;

    division.what = Division::What::kSplit;
    if (form == OutlineForm::kConvex) return division;
    const Pieces pieces(flat, division.triangles);
    if (pieces.any_turned() || pieces.any_overlap()) division.what = Division::What::kCrossing;
    return division;
}

}  // namespace firma
