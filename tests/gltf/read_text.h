// SPDX-License-Identifier: MIT
// Reads glTF from a string, in tests.
#pragma once

#include <gtest/gtest.h>

#include <string>

#include "firma/read_gltf.h"
#include "firma/solid.h"
#include "firma/world.h"

namespace firma::gltf {

inline Result<GltfLevel> read(const std::string& file, const GltfOptions& options = {}) {
    return read_gltf(std::as_bytes(std::span(file)), "a.glb", options);
}

inline GltfLevel read_good(const std::string& file, const GltfOptions& options = {}) {
    Result<GltfLevel> level = read(file, options);
    EXPECT_TRUE(level) << (level ? "" : level.error().text());
    return level ? std::move(level).value() : GltfLevel{};
}

inline std::string error_of(const std::string& file, const GltfOptions& options = {}) {
    const Result<GltfLevel> level = read(file, options);
    return level ? "none" : level.error().text();
}

/// Cubic metres of what the level's faces close in; NAN where not all of them bound a solid.
inline double volume_of(const GltfLevel& gltf) {
    if (level_solidity(gltf.level).solid_faces != gltf.level.faces.size()) return NAN;
    const Result<World> world = make_world(gltf.level);
    return world ? measure_solid(world.value()).volume : NAN;
}

inline Box bounds_of(const GltfLevel& gltf) {
    Box box;
    for (const std::uint32_t vertex : gltf.level.corners) box.add(to_metres(gltf.level.vertices[vertex]));
    return box;
}

inline std::string replaced(std::string text, const std::string& from, const std::string& to) {
    const std::size_t at = text.find(from);
    EXPECT_NE(at, text.npos) << from;
    return at == text.npos ? text : text.replace(at, from.size(), to);
}

}  // namespace firma::gltf
