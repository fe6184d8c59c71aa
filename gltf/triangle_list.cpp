// SPDX-License-Identifier: MIT
// The triangles of a primitive.
// Source: Khronos Group, glTF 2.0 Specification, 2021, section 3.7.2.1.
#include "gltf/triangle_list.h"

#include "level/divide_polygon.h"

namespace firma::gltf {

Result<TriangleList> TriangleList::open(const tinygltf::Primitive& primitive, Accessors& accessors,
                                        const std::string& place) {
    const auto fail = [&](std::string reason) { return Error{ErrorCode::kMalformed, place, std::move(reason)}; };
    TriangleList list;
    list.place_ = place;
    list.mode_ = primitive.mode;
    if (list.mode_ > TINYGLTF_MODE_TRIANGLE_FAN)
        return fail("is drawn in mode " + std::to_string(list.mode_) + ", which glTF does not have");
    const auto position = primitive.attributes.find("POSITION");
    if (list.mode_ < TINYGLTF_MODE_TRIANGLES || position == primitive.attributes.end()) return list;

    const Result<const Accessor*> positions = accessors.open(position->second, Accessors::What::kVectors, place);
    if (!positions) return positions.error();
    list.positions_ = positions.value();
    if (const auto normal = primitive.attributes.find("NORMAL"); normal != primitive.attributes.end()) {
        const Result<const Accessor*> normals = accessors.open(normal->second, Accessors::What::kVectors, place);
        if (!normals) return normals.error();
        list.normals_ = normals.value();
        if (list.normals_->count() != list.positions_->count())
            return fail("has " + std::to_string(list.positions_->count()) + " positions and " +
                        std::to_string(list.normals_->count()) + " normals");
    }
    if (const auto uv = primitive.attributes.find("TEXCOORD_0"); uv != primitive.attributes.end()) {
        const Result<const Accessor*> uvs = accessors.open(uv->second, Accessors::What::kPairs, place);
        list.broken_uvs_ = !uvs || uvs.value()->count() != list.positions_->count();
        if (!list.broken_uvs_) list.uvs_ = uvs.value();
    }
    if (primitive.indices >= 0) {
        const Result<const Accessor*> indices = accessors.open(primitive.indices, Accessors::What::kIndices, place);
        if (!indices) return indices.error();
        list.indices_ = indices.value();
    }
    const std::uint64_t corners = list.indices_ ? list.indices_->count() : list.positions_->count();
    if (list.mode_ == TINYGLTF_MODE_TRIANGLES) {
        if (corners % 3 != 0) return fail("has " + std::to_string(corners) + " corners, no multiple of three");
        list.size_ = corners / 3;
    } else {
        list.size_ = corners < 3 ? 0 : corners - 2;
    }
    return list;
}

Result<TriangleList::Triangle> TriangleList::at(std::uint64_t triangle) const {
    const std::uint64_t k = triangle;
    std::array<std::uint64_t, 3> corners{3 * k, 3 * k + 1, 3 * k + 2};
    if (mode_ == TINYGLTF_MODE_TRIANGLE_STRIP) corners = {k, k + 1 + k % 2, k + 2 - k % 2};
    if (mode_ == TINYGLTF_MODE_TRIANGLE_FAN) corners = {0, k + 1, k + 2};
    Triangle vertices{};
    for (std::size_t c = 0; c < 3; ++c) {
        vertices[c] = indices_ ? indices_->index(corners[c]) : std::uint32_t(corners[c]);
        if (vertices[c] >= positions_->count())
            return Error{ErrorCode::kMalformed, place_ + ", index " + std::to_string(corners[c]),
                         "names vertex " + std::to_string(vertices[c]) + " of " + std::to_string(positions_->count())};
    }
    return vertices;
}

bool TriangleList::have_one_normal(std::span<const std::uint32_t> vertices) const {
    for (const std::uint32_t vertex : vertices)
        if (normals_->vector(vertex) != normals_->vector(vertices[0])) return false;
    return true;
}

Result<std::vector<std::uint32_t>> TriangleList::fan_from(std::uint64_t first) const {
    const Result<Triangle> start = at(first);
    if (!start) return start.error();
    std::vector<std::uint32_t> outline(start.value().begin(), start.value().end());
    if (!normals_ || !have_one_normal(outline)) return outline;
    for (std::uint64_t k = first + 1; k < size_ && outline.size() < kMaxOutlineCorners; ++k) {
        const Result<Triangle> next = at(k);
        if (!next) return next.error();
        const auto [a, b, c] = next.value();
        const bool goes_on = a == outline[0] && b == outline.back() && c != outline[1];
        if (!goes_on || !have_one_normal(std::array{a, c})) break;
        outline.push_back(c);
    }
    return outline;
}

}  // namespace firma::gltf
