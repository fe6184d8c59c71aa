// SPDX-License-Identifier: MIT
// Where a node stands.
// Source: Khronos Group, glTF 2.0 Specification, 2021, section 3.5.3.
#include "gltf/placement.h"

#include <cmath>

namespace firma::gltf {
namespace {

/// Of any quaternion but zero, by its length: entries of quarter turns come out as 0, 1 and -1 exactly, whatever
/// rounding their sine and cosine had, so what write_glb() turned comes back to the bit.
std::optional<Placement> rotation(const std::vector<double>& q) {
    const double x = q[0], y = q[1], z = q[2], w = q[3];
    const double xx = x * x, yy = y * y, zz = z * z, ww = w * w;
    const double n = xx + yy + zz + ww;
    if (!(n > 0) || !is_finite(n)) return std::nullopt;
    Placement turn;
    turn.column[0] = {(ww + xx - yy - zz) / n, 2 * (x * y + w * z) / n, 2 * (x * z - w * y) / n};
    turn.column[1] = {2 * (x * y - w * z) / n, (ww - xx + yy - zz) / n, 2 * (y * z + w * x) / n};
    turn.column[2] = {2 * (x * z + w * y) / n, 2 * (y * z - w * x) / n, (ww - xx - yy + zz) / n};
    return turn;
}

}  // namespace

Placement operator*(const Placement& outer, const Placement& inner) {
    Placement both;
    for (std::size_t k = 0; k < 3; ++k) both.column[k] = outer.turned(inner.column[k]);
    both.column[3] = outer.turned(inner.column[3]) + outer.column[3];
    return both;
}

namespace {

/// The axes that columns are along, made unit and perpendicular, one after the other; none where they are flat.
std::optional<std::array<Vec3, 3>> axes_of(const Placement& placement) {
    const auto unit = [](const Vec3& v) { return v * (1 / length(v)); };
    const Vec3& x = placement.column[0];
    if (!(length(x) > 0)) return std::nullopt;
    const Vec3 first = unit(x), y = placement.column[1] - first * dot(first, placement.column[1]);
    if (!(length(y) > length(placement.column[1]) * 1e-9)) return std::nullopt;
    const Vec3 second = unit(y);
    return std::array{first, second, cross(first, second)};
}

}  // namespace

std::array<double, 4> Frame::rotation() const {
    const Vec3 &x = axis[0], &y = axis[1], &z = axis[2];
    // Each is 4 q[k]^2: the largest is divided by.
    const std::array<double, 4> square{1 + x.x - y.y - z.z, 1 - x.x + y.y - z.z, 1 - x.x - y.y + z.z,
                                       1 + x.x + y.y + z.z};
    std::size_t k = 3;
    for (std::size_t other = 0; other < 3; ++other)
        if (square[other] > square[k]) k = other;
    const double d = 2 * std::sqrt(square[k]), a = (y.z - z.y) / d, b = (z.x - x.z) / d, c = (x.y - y.x) / d;
    const double xy = (x.y + y.x) / d, xz = (z.x + x.z) / d, yz = (y.z + z.y) / d, own = d / 4;
    switch (k) {
        case 0:
            return {own, xy, xz, a};
        case 1:
            return {xy, own, yz, b};
        case 2:
            return {xz, yz, own, c};
        default:
            return {a, b, c, own};
    }
}

Placement Frame::inside(const Placement& placement) const {
    Placement seen;
    const auto back = [&](const Vec3& v) { return Vec3{dot(axis[0], v), dot(axis[1], v), dot(axis[2], v)}; };
    for (std::size_t k = 0; k < 3; ++k) seen.column[k] = back(placement.column[k]);
    seen.column[3] = back(placement.column[3] - position);
    return seen;
}

Frame frame_of(const Placement& node, const Placement& root) {
    Frame frame;
    frame.position = node.column[3];
    const auto turned = axes_of(node), file = axes_of(root);
    if (!turned || !file) return frame;
    for (int k = 0; k < 3; ++k) {  // turned * transposed file
        frame.axis[std::size_t(k)] = {};
        for (std::size_t c = 0; c < 3; ++c) frame.axis[std::size_t(k)] += (*turned)[c] * (*file)[c][k];
    }
    return frame;
}

Placement placement_of_file(int up, double scale) {
    Placement file;
    if (up == 2) {  // x, y, z -> x, -z, y
        file.column = {Vec3{1, 0, 0}, Vec3{0, 0, 1}, Vec3{0, -1, 0}, Vec3{}};
    } else if (up == 0) {  // x, y, z -> y, -x, z
        file.column = {Vec3{0, -1, 0}, Vec3{1, 0, 0}, Vec3{0, 0, 1}, Vec3{}};
    }
    for (Vec3& column : file.column) column = column * scale;
    return file;
}

std::optional<Placement> placement_of(const tinygltf::Node& node) {
    Placement own;
    if (!node.matrix.empty()) {
        const std::vector<double>& m = node.matrix;  // column by column
        if (m[3] != 0 || m[7] != 0 || m[11] != 0 || m[15] != 1) return std::nullopt;
        for (std::size_t k = 0; k < 4; ++k) own.column[k] = {m[4 * k], m[4 * k + 1], m[4 * k + 2]};
        return own;
    }
    if (!node.rotation.empty()) {
        const std::optional<Placement> turn = rotation(node.rotation);
        if (!turn) return std::nullopt;
        own = *turn;
    }
    if (!node.scale.empty())
        for (std::size_t k = 0; k < 3; ++k) own.column[k] = own.column[k] * node.scale[k];
    if (!node.translation.empty()) own.column[3] = {node.translation[0], node.translation[1], node.translation[2]};
    return own;
}

}  // namespace firma::gltf
