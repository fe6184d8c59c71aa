// SPDX-License-Identifier: MIT
// Pictures beside each other, and as PNG: libpng reads again what was written.
#include <gtest/gtest.h>
#include <png.h>

#include <stdexcept>
#include <string>

#include "draw/picture.h"
#include "scenes/rng.h"

namespace firma::draw {
namespace {

Picture read_png(const std::string& bytes) {
    png_image image{};
    image.version = PNG_IMAGE_VERSION;
    if (!png_image_begin_read_from_memory(&image, bytes.data(), bytes.size())) return {};
    EXPECT_EQ(image.format, png_uint_32(PNG_FORMAT_RGB));
    Picture picture(int(image.width), int(image.height), {});
    EXPECT_TRUE(png_image_finish_read(&image, nullptr, picture.pixels.data(), 0, nullptr)) << image.message;
    return picture;
}

TEST(Picture, SideBySide) {
    const Picture both = side_by_side(Picture(3, 2, {1, 2, 3}), Picture(5, 4, {7, 8, 9}));
    EXPECT_EQ(both.height, 4);
    EXPECT_GT(both.width, 8);
    EXPECT_EQ(both.at(2, 1), (Colour{1, 2, 3}));
    EXPECT_EQ(both.at(2, 2), (Colour{255, 255, 255}));
    EXPECT_EQ(both.at(3, 0), (Colour{255, 255, 255}));
    EXPECT_EQ(both.at(both.width - 1, 3), (Colour{7, 8, 9}));
}

TEST(Picture, FilmStrip) {
    const Picture frames[] = {Picture(3, 2, {1, 1, 1}), Picture(3, 2, {2, 2, 2}), Picture(3, 2, {3, 3, 3})};
    const Picture strip = film_strip(frames, 2);
    EXPECT_EQ(strip.at(0, 0)[0], 1);
    EXPECT_EQ(strip.at(strip.width - 1, 1)[0], 2);
    EXPECT_EQ(strip.at(0, strip.height - 1)[0], 3);
    EXPECT_EQ(strip.at(strip.width - 1, strip.height - 1)[0], 255);
    EXPECT_EQ(strip.at(3, 0)[0], 255);
    const Picture one = film_strip(std::span(frames, 1), 3);
    EXPECT_EQ(one.pixels, frames[0].pixels);
    EXPECT_EQ(film_strip({}, 3).width, 0);
}

TEST(Picture, FlatColoursMakeSmallFiles) {
    const std::string bytes = png_bytes(Picture(640, 480, {10, 200, 30}));
    EXPECT_TRUE(bytes.starts_with("\x89PNG\r\n\x1a\n"));
    EXPECT_LT(bytes.size(), 640u * 480u * 3u / 100u);
    EXPECT_NE(bytes, png_bytes(Picture(640, 480, {10, 200, 31})));
}

TEST(Picture, APngHoldsEveryPixel) {
    scenes::Rng rng(1);
    for (const auto& [width, height] : {std::pair(1, 1), std::pair(7, 3), std::pair(640, 480)}) {
        Picture picture(width, height, {});
        for (Colour& colour : picture.pixels)
            for (std::uint8_t& part : colour) part = std::uint8_t(rng.below(256));
        const Picture again = read_png(png_bytes(picture));
        EXPECT_EQ(again.width, width);
        EXPECT_EQ(again.height, height);
        EXPECT_EQ(again.pixels, picture.pixels);
    }
}

TEST(Picture, OneWithoutPixelsIsNoPng) {
    EXPECT_THROW(png_bytes(Picture()), std::runtime_error);
}

}  // namespace
}  // namespace firma::draw
