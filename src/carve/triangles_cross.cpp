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

int sign_of(Int128 value) {
    return value > 0 ? 1 : value < 0 ? -1 : 0;
}

int side(const InputPoint& a, const AreaVector& normal, const InputPoint& p) {
    return sign_of(Int128(normal.x) * (p.x - a.x) + Int128(normal.y) * (p.y - a.y) + Int128(normal.z) * (p.z - a.z));
}

int orient(const InputPoint& a, const InputPoint& b, const InputPoint& c, const InputPoint& p) {
    return side(a, area_vector(a, b, c), p);
}

/// A triangle with its plane. Views, for the length of one question.
struct Corners {
    const InputPoint& a;
    const InputPoint& b;
    const InputPoint& c;
    AreaVector normal = area_vector(a, b, c);

    int side_of(const InputPoint& p) const { return side(a, normal, p); }
};

/// The two axes left when a plane is seen along the largest component of its normal. The view may be a mirrored one:
/// signs are only compared with each other.
struct View {
    int u = 0, v = 1;

    explicit View(const AreaVector& normal) {
        const auto size = [](std::int64_t n) { return n < 0 ? -n : n; };
        const std::int64_t x = size(normal.x), y = size(normal.y), z = size(normal.z);
        if (x >= y && x >= z) {
            u = 1;
            v = 2;
        } else if (y >= z) {
            u = 2;
            v = 0;
        }
    }
    int turn(const InputPoint& a, const InputPoint& b, const InputPoint& p) const {
        const std::int64_t bu = b[u] - a[u], bv = b[v] - a[v], pu = p[u] - a[u], pv = p[v] - a[v];
        const std::int64_t area = bu * pv - bv * pu;
        return area > 0 ? 1 : area < 0 ? -1 : 0;
    }
    bool in_triangle(const Corners& t, const InputPoint& p) const {
        const int ab = turn(t.a, t.b, p), bc = turn(t.b, t.c, p), ca = turn(t.c, t.a, p);
        return (ab >= 0 && bc >= 0 && ca >= 0) || (ab <= 0 && bc <= 0 && ca <= 0);
    }
    /// Whether p, on the line a b, lies between the two, or at one.
    bool between(const InputPoint& a, const InputPoint& b, const InputPoint& p) const {
        const int axis = a[u] != b[u] ? u : v;
        return a[axis] < b[axis] ? a[axis] <= p[axis] && p[axis] <= b[axis] : b[axis] <= p[axis] && p[axis] <= a[axis];
    }
    bool segments_meet(const InputPoint& a, const InputPoint& b, const InputPoint& p, const InputPoint& q) const {
        const int sp = turn(a, b, p), sq = turn(a, b, q), sa = turn(p, q, a), sb = turn(p, q, b);
        if (sp * sq < 0 && sa * sb < 0) return true;
        return (sp == 0 && between(a, b, p)) || (sq == 0 && between(a, b, q)) || (sa == 0 && between(p, q, a)) ||
               (sb == 0 && between(p, q, b));
    }
};

/// Whether a closed segment meets a closed triangle, given the sides of its plane that the ends lie on.
bool segment_meets(const InputPoint& p, const InputPoint& q, int side_p, int side_q, const Corners& t) {
    if (side_p * side_q > 0) return false;
    if (side_p == 0 && side_q == 0) {
        // With both ends outside it crosses two sides, or passes through a corner: of two sides it meets one.
        const View view(t.normal);
        return view.in_triangle(t, p) || view.in_triangle(t, q) || view.segments_meet(t.a, t.b, p, q) ||
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
    const View view(t.normal);
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

AreaVector area_vector(const InputPoint& a, const InputPoint& b, const InputPoint& c) {
    const std::int64_t ux = b.x - a.x, uy = b.y - a.y, uz = b.z - a.z;
    const std::int64_t vx = c.x - a.x, vy = c.y - a.y, vz = c.z - a.z;
    return {uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx};
}

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
