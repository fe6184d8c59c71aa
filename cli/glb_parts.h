// SPDX-License-Identifier: MIT
// What a world becomes in a .glb: its faces sorted into parts of one material each, counted before memory is taken.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

#include "firma/world.h"
#include "solid/block.h"
#include "world/world_data.h"

namespace firma::cli {

/// Faces of one material of the file: of the level or of cuts, seen from one side or both.
struct GlbPart {
    std::string name;  ///< UTF-8; of what cuts left, with " (cut)" behind
    bool cut = false;
    bool two_sided = false;
    std::uint64_t faces = 0, corners = 0;

    /// Of a fan in each face.
    std::uint64_t triangles() const { return corners - 2 * faces; }
    /// Of positions as of normals: three floats a corner.
    std::uint64_t vertex_bytes() const { return 12 * corners; }
    std::uint64_t index_bytes() const { return 12 * triangles(); }
};

/// The parts of a world, and which one a face belongs to.
class GlbParts {
public:
    explicit GlbParts(const World& world);

    /// In order of the world's materials, those of the level first; none is without faces.
    const std::vector<GlbPart>& list() const& { return list_; }
    const std::vector<GlbPart>& list() const&& = delete;  // of what is gone after the line
    std::size_t part_of(const FaceRecord& face) const { return index_.at(key(face)); }
    /// Of the whole buffer.
    std::uint64_t buffer_bytes() const;
    /// Of a .glb of these parts, at most.
    std::uint64_t file_bytes() const;

private:
    using Key = std::tuple<std::uint32_t, bool, bool>;
    static Key key(const FaceRecord& face) { return {face.material, face.edit != 0, face.two_sided}; }

    std::vector<GlbPart> list_;
    std::map<Key, std::size_t> index_;
};

/// A .glb says its length in 32 bits.
inline constexpr std::uint64_t kLargestGlb = 0xFFFFFFFF;

/// @throws Failure naming the file, when a .glb cannot hold so many bytes
void judge_glb_size(std::uint64_t bytes, const std::string& path);

/// A material's name in UTF-8: each byte that is not, and zero, which would end the name, becomes U+FFFD.
std::string glb_name(std::string_view name);

/// A colour for a name, the same everywhere: red, green, blue, linear. Grey for "".
std::array<double, 3> colour_of(std::string_view name);

/// Calls function(block, record) for each face, block by block.
template <class Function>
void for_each_record(const World& world, const Function& function) {
    for_each_block_of(world.data(), [&](const Block& block) {
        for (const FaceRecord& record : block.faces) function(block, record);
    });
}

}  // namespace firma::cli
