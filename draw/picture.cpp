// SPDX-License-Identifier: MIT
// PNG by libpng.
#include "draw/picture.h"

#include <png.h>

#include <algorithm>
#include <stdexcept>

namespace firma::draw {
namespace {

constexpr int kGap = 12;
constexpr int kStripGap = 4;

void put_into(Picture& whole, const Picture& part, int left, int top) {
    for (int y = 0; y < part.height; ++y)
        for (int x = 0; x < part.width; ++x) whole.at(left + x, top + y) = part.at(x, y);
}

}  // namespace

Picture side_by_side(const Picture& left, const Picture& right) {
    Picture both(left.width + kGap + right.width, std::max(left.height, right.height), {255, 255, 255});
    put_into(both, left, 0, 0);
    put_into(both, right, left.width + kGap, 0);
    return both;
}

Picture film_strip(std::span<const Picture> frames, int columns) {
    if (frames.empty()) return {};
    const int count = int(frames.size()), across = std::min(columns, count), down = (count + columns - 1) / columns;
    const int width = frames[0].width + kStripGap, height = frames[0].height + kStripGap;
    Picture strip(across * width - kStripGap, down * height - kStripGap, {255, 255, 255});
    for (int k = 0; k < count; ++k) put_into(strip, frames[std::size_t(k)], k % columns * width, k / columns * height);
    return strip;
}

std::string png_bytes(const Picture& picture) {
    png_image image{};
    image.version = PNG_IMAGE_VERSION;
    image.width = png_uint_32(picture.width);
    image.height = png_uint_32(picture.height);
    image.format = PNG_FORMAT_RGB;
    std::string bytes(PNG_IMAGE_PNG_SIZE_MAX(image), 0);
    png_alloc_size_t size = bytes.size();
    if (!png_image_write_to_memory(&image, bytes.data(), &size, 0, picture.pixels.data(), 0, nullptr))
        throw std::runtime_error(std::string("libpng: ") + image.message);
    bytes.resize(size);
    return bytes;
}

}  // namespace firma::draw
