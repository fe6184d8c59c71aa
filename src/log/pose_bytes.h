// SPDX-License-Identifier: MIT
// Poses as bytes: few for those on the grids of quantised(), whole ones bit by bit.
#pragma once

#include <optional>

#include "firma/cutter.h"
#include "log/byte_reader.h"

namespace firma {

/// Where a pose's three parts lie, to be kept in 4 bits: the first two say which turn.
struct PoseForm {
    enum class Turn : std::uint8_t { kNone, kOfSeed, kSixteenBits, kWhole };
    Turn turn = Turn::kNone;
    bool whole_position = false, whole_scale = false;

    std::uint8_t bits() const {
        return std::uint8_t(std::uint8_t(turn) | std::uint8_t(whole_position) << 2 | std::uint8_t(whole_scale) << 3);
    }
    static PoseForm of_bits(unsigned bits) { return {Turn(bits & 3), (bits & 4) != 0, (bits & 8) != 0}; }
};

/// The shortest form that gives the pose back, bit by bit.
/// @param seed  of a crater, whose turn takes no bytes
PoseForm form_of(const Pose& pose, std::optional<std::uint64_t> seed);

void put_pose(ByteWriter& out, const Pose& pose, const PoseForm& form);
/// @return what was taken; check the reader before using it
Pose take_pose(ByteReader& in, const PoseForm& form, std::optional<std::uint64_t> seed);

}  // namespace firma
