// SPDX-License-Identifier: MIT
// The triangles of a primitive, whatever mode they are drawn in, and the faces they were fanned from.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "firma/result.h"
#include "gltf/accessor.h"

namespace firma::gltf {

/// A primitive's triangles: numbered corners of its accessors.
class TriangleList {
public:
    using Triangle = std::array<std::uint32_t, 3>;

    /// @param place  "file: mesh 3, primitive 0"
    /// @return nothing's triangles for points, lines, and what has no positions
    static Result<TriangleList> open(const tinygltf::Primitive& primitive, Accessors& accessors,
                                     const std::string& place);

    bool is_drawn() const { return positions_ != nullptr; }
    std::uint64_t size() const { return size_; }
    /// Vertices, counter-clockwise seen from the front.
    /// @return kMalformed for an index that names no vertex
    Result<Triangle> at(std::uint64_t triangle) const;
    std::array<double, 3> position(std::uint32_t vertex) const { return positions_->vector(vertex); }
    /// Texture coordinates, in repeats, v down; where they are.
    bool has_uvs() const { return uvs_ != nullptr; }
    std::array<double, 2> uv(std::uint32_t vertex) const { return uvs_->pair(vertex); }
    /// Whether the file has some that cannot be read: then they are as if they were not there.
    bool has_broken_uvs() const { return broken_uvs_; }

    /// The outline of the face that the file has in triangles from `first` on, in a fan from its first corner with
    /// one normal at all corners, as write_glb() and others write polygons: always at least a triangle.
    /// @return that, or an error as at()'s
    Result<std::vector<std::uint32_t>> fan_from(std::uint64_t first) const;

private:
    bool have_one_normal(std::span<const std::uint32_t> vertices) const;

    std::string place_;
    int mode_ = TINYGLTF_MODE_TRIANGLES;
    const Accessor* positions_ = nullptr;
    const Accessor* normals_ = nullptr;
    const Accessor* uvs_ = nullptr;
    const Accessor* indices_ = nullptr;
    bool broken_uvs_ = false;
    std::uint64_t size_ = 0;
};

}  // namespace firma::gltf
