// SPDX-License-Identifier: MIT
// Vectors and faces for the article's formulas, in float or in double: nothing here knows of Firma's own care.
#pragma once

#include <cmath>
#include <optional>
#include <vector>

#include "firma/vec.h"

namespace firma::naive {

template <class Real>
struct Vector {
    Real x = 0, y = 0, z = 0;
    Real operator[](int axis) const { return axis == 0 ? x : axis == 1 ? y : z; }
};
template <class Real>
Vector<Real> operator+(const Vector<Real>& a, const Vector<Real>& b) {
    return {a.x + b.x, a.y + b.y, a.z + b.z};
}
template <class Real>
Vector<Real> operator-(const Vector<Real>& a, const Vector<Real>& b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
}
template <class Real>
Vector<Real> operator*(const Vector<Real>& a, Real s) {
    return {a.x * s, a.y * s, a.z * s};
}
template <class Real>
Real dot(const Vector<Real>& a, const Vector<Real>& b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}
template <class Real>
Vector<Real> cross(const Vector<Real>& a, const Vector<Real>& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
template <class Real>
Real length(const Vector<Real>& a) {
    return std::sqrt(dot(a, a));
}
template <class Real>
Vector<Real> narrowed(const Vec3& v) {
    return {Real(v.x), Real(v.y), Real(v.z)};
}

/// n . p + offset = 0, n of length 1: "each world face stores its plane equation".
template <class Real>
struct Plane {
    Vector<Real> normal;
    Real offset = 0;
    Real distance_to_point(const Vector<Real>& p) const { return dot(normal, p) + offset; }
};

template <class Real>
struct PlainFace {
    std::vector<Vector<Real>> corners;
    Plane<Real> plane;
    int j = 0, k = 1;  ///< the axes that are left without the normal's dominant one

    explicit PlainFace(const std::vector<Vec3>& from) {
        // The plane comes from exact corners in double, then is rounded: the best a face could store.
        Vec3 normal;
        for (std::size_t c = 2; c < from.size(); ++c)
            normal = normal + firma::cross(from[c - 1] - from[0], from[c] - from[0]);
        normal = normal * (1 / firma::length(normal));
        for (const Vec3& corner : from) corners.push_back(narrowed<Real>(corner));
        plane = {narrowed<Real>(normal), Real(-firma::dot(normal, from[0]))};
        const double x = std::fabs(normal.x), y = std::fabs(normal.y), z = std::fabs(normal.z);
        const int dominant = x >= y && x >= z ? 0 : y >= z ? 1 : 2;
        j = dominant == 0 ? 1 : 0;
        k = dominant == 2 ? 1 : 2;
    }
    std::size_t next(std::size_t corner) const { return corner + 1 < corners.size() ? corner + 1 : 0; }
};

/// The fraction at which a mover meets a face, if it does.
template <class Real>
using Meeting = std::optional<Real>;

template <class Real>
void keep_earlier(Meeting<Real>& best, const Meeting<Real>& other) {
    if (other && (!best || *other < *best)) best = other;
}

}  // namespace firma::naive
