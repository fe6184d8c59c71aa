// SPDX-License-Identifier: MIT
// Numbers of a glTF accessor, read where they lie: every offset checked once, nothing copied.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <utility>

#include "firma/result.h"
#include "gltf/gltf_file.h"

namespace firma::gltf {

/// A row of elements in a buffer; all zeros where it has no bytes.
struct ElementRow {
    std::span<const std::byte> bytes;
    std::uint64_t stride = 0;
    int component = 0;  ///< glTF's number of the type
    bool normalized = false;

    double number(std::uint64_t element, int part) const;
    std::uint32_t integer(std::uint64_t element) const;
};

/// Positions or normals, texture coordinates, or indices.
class Accessor {
public:
    std::uint64_t count() const { return count_; }
    /// Of positions and normals: three numbers.
    std::array<double, 3> vector(std::uint64_t element) const;
    /// Of texture coordinates.
    std::array<double, 2> pair(std::uint64_t element) const;
    /// Of indices.
    std::uint32_t index(std::uint64_t element) const;

private:
    friend class Accessors;

    /// Where an element is, sparse ones told apart.
    std::pair<const ElementRow*, std::uint64_t> place_of(std::uint64_t element) const;

    std::uint64_t count_ = 0;
    ElementRow base_;
    std::uint64_t sparse_count_ = 0;
    ElementRow sparse_indices_, sparse_values_;
};

/// Opens accessors of a file, each once.
class Accessors {
public:
    enum class What { kVectors, kPairs, kIndices };

    explicit Accessors(const GltfFile& file) : file_(file) {}

    /// @param place  of what names the accessor, for the message
    /// @return the accessor, which stays where it is; or why it cannot be read
    Result<const Accessor*> open(int index, What what, const std::string& place);

private:
    Result<Accessor> opened(int index, What what, const std::string& place) const;
    Result<ElementRow> row(int view, std::uint64_t offset, std::uint64_t count, int component, int parts,
                           const std::string& place) const;
    std::optional<Error> open_sparse(const tinygltf::Accessor& from, int parts, Accessor& accessor,
                                     const std::string& place) const;

    const GltfFile& file_;
    std::map<std::pair<int, What>, Accessor> open_;
};

}  // namespace firma::gltf
