// SPDX-License-Identifier: MIT
// Wherever two convex polygons meet, an edge of one meets the other: so each edge of each is asked.
#include "geometry/polygons_cross.h"

#include <cstddef>

#include "geometry/polygon_shape.h"

namespace firma {
namespace {

constexpr std::size_t kNotThere = ~std::size_t(0);

std::size_t place_of(std::uint32_t point, const MeshPolygon& polygon) {
    for (std::size_t k = 0; k < polygon.corners.size(); ++k)
        if (polygon.corners[k] == point) return k;
    return kNotThere;
}

bool are_neighbours(std::size_t k, std::size_t j, const MeshPolygon& polygon) {
    const std::size_t between = k < j ? j - k : k - j;
    return between == 1 || between == polygon.corners.size() - 1;
}

/// The sides of another polygon's plane that corners lie on.
struct CornerSides {
    std::int8_t of[kMaxCorners];
    bool front = false, back = false;            ///< some
    std::size_t on_count = 0;                    ///< corners in the plane
    std::size_t on[2] = {kNotThere, kNotThere};  ///< the places of the first of them in the other polygon

    CornerSides(std::span<const InputPoint> points, const MeshPolygon& polygon, const MeshPolygon& other) {
        const InputPoint& in_plane = points[other.corners[0]];
        for (std::size_t k = 0; k < polygon.corners.size(); ++k) {
            const std::uint32_t corner = polygon.corners[k];
            const std::size_t place = place_of(corner, other);
            const int side = place != kNotThere ? 0 : side_of_plane(in_plane, other.normal, points[corner]);
            of[k] = std::int8_t(side);
            front |= side > 0;
            back |= side < 0;
            if (side != 0) continue;
            if (on_count < 2) on[on_count] = place;
            ++on_count;
        }
    }

    bool coplanar() const { return !front && !back; }
    /// Whether all lies on one side of the plane, and in it no more than a corner or an edge in common: so it is with
    /// most neighbours.
    bool apart(const MeshPolygon& other) const {
        if (front == back) return false;
        if (on_count == 0) return true;
        if (on_count > 2 || on[0] == kNotThere) return false;
        return on_count == 1 || (on[1] != kNotThere && are_neighbours(on[0], on[1], other));
    }
};

/// A polygon to be met by edges of another.
class Target {
public:
    Target(std::span<const InputPoint> points, const MeshPolygon& polygon)
        : points_(points), polygon_(polygon), view_(polygon.normal) {}

    /// Whether an edge of another polygon meets this one elsewhere than the corners and edges they have in common.
    /// @param side_a, side_b  of its ends
    bool met_by(std::uint32_t a, std::uint32_t b, int side_a, int side_b) const {
        if (side_a * side_b > 0) return false;
        if (side_a == 0 && side_b == 0) return met_within(a, b);
        if (side_a == 0) return place_of(a) == kNotThere && holds(points_[a]);
        if (side_b == 0) return place_of(b) == kNotThere && holds(points_[b]);
        return passed_by(points_[a], points_[b]);
    }

private:
    std::size_t count() const { return polygon_.corners.size(); }
    const InputPoint& corner(std::size_t k) const { return points_[polygon_.corners[k % count()]]; }
    std::size_t place_of(std::uint32_t point) const { return firma::place_of(point, polygon_); }

    /// A point of the plane.
    bool holds(const InputPoint& p) const {
        bool left = false, right = false;
        for (std::size_t k = 0; k < count(); ++k) {
            const int turn = view_.turn(corner(k), corner(k + 1), p);
            left |= turn > 0;
            right |= turn < 0;
        }
        return !left || !right;
    }

    /// A segment whose ends lie on either side: its line meets the plane in one point, in the polygon when it leaves
    /// all sides on one hand.
    bool passed_by(const InputPoint& a, const InputPoint& b) const {
        bool left = false, right = false;
        const InputPoint* last = &points_[polygon_.corners.back()];
        for (const std::uint32_t point : polygon_.corners) {
            const InputPoint* next = &points_[point];
            const int side = orient(a, b, *last, *next);
            left |= side > 0;
            right |= side < 0;
            if (left && right) return false;
            last = next;
        }
        return true;
    }

    /// A segment in the plane.
    bool met_within(std::uint32_t a, std::uint32_t b) const {
        const std::size_t at_a = place_of(a), at_b = place_of(b);
        if (at_a != kNotThere && at_b != kNotThere) return !are_neighbours(at_a, at_b, polygon_);
        if (at_a != kNotThere) return enters(at_a, points_[b]);
        if (at_b != kNotThere) return enters(at_b, points_[a]);
        if (holds(points_[a]) || holds(points_[b])) return true;
        for (std::size_t k = 0; k < count(); ++k)
            if (view_.segments_meet(corner(k), corner(k + 1), points_[a], points_[b])) return true;
        return false;
    }

    /// Whether the way from a corner to a point of the plane leads through the polygon, or along its side.
    bool enters(std::size_t k, const InputPoint& to) const {
        const int before = view_.turn(corner(k + count() - 1), corner(k), to);
        const int after = view_.turn(corner(k), corner(k + 1), to);
        return hand() > 0 ? before >= 0 && after >= 0 : before <= 0 && after <= 0;
    }
    /// Which way the corners run in this view.
    int hand() const {
        for (std::size_t k = 0; k < count(); ++k)
            if (const int turn = view_.turn(corner(k), corner(k + 1), corner(k + 2)); turn != 0) return turn;
        return 0;
    }

    std::span<const InputPoint> points_;
    const MeshPolygon& polygon_;
    const GridView view_;
};

bool edges_meet(const MeshPolygon& polygon, const CornerSides& sides, const Target& target) {
    const std::size_t count = polygon.corners.size();
    for (std::size_t k = 0; k < count; ++k) {
        const std::size_t next = k + 1 < count ? k + 1 : 0;
        if (target.met_by(polygon.corners[k], polygon.corners[next], sides.of[k], sides.of[next])) return true;
    }
    return false;
}

/// Whether two polygons of one plane lie on the same side of an edge that they share: folded onto each other.
bool folded(const MeshPolygon& p, const MeshPolygon& q) {
    const auto alike = [](std::int64_t a, std::int64_t b) { return (a > 0 && b > 0) || (a < 0 && b < 0); };
    const bool same_way = alike(p.normal.x, q.normal.x) || alike(p.normal.y, q.normal.y) ||
                          alike(p.normal.z, q.normal.z);  // they are parallel: any component that is not zero tells
    const std::size_t count_p = p.corners.size(), count_q = q.corners.size();
    for (std::size_t k = 0; k < count_p; ++k)
        for (std::size_t j = 0; j < count_q; ++j) {
            const std::uint32_t a = p.corners[k], b = p.corners[k + 1 < count_p ? k + 1 : 0];
            const std::uint32_t c = q.corners[j], d = q.corners[j + 1 < count_q ? j + 1 : 0];
            if ((a == c && b == d && same_way) || (a == d && b == c && !same_way)) return true;
        }
    return false;
}

/// Whether all that a triangle does not share with another lies strictly on one side of a plane through that.
/// @param shared  a bit for each corner of the triangle that it shares
inline bool on_one_side(std::span<const InputPoint> points, const MeshPolygon& triangle, unsigned shared,
                        const MeshPolygon& other) {
    const InputPoint& in_plane = points[other.corners[0]];
    bool front = false, back = false;
    for (unsigned k = 0; k < 3; ++k) {
        if ((shared >> k & 1) != 0) continue;
        const Int128 above = height(in_plane, other.normal, points[triangle.corners[k]]);
        if (above == 0) return false;
        front |= above > 0;
        back |= above < 0;
    }
    return front != back;
}

/// Whether two triangles have a corner or an edge in common, or nothing, as one lies on one side of the other: the
/// usual case, and all that this finds.
bool triangles_apart(std::span<const InputPoint> points, const MeshPolygon& p, const MeshPolygon& q) {
    unsigned of_p = 0, of_q = 0;
    for (unsigned k = 0; k < 3; ++k)
        for (unsigned j = 0; j < 3; ++j) {
            const auto same = unsigned(p.corners[k] == q.corners[j]);
            of_p |= same << k;
            of_q |= same << j;
        }
    return on_one_side(points, p, of_p, q) || on_one_side(points, q, of_q, p);
}

}  // namespace

AreaVector polygon_normal(std::span<const InputPoint> points, std::span<const std::uint32_t> corners) {
    for (std::size_t k = 2; k < corners.size(); ++k) {
        const AreaVector normal = area_vector(points[corners[0]], points[corners[k - 1]], points[corners[k]]);
        if (normal.x != 0 || normal.y != 0 || normal.z != 0) return normal;
    }
    return {};
}

bool polygons_cross(std::span<const InputPoint> points, const MeshPolygon& p, const MeshPolygon& q) {
    if (p.corners.size() == 3 && q.corners.size() == 3 && triangles_apart(points, p, q)) return false;
    const CornerSides of_p(points, p, q);
    if (of_p.apart(q)) return false;
    const CornerSides of_q(points, q, p);
    if (of_q.apart(p)) return false;
    if (of_p.coplanar() && folded(p, q)) return true;
    return edges_meet(p, of_p, Target(points, q)) || edges_meet(q, of_q, Target(points, p));
}

}  // namespace firma
