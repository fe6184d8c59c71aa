// SPDX-License-Identifier: MIT
// Divides an outline into triangles: judged first, clipped, and the pieces judged again.
#include "level/divide_polygon.h"

#include <algorithm>
#include <tuple>

#include "geometry/polygon_shape.h"
#include "level/clip_ears.h"
#include "level/judge_outline.h"

namespace firma {
namespace {

__extension__ using Wide = __int128;
using Judge = OutlineJudge<std::int64_t, Wide, GridPoint>;
using Triangle = std::array<std::uint32_t, 3>;

/// A direction that the outline is seen from, so that it runs counter-clockwise: an axis, and which way along it.
struct View {
    int axis = 2;
    bool flip = false;
};

/// Along the outline's normal; where that is zero, along the normal of any three corners that are not on one line.
View view_of(std::span<const GridPoint> outline, const Judge& judge) {
    if (judge.has_normal()) return {judge.dominant_axis(), judge.normal()[std::size_t(judge.dominant_axis())] < 0};
    std::array<GridPoint, 3> corners{outline[0], outline[0], outline[0]};
    for (const GridPoint& corner : outline) {
        if (corners[1] == corners[0]) corners[1] = corner;
        corners[2] = corner;
        const Judge three{std::span<const GridPoint>(corners)};
        if (three.has_normal()) return {three.dominant_axis(), three.normal()[std::size_t(three.dominant_axis())] < 0};
    }
    return {};
}

bool has_area(std::span<const GridPoint> outline, const Triangle& triangle) {
    const std::array<GridPoint, 3> corners{outline[triangle[0]], outline[triangle[1]], outline[triangle[2]]};
    return Judge(std::span<const GridPoint>(corners)).has_normal();
}

/// The pieces as seen, to tell whether they overlap. Those seen edge-on cover nothing and are left out.
class Pieces {
public:
    Pieces(std::span<const GridPoint> outline, std::span<const Triangle> triangles, View view) {
        const int u = (view.axis + (view.flip ? 2 : 1)) % 3, v = (view.axis + (view.flip ? 1 : 2)) % 3;
        pieces_.reserve(triangles.size());
        for (const Triangle& triangle : triangles) {
            Piece piece;
            for (std::size_t k = 0; k < 3; ++k) piece.corners[k] = {outline[triangle[k]][u], outline[triangle[k]][v]};
            if (side(piece.corners[0], piece.corners[1], piece.corners[2]) == 0) continue;
            for (std::size_t axis = 0; axis < 2; ++axis) {
                const auto& c = piece.corners;
                std::tie(piece.low[axis], piece.high[axis]) = std::minmax({c[0][axis], c[1][axis], c[2][axis]});
            }
            pieces_.push_back(piece);
        }
        std::sort(pieces_.begin(), pieces_.end(), [](const Piece& a, const Piece& b) { return a.low < b.low; });
    }

    /// Whether a piece is seen from behind.
    bool any_turned() const {
        return std::any_of(pieces_.begin(), pieces_.end(),
                           [](const Piece& p) { return side(p.corners[0], p.corners[1], p.corners[2]) < 0; });
    }

    /// Whether the insides of two pieces share a point. Swept along the first axis.
    bool any_overlap() const {
        for (std::size_t a = 0; a < pieces_.size(); ++a)
            for (std::size_t b = a + 1; b < pieces_.size() && pieces_[b].low[0] < pieces_[a].high[0]; ++b)
                if (overlap(pieces_[a], pieces_[b])) return true;
        return false;
    }

private:
    using Point = std::array<std::int64_t, 2>;
    struct Piece {
        std::array<Point, 3> corners;
        Point low, high;
    };

    static int side(const Point& a, const Point& b, const Point& p) {
        const Wide area = Wide(b[0] - a[0]) * (p[1] - a[1]) - Wide(b[1] - a[1]) * (p[0] - a[0]);
        return (area > 0) - (area < 0);
    }
    /// Two convex shapes are apart when a side of one of them has the whole of the other outside.
    static bool divides(const Piece& a, const Piece& b) {
        for (std::size_t k = 0; k < 3; ++k) {
            const Point &from = a.corners[k], &to = a.corners[(k + 1) % 3];
            if (side(from, to, b.corners[0]) <= 0 && side(from, to, b.corners[1]) <= 0 &&
                side(from, to, b.corners[2]) <= 0)
                return true;
        }
        return false;
    }
    static bool overlap(const Piece& a, const Piece& b) {
        if (a.low[1] >= b.high[1] || b.low[1] >= a.high[1]) return false;
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

    const View view = view_of(outline, judge);
    EarClipper clipper(outline, view.axis, view.flip);
    while (const auto triangle = clipper.next())
        if (has_area(outline, *triangle)) division.triangles.push_back(*triangle);
    if (division.triangles.empty()) return division;

    division.what = Division::What::kSplit;
    if (form == OutlineForm::kConvex) return division;
    const Pieces pieces(outline, division.triangles, view);
    if (pieces.any_turned() || pieces.any_overlap()) division.what = Division::What::kCrossing;
    return division;
}

}  // namespace firma
