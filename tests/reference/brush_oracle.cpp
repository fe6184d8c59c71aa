// SPDX-License-Identifier: MIT
// The volume of brushes joined: convex bodies as polygons with rational corners.
#include "tests/reference/brush_oracle.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace firma::reference {
namespace {

struct Corner {
    std::array<Rational, 3> at;
    double near[3];  ///< rounded

    explicit Corner(std::array<Rational, 3> exact) : at(std::move(exact)) {
        for (std::size_t axis = 0; axis < 3; ++axis) near[axis] = at[axis].convert_to<double>();
    }
};

/// A convex body. Corners that no polygon has do not matter.
struct Body {
    std::vector<Corner> corners;
    std::vector<std::vector<std::uint32_t>> polygons;

    bool empty() const { return polygons.empty(); }
};

struct DoubleBox {
    double low[3] = {INFINITY, INFINITY, INFINITY}, high[3] = {-INFINITY, -INFINITY, -INFINITY};

    /// A little wider than the body: a hundredth of a step.
    explicit DoubleBox(const Body& body) {
        for (const auto& polygon : body.polygons)
            for (const std::uint32_t corner : polygon)
                for (int axis = 0; axis < 3; ++axis) {
                    low[axis] = std::min(low[axis], body.corners[corner].near[axis] - 0.01);
                    high[axis] = std::max(high[axis], body.corners[corner].near[axis] + 0.01);
                }
    }
    bool meets(const DoubleBox& other) const {
        for (int axis = 0; axis < 3; ++axis)
            if (low[axis] > other.high[axis] || other.low[axis] > high[axis]) return false;
        return true;
    }
};

/// Exact; in double where that can tell.
int sign_at(const HalfSpace& by, const Corner& corner) {
    double sum = by.d, size = std::fabs(by.d);
    for (int axis = 0; axis < 3; ++axis) {
        sum += by.n[axis] * corner.near[axis];
        size += std::fabs(by.n[axis] * corner.near[axis]);
    }
    if (std::fabs(sum) > 1e-14 * size) return sum > 0 ? 1 : -1;
    return by.at(corner.at).sign();
}

std::vector<int> signs_at(const HalfSpace& by, const Body& body) {
    std::vector<int> signs;
    for (const Corner& corner : body.corners) signs.push_back(sign_at(by, corner));
    return signs;
}

Body cube(std::int64_t half) {
    Body body;
    for (int k = 0; k < 8; ++k)
        body.corners.emplace_back(
            std::array<Rational, 3>{k & 1 ? half : -half, k & 2 ? half : -half, k & 4 ? half : -half});
    body.polygons = {{0, 1, 3, 2}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 3, 7, 6}, {0, 2, 6, 4}, {1, 3, 7, 5}};
    return body;
}

Rational area_sign(const Corner& a, const Corner& b, const Corner& c, std::size_t u, std::size_t v) {
    return (b.at[u] - a.at[u]) * (c.at[v] - a.at[v]) - (b.at[v] - a.at[v]) * (c.at[u] - a.at[u]);
}

/// The hull of corners in a plane that is not parallel to the axis looked along.
std::vector<std::uint32_t> hull(const Body& body, std::vector<std::uint32_t> points, std::size_t axis) {
    const std::size_t u = (axis + 1) % 3, v = (axis + 2) % 3;
    std::sort(points.begin(), points.end());
    points.erase(std::unique(points.begin(), points.end()), points.end());
    std::sort(points.begin(), points.end(), [&](std::uint32_t a, std::uint32_t b) {
        const auto &p = body.corners[a].at, &q = body.corners[b].at;
        return p[u] != q[u] ? p[u] < q[u] : p[v] < q[v];
    });
    if (points.size() < 3) return {};
    std::vector<std::uint32_t> around;
    for (int pass = 0; pass < 2; ++pass) {
        const std::size_t start = around.size();
        for (const std::uint32_t point : points) {
            while (around.size() >= start + 2 && area_sign(body.corners[around[around.size() - 2]],
                                                           body.corners[around.back()], body.corners[point], u, v) <= 0)
                around.pop_back();
            around.push_back(point);
        }
        around.pop_back();
        std::reverse(points.begin(), points.end());
    }
    return around.size() < 3 ? std::vector<std::uint32_t>{} : around;
}

/// Leaves out corners that no polygon has.
Body tidy(Body body) {
    Body tidied;
    std::vector<std::uint32_t> number(body.corners.size(), ~0u);
    for (auto& polygon : body.polygons)
        for (std::uint32_t& corner : polygon) {
            if (number[corner] == ~0u) {
                number[corner] = std::uint32_t(tidied.corners.size());
                tidied.corners.push_back(std::move(body.corners[corner]));
            }
            corner = number[corner];
        }
    tidied.polygons = std::move(body.polygons);
    return tidied;
}

/// The part of a body on one side: behind the plane, or in front of it.
Body clip(const Body& body, const HalfSpace& by, bool keep_front) {
    std::vector<int> sign = signs_at(by, body);
    bool any = false, any_off = false;
    for (int& side : sign) {
        if (keep_front) side = -side;
        any = any || side < 0;
        any_off = any_off || side > 0;
    }
    if (!any) return {};
    if (!any_off) return body;  // a face that lies in the plane is there already
    Body kept;
    kept.corners = body.corners;
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> crossings;
    const auto crossing = [&](std::uint32_t a, std::uint32_t b) {
        const auto [at, is_new] = crossings.try_emplace(std::minmax(a, b), std::uint32_t(kept.corners.size()));
        if (is_new) {
            const std::array<Rational, 3>&p = body.corners[a].at, &q = body.corners[b].at;
            const Rational s = by.at(p), share = s / (s - by.at(q));
            std::array<Rational, 3> made;
            for (std::size_t axis = 0; axis < 3; ++axis) made[axis] = p[axis] + share * (q[axis] - p[axis]);
            kept.corners.emplace_back(std::move(made));
        }
        return at->second;
    };
    std::vector<std::uint32_t> on_plane;
    for (const auto& polygon : body.polygons) {
        std::vector<std::uint32_t> part;
        for (std::size_t k = 0; k < polygon.size(); ++k) {
            const std::uint32_t corner = polygon[k], next = polygon[(k + 1) % polygon.size()];
            if (sign[corner] <= 0) part.push_back(corner);
            if (sign[corner] == 0) on_plane.push_back(corner);
            if (sign[corner] * sign[next] >= 0) continue;
            part.push_back(crossing(corner, next));
            on_plane.push_back(part.back());
        }
        if (part.size() >= 3) kept.polygons.push_back(std::move(part));
    }
    std::size_t axis = 0;
    while (by.normal[axis] == 0) ++axis;
    if (auto cap = hull(kept, std::move(on_plane), axis); !cap.empty()) kept.polygons.push_back(std::move(cap));
    return tidy(std::move(kept));
}

LongReal body_volume(const Body& body) {
    if (body.empty()) return 0;
    std::vector<std::array<LongReal, 3>> from_first;
    for (const Corner& corner : body.corners) {
        auto& p = from_first.emplace_back();
        for (std::size_t axis = 0; axis < 3; ++axis) p[axis] = LongReal(corner.at[axis] - body.corners[0].at[axis]);
    }
    LongReal six = 0;
    for (const auto& polygon : body.polygons)
        for (std::size_t k = 2; k < polygon.size(); ++k) {
            const auto &a = from_first[polygon[0]], &b = from_first[polygon[k - 1]], &c = from_first[polygon[k]];
            const LongReal cone = a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) +
                                  a[2] * (b[0] * c[1] - b[1] * c[0]);
            six += abs(cone);
        }
    return six / 6;
}

/// What of a part lies outside a brush, as convex parts.
void take_away(const BrushBody& brush, const Body& part, std::vector<Body>& left) {
    std::vector<Body> rests{part};  // behind the first planes, ever more of them
    for (const HalfSpace& side : brush) {
        rests.push_back(clip(rests.back(), side, false));
        if (rests.back().empty()) return left.push_back(part);  // the two have nothing in common
    }
    for (std::size_t k = 0; k < brush.size(); ++k)
        if (Body front = clip(rests[k], brush[k], true); !front.empty()) left.push_back(std::move(front));
}

HalfSpace with_doubles(HalfSpace made) {
    for (std::size_t axis = 0; axis < 3; ++axis) made.n[axis] = made.normal[axis].convert_to<double>();
    made.d = made.offset.convert_to<double>();
    return made;
}

/// Whether two are one, by whatever numbers.
bool same_plane(const HalfSpace& a, const HalfSpace& b) {
    const Whole p[4] = {a.normal[0], a.normal[1], a.normal[2], a.offset};
    const Whole q[4] = {b.normal[0], b.normal[1], b.normal[2], b.offset};
    for (int i = 0; i < 4; ++i)
        for (int k = 0; k < i; ++k)
            if (p[i] * q[k] != p[k] * q[i]) return false;
    return true;
}

Body body_of(const BrushBody& brush) {
    Body body = cube(std::int64_t(1) << 26);
    for (const HalfSpace& side : brush) body = clip(body, side, false);
    return body;
}

}  // namespace

Rational HalfSpace::at(const std::array<Rational, 3>& p) const {
    return Rational(normal[0]) * p[0] + Rational(normal[1]) * p[1] + Rational(normal[2]) * p[2] + Rational(offset);
}

HalfSpace half_space(const Plane& plane) {
    HalfSpace made;
    for (std::size_t axis = 0; axis < 3; ++axis) made.normal[axis] = plane.normal[axis];
    made.offset = Whole(plane.offset());
    return with_doubles(std::move(made));
}

HalfSpace half_space(const BrushSide& side) {
    std::int64_t p[3][3];
    for (int k = 0; k < 3; ++k)
        for (int axis = 0; axis < 3; ++axis) p[k][axis] = side.points[k][axis] / kSurfacePerInput;
    HalfSpace made;
    for (int axis = 0; axis < 3; ++axis) {
        const int u = (axis + 1) % 3, v = (axis + 2) % 3;
        made.normal[std::size_t(axis)] =
            Whole(p[1][u] - p[0][u]) * (p[2][v] - p[0][v]) - Whole(p[1][v] - p[0][v]) * (p[2][u] - p[0][u]);
        made.offset -= made.normal[std::size_t(axis)] * p[0][axis];
    }
    return with_doubles(std::move(made));
}

double farthest_moved(const BrushBody& body, const BrushBody& once) {
    double farthest = 0;
    std::vector<std::size_t> moved;
    for (std::size_t k = 0; k < body.size(); ++k)
        if (!same_plane(body[k], once[k])) moved.push_back(k);
    if (moved.empty()) return 0;
    for (const Corner& corner : body_of(body).corners)
        for (const std::size_t k : moved) {
            if (sign_at(body[k], corner) != 0) continue;
            const double *n = once[k].n, size = std::sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
            farthest = std::max(farthest, std::fabs(once[k].at(corner.at).convert_to<double>()) / size);
        }
    return farthest;
}

LongReal joined_volume(std::span<const BrushBody> brushes) {
    std::vector<DoubleBox> boxes;
    LongReal sum = 0;
    for (std::size_t one = 0; one < brushes.size(); ++one) {
        Body body = body_of(brushes[one]);
        const DoubleBox& box = boxes.emplace_back(body);
        std::vector<Body> parts;
        if (!body.empty()) parts.push_back(std::move(body));
        for (std::size_t other = 0; other < one && !parts.empty(); ++other) {
            if (!box.meets(boxes[other])) continue;
            std::vector<Body> left;
            for (Body& part : parts)
                if (DoubleBox(part).meets(boxes[other]))
                    take_away(brushes[other], part, left);
                else
                    left.push_back(std::move(part));
            parts = std::move(left);
        }
        for (const Body& part : parts) sum += body_volume(part);
    }
    return sum;
}

int side_of_brushes(std::span<const BrushBody> brushes, const Rational (&point)[3]) {
    const Corner p({point[0], point[1], point[2]});
    int best = -1;
    for (const BrushBody& sides : brushes) {
        int inside = 1;
        for (const HalfSpace& side : sides) inside = std::min(inside, -sign_at(side, p));
        best = std::max(best, inside);
    }
    return best;
}

}  // namespace firma::reference
