// SPDX-License-Identifier: MIT
// Half planes around a line in order of angle, and whether air and solid alternate between them.
// Source: for this order as what makes a space of cells out of polygons, P. Hachenberger, L. Kettner, K. Mehlhorn,
// Boolean Operations on 3D Selective Nef Complexes, 2007.
#pragma once

#include <cstdint>
#include <span>

namespace firma {

/// A half plane that ends at the line: that of a polygon with a side there.
struct Spoke {
    std::uint32_t plane = 0;  ///< what SpokeAngles know it by
    std::uint32_t owner = 0;  ///< whose it is; those of one angle come in order of this
    bool air_before = false;  ///< turning about the line, air lies before it; else solid
    bool air_after = false;
    std::uint8_t part = 0;  ///< of the circle, counted from the first: sort_spokes() sets it
};

/// Exact signs of angles about the line, whatever planes and line are made of.
class SpokeAngles {
public:
    virtual ~SpokeAngles() = default;
    /// Sign of the turn from one half plane to another, the shorter way; 0 where they lie in one plane.
    virtual int turn(std::uint32_t a, std::uint32_t b) const = 0;
    /// Of two in one plane: whether they are the same half of it.
    virtual bool same_half(std::uint32_t a, std::uint32_t b) const = 0;
};

/// Sorts by angle, from the first on. The next of the last is then the first.
/// @return whether between neighbours there is either air or solid, on both sides, and no two are one half plane
bool sort_spokes(std::span<Spoke> spokes, const SpokeAngles& angles);

}  // namespace firma
