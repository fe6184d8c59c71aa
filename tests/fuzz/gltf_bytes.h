// SPDX-License-Identifier: MIT
// glTF files for a fuzzer: the bytes themselves, or a .glb whose container and JSON are in order, so that what lies
// behind them is reached.
#pragma once

#include <algorithm>
#include <cstdint>
#include <initializer_list>
#include <string>
#include <utility>

#include "tests/fuzz/bytes.h"

namespace firma::fuzz {

inline std::string u32_bytes(std::size_t number) {
    std::string bytes;
    for (int k = 0; k < 4; ++k) bytes += char(number >> (8 * k) & 0xFF);
    return bytes;
}

inline std::string glb_of(std::string json, std::string bin) {
    json.resize((json.size() + 3) / 4 * 4, ' ');
    bin.resize((bin.size() + 3) / 4 * 4);
    const std::string chunks =
        u32_bytes(json.size()) + "JSON" + json + u32_bytes(bin.size()) + std::string("BIN\0", 4) + bin;
    return "glTF" + u32_bytes(2) + u32_bytes(chunks.size() + 12) + chunks;
}

/// A document of all that the reader reads: 30 positions, indices of them, normals that are all alike; with them, now
/// and then, what hurts. Numbers by the bytes.
class GltfMaker {
public:
    explicit GltfMaker(Bytes& bytes) : bytes_(bytes) {}

    std::string glb() {
        std::string bin;
        for (int k = 0; k < 3 * kPositions; ++k) add_float(bin);
        const int triangles = 1 + bytes_.next() % 20;
        for (int k = 0; k < 3 * triangles; ++k) bin += char(bytes_.next() % (one_in(64) ? 256 : kPositions));

        std::string json = R"({"asset":{"version":"2.0"},"bufferViews":[{"buffer":0,"byteLength":360},)"
                           R"({"buffer":0,"byteOffset":360,"byteLength":)" +
                           std::to_string(3 * triangles) + "}," + several([&] { return view(); }) + "]";
        json += R"(,"accessors":[{"bufferView":0,"componentType":5126,"type":"VEC3","count":30},{"bufferView":1,)"
                R"("componentType":5121,"type":"SCALAR","count":)" +
                std::to_string(3 * triangles) + R"(},{"componentType":5126,"type":"VEC3","count":30},)" +
                several([&] { return accessor(); }) + "]";
        json += list("meshes", [&] { return R"({"primitives":[)" + several([&] { return primitive(); }) + "]}"; });
        json += list("materials", [&] { return choice({R"({"name":"a"})", R"({"doubleSided":true})", "{}"}); });
        json += R"(,"nodes":[)" + node(0) + "," + several([&] { return node(1); }) + "]";
        if (one_in(8)) json += R"(,"scenes":[{"nodes":)" + indices() + R"(}],"scene":)" + (one_in(8) ? "1" : "0");
        json += R"(,"buffers":[{"byteLength":)" + (one_in(64) ? number() : std::to_string(bin.size())) + "}]}";
        return glb_of(json, bin);
    }

private:
    bool one_in(int n) { return bytes_.next() % n == n - 1; }

    static constexpr int kPositions = 30;

    void add_float(std::string& to) {
        const float number = one_in(128) ? float(bytes_.any_double()) : float(bytes_.next() % 16 - 8) / 2;
        to.append(reinterpret_cast<const char*>(&number), sizeof number);
    }

    std::string choice(std::initializer_list<const char*> texts) {
        return texts.begin()[std::size_t(bytes_.next()) % texts.size()];
    }

    template <class Make>
    std::string several(Make make) {
        std::string text;
        for (int k = bytes_.next() % 4; k >= 0; --k) text += (text.empty() ? "" : ",") + make();
        return text;
    }
    template <class Make>
    std::string list(const char* name, Make make) {
        return std::string(",\"") + name + "\":[" + several(make) + "]";
    }

    std::string index() { return one_in(255) ? number() : std::to_string(bytes_.next() % 4); }
    /// Of an accessor: the one that fits, or any.
    std::string accessor_or(const char* good) { return one_in(16) ? std::to_string(bytes_.next() % 6) : good; }
    std::string indices() {
        return "[" + several([&] { return index(); }) + "]";
    }
    std::string number() {
        return choice({"-1", "3", "2147483647", "2147483648", "4294967296", "9007199254740992", "1e18", "0.5", "1e308",
                       "-1e308", "1e-320", "null", "true", "[]", "{}", "\"\""});
    }
    std::string small() { return one_in(255) ? number() : std::to_string(bytes_.next()); }
    std::string real() { return one_in(255) ? number() : std::to_string(double(bytes_.next() - 128) / 16); }
    std::string reals(int count) {
        std::string text;
        for (int k = 0; k < count; ++k) text += (k ? "," : "") + real();
        return "[" + text + "]";
    }

    std::string view() {
        return R"({"buffer":)" + (one_in(32) ? index() : "0") + R"(,"byteOffset":)" +
               std::to_string(bytes_.next() % 32) + R"(,"byteLength":)" + small() +
               (one_in(4) ? R"(,"byteStride":)" + choice({"4", "8", "12", "16"}) : "") + "}";
    }
    std::string component() {
        return one_in(64) ? choice({"5124", "5130", "0"}) : choice({"5126", "5123", "5121", "5125", "5120", "5122"});
    }
    std::string accessor() {
        std::string text = R"({"componentType":)" + component() + R"(,"type":)" +
                           choice({"\"VEC3\"", "\"SCALAR\"", "\"VEC3\"", "\"VEC2\""}) + R"(,"count":)" + small();
        if (!one_in(8)) text += R"(,"bufferView":)" + index();
        if (one_in(4)) text += R"(,"byteOffset":)" + small();
        if (one_in(4)) text += R"(,"normalized":true)";
        if (one_in(4))
            text += R"(,"sparse":{"count":)" + index() + R"(,"indices":{"bufferView":)" + index() +
                    R"(,"componentType":)" + component() + R"(},"values":{"bufferView":)" + index() + "}}";
        return text + "}";
    }
    std::string primitive() {
        std::string text = R"({"attributes":{"POSITION":)" + accessor_or("0");
        if (one_in(2)) text += R"(,"NORMAL":)" + accessor_or("2");
        text += "}";
        if (!one_in(8)) text += R"(,"indices":)" + accessor_or("1");
        if (one_in(2)) text += R"(,"mode":)" + std::to_string(one_in(32) ? 7 : bytes_.next() % 7);
        if (one_in(4)) text += R"(,"material":)" + (one_in(16) ? index() : "0");
        return text + "}";
    }
    /// @param first  0: it may have others as children
    std::string node(int first) {
        std::string text = "{" + choice({R"("name":"portal")", R"("name":"a")", R"("extras":{"mask":"walk"})",
                                         R"("extras":{"portal":1,"mask":7})"});
        if (first == 0 || !one_in(4)) text += R"(,"mesh":)" + (one_in(16) ? index() : "0");
        if (one_in(4) && first == 0) text += R"(,"children":)" + choice({"[1]", "[1]", "[1,2]", "[0]", "[9]"});
        if (one_in(8)) return text + R"(,"matrix":)" + (one_in(4) ? reals(16) : matrix()) + "}";
        if (one_in(4)) text += R"(,"rotation":)" + reals(4);
        if (one_in(4)) text += R"(,"scale":)" + reals(3);
        if (one_in(4)) text += R"(,"translation":)" + reals(3);
        return text + "}";
    }
    std::string matrix() {
        std::string text;
        for (int k = 0; k < 4; ++k) {
            for (int row = 0; row < 3; ++row) text += real() + ",";
            text += k < 3 ? "0," : "1";
        }
        return "[" + text + "]";
    }

    Bytes& bytes_;
};

/// Boxes, with fronts in- or outside, and portals, quads and triangles, at small whole numbers: much touches and
/// crosses.
inline std::string rooms_glb(Bytes& bytes) {
    std::string bin;
    const auto add_float = [&](float number) { bin.append(reinterpret_cast<const char*>(&number), sizeof number); };
    for (int k = 0; k < 8; ++k)
        for (int axis = 0; axis < 3; ++axis) add_float(float(k >> axis & 1));
    const char outward[] = {0, 2, 3, 0, 3, 1, 4, 5, 7, 4, 7, 6, 0, 1, 5, 0, 5, 4,
                            2, 6, 7, 2, 7, 3, 0, 4, 6, 0, 6, 2, 1, 3, 7, 1, 7, 5};
    for (std::size_t k = 0; k < 36; ++k) bin += outward[k];
    for (std::size_t k = 0; k < 36; k += 3) bin += {outward[k + 1], outward[k], outward[k + 2]};
    bin += std::string("\0\2\6\0\6\4", 6) + std::string("\0\3\5\0\5\7", 6);  // a square; two triangles askew
    std::string json = R"({"asset":{"version":"2.0"},"buffers":[{"byteLength":)" + std::to_string(bin.size()) +
                       R"(}],"bufferViews":[{"buffer":0,"byteLength":)" + std::to_string(bin.size()) +
                       R"(}],"accessors":[{"bufferView":0,"componentType":5126,"type":"VEC3","count":8})";
    std::string meshes;
    for (const auto& [offset, count] : {std::pair{96, 36}, {132, 36}, {168, 6}, {174, 6}}) {
        json += R"(,{"bufferView":0,"componentType":5121,"type":"SCALAR","byteOffset":)" + std::to_string(offset) +
                R"(,"count":)" + std::to_string(count) + "}";
        meshes += std::string(meshes.empty() ? "" : ",") + R"({"primitives":[{"attributes":{"POSITION":0},"indices":)" +
                  std::to_string(1 + (offset - 96) / 36 + (offset == 174)) + "}]}";
    }
    json += R"(],"meshes":[)" + meshes + R"(],"nodes":[)";
    const int nodes = 1 + bytes.next() % 6;
    for (int k = 0; k < nodes; ++k) {
        const int mesh = k == 0 ? bytes.next() % 2 : bytes.next() % 4;
        json += std::string(k ? "," : "") + R"({"mesh":)" + std::to_string(mesh) + R"(,"name":")" +
                (mesh > 1 && bytes.next() % 8 ? "portal" : "wall") + '"';
        for (const char* member : {"translation", "scale"}) {
            json += std::string(",\"") + member + "\":[";
            for (int axis = 0; axis < 3; ++axis) {
                const int number = bytes.next();
                json += std::to_string(number % 8 + (number >= 240 ? 0.1 : 0) - (member[0] == 't' ? 2 : -1)) +
                        (axis < 2 ? "," : "]");
            }
        }
        const int turn = bytes.next() % 8;
        if (turn == 1) json += R"(,"rotation":[0,1,0,1])";
        if (turn == 2) json += R"(,"rotation":[0,0,1,1])";
        if (turn == 3) json += R"(,"rotation":[1,2,3,4])";
        json += "}";
    }
    return glb_of(json + "]}", bin);
}

/// By the first byte: M, a made document; R, rooms; J, JSON up to a zero and a buffer, in a container; else a file as
/// it is.
inline std::string gltf_bytes(const std::uint8_t* data, std::size_t size) {
    const std::string file(reinterpret_cast<const char*>(data), size);
    if (file.starts_with('M')) {
        Bytes bytes(data + 1, size - 1);
        return GltfMaker(bytes).glb();
    }
    if (file.starts_with('R')) {
        Bytes bytes(data + 1, size - 1);
        return rooms_glb(bytes);
    }
    if (file.starts_with('J')) {
        const std::size_t end = std::min(file.find('\0'), file.size());
        return glb_of(file.substr(1, end - 1), end < file.size() ? file.substr(end + 1) : "");
    }
    return file;
}

}  // namespace firma::fuzz
