// SPDX-License-Identifier: MIT
// Ways to tell whether a hit point, or the line of a ray, lies inside a convex polygon: for comparison only.
#pragma once

#include "naive/mended.h"
#include "naive/printed.h"

namespace firma::naive {

/// Edge signs in two dimensions, on the hit point: the dominant axis dropped, no division.
template <class Real>
bool edge_signs_inside(const PlainFace<Real>& face, const Vector<Real>& p) {
    const int j = face.j, k = face.k;
    // Without the dominant axis, counter-clockwise turns clockwise when the normal points down it or the axes swap.
    const int dropped = 3 - j - k;
    const bool turned = (face.plane.normal[dropped] < 0) != (dropped == 1);
    const std::size_t count = face.corners.size();
    const Vector<Real>* a = &face.corners[count - 1];
    for (std::size_t c = 0; c < count; ++c) {
        const Vector<Real>* b = &face.corners[c];
        const Real side = ((*b)[j] - (*a)[j]) * (p[k] - (*a)[k]) - ((*b)[k] - (*a)[k]) * (p[j] - (*a)[j]);
        if (turned ? side > 0 : side < 0) return false;
        a = b;
    }
    return true;
}

/// Signs of the triple products d . (a x b): no hit point needed.
template <class Real>
bool triple_product_inside(const PlainFace<Real>& face, const Vector<Real>& pos, const Vector<Real>& path) {
    Vector<Real> a = face.corners.back() - pos;
    for (const Vector<Real>& corner : face.corners) {
        const Vector<Real> b = corner - pos;
        if (dot(path, cross(a, b)) > 0) return false;
        a = b;
    }
    return true;
}

}  // namespace firma::naive
