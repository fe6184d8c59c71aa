// SPDX-License-Identifier: MIT
// Where a hull touches a polygon: what both have farthest along the facet's direction meets there.
//
// Each is a corner, an edge or an area across the direction. Their common part, seen along it, has as corners those of
// either that lie in the other, and crossings of their edges; the point given is the mean of these.
#include "cast/make_hull_hit.h"

#include <cmath>

#include "cast/contact_polygon.h"
#include "geometry/closest_point.h"
#include "geometry/rounding.h"

namespace firma {
namespace {

/// What rounding leaves between corners that touch one plane, as a share of all sizes.
constexpr double kSamePlane = 0x1p-40;

struct Flat {
    double x = 0, y = 0;
};
Flat operator-(const Flat& a, const Flat& b) {
    return {a.x - b.x, a.y - b.y};
}
double dot(const Flat& a, const Flat& b) {
    return a.x * b.x + a.y * b.y;
}
double cross(const Flat& a, const Flat& b) {
    return a.x * b.y - a.y * b.x;
}
double length(const Flat& a) {
    return std::sqrt(dot(a, a));
}

bool on_segment(const Flat& p, const Flat& a, const Flat& b, double slack) {
    const Flat ab = b - a, ap = p - a;
    const double square = dot(ab, ab);
    const double part = square > 0 ? dot(ap, ab) / square : 0;
    const double within = part < 0 ? 0 : part > 1 ? 1 : part;
    return length(ap - Flat{ab.x * within, ab.y * within}) <= slack;
}

/// What touches the plane across a direction: corners, and the edges between them.
class Side {
public:
    void add_corner(const Vec3& at, const Flat& seen) {
        at_[count_] = at;
        seen_[count_++] = seen;
    }
    std::size_t count() const { return count_; }
    const Vec3& at(std::size_t k) const { return at_[k]; }
    const Flat& seen(std::size_t k) const { return seen_[k]; }

private:
    std::array<Vec3, kMaxHullCorners> at_;
    std::array<Flat, kMaxHullCorners> seen_;
    std::size_t count_ = 0;
};

/// The corners' mean.
struct MeanPoint {
    Vec3 sum;
    double count = 0;
    void add(const Vec3& p) {
        sum = sum + p;
        ++count;
    }
};

class Touching {
public:
    /// @param place  where the hull is put, less the polygon's first corner
    /// @param reach    from what the rounding of `place` come
    Touching(const Vec3& place, double reach, const HullShape& hull, const PolygonShape& polygon, const Vec3& unit)
        : hull_(hull) {
        const Vec3 least = std::fabs(unit.x) < 0.6 ? Vec3{1, 0, 0} : Vec3{0, 1, 0};
        across_ = cross(unit, least) * (1 / firma::length(cross(unit, least)));
        other_ = cross(unit, across_);
        double size = 0, lowest = 0, highest = 0;
        for (const Vec3& corner : polygon.corners) {
            const double far = max_abs(corner - polygon.corners[0]);
            if (far > size) size = far;
            const double height = dot(unit, corner - polygon.corners[0]);
            if (height > highest) highest = height;
        }
        size += hull.reach;
        for (std::size_t i = 0; i < hull.corners.size(); ++i) {
            const double height = dot(unit, hull.corners[i]);
            if (i == 0 || height < lowest) lowest = height;
        }
        for (std::size_t k = 0; k < polygon.corners.size(); ++k) {
            const Vec3 at = polygon.corners[k] - polygon.corners[0];
            if (dot(unit, at) < highest - kSamePlane * size) continue;
            face_.add_corner(at, seen(at));
        }
        for (std::size_t i = 0; i < hull.corners.size(); ++i) {
            place_of_[i] = -1;
            if (dot(unit, hull.corners[i]) > lowest + kSamePlane * size) continue;
            place_of_[i] = int(body_.count());
            body_.add_corner(place + hull.corners[i], seen(place + hull.corners[i]));
        }
        slack_ = kSamePlane * size + rounding(64) * (max_abs(place) + reach);
    }

    /// From the polygon's first corner, on the polygon to rounding.
    Vec3 point() const {
        if (face_.count() == 1) return face_.at(0);
        if (body_.count() == 1) return body_.at(0);
        MeanPoint mean;
        each_corner([&](const Vec3& at) { mean.add(at); });
        if (mean.count > 0) return mean.sum * (1 / mean.count);
        return body_.at(0);
    }

    /// Calls function(at) for each corner of the common part, some more than once, and for some points within it.
    template <class Function>
    void each_corner(const Function& function) const {
        for (std::size_t k = 0; k < face_.count(); ++k)
            if (in_body(face_.seen(k))) function(face_.at(k));
        for (std::size_t i = 0; i < body_.count(); ++i)
            if (in_face(body_.seen(i))) function(body_.at(i));
        for (const HullShape::Edge& edge : hull_.edges) {
            const int a = place_of_[edge.from], b = place_of_[edge.to];
            if (a < 0 || b < 0) continue;
            for (std::size_t k = 0; k < sides(); ++k) cross_edges(std::size_t(a), std::size_t(b), k, function);
        }
    }

    /// As point(), up to four: of the common part the four corners that span the most.
    ContactPoints points() const {
        ContactPoints found;
        if (face_.count() == 1 || body_.count() == 1) {
            found.at[0] = point();
            found.count = 1;
            return found;
        }
        std::array<Vec3, kMostCorners> at;
        std::array<SeenPoint, kMostCorners> all;
        std::size_t count = 0;
        each_corner([&](const Vec3& corner) {
            if (count == kMostCorners) return;
            const Flat flat = seen(corner);
            at[count] = corner;
            all[count] = {flat.x, flat.y, count};
            ++count;
        });
        if (count == 0) {
            found.at[0] = point();
            found.count = 1;
            return found;
        }
        std::array<SeenPoint, kMostCorners> hull;
        std::array<SeenPoint, 4> widest;
        const std::size_t corners = hull_in_plane(std::span(all).first(count), slack_, hull);
        found.count = widest_four(std::span(hull).first(corners), widest);
        for (std::size_t k = 0; k < found.count; ++k) found.at[k] = at[widest[k].index];
        return found;
    }

private:
    /// Of a face of 64 corners, cut into triangles, against a polygon of 64: each edge meets the rim twice at most.
    static constexpr std::size_t kMostCorners = 2 * 64 + 2 * (2 * 64 - 3);

    Flat seen(const Vec3& at) const { return {dot(across_, at), dot(other_, at)}; }
    std::size_t sides() const { return face_.count() == 2 ? 1 : face_.count(); }
    std::size_t next(std::size_t k) const { return k + 1 < face_.count() ? k + 1 : 0; }

    bool in_face(const Flat& p) const {
        bool left = true, right = true, far = false;  // far from a side: corners on one line have no inside
        for (std::size_t k = 0; k < sides(); ++k) {
            const Flat &a = face_.seen(k), &b = face_.seen(next(k));
            if (on_segment(p, a, b, slack_)) return true;
            const double side = cross(b - a, p - a);
            left = left && side >= 0;
            right = right && side <= 0;
            far = far || std::fabs(side) > slack_ * length(b - a);
        }
        return far && face_.count() > 2 && (left || right);
    }
    bool in_body(const Flat& p) const {
        for (const HullShape::Edge& edge : hull_.edges) {
            const int a = place_of_[edge.from], b = place_of_[edge.to];
            if (a >= 0 && b >= 0 && on_segment(p, body_.seen(std::size_t(a)), body_.seen(std::size_t(b)), slack_))
                return true;
        }
        for (const HullShape::Triangle& triangle : hull_.triangles) {
            const int a = place_of_[triangle.corner[0]], b = place_of_[triangle.corner[1]],
                      c = place_of_[triangle.corner[2]];
            if (a < 0 || b < 0 || c < 0) continue;
            const Flat &pa = body_.seen(std::size_t(a)), &pb = body_.seen(std::size_t(b)),
                       &pc = body_.seen(std::size_t(c));
            const double x = cross(pb - pa, p - pa), y = cross(pc - pb, p - pb), z = cross(pa - pc, p - pc);
            if ((x >= 0 && y >= 0 && z >= 0) || (x <= 0 && y <= 0 && z <= 0)) return true;
        }
        return false;
    }
    template <class Function>
    void cross_edges(std::size_t a, std::size_t b, std::size_t k, const Function& function) const {
        const Flat g = body_.seen(b) - body_.seen(a), e = face_.seen(next(k)) - face_.seen(k);
        const Flat w = body_.seen(a) - face_.seen(k);
        const double turn = cross(e, g);
        if (std::fabs(turn) <= 0x1p-40 * length(e) * length(g)) return;
        const double part = cross(w, g) / turn, along = cross(w, e) / turn;
        const double blur = 0x1p-30;
        if (part < -blur || part > 1 + blur || along < -blur || along > 1 + blur) return;
        const double within = part < 0 ? 0 : part > 1 ? 1 : part;
        function(face_.at(k) + (face_.at(next(k)) - face_.at(k)) * within);
    }

    const HullShape& hull_;
    Vec3 across_, other_;
    Side face_, body_;
    std::array<int, kMaxHullCorners> place_of_{};
    double slack_ = 0;
};

}  // namespace

PolygonHit make_hull_hit(const Sweep& sweep, const HullShape& hull, const PolygonShape& polygon,
                         const HullContact& found) {
    Vec3 unit;
    if (found.facet.kind() == SumFacet::kPlane) {
        unit = polygon.unit_normal() * found.facet.name.turn;
    } else {
        const auto u = HullAgainstPolygon(sweep, hull, polygon).direction_precisely(found.facet.name);
        const DoubleDouble size = square_root(dot(u, u));
        unit = {rounded(u.x / size), rounded(u.y / size), rounded(u.z / size)};
    }

    PolygonHit hit;
    hit.status = found.contact.status;
    hit.fraction = sweep.fraction(found.contact.t);
    hit.centre = sweep.at(found.contact.t);
    hit.face_normal = polygon.unit_normal();
    hit.normal = unit;
    const Vec3 place = (sweep.start - polygon.corners[0]) + sweep.direction * found.contact.t;
    const Vec3 point = Touching(place, max_abs(sweep.start) + sweep.end, hull, polygon, unit).point();
    // Only the plane's own facet stands for the face.
    const bool by_face = found.facet.kind() == SumFacet::kPlane;
    const Closest closest = by_face ? closest_to(point, polygon) : closest_on_rim(point, polygon);
    hit.point = polygon.corners[0] + closest.offset;
    if (by_face) return hit;
    hit.feature = closest.feature;
    hit.feature_index = closest.index;
    return hit;
}

WayOut way_out_of_hull(const Sweep& sweep, const HullShape& hull, const PolygonShape& polygon, bool along_normal) {
    const HullAgainstPolygon pair(sweep, hull, polygon);
    const SumFacet facet = along_normal ? pair.facet({SumFacet::kPlane, 1, 0, 0}) : nearest_facet(pair);
    const HullAgainstPolygon::Precise precise = pair.precisely(facet);
    const PolygonHit hit =
        make_hull_hit(sweep, hull, polygon, {{Status::kInitialOverlap, Feature::kFace, 0, 0}, facet});
    WayOut out;
    out.direction = hit.normal;
    out.depth = rounded(-precise.outside / precise.length);
    if (!(out.depth > 0)) out.depth = 0;
    out.closest.offset = hit.point - polygon.corners[0];
    out.closest.feature = hit.feature;
    out.closest.index = hit.feature_index;
    return out;
}

ContactPoints points_of_contact(const HullShape& hull, const PolygonHit& hit, const PolygonShape& polygon) {
    const Vec3 place = hit.centre - polygon.corners[0];
    ContactPoints found = Touching(place, max_abs(hit.centre), hull, polygon, hit.normal).points();
    for (std::size_t k = 0; k < found.count; ++k)
        found.at[k] = polygon.corners[0] + closest_to(found.at[k], polygon).offset;
    return found;
}

}  // namespace firma
