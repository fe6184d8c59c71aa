// SPDX-License-Identifier: MIT
// Divides a flat face with holes into triangles: bridges to the holes, then ears.
#include "solid/triangulate.h"

#include <algorithm>

#include "base/sort.h"

namespace firma {
namespace {

constexpr std::uint32_t kNobody = UINT32_MAX;

bool before(const FlatPoint& a, const FlatPoint& b) {
    return a.u != b.u ? a.u < b.u : a.v < b.v;
}

}  // namespace

bool Triangulator::make(std::span<const GridPoint> points, std::span<const FlatPoint> flat,
                        std::span<const std::uint32_t> loop_ends, Triangles& triangles) {
    points_ = points;
    triangles.corners.clear();
    triangles.twins.clear();
    return link_loops(flat, loop_ends) && join_holes() && clip(triangles);
}

/// @return false when a loop runs the wrong way around
bool Triangulator::link_loops(std::span<const FlatPoint> flat, std::span<const std::uint32_t> loop_ends) {
    nodes_.resize(flat.size());
    holes_.clear();
    std::uint32_t begin = 0;
    for (const std::uint32_t end : loop_ends) {
        Int128 area = 0;
        std::uint32_t lowest = begin;
        for (std::uint32_t k = begin; k < end; ++k) {
            nodes_[k] = {flat[k], k, k > begin ? k - 1 : end - 1, k + 1 < end ? k + 1 : begin};
            if (before(flat[k], flat[lowest])) lowest = k;
            if (k > begin + 1) area += turn(flat[begin], flat[k - 1], flat[k]);
        }
        const bool outer = begin == 0;
        if (outer ? area <= 0 : area >= 0) return false;
        if (!outer) holes_.push_back(lowest);
        begin = end;
    }
    return true;
}

/// Every hole is joined to what lies before its lowest corner: the outer loop and holes that have been joined. A bridge
/// that way exists whenever the hole lies directly inside: any triangulation has a diagonal from there to an earlier
/// corner, as all else would leave an angle of 180 degrees or more. Where it does not lie so, whatever its lowest
/// corner sees turns its back on it.
bool Triangulator::join_holes() {
    std::sort(holes_.begin(), holes_.end(),
              [&](std::uint32_t a, std::uint32_t b) { return before(nodes_[a].at, nodes_[b].at); });
    for (const std::uint32_t hole : holes_)
        if (!join(hole)) return false;
    return true;
}

bool Triangulator::join(std::uint32_t hole) {
    const Node from = nodes_[hole];
    rims_.clear();
    for (std::uint32_t k = 0; k < nodes_.size(); ++k)
        if (before(nodes_[k].at, from.at))
            rims_.push_back({square_distance(points_[nodes_[k].point], points_[from.point]), k});
    std::make_heap(rims_.begin(), rims_.end());
    while (!rims_.empty()) {
        const std::uint32_t rim = rims_.front().node;
        if (opens_to(nodes_[rim], from.at) && visible(rim, hole)) {
            splice(rim, hole);
            return true;
        }
        std::pop_heap(rims_.begin(), rims_.end());
        rims_.pop_back();
    }
    return false;
}

/// Whether a point lies strictly within the angle of a corner.
bool Triangulator::opens_to(const Node& node, const FlatPoint& target) const {
    const FlatPoint &a = nodes_[node.before].at, &b = node.at, &c = nodes_[node.after].at;
    const bool left_of_in = turn(a, b, target) > 0, left_of_out = turn(b, c, target) > 0;
    return turn(a, b, c) > 0 ? left_of_in && left_of_out : left_of_in || left_of_out;
}

/// Whether no edge touches the bridge on its way. Edges at its ends do not matter: the corner opens to the other end,
/// and an edge that runs along it from there would end on it, where the next edges count.
bool Triangulator::visible(std::uint32_t from, std::uint32_t to) const {
    const FlatPoint &a = nodes_[from].at, &b = nodes_[to].at;
    const auto [low_v, high_v] = std::minmax(a.v, b.v);
    for (const Node& node : nodes_) {
        const FlatPoint &c = node.at, &d = nodes_[node.after].at;
        if ((c.u < a.u && d.u < a.u) || (c.u > b.u && d.u > b.u)) continue;
        if ((c.v < low_v && d.v < low_v) || (c.v > high_v && d.v > high_v)) continue;
        if (c == a || c == b || d == a || d == b) continue;
        const Int128 side_c = turn(a, b, c), side_d = turn(a, b, d);
        if ((side_c > 0 && side_d > 0) || (side_c < 0 && side_d < 0)) continue;
        const Int128 side_a = turn(c, d, a), side_b = turn(c, d, b);
        if ((side_a > 0 && side_b > 0) || (side_a < 0 && side_b < 0)) continue;
        return false;
    }
    return true;
}

/// rim -> after becomes rim -> hole -> around it -> hole again -> rim again -> after.
void Triangulator::splice(std::uint32_t rim, std::uint32_t hole) {
    const auto hole_again = std::uint32_t(nodes_.size()), rim_again = hole_again + 1;
    const Node rim_copy = nodes_[rim], hole_copy = nodes_[hole];
    nodes_.push_back(hole_copy);
    nodes_.push_back(rim_copy);
    nodes_[rim_again].before = hole_again;
    nodes_[rim_copy.after].before = rim_again;
    if (rim_copy.partner != kNobody) nodes_[rim_copy.partner].partner = rim_again;
    nodes_[hole_copy.before].after = hole_again;
    nodes_[hole_again].after = rim_again;
    nodes_[hole_again].partner = rim;
    nodes_[hole].before = rim;
    nodes_[rim].after = hole;
    nodes_[rim].partner = hole_again;
}

/// An outline that does not meet itself always has an ear, however many of its corners lie along its sides, and
/// without that ear it still does not. A corner is judged again only when a neighbour goes, as no other can turn into
/// an ear (O'Rourke).
bool Triangulator::clip(Triangles& triangles) {
    ears_.reset(nodes_.size());
    inward_.clear();
    for (std::uint32_t k = 0; k < nodes_.size(); ++k) {
        judge(k);
        if (!nodes_[k].left) inward_.push_back({nodes_[k].at, k});
    }
    sort_range(inward_,
               [](const Inward& a, const Inward& b) { return a.at.u != b.at.u ? a.at.u < b.at.u : a.node < b.node; });
    for (std::size_t remaining = nodes_.size(); remaining > 2;) {
        const std::uint32_t ear = ears_.find();
        if (ear == kNobody) return false;
        ears_.set(ear, LowestKey::kNone);
        if (blocked(ear)) continue;
        emit(ear, triangles);
        Node& node = nodes_[ear];
        node.gone = true;
        nodes_[node.before].after = node.after;
        nodes_[node.after].before = node.before;
        if (--remaining > 2) {
            judge(node.before);
            judge(node.after);
        }
    }
    return true;
}

void Triangulator::judge(std::uint32_t k) {
    Node& node = nodes_[k];
    const Node &last = nodes_[node.before], &next = nodes_[node.after];
    node.left = turn(last.at, node.at, next.at) > 0;
    ears_.set(k, node.left ? square_distance(points_[last.point], points_[next.point]) : LowestKey::kNone);
}

/// Whether another corner lies in the triangle at a left turn, or on its third side. What enters the triangle has its
/// farthest corner there, which is no left turn; and corners at the same place as one of its own (ends of bridges) can
/// only lead in to such.
bool Triangulator::blocked(std::uint32_t k) const {
    const FlatPoint &b = nodes_[k].at, &a = nodes_[nodes_[k].before].at, &c = nodes_[nodes_[k].after].at;
    const auto [low_u, high_u] = std::minmax({a.u, b.u, c.u});
    const auto [low_v, high_v] = std::minmax({a.v, b.v, c.v});
    auto it = std::lower_bound(inward_.begin(), inward_.end(), low_u,
                               [](const Inward& inward, std::int64_t u) { return inward.at.u < u; });
    for (; it != inward_.end() && it->at.u <= high_u; ++it) {
        const FlatPoint& other = it->at;
        if (other.v < low_v || other.v > high_v || other == a || other == b || other == c) continue;
        if (nodes_[it->node].gone || nodes_[it->node].left) continue;
        if (turn(c, a, other) >= 0 && turn(a, b, other) >= 0 && turn(b, c, other) >= 0) return true;
    }
    return false;
}

void Triangulator::emit(std::uint32_t ear, Triangles& triangles) {
    const std::uint32_t last = nodes_[ear].before, next = nodes_[ear].after;
    const auto side = std::uint32_t(triangles.corners.size());
    for (const std::uint32_t k : {last, ear, next}) triangles.corners.push_back(nodes_[k].point);
    triangles.twins.resize(side + 3, Triangles::kNoTwin);
    use_edge(last, side, triangles);
    use_edge(ear, side + 1, triangles);
    if (nodes_[next].after == last)
        use_edge(next, side + 2, triangles);
    else
        nodes_[last].twin = side + 2;
}

/// The edge from a node has got its triangle.
void Triangulator::use_edge(std::uint32_t k, std::uint32_t side, Triangles& triangles) {
    const Node& node = nodes_[k];
    if (node.twin != Triangles::kNoTwin) {
        triangles.twins[side] = node.twin;
        triangles.twins[node.twin] = side;
    } else if (node.partner != kNobody) {
        nodes_[node.partner].twin = side;
    }
}

}  // namespace firma
