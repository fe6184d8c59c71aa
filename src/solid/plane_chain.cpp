// SPDX-License-Identifier: MIT
// Directed edges in one plane: whether they cancel.
//
// Edges are sorted by line, and ends along each line. Every comparison is exact: doubles answer where they surely can,
// with bounds on what rounding does, else integers do.
#include "solid/plane_chain.h"

#include <cmath>
#include <numeric>

#include "base/sort.h"
#include "geometry/rounding.h"

namespace firma {
namespace {

int sign_of(const Int256& value) {
    return value.sign();
}
int sign_of(std::int64_t value) {
    return (value > 0) - (value < 0);
}

/// A component of the cross product of two normals.
Int128 component(const Plane& a, const Plane& b, int axis) {
    return normal_minor(a, b, (axis + 1) % 3, (axis + 2) % 3);
}

}  // namespace

void PlaneChain::start(const Plane& plane) {
    plane_ = &plane;
    u_ = plane.front_view().u();
    v_ = plane.front_view().v();
    edges_.clear();
    made_.clear();
}

void PlaneChain::add(const InputPoint& from, const InputPoint& to) {
    if (from == to) return;
    Edge edge;
    edge.from.grid = from;
    edge.to.grid = to;
    edge.u = to[u_] - from[u_];
    edge.v = to[v_] - from[v_];
    if (edge.u < 0 || (edge.u == 0 && edge.v < 0)) {
        edge.u = -edge.u;
        edge.v = -edge.v;
    }
    edges_.push_back(edge);
}

void PlaneChain::add(const ExactPoint& from, const ExactPoint& to, const Plane& p, const Plane& q) {
    if (from.on_grid() && to.on_grid()) return add(from.grid(), to.grid());
    Edge edge;
    edge.from = end_of(from);
    edge.to = end_of(to);
    for (const Plane* across : {&p, &q}) {
        edge.u = component(*plane_, *across, u_);
        edge.v = component(*plane_, *across, v_);
        if (edge.u == 0 && edge.v == 0) continue;  // parallel: the line lies in the plane, whose normal has more
        set_across(edge, *across);
        if (edge.against) {
            edge.u = -edge.u;
            edge.v = -edge.v;
        }
        break;
    }
    edges_.push_back(edge);
}

bool PlaneChain::cancels() {
    order_.resize(edges_.size());
    std::iota(order_.begin(), order_.end(), 0u);
    sort_range(order_, [&](std::uint32_t a, std::uint32_t b) { return compare_lines(edges_[a], edges_[b]) < 0; });
    for (std::size_t first = 0, end; first < order_.size(); first = end) {
        for (end = first + 1; end < order_.size(); ++end)
            if (compare_lines(edges_[order_[first]], edges_[order_[end]]) != 0) break;
        if (!cancels_along(first, end)) return false;
    }
    return true;
}

PlaneChain::End PlaneChain::end_of(const ExactPoint& point) {
    End end;
    if (point.on_grid())
        end.grid = point.grid();
    else
        end.point = &point;
    return end;
}

void PlaneChain::set_across(Edge& edge, const Plane& across) const {
    const Int128 u = component(*plane_, across, u_);
    edge.across = &across;
    edge.against = u < 0 || (u == 0 && component(*plane_, across, v_) < 0);
}

const Plane& PlaneChain::across_of(Edge& edge) {
    if (!edge.across) set_across(edge, made_.emplace_back(edge_plane(edge.from.grid, edge.to.grid, *plane_)));
    return *edge.across;
}

/// Which way b turns from a: 1 counter-clockwise.
int PlaneChain::turn(const Edge& a, const Edge& b) const {
    if (a.on_grid() && b.on_grid())  // 28 bits each
        return sign_of(std::int64_t(a.u) * std::int64_t(b.v) - std::int64_t(a.v) * std::int64_t(b.u));
    // Neither product passes through more than four roundings: two factors, their product, the difference. One more for
    // the bound.
    const double left = double(a.u) * double(b.v), right = double(a.v) * double(b.u), difference = left - right;
    if (std::fabs(difference) > rounding(6) * (std::fabs(left) + std::fabs(right))) return difference > 0 ? 1 : -1;
    return sign_of(product(a.u, b.v) - product(a.v, b.u));  // of 211 bits
}

/// The side of an edge's line that a point of the plane lies on: 1 left of (u, v).
int PlaneChain::side(Edge& edge, const End& point) {
    const End& on = edge.from;
    if (edge.on_grid() && !point.point)
        return sign_of(std::int64_t(edge.u) * (point.grid[v_] - on.grid[v_]) -
                       std::int64_t(edge.v) * (point.grid[u_] - on.grid[u_]));
    // Both points are off by kApproximation each; a difference is at most 2^26, and no product passes through more than
    // four roundings: direction, difference, product, sum. Three more for the bound, and for points beyond the rim.
    constexpr double kError = 2 * kApproximation + rounding(7) * 2 * kRimSteps;
    const double u = double(edge.u), v = double(edge.v);
    const double estimate = u * (point.at(v_) - on.at(v_)) - v * (point.at(u_) - on.at(u_));
    if (std::fabs(estimate) > kError * (std::fabs(u) + std::fabs(v))) return estimate > 0 ? 1 : -1;
    // The front of `across` is to the right of the cross product plane x across, seen from the plane's front.
    const Plane& across = across_of(edge);
    const int front = exact_side(across, point.exact());
    return edge.against ? front : -front;
}

/// By direction, from (0, -1) counter-clockwise to (0, 1), then from right to left. 0: one line.
int PlaneChain::compare_lines(Edge& a, Edge& b) {
    const int turned = turn(a, b);
    return turned != 0 ? -turned : -side(a, b.from);
}

/// Along a line.
int PlaneChain::compare_places(Edge& line, const End& a, const End& b) {
    const bool along_u = std::fabs(double(line.u)) >= std::fabs(double(line.v));
    const int axis = along_u ? u_ : v_;
    if (!a.point && !b.point) return sign_of(std::int64_t(a.grid[axis]) - b.grid[axis]);
    if (a.point == b.point) return 0;
    const double along = b.at(axis) - a.at(axis);
    if (along > 2 * kApproximation || along < -2 * kApproximation) return along > 0 ? -1 : 1;
    const Plane& across = across_of(line);
    const bool ascends = ((along_u ? line.u : line.v) > 0) != line.against;
    const auto order_by = [&](const Plane& through) {
        const int after = exact_order(*plane_, across, a.exact(), through, b.exact());
        return ascends ? -after : after;
    };
    if (!a.point) return order_by(axis_plane(axis, a.grid[axis]));
    int k = 0;
    while (k < 2 && exact_turn(*plane_, across, *a.point->plane(k)) == 0) ++k;  // one of the three meets the line
    return order_by(*a.point->plane(k));
}

bool PlaneChain::cancels_along(std::size_t first, std::size_t end) {
    events_.clear();
    for (std::size_t k = first; k < end; ++k) {
        const Edge& edge = edges_[order_[k]];
        events_.push_back({edge.from, -1});
        events_.push_back({edge.to, 1});
    }
    Edge& line = edges_[order_[first]];
    sort_range(events_, [&](const Event& a, const Event& b) { return compare_places(line, a.end, b.end) < 0; });
    int sum = 0;
    for (std::size_t k = 0; k < events_.size(); ++k) {
        sum += events_[k].weight;
        const bool last = k + 1 == events_.size() || compare_places(line, events_[k].end, events_[k + 1].end) != 0;
        if (last && sum != 0) return false;
    }
    return true;
}

}  // namespace firma
