// SPDX-License-Identifier: MIT
// Numbers of a glTF accessor.
// Source: Khronos Group, glTF 2.0 Specification, 2021, sections 3.6.2 and 5.1 to 5.11.
#include "gltf/accessor.h"

#include <algorithm>
#include <bit>
#include <cstring>

namespace firma::gltf {
namespace {

static_assert(std::endian::native == std::endian::little, "glTF's buffers are little-endian: swap bytes in read_as()");

/// 0 for types that glTF 2.0 does not have.
std::uint64_t size_of(int component) {
    switch (component) {
        case TINYGLTF_COMPONENT_TYPE_BYTE:
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
            return 1;
        case TINYGLTF_COMPONENT_TYPE_SHORT:
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
            return 2;
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
        case TINYGLTF_COMPONENT_TYPE_FLOAT:
            return 4;
        default:
            return 0;
    }
}

bool holds_indices(int component) {
    return component == TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE || component == TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT ||
           component == TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT;
}

template <class T>
T read_as(const std::byte* from) {
    T value;
    std::memcpy(&value, from, sizeof value);
    return value;
}

std::string text(std::uint64_t number) {
    return std::to_string(number);
}

}  // namespace

double ElementRow::number(std::uint64_t element, int part) const {
    if (bytes.empty()) return 0;
    const std::byte* from = bytes.data() + element * stride + std::uint64_t(part) * size_of(component);
    switch (component) {
        case TINYGLTF_COMPONENT_TYPE_BYTE: {
            const double value = read_as<std::int8_t>(from);
            return normalized ? std::max(value / 127, -1.0) : value;
        }
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE: {
            const double value = read_as<std::uint8_t>(from);
            return normalized ? value / 255 : value;
        }
        case TINYGLTF_COMPONENT_TYPE_SHORT: {
            const double value = read_as<std::int16_t>(from);
            return normalized ? std::max(value / 32767, -1.0) : value;
        }
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT: {
            const double value = read_as<std::uint16_t>(from);
            return normalized ? value / 65535 : value;
        }
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
            return read_as<std::uint32_t>(from);
        default:
            return double(read_as<float>(from));
    }
}

std::uint32_t ElementRow::integer(std::uint64_t element) const {
    if (bytes.empty()) return 0;
    const std::byte* from = bytes.data() + element * stride;
    if (component == TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE) return read_as<std::uint8_t>(from);
    if (component == TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT) return read_as<std::uint16_t>(from);
    return read_as<std::uint32_t>(from);
}

std::pair<const ElementRow*, std::uint64_t> Accessor::place_of(std::uint64_t element) const {
    std::uint64_t low = 0, high = sparse_count_;
    while (low < high) {
        const std::uint64_t middle = low + (high - low) / 2;
        if (sparse_indices_.integer(middle) < element) {
            low = middle + 1;
        } else {
            high = middle;
        }
    }
    if (low < sparse_count_ && sparse_indices_.integer(low) == element) return {&sparse_values_, low};
    return {&base_, element};
}

std::array<double, 3> Accessor::vector(std::uint64_t element) const {
    const auto [row, at] = place_of(element);
    return {row->number(at, 0), row->number(at, 1), row->number(at, 2)};
}

std::array<double, 2> Accessor::pair(std::uint64_t element) const {
    const auto [row, at] = place_of(element);
    return {row->number(at, 0), row->number(at, 1)};
}

std::uint32_t Accessor::index(std::uint64_t element) const {
    const auto [row, at] = place_of(element);
    return row->integer(at);
}

Result<const Accessor*> Accessors::open(int index, What what, const std::string& place) {
    const std::pair key{index, what};
    if (const auto known = open_.find(key); known != open_.end()) return &known->second;
    Result<Accessor> accessor = opened(index, what, place + ", accessor " + std::to_string(index));
    if (!accessor) return accessor.error();
    return &open_.emplace(key, std::move(accessor).value()).first->second;
}

Result<Accessor> Accessors::opened(int index, What what, const std::string& place) const {
    const auto fail = [&](std::string reason) { return Error{ErrorCode::kMalformed, place, std::move(reason)}; };
    const auto& list = file_.model.accessors;
    if (std::size_t(index) >= list.size()) return fail("is not there; there are " + text(list.size()));
    const tinygltf::Accessor& from = list[std::size_t(index)];
    const bool indices = what == What::kIndices;
    const int type = indices ? TINYGLTF_TYPE_SCALAR : what == What::kPairs ? TINYGLTF_TYPE_VEC2 : TINYGLTF_TYPE_VEC3;
    if (from.type != type)
        return fail(std::string("is not of type ") + (indices ? "SCALAR" : what == What::kPairs ? "VEC2" : "VEC3"));
    if (!(indices ? holds_indices(from.componentType) : size_of(from.componentType) > 0))
        return fail("is of component type " + std::to_string(from.componentType) +
                    (indices ? ", which indices cannot have" : ", which glTF does not have"));
    if (from.count >= (std::uint64_t(1) << 32)) return fail("has " + text(from.count) + " elements; 2^32 are too many");
    Accessor accessor;
    accessor.count_ = from.count;
    const int parts = indices ? 1 : what == What::kPairs ? 2 : 3;
    if (from.bufferView >= 0) {
        Result<ElementRow> base = row(from.bufferView, from.byteOffset, from.count, from.componentType, parts, place);
        if (!base) return base.error();
        accessor.base_ = std::move(base).value();
        accessor.base_.normalized = from.normalized;
    }
    if (from.sparse.isSparse)
        if (std::optional<Error> error = open_sparse(from, parts, accessor, place)) return *error;
    return accessor;
}

/// Offsets are below 2^54, strides below 2^8: no sum or product here exceeds 64 bits.
Result<ElementRow> Accessors::row(int view, std::uint64_t offset, std::uint64_t count, int component, int parts,
                                  const std::string& place) const {
    const std::string at = place + ", buffer view " + std::to_string(view);
    const auto fail = [&](std::string reason) { return Error{ErrorCode::kMalformed, at, std::move(reason)}; };
    const auto& views = file_.model.bufferViews;
    if (std::size_t(view) >= views.size()) return fail("is not there; there are " + text(views.size()));
    const tinygltf::BufferView& from = views[std::size_t(view)];
    const auto& buffers = file_.buffers.list();
    if (std::size_t(from.buffer) >= buffers.size())
        return fail("names buffer " + std::to_string(from.buffer) + " of " + text(buffers.size()));
    const std::span<const std::byte> buffer = buffers[std::size_t(from.buffer)];
    if (from.byteOffset + from.byteLength > buffer.size())
        return fail("ends at byte " + text(from.byteOffset + from.byteLength) + " of a buffer of " +
                    text(buffer.size()));
    const std::uint64_t element = size_of(component) * std::uint64_t(parts);
    const std::uint64_t stride = from.byteStride == 0 ? element : from.byteStride;
    if (stride < element) return fail("has a stride of " + text(stride) + " bytes for elements of " + text(element));
    ElementRow row;
    row.component = component;
    row.stride = stride;
    if (count == 0) return row;
    const std::uint64_t end = offset + stride * (count - 1) + element;
    if (end > from.byteLength)
        return fail("has " + text(from.byteLength) + " bytes, and " + text(end) + " would be needed");
    row.bytes = buffer.subspan(std::size_t(from.byteOffset + offset), std::size_t(end - offset));
    return row;
}

std::optional<Error> Accessors::open_sparse(const tinygltf::Accessor& from, int parts, Accessor& accessor,
                                            const std::string& place) const {
    const auto fail = [&](std::string reason) { return Error{ErrorCode::kMalformed, place, std::move(reason)}; };
    const auto& sparse = from.sparse;
    if (!holds_indices(sparse.indices.componentType))
        return fail("has sparse indices of component type " + std::to_string(sparse.indices.componentType));
    const std::uint64_t count = std::uint64_t(sparse.count);
    Result<ElementRow> indices = row(sparse.indices.bufferView, std::uint64_t(sparse.indices.byteOffset), count,
                                     sparse.indices.componentType, 1, place + " sparse indices");
    if (!indices) return indices.error();
    Result<ElementRow> values = row(sparse.values.bufferView, std::uint64_t(sparse.values.byteOffset), count,
                                    from.componentType, parts, place + " sparse values");
    if (!values) return values.error();
    accessor.sparse_count_ = count;
    accessor.sparse_indices_ = std::move(indices).value();
    accessor.sparse_values_ = std::move(values).value();
    accessor.sparse_values_.normalized = from.normalized;
    for (std::uint64_t k = 0; k < count; ++k) {
        const std::uint64_t element = accessor.sparse_indices_.integer(k);
        if (element >= from.count) return fail("replaces element " + text(element) + " of " + text(from.count));
        if (k > 0 && element <= accessor.sparse_indices_.integer(k - 1))
            return fail("has sparse indices that do not increase");
    }
    return std::nullopt;
}

}  // namespace firma::gltf
