// SPDX-License-Identifier: MIT
// Where two answers to the same casts differ, and which of them is wrong.
#include "scale/differences.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "tests/reference/exact_oracle.h"

namespace firma::bench {
namespace {

bool is_hit(double fraction) {
    return fraction <= 1;
}

/// Whether stops are the same within the tolerance; one that is within it of the path's end may be a miss.
bool same_stop(double a, double b, double length) {
    const double rim = kStopTolerance / length;
    if (is_hit(a) && is_hit(b)) return std::fabs(a - b) <= rim;
    return is_hit(a) == is_hit(b) || std::min(a, b) >= 1 - rim;
}

/// Whether a segment, made wider by `reach`, may meet a triangle's box: slabs in double, a micrometre to spare.
bool near_segment(const Vec3& start, const Vec3& path, double reach, const Vec3* corners) {
    double from = 0, to = 1;
    for (int axis = 0; axis < 3; ++axis) {
        const auto [low, high] = std::minmax({corners[0][axis], corners[1][axis], corners[2][axis]});
        const double a = low - reach - 1e-6 - start[axis], b = high + reach + 1e-6 - start[axis];
        if (path[axis] == 0) {
            if (a > 0 || b < 0) return false;
            continue;
        }
        const double enter = (path[axis] > 0 ? a : b) / path[axis], leave = (path[axis] > 0 ? b : a) / path[axis];
        from = std::max(from, enter - 1e-9);
        to = std::min(to, leave + 1e-9);
    }
    return from <= to;
}

Vec3 vec_of(const float* p) {
    return {p[0], p[1], p[2]};
}

}  // namespace

double Judge::truth(std::size_t cast) {
    const auto [found, is_new] = known_.try_emplace(cast, kScaleMiss);
    if (!is_new) return found->second;
    const FloatCast& c = casts_[cast];
    const Vec3 start = vec_of(c.start), path = vec_of(c.path);
    std::vector<std::vector<Vec3>> near;
    for (std::size_t k = 0; k < mesh_.corners.size(); k += 3) {
        Vec3 corners[3];
        for (std::size_t i = 0; i < 3; ++i)
            corners[i] = vec_of(mesh_.positions.data() + 3 * std::size_t(mesh_.corners[k + i]));
        if (near_segment(start, path, c.radius, corners)) near.push_back({corners[0], corners[1], corners[2]});
    }
    if (near.empty()) return kScaleMiss;
    const reference::ExactOracle oracle(near);
    const reference::Expected expected = oracle.expect({{start, c.radius}, path, Sides::kBoth});
    if (expected.touched()) found->second = std::stod(expected.fraction_text());
    return found->second;
}

Differences Judge::compare(std::span<const double> ours, std::span<const double> theirs) {
    Differences all;
    all.asked = theirs.size();
    double looked_at = 0;
    for (std::size_t k = 0; k < theirs.size(); ++k) {
        const FloatCast& c = casts_[k];
        const double length = std::sqrt(dot(vec_of(c.path), vec_of(c.path)));
        all.hits += is_hit(theirs[k]);
        all.leaks += must_hit_ && !is_hit(theirs[k]);
        all.our_leaks += must_hit_ && !is_hit(ours[k]);
        if (same_stop(ours[k], theirs[k], length)) continue;
        ++all.differ;
        if (looked_at > max_) continue;
        if (!known_.contains(k)) looked_at += double(mesh_.triangles());
        const double right = truth(k);
        ++all.judged;
        all.ours_wrong += !same_stop(ours[k], right, length);
        if (same_stop(theirs[k], right, length)) continue;
        ++all.wrong;
        if (!is_hit(theirs[k]))
            ++all.missed;
        else if (!is_hit(right))
            ++all.false_hits;
        else
            ++(theirs[k] < right ? all.early : all.late);
    }
    return all;
}

}  // namespace firma::bench
