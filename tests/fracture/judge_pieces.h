// SPDX-License-Identifier: MIT
// Whether pieces are the whole: exactly, none over another, volumes added up.
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "firma/fracture.h"

namespace firma::test {

/// Each is sound and one body; their volumes come to that of the whole but for the rounding of each.
inline void expect_volumes(const Solid& whole, const Fracture& broken) {
    const double volume = measure_solid(whole).volume;
    double sum = 0;
    for (const FracturePiece& piece : broken.pieces) {
        const std::optional<SolidFault> fault = check_solid(piece.solid);
        EXPECT_FALSE(fault) << fault->what;
        EXPECT_EQ(connected_pieces(piece.solid).size(), 1u);
        EXPECT_GT(piece.mass.volume, 0);
        EXPECT_EQ(piece.mass.volume, mass_properties(piece.solid, 1).volume);
        sum += piece.mass.volume;
    }
    EXPECT_NEAR(sum, volume, double(broken.pieces.size()) * 0x1p-51 * volume);
}

/// All of them united are the same set of points as the whole, and none takes anything of another: in exact arithmetic.
inline void expect_whole(const Solid& whole, const Fracture& broken) {
    expect_volumes(whole, broken);
    Solid united;
    for (const FracturePiece& piece : broken.pieces) {
        const Cutter cutter = cutter_from_solid(piece.solid).value();
        // What is there already would not be filled again: this one is all air.
        if (united.face_count() > 0) {
            const SolidResult taken = subtract(united, cutter, {});
            EXPECT_EQ(taken.status, CarveStatus::kNothing) << taken.error.reason;
        }
        const SolidResult more = unite(united, cutter, {});
        ASSERT_TRUE(more.done()) << more.error.reason;
        united = more.solid;
    }
    EXPECT_TRUE(same_solid(united, whole));
    EXPECT_EQ(hash_solid(united), hash_solid(whole));
}

}  // namespace firma::test
