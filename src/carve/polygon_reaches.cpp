// SPDX-License-Identifier: MIT
// Whether a polygon reaches into a box.
#include "carve/polygon_reaches.h"

#include "firma/grid.h"

namespace firma {

bool polygon_reaches_into(std::vector<Vec3>& loop, const GridBox& box) {
    std::vector<Vec3> kept;
    for (int axis = 0; axis < 3; ++axis)
        for (const double sign : {1.0, -1.0}) {
            const double bound = sign * (sign > 0 ? box.low : box.high)[axis] / kSurfacePerInput;
            kept.clear();
            for (std::size_t k = 0; k < loop.size(); ++k) {
                const Vec3 &a = loop[k], &b = loop[k + 1 < loop.size() ? k + 1 : 0];
                const double at_a = sign * a[axis] - bound, at_b = sign * b[axis] - bound;
                if (at_a >= 0) kept.push_back(a);
                if ((at_a < 0 && at_b > 0) || (at_a > 0 && at_b < 0))
                    kept.push_back(a + (b - a) * (at_a / (at_a - at_b)));
            }
            loop.swap(kept);
        }
    return !loop.empty();
}

}  // namespace firma
