// SPDX-License-Identifier: MIT
// Judges a Level that anybody may have made: indices, counts, faces.
#pragma once

#include <optional>
#include <span>
#include <string>

#include "firma/level.h"

namespace firma {

/// What every index of a list must be below. An empty list of names counts as the one name of none.
inline std::size_t name_count(const std::vector<std::string>& names) {
    return names.empty() ? 1 : names.size();
}

/// The first thing that keeps a level from being used: more than a world holds (kTooLarge); a face whose corners,
/// vertices, material, group or texture are not there, or that is not convex and planar, with area and 3 to 64 corners
/// (kInvalid, with the face's source); a texture that is not usable (kInvalid, with its index).
///
/// @param what  of which level, in front of the face in messages: "" or "surfaces, "
std::optional<Error> judge_level(const Level& level, const std::string& name, const std::string& what = "");

/// kInvalid, with its index, for the first projection that is not usable.
std::optional<Error> judge_textures(std::span<const TextureProjection> textures, const std::string& name,
                                    const std::string& what = "");

}  // namespace firma
