// SPDX-License-Identifier: MIT
// Two convex pieces are convex together where both have the same polygon in a plane between them, and at each of its
// sides their next faces lie in one plane or meet in a convex edge: then all of the union's edges are convex.
#include "convex/merge_convex.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "base/sort.h"

namespace firma {
namespace {

/// A polygon between two pieces, by its plane and its corners in order of number.
struct PolygonKey {
    PlaneId plane = kNoPlane;
    std::vector<std::uint32_t> corners;
    friend auto operator<=>(const PolygonKey&, const PolygonKey&) = default;
};

struct FaceOfPiece {
    std::uint32_t piece = 0, face = 0;
};

PolygonKey key_of(const ConvexPiece& polygon) {
    PolygonKey key;
    key.plane = polygon.plane & ~1u;
    for (const PieceSide& side : polygon.sides) key.corners.push_back(side.corner);
    sort_range(key.corners);
    return key;
}

class PieceJoiner {
public:
    PieceJoiner(ConvexSpace& space, std::vector<ConvexShape>& pieces) : space_(space), pieces_(pieces) {}

    std::size_t run() {
        std::size_t merged = 0;
        for (std::uint32_t k = 0; k < pieces_.size(); ++k) enter(k);
        while (!pairs_.empty()) {
            const Pair best = pairs_.front();
            std::pop_heap(pairs_.begin(), pairs_.end(), later);
            pairs_.pop_back();
            if (pieces_[best.a].planes.empty() || pieces_[best.b].planes.empty()) continue;
            merged += merge(best);
        }
        std::erase_if(pieces_, [](const ConvexShape& piece) { return piece.planes.empty(); });
        return merged;
    }

private:
    struct Pair {
        double area = 0;
        std::uint32_t a = 0, b = 0;  ///< a was before b
        PlaneId plane = kNoPlane;
    };
    /// The largest first, of several the first.
    static bool later(const Pair& x, const Pair& y) {
        if (x.area != y.area) return x.area < y.area;
        return std::pair(x.a, x.b) > std::pair(y.a, y.b);
    }

    /// Notes with which of the pieces so far this one is convex.
    void enter(std::uint32_t piece) {
        const std::vector<BrushShape::Face>& faces = pieces_[piece].shape.faces;
        for (std::uint32_t f = 0; f < faces.size(); ++f) {
            std::vector<FaceOfPiece>& known = faces_[key_of(faces[f].piece)];
            for (const FaceOfPiece& other : known) {
                const ConvexShape& beside = pieces_[other.piece];
                if (beside.planes.empty()) continue;
                if (!fits(faces[f].piece, beside.shape.faces[other.face].piece)) continue;
                pairs_.push_back({area(faces[f].piece), other.piece, piece, faces[f].piece.plane});
                std::push_heap(pairs_.begin(), pairs_.end(), later);
            }
            known.push_back({piece, f});
        }
    }

    /// Twice the area as rounded, square steps.
    double area(const ConvexPiece& polygon) const {
        const Vec3& apex = space_.point(polygon.corner(0)).approximate();
        Vec3 sum;
        for (std::size_t k = 2; k < polygon.sides.size(); ++k)
            sum += cross(space_.point(polygon.corner(k - 1)).approximate() - apex,
                         space_.point(polygon.corner(k)).approximate() - apex);
        return length(sum);
    }

    bool fits(const ConvexPiece& own, const ConvexPiece& other) {
        if (own.plane != from_behind(other.plane)) return false;
        for (std::size_t k = 0; k < own.sides.size(); ++k) {
            const std::uint32_t from = own.corner(k), to = own.corner(own.next(k));
            std::size_t back = 0;
            while (back < other.sides.size() && other.corner(back) != to) ++back;
            if (back == other.sides.size() || other.corner(other.next(back)) != from) return false;
            const PlaneId a = own.sides[k].plane, b = other.sides[back].plane;
            if (a == b) continue;
            if (same_plane(a, b)) return false;
            // The face beyond the own side runs from `to` to `from` along it.
            const std::uint32_t line = space_.lines.add(a, b, to);
            const int along = space_.lines.before(line, to, from) ? 1 : -1;
            if (along * space_.lines.turn(line, a, b) <= 0) return false;
        }
        return true;
    }

    bool merge(const Pair& pair) {
        std::vector<PlaneId> planes;
        for (const std::uint32_t piece : {pair.a, pair.b})
            for (const PlaneId plane : pieces_[piece].planes)
                if (!same_plane(plane, pair.plane)) planes.push_back(plane);
        ConvexShape made;
        if (!make_convex_shape(space_, std::move(planes), made)) return false;
        made.number = pieces_[pair.a].number;
        pieces_[pair.a].planes.clear();
        pieces_[pair.b].planes.clear();
        pieces_.push_back(std::move(made));
        enter(std::uint32_t(pieces_.size() - 1));
        return true;
    }

    ConvexSpace& space_;
    std::vector<ConvexShape>& pieces_;
    std::map<PolygonKey, std::vector<FaceOfPiece>> faces_;
    std::vector<Pair> pairs_;  ///< a heap
};

}  // namespace

bool make_convex_shape(ConvexSpace& space, std::vector<PlaneId> planes, ConvexShape& made) {
    sort_once(planes);
    if (make_brush_shape(space.tables, planes, made.shape) != BrushFault::kNone) return false;
    made.planes.clear();
    for (const BrushShape::Face& face : made.shape.faces) made.planes.push_back(face.piece.plane);
    sort_once(made.planes);
    return true;
}

std::size_t merge_convex(ConvexSpace& space, std::vector<ConvexShape>& pieces) {
    return PieceJoiner(space, pieces).run();
}

}  // namespace firma
