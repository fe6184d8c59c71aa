// SPDX-License-Identifier: MIT
// For the module of readers: an .obj file as the mesh that a cutter is made of, which the other module does.
#include <cstring>
#include <memory>

#include "bindings/c/convert.h"
#include "bindings/c/objects.h"
#include "carve/level_triangles.h"
#include "firma/level.h"

using namespace firma;
using namespace firma::c;

/// firma_cutter_from_obj() up to the mesh that firma_cutter_from_mesh() then gets: three doubles for each of
/// `vertex_count` vertices, then three words a triangle.
extern "C" firma_code firma_wasm_mesh_from_obj(const char* text, size_t length, const char* name,
                                               uint32_t* vertex_count, firma_bytes* bytes) {
    return guarded(__func__, [&, function = __func__] {
        if (!bytes || !vertex_count || (length && !text)) return bad_call(function, kNull);
        const Result<Level> level = read_obj({text, length}, name_or(name, "obj"));
        if (!level) return fail(level.error());
        const Result<LevelTriangles> mesh = level_triangles(level.value());
        if (!mesh) return fail(mesh.error());
        const auto& [vertices, triangles] = mesh.value();
        auto made = std::make_unique<BytesObject>();
        made->bytes.resize(vertices.size() * sizeof(Vec3) + triangles.size() * sizeof(CutterTriangle));
        if (!vertices.empty()) std::memcpy(made->bytes.data(), vertices.data(), vertices.size() * sizeof(Vec3));
        if (!triangles.empty())
            std::memcpy(made->bytes.data() + vertices.size() * sizeof(Vec3), triangles.data(),
                        triangles.size() * sizeof(CutterTriangle));
        *vertex_count = uint32_t(vertices.size());
        return give(std::move(made), bytes, function);
    });
}
