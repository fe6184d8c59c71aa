// SPDX-License-Identifier: MIT
// Finds edges that a further position lies on: a tree of points in double, generous, then whole numbers.
#include "level/find_t_joints.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "level/exact_points.h"

namespace firma {
namespace {

/// Whether p lies on the line through a and b, and between the two: p - a = t (b - a), 0 < t < 1.
template <class Wide, class Point>
bool between(const Point& a, const Point& b, const Point& p) {
    std::array<Wide, 3> along, part;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        along[axis] = Wide(b[axis]) - Wide(a[axis]);
        part[axis] = Wide(p[axis]) - Wide(a[axis]);
    }
    for (std::size_t u = 0, v = 1; u < 3; ++u, v = (v + 1) % 3)
        if (Wide(along[u] * part[v]) != Wide(along[v] * part[u])) return false;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        if (along[axis] == 0) continue;
        return along[axis] > 0 ? part[axis] > 0 && part[axis] < along[axis]
                               : part[axis] < 0 && part[axis] > along[axis];
    }
    return false;
}

class TJointFinder {
public:
    TJointFinder(const ExactMesh& mesh, const WeldedPositions& welded) : mesh_(mesh), welded_(welded) {
        double size = 0;
        for (const std::uint32_t vertex : welded.vertex) size = std::max(size, max_abs(mesh.nearest[vertex]));
        // Outside these limits doubles hold too little of the numbers: then everything counts as near everything.
        const bool trusted = size >= 1e-100 && size <= 1e100;
        if (!trusted) slack_ = 1;
        const double unit = trusted ? 1 / size : 0;
        for (const std::uint32_t vertex : welded.vertex) points_.push_back(mesh.nearest[vertex] * unit);
        order_.resize(points_.size());
        std::iota(order_.begin(), order_.end(), 0u);
        build(0, order_.size());
    }

    bool any_on(const PositionPair& edge) {
        edge_ = edge;
        a_ = points_[edge[0]];
        along_ = points_[edge[1]] - a_;
        for (int axis = 0; axis < 3; ++axis) inverse_[axis] = std::fabs(along_[axis]) > 0x1p-60 ? 1 / along_[axis] : 0;
        return search(0);
    }

private:
    static constexpr std::size_t kLeaf = 8;

    /// A box around order_[begin .. end). Its first half, where it has halves, is the next node.
    struct Node {
        Box box;
        std::size_t begin = 0, end = 0;
        std::size_t second_half = 0;  ///< 0 for a leaf
    };

    /// Halves a range of points by the median along the longest axis of their box, and its halves likewise.
    void build(std::size_t begin, std::size_t end) {
        const std::size_t node = nodes_.size();
        nodes_.push_back({{}, begin, end, 0});
        Box& box = nodes_.back().box;
        for (std::size_t k = begin; k < end; ++k) box.add(points_[order_[k]]);
        if (end - begin <= kLeaf) return;
        const Vec3 size = box.high - box.low;
        const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
        const std::size_t middle = begin + (end - begin) / 2;
        const auto at = [&](std::size_t k) { return order_.begin() + std::ptrdiff_t(k); };
        std::nth_element(at(begin), at(middle), at(end),
                         [&](std::uint32_t a, std::uint32_t b) { return points_[a][axis] < points_[b][axis]; });
        build(begin, middle);
        nodes_[node].second_half = nodes_.size();
        build(middle, end);
    }

    bool search(std::size_t index) {
        const Node& node = nodes_[index];
        if (!passes(node.box)) return false;
        if (node.second_half != 0) return search(index + 1) || search(node.second_half);
        for (std::size_t k = node.begin; k < node.end; ++k)
            if (lies_on(order_[k])) return true;
        return false;
    }

    /// Whether the edge may come within rounding of a box: the parts a + t along, 0 <= t <= 1, between its sides in
    /// turn.
    bool passes(const Box& box) const {
        double first = 0, last = 1;
        for (int axis = 0; axis < 3; ++axis) {
            const double low = box.low[axis] - slack_ - a_[axis], high = box.high[axis] + slack_ - a_[axis];
            const double inverse = inverse_[axis];
            if (inverse == 0) {
                if (low > 0 || high < 0) return false;
                continue;
            }
            first = std::max(first, (inverse > 0 ? low : high) * inverse);
            last = std::min(last, (inverse > 0 ? high : low) * inverse);
        }
        return first <= last;
    }

    bool lies_on(std::uint32_t position) {
        if (position == edge_[0] || position == edge_[1]) return false;
        const Vec3 part = points_[position] - a_;
        const Vec3 area = cross(along_, part);
        const double reach = slack_ * (max_abs(along_) + max_abs(part) + slack_);
        if (max_abs(area) > reach || dot(part, along_) < -reach) return false;
        return lies_on_exactly(position);
    }

    bool lies_on_exactly(std::uint32_t position) {
        const std::array<std::uint32_t, 3> vertices{welded_.vertex[edge_[0]], welded_.vertex[edge_[1]],
                                                    welded_.vertex[position]};
        if (to_small_points(mesh_, vertices, small_)) return between<Int128>(small_[0], small_[1], small_[2]);
        to_big_points(mesh_, vertices, big_);
        return between<BigInt>(big_[0], big_[1], big_[2]);
    }

    const ExactMesh& mesh_;
    const WeldedPositions& welded_;
    std::vector<Vec3> points_;          ///< of positions, the largest coordinate taken as 1
    std::vector<std::uint32_t> order_;  ///< positions, those of a node in a row
    std::vector<Node> nodes_;           ///< the tree, the root first
    /// How far a coordinate may be off through rounding, many times over: of numbers near 1 in double, a few of 2^-53.
    double slack_ = 0x1p-45;
    PositionPair edge_{};
    Vec3 a_, along_;
    Vec3 inverse_;  ///< of along; 0 where that is far below the slack
    std::vector<SmallPoint> small_;
    std::vector<BigPoint> big_;
};

}  // namespace

std::vector<bool> find_t_joints(const ExactMesh& mesh, const WeldedPositions& welded,
                                std::span<const PositionPair> edges) {
    std::vector<bool> found;
    if (edges.empty()) return found;
    TJointFinder finder(mesh, welded);
    for (const PositionPair& edge : edges) found.push_back(finder.any_on(edge));
    return found;
}

}  // namespace firma
