// SPDX-License-Identifier: MIT
// The hull grows point by point: triangles that see the new point go, and the rim of the hole is joined to it.
// Source: M. Kallay, The complexity of incremental convex hull algorithms, 1984.
#include "convex/grid_hull.h"

#include <cmath>

#include "base/sort.h"

namespace firma {
namespace {

/// A plane through three points of the grid: normals have 67 bits.
struct GridPlane {
    GridPoint at;
    Int128 normal[3] = {0, 0, 0};
    double rounded[3] = {0, 0, 0};

    GridPlane(const GridPoint& a, const GridPoint& b, const GridPoint& c) : at(a) {
        std::int64_t u[3], v[3];
        for (int axis = 0; axis < 3; ++axis) {
            u[axis] = std::int64_t(b[axis]) - a[axis];
            v[axis] = std::int64_t(c[axis]) - a[axis];
        }
        for (int k = 0, i = 1, j = 2; k < 3; i = j, j = k, ++k) {
            normal[k] = Int128(u[i]) * v[j] - Int128(u[j]) * v[i];
            rounded[k] = double(normal[k]);
        }
    }
    [[nodiscard]] bool valid() const { return normal[0] != 0 || normal[1] != 0 || normal[2] != 0; }

    [[nodiscard]] Int128 height(const GridPoint& p) const {
        Int128 sum = 0;
        for (int axis = 0; axis < 3; ++axis) sum += normal[axis] * (std::int64_t(p[axis]) - at[axis]);
        return sum;
    }
    /// Differences are exact; each term passes through two roundings and at most two of sums.
    [[nodiscard]] int side(const GridPoint& p) const {
        double sum = 0, size = 0;
        for (int axis = 0; axis < 3; ++axis) {
            const double term = rounded[axis] * (double(p[axis]) - double(at[axis]));
            sum += term;
            size += std::fabs(term);
        }
        if (std::fabs(sum) > size * 0x1p-49) return sum > 0 ? 1 : -1;
        const Int128 exact = height(p);
        return exact > 0 ? 1 : exact < 0 ? -1 : 0;
    }
};

class HullBuilder {
public:
    explicit HullBuilder(const std::vector<GridPoint>& points) : points_(points) {}

    /// @return false where all points lie in one plane
    bool build() {
        std::uint32_t first[4] = {0, 1, 0, 0};
        const auto count = std::uint32_t(points_.size());
        if (count < 4) return false;
        std::uint32_t& third = first[2] = 2;
        while (third < count && !GridPlane(points_[0], points_[1], points_[third]).valid()) ++third;
        if (third == count) return false;
        const GridPlane base(points_[0], points_[1], points_[third]);
        std::uint32_t& fourth = first[3] = 2;
        while (fourth < count && base.side(points_[fourth]) == 0) ++fourth;
        if (fourth == count) return false;
        if (base.side(points_[fourth]) > 0) std::swap(first[1], first[2]);
        const auto [a, b, c, d] = first;
        add(a, b, c);
        add(b, a, d);
        add(c, b, d);
        add(a, c, d);
        for (std::uint32_t k = 0; k < count; ++k)
            if (k != a && k != b && k != c && k != d) add_point(k);
        return true;
    }

    struct Facet {
        std::array<std::uint32_t, 3> corner;
        GridPlane plane;
    };
    [[nodiscard]] const std::vector<Facet>& facets() const { return facets_; }

private:
    void add(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
        facets_.push_back({{a, b, c}, GridPlane(points_[a], points_[b], points_[c])});
    }

    void add_point(std::uint32_t k) {
        rim_.clear();
        std::size_t kept = 0;
        for (std::size_t f = 0; f < facets_.size(); ++f) {
            if (facets_[f].plane.side(points_[k]) <= 0) {
                if (kept != f) facets_[kept] = facets_[f];
                ++kept;
                continue;
            }
            const auto& corner = facets_[f].corner;
            for (std::size_t side = 0; side < 3; ++side) rim_.push_back({corner[side], corner[(side + 1) % 3]});
        }
        if (kept == facets_.size()) return;
        facets_.erase(facets_.begin() + std::ptrdiff_t(kept), facets_.end());
        sort_range(rim_);
        const std::vector<Side> sides = rim_;
        for (const Side& side : sides)
            if (!std::binary_search(sides.begin(), sides.end(), Side{side[1], side[0]})) add(side[0], side[1], k);
    }

    using Side = std::array<std::uint32_t, 2>;

    const std::vector<GridPoint>& points_;
    std::vector<Facet> facets_;
    std::vector<Side> rim_;
};

}  // namespace

double GridHull::volume() const {
    return double(sixths) / 6 / (kSurfaceSteps * kSurfaceSteps * kSurfaceSteps);
}

GridHull hull_of(std::vector<GridPoint> points) {
    sort_once(points);
    GridHull hull;
    HullBuilder builder(points);
    if (!builder.build()) return hull;
    std::vector<std::uint32_t> number(points.size(), ~0u);
    for (const HullBuilder::Facet& facet : builder.facets())
        for (const std::uint32_t corner : facet.corner) number[corner] = 0;
    for (std::size_t k = 0; k < points.size(); ++k) {
        if (number[k] != 0) continue;
        number[k] = std::uint32_t(hull.points.size());
        hull.points.push_back(points[k]);
    }
    for (const HullBuilder::Facet& facet : builder.facets()) {
        GridHull::Triangle triangle;
        for (std::size_t k = 0; k < 3; ++k) triangle.corner[k] = number[facet.corner[k]];
        const Vec3 normal{facet.plane.rounded[0], facet.plane.rounded[1], facet.plane.rounded[2]};
        triangle.normal = normal * (1 / length(normal));
        triangle.offset = dot(triangle.normal, to_metres(facet.plane.at));
        hull.triangles.push_back(triangle);
        hull.sixths -= facet.plane.height(points[0]);
    }
    return hull;
}

}  // namespace firma
