// SPDX-License-Identifier: MIT
// PNG by libpng.
#include "draw/picture.h"

#include <png.h>

#include <algorithm>
#include <stdexcept>

namespace firma::draw {
namespace {

constexpr int kGap = 12;

}  // namespace

Picture side_by_side(const Picture& left, const Picture& right) {
    Picture both(left.width + kGap + right.width, std::max(left.height, right.height), {255, 255, 255});
    const auto put = [&](const Picture& part, int shift) {
        for (int y = 0; y < part.height; ++y)
            for (int x = 0; x < part.width; ++x) both.at(x + shift, y) = part.at(x, y);
    };
    put(left, 0);
    put(right, left.width + kGap);
    return both;
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
