// SPDX-License-Identifier: MIT
// Where a node stands: affine maps from its own coordinates to the level's.
#pragma once

#include <tiny_gltf.h>

#include <array>
#include <optional>

#include "firma/vec.h"

namespace firma::gltf {

/// column[0] x + column[1] y + column[2] z + column[3].
struct Placement {
    std::array<Vec3, 4> column{Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}, Vec3{0, 0, 0}};

    Vec3 of(const std::array<double, 3>& p) const {
        return column[0] * p[0] + column[1] * p[1] + column[2] * p[2] + column[3];
    }
    Vec3 turned(const Vec3& v) const { return column[0] * v.x + column[1] * v.y + column[2] * v.z; }
    /// Whether it makes left hands of right ones.
    bool mirrors() const { return dot(cross(column[0], column[1]), column[2]) < 0; }
};

/// A turn and a place: what is rigid of a placement.
struct Frame {
    std::array<Vec3, 3> axis{Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}};  ///< unit, right-handed
    Vec3 position;

    std::array<double, 4> rotation() const;  ///< as a Quaternion (turn.h)
    /// What is placed, as seen from the frame.
    Placement inside(const Placement& placement) const;
};

/// Of a part: where its node stands, turned as that is, less the turn of the file's axes. Scales and mirrors are left
/// to what is inside. A placement that flattens all to a plane or less has the file's turn.
Frame frame_of(const Placement& node, const Placement& root);

/// First `inner`, then `outer`.
Placement operator*(const Placement& outer, const Placement& inner);

/// From glTF's axes to those of a level in which `up` is where y was: a turn to other axes, exactly, and a scale.
Placement placement_of_file(int up, double scale);

/// A node's own.
/// @return nothing for a matrix that is not affine, or a rotation that is no direction
std::optional<Placement> placement_of(const tinygltf::Node& node);

}  // namespace firma::gltf
