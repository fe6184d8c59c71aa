// SPDX-License-Identifier: MIT
// Whether a polygon reaches into a box, or a bevelled one.
#include "carve/polygon_reaches.h"

#include "firma/grid.h"

namespace firma {
namespace {

/// Keeps what of a loop has at(p) >= 0.
template <class At>
void clip(std::vector<Vec3>& loop, std::vector<Vec3>& kept, const At& at) {
    kept.clear();
    for (std::size_t k = 0; k < loop.size(); ++k) {
        const Vec3 &a = loop[k], &b = loop[k + 1 < loop.size() ? k + 1 : 0];
        const double at_a = at(a), at_b = at(b);
        if (at_a >= 0) kept.push_back(a);
        if ((at_a < 0 && at_b > 0) || (at_a > 0 && at_b < 0)) kept.push_back(a + (b - a) * (at_a / (at_a - at_b)));
    }
    loop.swap(kept);
}

}  // namespace

bool polygon_reaches_into(std::vector<Vec3>& loop, const GridBox& box) {
    std::vector<Vec3> kept;
    for (int axis = 0; axis < 3; ++axis)
        for (const double sign : {1.0, -1.0}) {
            const double bound = sign * (sign > 0 ? box.low : box.high)[axis] / kSurfacePerInput;
            clip(loop, kept, [&](const Vec3& p) { return sign * p[axis] - bound; });
        }
    return !loop.empty();
}

bool polygon_reaches_into(std::vector<Vec3>& loop, const BevelledBox& box, std::int32_t steps) {
    std::vector<Vec3> kept;
    box.for_each_plane(steps, [&](const GridPoint& outward, std::int64_t bound) {
        const Vec3 normal{double(outward.x), double(outward.y), double(outward.z)};
        clip(loop, kept, [&](const Vec3& p) { return double(bound) / kSurfacePerInput - dot(normal, p); });
    });
    return !loop.empty();
}

}  // namespace firma
