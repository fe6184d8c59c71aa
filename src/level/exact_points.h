// SPDX-License-Identifier: MIT
// Exact positions as whole numbers, all multiplied by one power of their base: signs and zeros of polynomials in their
// differences are those of the positions.
#pragma once

#include <boost/multiprecision/cpp_int.hpp>

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "level/check_mesh_core.h"

namespace firma {

__extension__ using Int128 = __int128;
using BoostInt256 = boost::multiprecision::number<
    boost::multiprecision::cpp_int_backend<256, 256, boost::multiprecision::signed_magnitude,
                                           boost::multiprecision::unchecked, void>,
    boost::multiprecision::et_off>;
using BigInt = boost::multiprecision::number<boost::multiprecision::cpp_int_backend<>, boost::multiprecision::et_off>;

using SmallPoint = std::array<std::int64_t, 3>;
using BigPoint = std::array<BigInt, 3>;

/// Takes vertices of a mesh to whole numbers below 2^61, either way.
/// @return false when they do not fit
bool to_small_points(const ExactMesh& mesh, std::span<const std::uint32_t> vertices, std::vector<SmallPoint>& points);

/// The same, whatever their size.
void to_big_points(const ExactMesh& mesh, std::span<const std::uint32_t> vertices, std::vector<BigPoint>& points);

/// Bits of the largest magnitude.
int bits_of(std::span<const SmallPoint> points);

}  // namespace firma
