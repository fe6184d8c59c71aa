// SPDX-License-Identifier: MIT
// Lines are cut in metres, before large numbers come near the page.
#include "draw/view.h"

namespace firma::draw {

namespace {

/// Shrinks [first, last], fractions of a line, to where start + f * path lies within low .. high.
void shrink(double start, double path, double low, double high, double& first, double& last) {
    if (path == 0) {
        if (start < low || start > high) last = -1;
        return;
    }
    const double a = (low - start) / path, b = (high - start) / path;
    const double enter = a < b ? a : b, leave = a < b ? b : a;
    if (enter > first) first = enter;
    if (leave < last) last = leave;
}

}  // namespace

PageLine cut_to_view(const View& view, const Vec3& from, const Vec3& to) {
    double first = 0, last = 1;
    for (const int axis : {view.across, view.upward})
        shrink(from[axis], to[axis] - from[axis], view.region.low[axis], view.region.high[axis], first, last);
    if (!(first <= last)) return {};
    const Vec3 path = to - from;
    return {view.place(from + path * first), view.place(from + path * last), first > 0, last < 1, true};
}

}  // namespace firma::draw
