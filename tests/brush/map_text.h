// SPDX-License-Identifier: MIT
// Brushes of .map files as text: boxes, and any planes, in each form.
#pragma once

#include <array>
#include <cstdio>
#include <string>
#include <vector>

#include "firma/vec.h"

namespace firma::map_text {

inline std::string number(double x, const char* format = "%.17g") {
    char text[64];
    std::snprintf(text, sizeof text, format, x);
    return text;
}

inline std::string point(const Vec3& p) {
    return "( " + number(p.x) + " " + number(p.y) + " " + number(p.z) + " ) ";
}

inline std::string world(const std::string& content) {
    return "{\n\"classname\" \"worldspawn\"\n" + content + "}\n";
}

/// Three points of each side of a box in Quake's order: low and high x, y, z.
inline std::array<std::array<Vec3, 3>, 6> box_points(const Vec3& low, const Vec3& high) {
    std::array<std::array<Vec3, 3>, 6> sides;
    for (int axis = 0; axis < 3; ++axis)
        for (const bool top : {false, true}) {
            Vec3 a = low, b, c;
            a[axis] = top ? high[axis] : low[axis];
            b = c = a;
            const int u = (axis + 1) % 3, v = (axis + 2) % 3;
            b[top ? v : u] = high[top ? v : u];
            c[top ? u : v] = high[top ? u : v];
            sides[std::size_t(2 * axis + top)] = {a, b, c};
        }
    return sides;
}

/// A box in the Standard form.
inline std::string box(const Vec3& low, const Vec3& high, const std::string& texture = "wall",
                       const std::string& tail = "0 0 0 1 1") {
    std::string text = "{\n";
    for (const auto& [a, b, c] : box_points(low, high))
        text += point(a) + point(b) + point(c) + texture + " " + tail + "\n";
    return text + "}\n";
}

constexpr const char* kMatrix = "( ( 0.03125 0 0 ) ( 0 0.03125 0 ) ) ";

/// The same as a primitive of Quake 3's.
inline std::string primitive_box(const Vec3& low, const Vec3& high, const std::string& texture = "a/wall",
                                 const std::string& tail = "0 0 0") {
    std::string text = "{\nbrushDef\n{\n";
    for (const auto& [a, b, c] : box_points(low, high))
        text += point(a) + point(b) + point(c) + kMatrix + texture + " " + tail + "\n";
    return text + "}\n}\n";
}

/// What lies outside has normal . p > distance.
struct PlaneText {
    Vec3 normal;
    double distance;
};

/// As in Doom 3's files, written with so many digits.
inline std::string plane_brush(const std::vector<PlaneText>& planes, const std::string& texture = "textures/a/wall",
                               const char* format = "%.17g") {
    std::string text = "{\nbrushDef3\n{\n";
    for (const PlaneText& plane : planes)
        text += "( " + number(plane.normal.x, format) + " " + number(plane.normal.y, format) + " " +
                number(plane.normal.z, format) + " " + number(-plane.distance, format) + " ) " + kMatrix + "\"" +
                texture + "\" 0 0 0\n";
    return text + "}\n}\n";
}

inline std::vector<PlaneText> box_planes(const Vec3& low, const Vec3& high) {
    return {{{-1, 0, 0}, -low.x}, {{1, 0, 0}, high.x},  {{0, -1, 0}, -low.y},
            {{0, 1, 0}, high.y},  {{0, 0, -1}, -low.z}, {{0, 0, 1}, high.z}};
}

}  // namespace firma::map_text
