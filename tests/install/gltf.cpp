// SPDX-License-Identifier: MIT
// A program of a user's that reads glTF: a triangle in the plane z = 0, under a falling particle.
#include <cstdio>
#include <span>
#include <string>

#include "firma/firma.h"
#include "firma/read_gltf.h"

int main() {
    // Positions (0, 0, 0), (4, 0, 0), (0, 4, 0) as little-endian floats; z points up in the file too.
    const std::string file =
        R"({"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
        "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3", "min": [0, 0, 0], "max": [4, 4, 0]}],
        "bufferViews": [{"buffer": 0, "byteLength": 36}],
        "buffers": [{"byteLength": 36,
                     "uri": "data:application/octet-stream;base64,AAAAAAAAAAAAAAAAAACAQAAAAAAAAAAAAAAAAAAAgEAAAAAA"}]})";
    const auto gltf = firma::read_gltf(std::as_bytes(std::span(file)), "triangle.gltf", {.up = 1});
    if (!gltf) return std::puts(gltf.error().text().c_str()), 1;
    const auto world = firma::make_world(gltf.value());
    if (!world) return std::puts(world.error().text().c_str()), 1;
    const firma::Hit hit = firma::cast(world.value(), {.centre = {1, 1, 2}}, {0, 0, -4});
    std::printf("glTF: %zu face, met after %g\n", world.value().face_count(), hit.fraction);
}
