// SPDX-License-Identifier: MIT
// Ear clipping in a plane of whole numbers.
#include "geometry/clip_ears.h"

#include <algorithm>

#include "base/sort.h"

namespace firma {
namespace {

constexpr std::uint32_t kNobody = UINT32_MAX;

// What a kind counts: squares of lengths are zero (of spikes only) or from 1 to 2^68, so those of two kinds never mix.
constexpr double kSpike = 0x1p-100, kFlat = 0x1p100, kBlocked = 0x1p200, kRight = 0x1p300;  // and an ear 1

}  // namespace

void link_ring(std::span<const FlatPoint> flat, std::uint32_t first, std::uint32_t end, std::span<RingCorner> ring) {
    for (std::uint32_t k = first; k < end; ++k)
        ring[k] = {flat[k], k, k > first ? k - 1 : end - 1, k + 1 < end ? k + 1 : first};
}

bool EarClipper::clip(std::span<const GridPoint> points, std::span<RingCorner> ring, Takes takes,
                      Triangles& triangles) {
    points_ = points;
    ring_ = ring;
    takes_anything_ = takes == Takes::kAnything;
    next_.reset(ring.size());
    inward_.clear();
    for (std::uint32_t k = 0; k < ring.size(); ++k) {
        judge(k);
        if (!ring[k].left) inward_.push_back({ring[k].at, k});
    }
    sort_range(inward_, [](const Inward& a, const Inward& b) {
        return a.at.u != b.at.u ? a.at.u < b.at.u : a.corner < b.corner;
    });
    if (takes_anything_)
        for (std::uint32_t k = 0; k < ring.size(); ++k) defer_blocked(k);
    for (std::size_t remaining = ring.size(); remaining > 2;) {
        const std::uint32_t k = next_.find();
        if (k == kNobody) return false;
        next_.set(k, LowestKey::kNone);
        if (!takes_anything_ && blocked(k)) continue;
        emit(k, triangles);
        RingCorner& corner = ring[k];
        corner.gone = true;
        ring[corner.before].after = corner.after;
        ring[corner.after].before = corner.before;
        if (--remaining > 2)
            for (const std::uint32_t neighbour : {corner.before, corner.after}) {
                judge(neighbour);
                if (takes_anything_) defer_blocked(neighbour);
            }
    }
    return true;
}

double EarClipper::third_side(const RingCorner& corner) const {
    return square_distance(points_[ring_[corner.before].point], points_[ring_[corner.after].point]);
}

/// A left turn counts as an ear: whether it is blocked is asked later.
void EarClipper::judge(std::uint32_t k) {
    RingCorner& corner = ring_[k];
    const RingCorner &last = ring_[corner.before], &next = ring_[corner.after];
    const Int128 turned = turn(last.at, corner.at, next.at);
    corner.left = turned > 0;
    if (corner.left) return next_.set(k, third_side(corner));
    if (!takes_anything_) return next_.set(k, LowestKey::kNone);
    const GridPoint &a = points_[last.point], &b = points_[corner.point], &c = points_[next.point];
    const bool spike = a == b || b == c || a == c;
    next_.set(k, third_side(corner) * (spike ? kSpike : turned < 0 ? kRight : kFlat));
}

/// Where an outline touches itself, what once was blocked must wait, though nothing may block it any more: triangles
/// would overlap. Of an outline that does not, it cannot become an ear: so there it need not be asked before its turn.
void EarClipper::defer_blocked(std::uint32_t k) {
    if (ring_[k].left && blocked(k)) next_.set(k, third_side(ring_[k]) * kBlocked);
}

/// Whether another part of the outline enters the triangle at a left turn, or stands on its third side. What enters has
/// its farthest corner there, which is no left turn.
bool EarClipper::blocked(std::uint32_t k) const {
    const RingCorner& corner = ring_[k];
    const FlatPoint &b = corner.at, &a = ring_[corner.before].at, &c = ring_[corner.after].at;
    const auto [low_u, high_u] = std::minmax({a.u, b.u, c.u});
    const auto [low_v, high_v] = std::minmax({a.v, b.v, c.v});
    auto it = std::lower_bound(inward_.begin(), inward_.end(), low_u,
                               [](const Inward& inward, std::int64_t u) { return inward.at.u < u; });
    for (; it != inward_.end() && it->at.u <= high_u; ++it) {
        if (it->at.v < low_v || it->at.v > high_v || it->corner == corner.before || it->corner == corner.after)
            continue;
        const RingCorner& other = ring_[it->corner];
        if (!other.gone && !other.left && enters(other, a, b, c)) return true;
    }
    return false;
}

/// Whether a corner lies inside a triangle or within its third side, c a, or lies on its rim and leads in from there
/// (as ends of bridges do, in the places of its own corners).
bool EarClipper::enters(const RingCorner& other, const FlatPoint& a, const FlatPoint& b, const FlatPoint& c) const {
    const Int128 of_third = turn(c, a, other.at);
    if (of_third < 0) return false;
    const Int128 of_first = turn(a, b, other.at), of_second = turn(b, c, other.at);
    if (of_first < 0 || of_second < 0) return false;
    if (of_first > 0 && of_second > 0) return true;
    const auto leads_in = [&](const FlatPoint& to) {
        return (of_third > 0 || turn(c, a, to) > 0) && (of_first > 0 || turn(a, b, to) > 0) &&
               (of_second > 0 || turn(b, c, to) > 0);
    };
    return leads_in(ring_[other.before].at) || leads_in(ring_[other.after].at);
}

void EarClipper::emit(std::uint32_t k, Triangles& triangles) {
    const std::uint32_t last = ring_[k].before, next = ring_[k].after;
    const auto side = std::uint32_t(triangles.corners.size());
    for (const std::uint32_t corner : {last, k, next}) triangles.corners.push_back(ring_[corner].point);
    triangles.twins.resize(side + 3, Triangles::kNoTwin);
    use_edge(last, side, triangles);
    use_edge(k, side + 1, triangles);
    if (ring_[next].after == last)
        use_edge(next, side + 2, triangles);
    else
        ring_[last].twin = side + 2;
}

/// The edge from a corner has got its triangle.
void EarClipper::use_edge(std::uint32_t k, std::uint32_t side, Triangles& triangles) {
    const RingCorner& corner = ring_[k];
    if (corner.twin != Triangles::kNoTwin) {
        triangles.twins[side] = corner.twin;
        triangles.twins[corner.twin] = side;
    } else if (corner.partner != kNobody) {
        ring_[corner.partner].twin = side;
    }
}

}  // namespace firma
