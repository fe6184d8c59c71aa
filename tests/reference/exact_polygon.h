// SPDX-License-Identifier: MIT
// One polygon and one moving sphere, exactly: the first touch, the nearest point at any moment, how deep a path goes.
//
// Letters: v_k corners, e_k = v_k+1 - v_k, n the normal (any length), h_k = e_k x n out of the polygon across edge k;
// c(t) = start + t path, a_k = start - v_k, d = path, r the radius. A sphere of radius r touches the polygon when its
// centre lies in the union of
//     balls      |c - v_k|^2 <= r^2
//     cylinders  |c - v_k|^2 e.e - ((c - v_k).e)^2 <= r^2 e.e,  (c - v_k).e >= 0,  (c - v_k+1).e <= 0
//     the prism  ((c - v_0).n)^2 <= r^2 n.n,  (c - v_k).h_k <= 0 for all k
// Each part is convex, one quadratic and some linear inequalities in t. The first touch is the least t in [0, 1] at
// which any part holds. Every decision is the sign of a whole number.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "firma/hit.h"
#include "firma/polygon.h"
#include "tests/reference/exact_number.h"

namespace firma::reference {

/// A cast in whole units of 2^-unit metres.
struct ExactCast {
    int unit = 18;
    IntegerVec start, path;
    Integer radius = 0;

    /// @param sphere, path  finite
    ExactCast(const Sphere& sphere, const Vec3& path);
    bool moves() const { return sign(path.x) != 0 || sign(path.y) != 0 || sign(path.z) != 0; }
};

/// A polygon in whole steps, those of the surface grid unless said otherwise, with what is worth computing once.
struct ExactPolygon {
    std::vector<IntegerVec> corners, edges, outward;  ///< v_k, e_k, h_k
    std::vector<Integer> edge_squares;                ///< e_k . e_k
    IntegerVec normal;
    Integer normal_square;

    int unit = 18;  ///< its steps are 2^-unit metres

    explicit ExactPolygon(std::span<const Vec3> corners);
    /// @param corners  in any steps, in one plane
    ExactPolygon(std::vector<IntegerVec> corners, int unit);
};

/// The first touch.
struct Touch {
    Root at;
    Feature feature = Feature::kFace;  ///< the lowest that it touches with
    std::uint32_t index = 0;
};

/// The point of a polygon nearest to the centre at some moment.
struct Nearest {
    Feature feature = Feature::kFace;
    std::uint32_t index = 0;
    Vec3 centre, point;   ///< metres, nearest doubles
    Vec3 direction;       ///< unit, from the point toward the centre; zero when they coincide
    Ratio square;         ///< of the distance, in the cast's units
    double distance = 0;  ///< metres
    double gap = 0;       ///< distance less radius, metres, negative in an overlap
    int closing = 0;      ///< sign of path . (centre - point): negative while the distance decreases
    bool on_polygon() const { return sign(square.top) == 0; }
};

/// A polygon as one cast sees it.
class SeenPolygon {
public:
    /// Both must outlive this. The cast's unit is at least the polygon's.
    SeenPolygon(const ExactPolygon& polygon, const ExactCast& cast);

    /// Sign of path . normal.
    int facing() const { return sign(path_normal_); }
    /// Of the closed polygon with the closed ball, over t in [0, 1]; a zero root when they share a point at the start.
    std::optional<Touch> first_touch() const;
    Nearest nearest_at(const Ratio& t) const;
    /// Like nearest_at(), for the root's first 256 bits.
    Nearest nearest_at(const Root& t) const;
    /// How deep the sphere would go on its whole path, metres: beyond its overlap at the start; when the centre passes
    /// through the polygon, as far again as to the rim or the end. Negative: the clearance.
    double margin() const;
    /// Whether the path of the centre and the polygon share a point, not counting paths within its plane.
    bool passes_through() const;

private:
    struct Quadratic {  // value t^2 a + 2 t b + c
        Integer a, b, c;
    };
    class Interval;
    Quadratic of_ball(std::size_t k) const;
    Quadratic of_cylinder(std::size_t k) const;
    Quadratic of_prism() const;
    bool inside(const std::vector<IntegerVec>& from_corner) const;
    Ratio rim_square() const;  // of the distance between path and rim

    const ExactPolygon& polygon_;
    const ExactCast& cast_;
    std::vector<IntegerVec> from_corner_;  // a_k
    Integer path_square_, path_normal_;    // d.d, d.n
    std::vector<Integer> path_edge_;       // d.e_k
};

}  // namespace firma::reference
