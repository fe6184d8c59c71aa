// SPDX-License-Identifier: MIT
// Divides a flat face with holes into triangles: bridges to the holes, then ears.
#include "geometry/triangulate.h"

#include <algorithm>

#include "geometry/flat_loop.h"

namespace firma {

bool Triangulator::make(std::span<const GridPoint> points, std::span<const FlatPoint> flat,
                        std::span<const std::uint32_t> loop_ends, Triangles& triangles) {
    points_ = points;
    triangles.clear();
    return link_loops(flat, loop_ends) && join_holes() &&
           clipper_.clip(points, ring_, EarClipper::Takes::kEars, triangles);
}

void Triangulator::make_any(std::span<const GridPoint> points, std::span<const FlatPoint> flat,
                            std::span<const std::uint32_t> loop_ends, Triangles& triangles) {
    points_ = points;
    triangles.clear();
    link_loops(flat, loop_ends);
    std::sort(holes_.begin(), holes_.end(),
              [&](std::uint32_t a, std::uint32_t b) { return ring_[a].at < ring_[b].at; });
    joined_.assign(flat.size(), 0);
    std::fill(joined_.begin(), joined_.begin() + loop_ends[0], 1);
    for (const std::uint32_t hole : holes_) join_anyhow(hole);
    clipper_.clip(points, ring_, EarClipper::Takes::kAnything, triangles);
}

/// To what it touches, to what it sees, or to the nearest.
void Triangulator::join_anyhow(std::uint32_t hole) {
    std::uint32_t best = UINT32_MAX, from = hole;
    double nearest = 0;
    std::uint32_t k = hole;
    do {  // a corner that both share
        for (std::uint32_t rim = 0; rim < ring_.size(); ++rim)
            if (joined_[rim] && ring_[rim].at == ring_[k].at && opens_to(ring_[rim], ring_[ring_[k].after].at)) {
                best = rim;
                from = k;
            }
        k = ring_[k].after;
    } while (k != hole && best == UINT32_MAX);
    if (best == UINT32_MAX) {
        if (join(hole)) {
            mark_joined(hole);
            return;
        }
        for (std::uint32_t rim = 0; rim < ring_.size(); ++rim) {
            if (!joined_[rim]) continue;
            const double length = square_distance(points_[ring_[rim].point], points_[ring_[hole].point]);
            if (best != UINT32_MAX && length >= nearest) continue;
            nearest = length;
            best = rim;
        }
    }
    splice(best, from);
    mark_joined(from);
}

/// The hole's corners, and the ends of the bridge, which were made last.
void Triangulator::mark_joined(std::uint32_t hole) {
    joined_.resize(ring_.size(), 1);
    for (std::uint32_t k = hole; !joined_[k]; k = ring_[k].after) joined_[k] = 1;
}

/// @return false when a loop runs the wrong way around
bool Triangulator::link_loops(std::span<const FlatPoint> flat, std::span<const std::uint32_t> loop_ends) {
    ring_.resize(flat.size());
    holes_.clear();
    bool right = true;
    std::uint32_t begin = 0;
    for (const std::uint32_t end : loop_ends) {
        const auto loop = flat.subspan(begin, end - begin);
        const Int128 area = twice_area(loop);
        const bool outer = begin == 0;
        if (outer ? area <= 0 : area >= 0) right = false;
        if (!outer) holes_.push_back(begin + std::uint32_t(std::min_element(loop.begin(), loop.end()) - loop.begin()));
        link_ring(flat, begin, end, ring_);
        begin = end;
    }
    return right;
}

/// Every hole is joined to what lies before its lowest corner: the outer loop and holes that have been joined. A bridge
/// that way exists whenever the hole lies directly inside: any triangulation has a diagonal from there to an earlier
/// corner, as all else would leave an angle of 180 degrees or more. Where it does not lie so, whatever its lowest
/// corner sees turns its back on it.
bool Triangulator::join_holes() {
    std::sort(holes_.begin(), holes_.end(),
              [&](std::uint32_t a, std::uint32_t b) { return ring_[a].at < ring_[b].at; });
    for (const std::uint32_t hole : holes_)
        if (!join(hole)) return false;
    return true;
}

bool Triangulator::join(std::uint32_t hole) {
    const RingCorner from = ring_[hole];
    rims_.clear();
    for (std::uint32_t k = 0; k < ring_.size(); ++k)
        if (ring_[k].at < from.at) rims_.push_back({square_distance(points_[ring_[k].point], points_[from.point]), k});
    std::make_heap(rims_.begin(), rims_.end());
    while (!rims_.empty()) {
        const std::uint32_t rim = rims_.front().corner;
        if (opens_to(ring_[rim], from.at) && visible(rim, hole)) {
            splice(rim, hole);
            return true;
        }
        std::pop_heap(rims_.begin(), rims_.end());
        rims_.pop_back();
    }
    return false;
}

/// Whether a point lies strictly within the angle of a corner.
bool Triangulator::opens_to(const RingCorner& corner, const FlatPoint& target) const {
    const FlatPoint &a = ring_[corner.before].at, &b = corner.at, &c = ring_[corner.after].at;
    const bool left_of_in = turn(a, b, target) > 0, left_of_out = turn(b, c, target) > 0;
    return turn(a, b, c) > 0 ? left_of_in && left_of_out : left_of_in || left_of_out;
}

/// Whether no edge touches the bridge on its way. Edges at its ends do not matter: the corner opens to the other end,
/// and an edge that runs along it from there would end on it, where the next edges count.
bool Triangulator::visible(std::uint32_t from, std::uint32_t to) const {
    const FlatPoint &a = ring_[from].at, &b = ring_[to].at;
    const auto [low_v, high_v] = std::minmax(a.v, b.v);
    for (const RingCorner& corner : ring_) {
        const FlatPoint &c = corner.at, &d = ring_[corner.after].at;
        if ((c.u < a.u && d.u < a.u) || (c.u > b.u && d.u > b.u)) continue;
        if ((c.v < low_v && d.v < low_v) || (c.v > high_v && d.v > high_v)) continue;
        if (c == a || c == b || d == a || d == b) continue;
        if (segments_meet(a, b, c, d)) return false;
    }
    return true;
}

/// rim -> after becomes rim -> hole -> around it -> hole again -> rim again -> after.
void Triangulator::splice(std::uint32_t rim, std::uint32_t hole) {
    const auto hole_again = std::uint32_t(ring_.size()), rim_again = hole_again + 1;
    const RingCorner rim_copy = ring_[rim], hole_copy = ring_[hole];
    ring_.push_back(hole_copy);
    ring_.push_back(rim_copy);
    ring_[rim_again].before = hole_again;
    ring_[rim_copy.after].before = rim_again;
    if (rim_copy.partner != UINT32_MAX) ring_[rim_copy.partner].partner = rim_again;
    ring_[hole_copy.before].after = hole_again;
    ring_[hole_again].after = rim_again;
    ring_[hole_again].partner = rim;
    ring_[hole].before = rim;
    ring_[rim].after = hole;
    ring_[rim].partner = hole_again;
}

}  // namespace firma
