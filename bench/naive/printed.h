// SPDX-License-Identifier: MIT
// The article's formulas exactly as printed, faults and all: for measuring, never for use.
// Source: "Collision Detection Using Ray Casting", Game Developer Magazine. Where the scan is plainly misread (an
// index, the closing brace), the sense is followed; the formulas are not touched.
#pragma once

#include "naive/plain.h"

namespace firma::naive {

/// collide_line_plane() of the article, its early-outs included.
template <class Real>
bool collide_line_plane(const Vector<Real>& pos, const Vector<Real>& path, const Plane<Real>& plane, Real& time) {
    const Real dist = plane.distance_to_point(pos);
    if (dist < 0) return false;  // behind plane
    const Real len = -dot(path, plane.normal);
    if (len < dist) return false;  // moving away from plane or point too far away
    time = dist / len;
    return true;
}

/// C = alpha A + beta B for the triangle V0, V1, V2, seen without the dominant axis.
template <class Real>
bool alpha_beta_inside(const Vector<Real>& v0, const Vector<Real>& v1, const Vector<Real>& v2, const Vector<Real>& p,
                       int j, int k) {
    const Vector<Real> a = v1 - v0, b = v2 - v0, c = p - v0;
    const Real determinant = a[j] * b[k] - a[k] * b[j];
    const Real alpha = (b[k] * c[j] - b[j] * c[k]) / determinant;
    const Real beta = (a[j] * c[k] - a[k] * c[j]) / determinant;
    return alpha >= 0 && beta >= 0 && alpha + beta <= 1;
}

/// "Modified to loop through the vertices of the polygon three at a time."
template <class Real>
bool alpha_beta_inside(const PlainFace<Real>& face, const Vector<Real>& p) {
    for (std::size_t c = 2; c < face.corners.size(); ++c)
        if (alpha_beta_inside(face.corners[0], face.corners[c - 1], face.corners[c], p, face.j, face.k)) return true;
    return false;
}

/// The smaller root; one root is a graze and "we can safely ignore it".
template <class Real>
Meeting<Real> printed_root(Real a, Real b, Real c) {
    const Real determinant = b * b - 4 * a * c;
    if (determinant <= 0) return {};
    const Real root = std::sqrt(determinant);
    const Real one = (-b + root) / (2 * a), other = (-b - root) / (2 * a);
    const Real hit_time = one < other ? one : other;
    if (!(hit_time >= 0 && hit_time <= 1)) return {};
    return hit_time;
}

/// Ve = V1 - V0, Vs = path, Vd = pos - V0. As printed: a ends in (Ve.Ve)^2, c begins with (Vd.Ve)(Vd.Vs).
template <class Real>
Meeting<Real> printed_edge(const Vector<Real>& pos, const Vector<Real>& path, Real r, const Vector<Real>& v0,
                           const Vector<Real>& v1) {
    const Vector<Real> ve = v1 - v0, vs = path, vd = pos - v0;
    const Real a = dot(ve, vs) * dot(ve, vs) - dot(ve, ve) * dot(ve, ve);
    const Real b = 2 * (dot(vd, ve) * dot(ve, vs) - dot(vd, vs) * dot(ve, ve));
    const Real c = dot(vd, ve) * dot(vd, vs) + r * r * dot(ve, ve) - dot(vd, vd) * dot(ve, ve);
    const Meeting<Real> hit_time = printed_root(a, b, c);
    if (!hit_time) return {};
    const Vector<Real> hit_pos = path * *hit_time + pos;
    const Real dist = dot(hit_pos - v0, ve) / dot(ve, ve);
    if (!(dist >= 0 && dist <= 1)) return {};
    return hit_time;
}

template <class Real>
Meeting<Real> printed_vertex(const Vector<Real>& pos, const Vector<Real>& path, Real r, const Vector<Real>& vertex) {
    const Vector<Real> vs = path, vd = pos - vertex;
    return printed_root(dot(vs, vs), 2 * dot(vd, vs), dot(vd, vd) - r * r);
}

/// A sphere against a face, in the article's order: its point nearest to the plane as a particle; when that meets the
/// plane beside the polygon, each edge and each edge's first vertex.
template <class Real>
Meeting<Real> printed_cast(const PlainFace<Real>& face, const Vector<Real>& pos, const Vector<Real>& path, Real r) {
    const Vector<Real> leading = pos - face.plane.normal * r;
    Real time = 0;
    if (!collide_line_plane(leading, path, face.plane, time)) return {};
    if (alpha_beta_inside(face, path * time + leading)) return time;
    Meeting<Real> best;
    if (r == 0) return best;
    for (std::size_t c = 0; c < face.corners.size(); ++c) {
        keep_earlier(best, printed_edge(pos, path, r, face.corners[c], face.corners[face.next(c)]));
        keep_earlier(best, printed_vertex(pos, path, r, face.corners[c]));
    }
    return best;
}

}  // namespace firma::naive
