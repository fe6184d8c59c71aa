// SPDX-License-Identifier: MIT
// How each matter breaks, and what its cracks look like.
#include <string_view>

#include "firma/chunk.h"
#include "firma/fracture.h"
#include "firma/world.h"
#include "world/world_data.h"

namespace firma {

FracturePattern fracture_pattern(const Matter& matter) {
    FracturePattern pattern;
    const std::string_view name = matter.name;
    if (matter.fracture == FractureStyle::kPane) {
        pattern.style = CrackStyle::kShards;
        pattern.size = {0.12, 0.08, 1};
        pattern.growth = 2;
        pattern.crooked = 0.6;
    } else if (matter.fracture == FractureStyle::kSplinters) {
        pattern.size = {0.8, 0.08, 0.06};
        pattern.crooked = 0.4;
    } else if (matter.fracture == FractureStyle::kBends) {
        pattern.size = {1, 0.6, 0.6};
        pattern.crooked = 0.3;
    } else if (name == "brick") {
        pattern.style = CrackStyle::kBricks;
        pattern.size = {0.25, 0.125, 0.0625};
        pattern.growth = 4;
        pattern.crooked = 0;
    } else if (name == "concrete") {
        // Slabs up to three quarters of a metre keep their thickness.
        pattern.size = {0.6, 0.6, 0.5};
        pattern.crooked = 0.6;
    }
    return pattern;
}

std::uint32_t main_matter(const Chunk& chunk) {
    MatterVolume most;
    for (const MatterVolume& share : chunk.matters)
        if (share.volume > most.volume) most = share;
    return most.matter;
}

std::optional<std::uint32_t> crack_material(const World& world, std::uint32_t index) {
    const std::vector<std::string>* names = world.data().materials.get();
    if (!names) return std::nullopt;
    const std::string& inside = matter(world, index).inside;
    for (std::size_t k = 0; k < names->size(); ++k)
        if ((*names)[k] == inside) return std::uint32_t(k);
    return std::nullopt;
}

}  // namespace firma
