// SPDX-License-Identifier: MIT
// Blasts of `firma carve`: x,y,z,radius,shape,seed, and fx,fy,fz where a file has them.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "firma/cutter.h"

namespace firma::cli {

/// A crater to come: where, how large, and what it is cut with.
struct Blast {
    Vec3 position;
    double radius = 1;  ///< metres; the cutter's scale
    CutterShape shape = CutterShape::kRocky;
    std::uint64_t seed = 0;      ///< of the shape and of its turn
    std::optional<Vec3> from{};  ///< where the shot came from, metres
};

/// Every row: blast k stands on line k + 2.
/// @throws Failure naming file and line for whatever is not four finite numbers (seven, with where the shot came from),
/// the
///         name of a shape and a whole number of 64 bits. Numbers that make no crater (a radius of 0, a place outside
///         the world) are the library's to refuse.
std::vector<Blast> read_blasts(const std::string& path);

/// The cutter of a blast, of mean radius 1, and where it goes.
Cutter cutter_of(const Blast& blast);
Pose pose_of(const Blast& blast);

}  // namespace firma::cli
