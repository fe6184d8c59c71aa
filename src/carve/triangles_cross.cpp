// SPDX-License-Identifier: MIT
// Pairs of triangles by how many vertices they share; what is left are segments against triangles.
//
// Letters: T and U are the triangles; orient(a, b, c, p) is (b - a) x (c - a) . (p - a), positive on the side from
// which a b c run counter-clockwise. Differences have 27 bits with sign, minors 55, the determinant 83.
// Source: the signs are those of P. Guigue and O. Devillers, Fast and Robust Triangle-Triangle Overlap Test Using
// Orientation Predicates, 2003, section 2; the cases of shared vertices are our own.
#include "carve/triangles_cross.h"

#include <cstddef>

namespace firma {
namespace {

/// A triangle with its plane. Views, for the length of one question.
struct Corners {
    const InputPoint& a;
    const InputPoint& b;
    const InputPoint& c;
    AreaVector normal = area_vector(a, b, c);

    int side_of(const InputPoint& p) const { return side_of_plane(a, normal, p); }
};

bool in_triangle(const GridView& view, const Corners& t, const InputPoint& p) {
    const int ab = view.turn(t.a, t.b, p), bc = view.turn(t.b, t.c, p), ca = view.turn(t.c, t.a, p);
    return (ab >= 0 && bc >= 0 && ca >= 0) || (ab <= 0 && bc <= 0 && ca <= 0);
}

/// Whether a closed segment meets a closed triangle, given the sides of its plane that the ends lie on.
bool segment_meets(const InputPoint& p, const InputPoint& q, int side_p, int side_q, const Corners& t) {
    if (side_p * side_q > 0) return false;
    if (side_p == 0 && side_q == 0) {
        // With both ends outside it crosses two sides, or passes through a corner: of two sides it meets one.
        const GridView view(t.normal);
        return in_triangle(view, t, p) || in_triangle(view, t, q) || view.segments_meet(t.a, t.b, p, q) ||
               view.segments_meet(t.b, t.c, p, q);
    }
    // The line p q meets the plane in one point: in the triangle when it leaves all sides on one hand.
    const int ab = orient(p, q, t.a, t.b), bc = orient(p, q, t.b, t.c);
    if (ab * bc < 0) return false;
    const int ca = orient(p, q, t.c, t.a);
    return ab * ca >= 0 && bc * ca >= 0;
}

/// No vertex in common: an edge of one meets the other wherever two triangles meet.
bool apart_cross(const Corners& t, const Corners& u) {
    const int ta = u.side_of(t.a), tb = u.side_of(t.b), tc = u.side_of(t.c);
    if ((ta > 0 && tb > 0 && tc > 0) || (ta < 0 && tb < 0 && tc < 0)) return false;
    const int ua = t.side_of(u.a), ub = t.side_of(u.b), uc = t.side_of(u.c);
    if ((ua > 0 && ub > 0 && uc > 0) || (ua < 0 && ub < 0 && uc < 0)) return false;
    return segment_meets(t.a, t.b, ta, tb, u) || segment_meets(t.b, t.c, tb, tc, u) ||
           segment_meets(t.c, t.a, tc, ta, u) || segment_meets(u.a, u.b, ua, ub, t) ||
           segment_meets(u.b, u.c, ub, uc, t) || segment_meets(u.c, u.a, uc, ua, t);
}

/// Vertex a in common. Whatever else they share, the ray from a through it leaves one of the two first, across the side
/// opposite to a, and is still in the other there. No such side holds a, so nothing is mistaken for the shared vertex.
bool vertex_cross(const Corners& t, const Corners& u) {
    const int tb = u.side_of(t.b), tc = u.side_of(t.c);
    if (tb * tc > 0) return false;
    const int ub = t.side_of(u.b), uc = t.side_of(u.c);
    if (ub * uc > 0) return false;
    return segment_meets(t.b, t.c, tb, tc, u) || segment_meets(u.b, u.c, ub, uc, t);
}

/// The edge between a and b in common: only triangles of one plane can share more, when folded onto each other.
bool edge_cross(const Corners& t, const InputPoint& other) {
    if (t.side_of(other) != 0) return false;
    const GridView view(t.normal);
    return view.turn(t.a, t.b, t.c) == view.turn(t.a, t.b, other);
}

/// A triangle's corners with the shared ones first.
CutterTriangle shared_first(const CutterTriangle& t, const CutterTriangle& u, std::size_t& shared) {
    CutterTriangle first{};
    std::size_t front = 0, back = 3;
    for (const std::uint32_t corner : t) {
        const bool is_shared = corner == u[0] || corner == u[1] || corner == u[2];
        first[is_shared ? front++ : --back] = corner;
    }
    shared = front;
    return first;
}

}  // namespace

bool triangles_cross(std::span<const InputPoint> vertices, const CutterTriangle& t, const CutterTriangle& u) {
    std::size_t shared = 0;
    const CutterTriangle p = shared_first(t, u, shared), q = shared_first(u, t, shared);
    if (shared == 3) return true;
    const Corners first{vertices[p[0]], vertices[p[1]], vertices[p[2]]};
    if (shared == 2) return edge_cross(first, vertices[q[2]]);
    const Corners second{vertices[q[0]], vertices[q[1]], vertices[q[2]]};
    return shared == 1 ? vertex_cross(first, second) : apart_cross(first, second);
}

}  // namespace firma
