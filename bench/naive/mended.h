// SPDX-License-Identifier: MIT
// The article's formulas with their slips corrected, in plain arithmetic: what a careful reader would write in an
// evening. What still goes wrong here is rounding's.
//
// Mended: the edge's a and c; the early-out "behind the plane", which holds for the inside of a face only; 0/0; grazes;
// neighbours that must agree at shared edges and vertices. Added, because the article leaves it open: a sphere that
// starts in overlap touches at 0 when it comes closer and is ignored otherwise.
// Source: "Collision Detection Using Ray Casting", Game Developer Magazine; ../shared/DESIGN.md, section 1.
#pragma once

#include "naive/plain.h"

namespace firma::naive {

/// A path made ready to see corners along itself: the same two numbers for a corner, whatever face asks.
template <class Real>
struct ViewAlong {
    int u = 0, v = 1, k = 2;
    Real shear_u = 0, shear_v = 0;

    explicit ViewAlong(const Vector<Real>& d) {
        const Real x = std::fabs(d.x), y = std::fabs(d.y), z = std::fabs(d.z);
        k = x >= y && x >= z ? 0 : y >= z ? 1 : 2;
        u = (k + 1) % 3;
        v = (k + 2) % 3;
        if (d[k] < 0) std::swap(u, v);
        shear_u = d[u] / d[k];
        shear_v = d[v] / d[k];
    }
};

/// Every edge's side by the sign of a difference of two rounded products; zero counts as inside.
template <class Real>
bool line_meets_face(const PlainFace<Real>& face, const Vector<Real>& pos, const ViewAlong<Real>& view) {
    const auto project_u = [&](const Vector<Real>& w) { return w[view.u] - view.shear_u * w[view.k]; };
    const auto project_v = [&](const Vector<Real>& w) { return w[view.v] - view.shear_v * w[view.k]; };
    const Vector<Real> last = face.corners.back() - pos;
    Real au = project_u(last), av = project_v(last);
    for (const Vector<Real>& corner : face.corners) {
        const Vector<Real> w = corner - pos;
        const Real bu = project_u(w), bv = project_v(w);
        if (au * bv - av * bu > 0) return false;
        au = bu;
        av = bv;
    }
    return true;
}

/// The foot of a point, judged by the face's edges in space.
template <class Real>
bool edges_inside(const PlainFace<Real>& face, const Vector<Real>& p) {
    for (std::size_t c = 0; c < face.corners.size(); ++c) {
        const Vector<Real>&a = face.corners[c], &b = face.corners[face.next(c)];
        if (dot(cross(b - a, p - a), face.plane.normal) < 0) return false;
    }
    return true;
}

/// a = (Ve.Vs)^2 - (Ve.Ve)(Vs.Vs) <= 0, so the first touch is (-b + sqrt(b^2 - 4ac)) / 2a; a = 0 is a path along the
/// edge, whose ends decide.
template <class Real>
Meeting<Real> mended_edge(const Vector<Real>& pos, const Vector<Real>& path, Real r, const Vector<Real>& v0,
                          const Vector<Real>& v1) {
    const Vector<Real> ve = v1 - v0, vs = path, vd = pos - v0;
    const Real ee = dot(ve, ve), es = dot(ve, vs), de = dot(vd, ve);
    const Real a = es * es - ee * dot(vs, vs);
    const Real b = 2 * (de * es - dot(vd, vs) * ee);
    const Real c = de * de + r * r * ee - dot(vd, vd) * ee;
    const Real determinant = b * b - 4 * a * c;
    if (!(a < 0) || determinant < 0) return {};
    const Real time = (-b + std::sqrt(determinant)) / (2 * a);
    if (!(time >= 0 && time <= 1)) return {};
    const Real along = de + time * es;
    if (!(along >= 0 && along <= ee)) return {};
    return time;
}

template <class Real>
Meeting<Real> mended_vertex(const Vector<Real>& pos, const Vector<Real>& path, Real r, const Vector<Real>& vertex) {
    const Vector<Real> vd = pos - vertex;
    const Real a = dot(path, path), b = 2 * dot(vd, path), c = dot(vd, vd) - r * r;
    const Real determinant = b * b - 4 * a * c;
    if (determinant < 0) return {};
    const Real time = (-b - std::sqrt(determinant)) / (2 * a);
    if (!(time >= 0 && time <= 1)) return {};
    return time;
}

enum class AtStart { kApart, kInitialOverlap, kIgnored };

/// Whether a sphere overlaps the face before it moves, and comes closer.
template <class Real>
AtStart start_of(const PlainFace<Real>& face, const Vector<Real>& pos, const Vector<Real>& path, Real r) {
    const Real height = face.plane.distance_to_point(pos);
    if (std::fabs(height) > r) return AtStart::kApart;
    Vector<Real> away = face.plane.normal * height;
    if (!edges_inside(face, pos)) {
        for (std::size_t c = 0; c < face.corners.size(); ++c) {
            const Vector<Real> e = face.corners[face.next(c)] - face.corners[c], w = pos - face.corners[c];
            Real along = dot(w, e) / dot(e, e);
            along = along < 0 ? 0 : along > 1 ? 1 : along;
            const Vector<Real> other = w - e * along;
            if (c == 0 || dot(other, other) < dot(away, away)) away = other;
        }
    }
    const Real distance = length(away);
    if (distance > r) return AtStart::kApart;
    return distance == 0 || dot(away, path) < 0 ? AtStart::kInitialOverlap : AtStart::kIgnored;
}

/// One-sided, as the article has it.
///
/// @param plane_early_out  true leaves one fault in: a sphere whose leading point is behind the plane meets nothing
template <class Real>
Meeting<Real> mended_cast(const PlainFace<Real>& face, const Vector<Real>& pos, const Vector<Real>& path, Real r,
                          const ViewAlong<Real>& view, bool plane_early_out = false) {
    const Real len = -dot(path, face.plane.normal);
    if (!(len > 0)) return {};
    const Real height = face.plane.distance_to_point(pos);
    if (r == 0) {
        if (height < 0 || len < height || !line_meets_face(face, pos, view)) return {};
        return height / len;
    }
    if (height < -r) return {};
    if (plane_early_out) {
        if (height < r) return {};
    } else {
        const AtStart start = start_of(face, pos, path, r);
        if (start == AtStart::kIgnored) return {};
        if (start == AtStart::kInitialOverlap) return Real(0);
    }
    if (height >= r) {
        const Real time = (height - r) / len;
        if (time > 1) return {};
        if (edges_inside(face, pos + path * time)) return time;
    }
    Meeting<Real> best;
    for (std::size_t c = 0; c < face.corners.size(); ++c) {
        keep_earlier(best, mended_edge(pos, path, r, face.corners[c], face.corners[face.next(c)]));
        keep_earlier(best, mended_vertex(pos, path, r, face.corners[c]));
    }
    return best;
}

}  // namespace firma::naive
