// SPDX-License-Identifier: MIT
// Pictures made of pixels, and as PNG.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace firma::draw {

using Colour = std::array<std::uint8_t, 3>;

struct Picture {
    int width = 0, height = 0;
    std::vector<Colour> pixels;  ///< rows from the top

    Picture() = default;
    Picture(int wide, int high, Colour colour)
        : width(wide), height(high), pixels(std::size_t(wide) * std::size_t(high), colour) {}
    Colour& at(int x, int y) { return pixels[std::size_t(y) * std::size_t(width) + std::size_t(x)]; }
    const Colour& at(int x, int y) const { return pixels[std::size_t(y) * std::size_t(width) + std::size_t(x)]; }
};

/// Two pictures next to each other on white, with a gap.
Picture side_by_side(const Picture& left, const Picture& right);

/// Pictures of one size in rows of so many, from the top left, on white, with narrow gaps.
/// @param columns  at least 1
Picture film_strip(std::span<const Picture> frames, int columns);

/// The bytes of a PNG, 8 bits a channel.
/// @throws std::runtime_error for a picture that libpng cannot make, as one without pixels
std::string png_bytes(const Picture& picture);

}  // namespace firma::draw
