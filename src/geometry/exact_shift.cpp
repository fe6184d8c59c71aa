// SPDX-License-Identifier: MIT
// What a predicate that answers zero would answer if part of the geometry were shifted a little.
#include "geometry/exact_shift.h"

namespace firma {
namespace {

/// det of three normals: 158 bits.
Int256 determinant(const Plane& a, const Plane& b, const Plane& c) {
    return product(normal_minor(a, b, 1, 2), c.normal[0]) + product(normal_minor(a, b, 2, 0), c.normal[1]) +
           product(normal_minor(a, b, 0, 1), c.normal[2]);
}

}  // namespace

// The side is det4 / det3(p, q, r), det4 being that of rows p, q, r, a with their offsets in the last column. A shift
// by s takes normal . s off an offset, and so, expanding along that column, normal . s times its cofactor off det4: the
// sign is that of the first axis along which this does not cancel. Products have 53 + 158 bits.
int shifted_side(const ShiftedPlane& a, const ShiftedPlane& p, const ShiftedPlane& q, const ShiftedPlane& r) {
    const Int256 pqr = determinant(*p.plane, *q.plane, *r.plane);
    const struct {
        const ShiftedPlane& plane;
        Int256 cofactor;
    } terms[] = {{p, -determinant(*q.plane, *r.plane, *a.plane)},
                 {q, determinant(*p.plane, *r.plane, *a.plane)},
                 {r, -determinant(*p.plane, *q.plane, *a.plane)},
                 {a, pqr}};
    for (int axis = 0; axis < 3; ++axis) {
        Int256 change;
        for (const auto& [plane, cofactor] : terms)
            if (plane.shifts) change = change - cofactor * plane.plane->normal[axis];
        if (change.sign() != 0) return change.sign() * pqr.sign();
    }
    return 0;
}

}  // namespace firma
