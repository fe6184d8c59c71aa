// SPDX-License-Identifier: MIT
// Bounds on rounding: what follows from the size of operands and the number of operations, never a physical distance.
// Source: N. Higham, Accuracy and Stability of Numerical Algorithms, 2002, section 3.1.
#pragma once

namespace firma {

/// Half an ulp of 1 in double: each operation's result is off by at most this factor.
inline constexpr double kRoundoff = 0x1p-53;

/// Bound on the relative error of n operations in a row, with room for the second order.
constexpr double rounding(int operations) {
    return operations * kRoundoff * (1 + 0x1p-40);
}

/// The same for double-double arithmetic, whose operations are off by a few units in the 104th bit.
inline constexpr double kDoubleDoubleRoundoff = 0x1p-100;

/// Numbers of a cast beyond this are refused: products of five of them could overflow.
inline constexpr double kLargestNumber = 0x1p+200;

/// A path without a coordinate of this size counts as none, in metres.
inline constexpr double kShortestPath = 0x1p-1000;

/// Parts of numbers below this count as zero in a cast, so that exact products of three never underflow.
inline constexpr double kSmallestNumber = 0x1p-250;

}  // namespace firma
