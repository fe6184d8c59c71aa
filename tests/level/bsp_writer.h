// SPDX-License-Identifier: MIT
// Writes small .bsp files for tests: sound ones, and broken ones by changing what is public here.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "firma/vec.h"
#include "level/bsp_file.h"

namespace firma::test {

/// Appends little-endian numbers.
struct ByteWriter {
    std::vector<std::byte> bytes;

    void add(std::uint32_t value) {
        for (int k = 0; k < 4; ++k) bytes.push_back(std::byte(value >> (8 * k) & 255));
    }
    void add(std::int32_t value) { add(std::uint32_t(value)); }
    void add(float value) { add(std::bit_cast<std::uint32_t>(value)); }
    void add(const Vec3& v) {
        for (int axis = 0; axis < 3; ++axis) add(float(v[axis]));
    }
    void add_name(std::string_view name) {
        for (std::size_t k = 0; k < 64; ++k) bytes.push_back(k < name.size() ? std::byte(name[k]) : std::byte{0});
    }
    void add_zeros(std::size_t count) { bytes.resize(bytes.size() + count); }
};

/// Overwrites four bytes.
inline void poke(std::span<std::byte> bytes, std::size_t at, std::int32_t value) {
    for (std::size_t k = 0; k < 4; ++k) bytes[at + k] = std::byte(std::uint32_t(value) >> (8 * k) & 255);
}

/// Where the directory's entry for a lump begins: its offset, and its length four bytes on.
inline std::size_t directory_entry(BspLump lump) {
    return 8 + 8 * std::size_t(lump);
}

class BspWriter {
public:
    BspWriter() { shader("textures/tests/wall"); }

    struct Model {
        std::int32_t first_face = 0, face_count = -1;    ///< -1: all
        std::int32_t first_brush = 0, brush_count = -1;  ///< likewise
    };

    std::string magic = "IBSP";
    std::int32_t version = 46;
    std::string entities = "{ \"classname\" \"worldspawn\" }";
    std::vector<std::string> shaders;
    std::vector<std::array<std::int32_t, 2>> shader_flags;  ///< surface, contents
    std::vector<BspPlane> planes;
    std::vector<BspBrush> brushes;
    std::vector<BspBrushSide> brush_sides;
    std::vector<Vec3> vertices;
    std::vector<std::array<float, 2>> uvs;  ///< of vertices; missing ones are 0
    std::vector<std::int32_t> mesh_vertices;
    std::vector<BspFace> faces;
    std::vector<Model> models = {{}};

    std::int32_t shader(std::string name, std::int32_t surface = 0, std::uint32_t contents = 0) {
        shaders.push_back(std::move(name));
        shader_flags.push_back({surface, std::int32_t(contents)});
        return std::int32_t(shaders.size()) - 1;
    }

    /// The plane normal . p = distance and its negative behind it; the number of the first.
    std::int32_t plane(const Vec3& normal, double distance) {
        for (const float sign : {1.0f, -1.0f}) {
            const Vec3 n = normal * double(sign);
            planes.push_back({{float(n.x), float(n.y), float(n.z)}, sign * float(distance)});
        }
        return std::int32_t(planes.size()) - 2;
    }

    /// A brush by its planes' numbers, all of one shader.
    BspBrush& brush(const std::vector<std::int32_t>& of, std::int32_t shader) {
        brushes.push_back({std::int32_t(brush_sides.size()), std::int32_t(of.size()), shader});
        for (const std::int32_t k : of) brush_sides.push_back({k, shader});
        return brushes.back();
    }

    /// A box; sides in the order low x, high x, low y ...
    BspBrush& box(const Vec3& low, const Vec3& high, std::int32_t shader) {
        std::vector<std::int32_t> of;
        for (int axis = 0; axis < 3; ++axis) {
            Vec3 normal;
            normal[axis] = 1;
            of.push_back(plane(normal, low[axis]) + 1);
            of.push_back(plane(normal, high[axis]));
        }
        return brush(of, shader);
    }

    /// Triangles by corners counted from 0, counter-clockwise seen from the front; they are written clockwise, as Quake
    /// has it.
    BspFace& triangles(std::int32_t type, const std::vector<Vec3>& corners,
                       const std::vector<std::array<std::int32_t, 3>>& list, const Vec3& normal = {0, 0, 1}) {
        BspFace face;
        face.type = type;
        face.first_vertex = std::int32_t(vertices.size());
        face.vertex_count = std::int32_t(corners.size());
        face.first_mesh_vertex = std::int32_t(mesh_vertices.size());
        face.mesh_vertex_count = std::int32_t(3 * list.size());
        face.normal = {float(normal.x), float(normal.y), float(normal.z)};
        vertices.insert(vertices.end(), corners.begin(), corners.end());
        for (const auto& [a, b, c] : list) mesh_vertices.insert(mesh_vertices.end(), {a, c, b});
        return faces.emplace_back(face);
    }

    /// A planar face by its outline, counter-clockwise, as a fan around its first corner.
    BspFace& polygon(const std::vector<Vec3>& outline) {
        std::vector<std::array<std::int32_t, 3>> fan;
        Vec3 normal;
        for (std::int32_t k = 2; k < std::int32_t(outline.size()); ++k) {
            fan.push_back({0, k - 1, k});
            normal = normal + cross(outline[std::size_t(k) - 1] - outline[0], outline[std::size_t(k)] - outline[0]);
        }
        return triangles(BspFace::kPlanar, outline, fan, normal * (1 / length(normal)));
    }

    BspFace& patch(std::int32_t width, std::int32_t height, const std::vector<Vec3>& control) {
        BspFace face;
        face.type = BspFace::kPatch;
        face.first_vertex = std::int32_t(vertices.size());
        face.vertex_count = std::int32_t(control.size());
        face.patch_width = width;
        face.patch_height = height;
        vertices.insert(vertices.end(), control.begin(), control.end());
        return faces.emplace_back(face);
    }

    std::vector<std::byte> bytes() const {
        std::array<ByteWriter, kBspLumps> lumps;
        write_lumps(lumps);
        ByteWriter file;
        for (const char c : magic) file.bytes.push_back(std::byte(c));
        file.add(version);
        auto offset = std::int32_t(8 + 8 * kBspLumps);
        for (const ByteWriter& lump : lumps) {
            file.add(offset);
            file.add(std::int32_t(lump.bytes.size()));
            offset += std::int32_t(lump.bytes.size());
        }
        for (const ByteWriter& lump : lumps) file.bytes.insert(file.bytes.end(), lump.bytes.begin(), lump.bytes.end());
        return file.bytes;
    }

private:
    void write_lumps(std::array<ByteWriter, kBspLumps>& lumps) const {
        const auto lump = [&](BspLump which) -> ByteWriter& { return lumps[std::size_t(which)]; };
        for (const char c : entities) lump(BspLump::kEntities).bytes.push_back(std::byte(c));
        lump(BspLump::kEntities).add_zeros(1);
        for (std::size_t k = 0; k < shaders.size(); ++k) {
            lump(BspLump::kShaders).add_name(shaders[k]);
            for (const std::int32_t flags : shader_flags[k]) lump(BspLump::kShaders).add(flags);
        }
        if (planes.empty()) lump(BspLump::kPlanes).add_zeros(16);
        for (const BspPlane& each : planes) {
            for (const float component : each.normal) lump(BspLump::kPlanes).add(component);
            lump(BspLump::kPlanes).add(each.distance);
        }
        for (const BspBrush& each : brushes)
            for (const std::int32_t field : {each.first_side, each.side_count, each.shader})
                lump(BspLump::kBrushes).add(field);
        for (const BspBrushSide& side : brush_sides)
            for (const std::int32_t field : {side.plane, side.shader}) lump(BspLump::kBrushSides).add(field);
        for (const Model& model : models) {
            lump(BspLump::kModels).add_zeros(24);
            lump(BspLump::kModels).add(model.first_face);
            lump(BspLump::kModels).add(model.face_count < 0 ? std::int32_t(faces.size()) : model.face_count);
            lump(BspLump::kModels).add(model.first_brush);
            lump(BspLump::kModels).add(model.brush_count < 0 ? std::int32_t(brushes.size()) : model.brush_count);
        }
        for (std::size_t k = 0; k < vertices.size(); ++k) {
            lump(BspLump::kVertices).add(vertices[k]);
            for (const float part : k < uvs.size() ? uvs[k] : std::array<float, 2>{})
                lump(BspLump::kVertices).add(part);
            lump(BspLump::kVertices).add_zeros(24);
        }
        for (const std::int32_t k : mesh_vertices) lump(BspLump::kMeshVertices).add(k);
        for (const BspFace& face : faces) write_face(lump(BspLump::kFaces), face);
        lump(BspLump::kVisibility).add_zeros(9);
    }

    static void write_face(ByteWriter& out, const BspFace& face) {
        out.add(face.shader);
        out.add(-1);  // effect
        for (const std::int32_t field :
             {face.type, face.first_vertex, face.vertex_count, face.first_mesh_vertex, face.mesh_vertex_count}) {
            out.add(field);
        }
        out.add_zeros(56);  // lightmap
        for (const float component : face.normal) out.add(component);
        out.add(face.patch_width);
        out.add(face.patch_height);
    }
};

}  // namespace firma::test
