// SPDX-License-Identifier: MIT
// Makes small glTF files by hand: accessors from numbers, everything else as JSON text.
#pragma once

#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <vector>

namespace firma::gltf {

inline std::string base64(std::string_view bytes) {
    constexpr char kLetters[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    for (std::size_t k = 0; k < bytes.size(); k += 3) {
        std::uint32_t bits = 0;
        for (std::size_t c = 0; c < 3; ++c)
            bits = bits << 8 | (k + c < bytes.size() ? static_cast<unsigned char>(bytes[k + c]) : 0u);
        for (std::size_t c = 0; c < 4; ++c) text += k + c > bytes.size() ? '=' : kLetters[bits >> (18 - 6 * c) & 63];
    }
    return text;
}

inline std::string u32_bytes(std::uint32_t number) {
    std::string bytes(4, '\0');
    std::memcpy(bytes.data(), &number, 4);
    return bytes;
}

template <class T>
std::string bytes_of(const std::vector<T>& values) {
    std::string bytes(values.size() * sizeof(T), '\0');
    if (!values.empty()) std::memcpy(bytes.data(), values.data(), bytes.size());
    return bytes;
}

template <class T>
inline constexpr int kComponent = 5126;
template <>
inline constexpr int kComponent<std::int8_t> = 5120;
template <>
inline constexpr int kComponent<std::uint8_t> = 5121;
template <>
inline constexpr int kComponent<std::int16_t> = 5122;
template <>
inline constexpr int kComponent<std::uint16_t> = 5123;
template <>
inline constexpr int kComponent<std::uint32_t> = 5125;

class SmallGltf {
public:
    /// Adds bytes as a buffer view; returns its index.
    int view(const std::string& bytes, const std::string& extra = "") {
        views_.push_back(R"({"buffer":0,"byteOffset":)" + std::to_string(buffer_.size()) + R"(,"byteLength":)" +
                         std::to_string(bytes.size()) + extra + "}");
        buffer_ += bytes;
        buffer_.resize((buffer_.size() + 3) / 4 * 4);
        return int(views_.size()) - 1;
    }
    /// Adds an accessor as JSON; returns its index.
    int accessor(const std::string& json) {
        accessors_.push_back(json);
        return int(accessors_.size()) - 1;
    }
    template <class T>
    int vectors(const std::vector<T>& values, const std::string& extra = "") {
        return accessor(R"({"bufferView":)" + std::to_string(view(bytes_of(values))) + R"(,"componentType":)" +
                        std::to_string(kComponent<T>) + R"(,"count":)" + std::to_string(values.size() / 3) +
                        R"(,"type":"VEC3")" + extra + "}");
    }
    /// Texture coordinates.
    template <class T>
    int pairs(const std::vector<T>& values, const std::string& extra = "") {
        return accessor(R"({"bufferView":)" + std::to_string(view(bytes_of(values))) + R"(,"componentType":)" +
                        std::to_string(kComponent<T>) + R"(,"count":)" + std::to_string(values.size() / 2) +
                        R"(,"type":"VEC2")" + extra + "}");
    }
    template <class T>
    int indices(const std::vector<T>& values) {
        return accessor(R"({"bufferView":)" + std::to_string(view(bytes_of(values))) + R"(,"componentType":)" +
                        std::to_string(kComponent<T>) + R"(,"count":)" + std::to_string(values.size()) +
                        R"(,"type":"SCALAR"})");
    }

    std::string meshes, materials;  ///< entries, with commas between
    std::string nodes = R"({"mesh":0})";
    std::string scenes = R"({"nodes":[0]})";
    std::string more;  ///< of the root, with a comma before

    const std::string& buffer() const { return buffer_; }

    /// @param uri  of the buffer, as JSON with a comma before; empty for a .glb
    std::string json(const std::string& uri) const {
        std::string text = R"({"asset":{"version":"2.0"},"buffers":[{"byteLength":)" + std::to_string(buffer_.size()) +
                           uri + R"(}],"bufferViews":[)" + list(views_) + R"(],"accessors":[)" + list(accessors_) +
                           R"(],"meshes":[)" + meshes + R"(],"materials":[)" + materials + R"(],"nodes":[)" + nodes +
                           "]";
        if (!scenes.empty()) text += R"(,"scenes":[)" + scenes + "]";
        return text + more + "}";
    }
    std::string text() const {
        return json(R"(,"uri":"data:application/octet-stream;base64,)" + base64(buffer_) + '"');
    }
    std::string glb() const {
        std::string head = json("");
        head.resize((head.size() + 3) / 4 * 4, ' ');
        const std::string chunks = u32_bytes(std::uint32_t(head.size())) + "JSON" + head +
                                   u32_bytes(std::uint32_t(buffer_.size())) + std::string("BIN\0", 4) + buffer_;
        return "glTF" + u32_bytes(2) + u32_bytes(std::uint32_t(chunks.size()) + 12) + chunks;
    }

private:
    static std::string list(const std::vector<std::string>& entries) {
        std::string text;
        for (const std::string& entry : entries) text += (text.empty() ? "" : ",") + entry;
        return text;
    }

    std::string buffer_;
    std::vector<std::string> views_, accessors_;
};

/// Corners of a box from (0, 0, 0) to (a, b, c), number k at bits x, y, z of k.
inline std::vector<float> box_corners(float a, float b, float c) {
    std::vector<float> corners;
    for (int k = 0; k < 8; ++k)
        for (const float x : {k & 1 ? a : 0, k & 2 ? b : 0, k & 4 ? c : 0}) corners.push_back(x);
    return corners;
}

/// Its twelve triangles, fronts outside.
template <class T = std::uint16_t>
std::vector<T> box_triangles() {
    return {0, 2, 3, 0, 3, 1, 4, 5, 7, 4, 7, 6, 0, 1, 5, 0, 5, 4, 2, 6, 7, 2, 7, 3, 0, 4, 6, 0, 6, 2, 1, 3, 7, 1, 7, 5};
}

inline std::string primitive(int position, int indices, const std::string& extra = "") {
    return R"({"attributes":{"POSITION":)" + std::to_string(position) + "}" +
           (indices < 0 ? "" : R"(,"indices":)" + std::to_string(indices)) + extra + "}";
}

/// A box of 2 x 1 x 3 m, in the file's axes.
inline SmallGltf box_file() {
    SmallGltf file;
    const int positions = file.vectors(box_corners(2, 1, 3));
    const int indices = file.indices(box_triangles());
    file.meshes = R"({"name":"box","primitives":[)" + primitive(positions, indices) + "]}";
    return file;
}

}  // namespace firma::gltf
