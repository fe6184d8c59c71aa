// SPDX-License-Identifier: MIT
// Fills one buffer (positions, normals, indices of each part in a row), describes it, has tinygltf write both.
// Source: Khronos Group, glTF 2.0 Specification, 2021, sections 3.6, 3.7 and 4.4.
#include "cli/write_glb.h"

#include <fmt/format.h>
#include <tiny_gltf.h>

#include <algorithm>
#include <bit>
#include <cstring>
#include <limits>
#include <ostream>
#include <streambuf>

#include "world/block_faces.h"

namespace firma::cli {

namespace {

static_assert(std::endian::native == std::endian::little, "glTF's buffers are little-endian: swap bytes in append()");

/// Hands on what is written to a std::ostream.
class PutBuffer : public std::streambuf {
public:
    explicit PutBuffer(const std::function<void(std::string_view)>& put) : put_(put) {}

protected:
    std::streamsize xsputn(const char* from, std::streamsize size) override {
        put_({from, std::size_t(size)});
        return size;
    }
    int_type overflow(int_type c) override {
        if (traits_type::eq_int_type(c, traits_type::eof())) return traits_type::not_eof(c);
        const char one = traits_type::to_char_type(c);
        put_({&one, 1});
        return c;
    }

private:
    const std::function<void(std::string_view)>& put_;
};

/// Where the next vertex and triangle of a part go.
struct Cursor {
    std::uint64_t first = 0;  ///< byte of the buffer at which the part begins
    std::uint64_t corners = 0, triangles = 0;
    std::array<float, 3> low, high;  ///< of its positions, as they are written
};

struct PlacedFace {
    FaceId id;
    const Block* block;
    const FaceRecord* record;
};

std::vector<PlacedFace> faces_by_id(const World& world) {
    std::vector<PlacedFace> faces;
    faces.reserve(world.face_count());
    for_each_record(
        world, [&](const Block& block, const FaceRecord& record) { faces.push_back({record.id, &block, &record}); });
    std::sort(faces.begin(), faces.end(), [](const PlacedFace& a, const PlacedFace& b) { return a.id < b.id; });
    return faces;
}

std::vector<Cursor> cursors_of(const GlbParts& parts) {
    std::vector<Cursor> cursors;
    std::uint64_t bytes = 0;
    for (const GlbPart& part : parts.list()) {
        Cursor& cursor = cursors.emplace_back();
        cursor.first = bytes;
        cursor.low.fill(std::numeric_limits<float>::infinity());
        cursor.high.fill(-std::numeric_limits<float>::infinity());
        bytes += 2 * part.vertex_bytes() + part.index_bytes();
    }
    return cursors;
}

std::array<float, 3> to_floats(const Vec3& v) {
    return {float(v.x), float(v.y), float(v.z)};
}

/// A face's corners with its normal, and a fan from the first corner.
void add_face(const Face& face, const GlbPart& part, Cursor& cursor, std::vector<unsigned char>& buffer) {
    unsigned char* const positions = buffer.data() + cursor.first;
    unsigned char* const normals = positions + part.vertex_bytes();
    unsigned char* const indices = normals + part.vertex_bytes();
    const std::array<float, 3> normal = to_floats(face.normal);
    const std::uint32_t first = std::uint32_t(cursor.corners);
    for (const Vec3& corner : face.corners) {
        const std::array<float, 3> position = to_floats(corner);
        for (std::size_t axis = 0; axis < 3; ++axis) {
            cursor.low[axis] = std::min(cursor.low[axis], position[axis]);
            cursor.high[axis] = std::max(cursor.high[axis], position[axis]);
        }
        std::memcpy(positions + 12 * cursor.corners, position.data(), 12);
        std::memcpy(normals + 12 * cursor.corners, normal.data(), 12);
        ++cursor.corners;
    }
    for (std::uint32_t k = 1; k + 1 < face.corners.size(); ++k) {
        const std::array<std::uint32_t, 3> triangle{first, first + k, first + k + 1};
        std::memcpy(indices + 12 * cursor.triangles, triangle.data(), 12);
        ++cursor.triangles;
    }
}

/// A view of its own for each accessor: tinygltf writes an accessor's offset as an int, which ends at 2 GiB.
int add_accessor(tinygltf::Model& model, std::uint64_t offset, std::uint64_t bytes, std::uint64_t count, bool indices) {
    tinygltf::BufferView view;
    view.buffer = 0;
    view.byteOffset = offset;
    view.byteLength = bytes;
    view.target = indices ? TINYGLTF_TARGET_ELEMENT_ARRAY_BUFFER : TINYGLTF_TARGET_ARRAY_BUFFER;
    model.bufferViews.push_back(view);
    tinygltf::Accessor accessor;
    accessor.bufferView = int(model.bufferViews.size()) - 1;
    accessor.componentType = indices ? TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT : TINYGLTF_COMPONENT_TYPE_FLOAT;
    accessor.type = indices ? TINYGLTF_TYPE_SCALAR : TINYGLTF_TYPE_VEC3;
    accessor.count = count;
    model.accessors.push_back(accessor);
    return int(model.accessors.size()) - 1;
}

tinygltf::Material material_of(const GlbPart& part) {
    const std::array<double, 3> colour = colour_of(part.name);
    tinygltf::Material material;
    material.name = part.name;
    material.doubleSided = part.two_sided;
    material.pbrMetallicRoughness.baseColorFactor = {colour[0], colour[1], colour[2], 1};
    material.pbrMetallicRoughness.metallicFactor = 0;
    material.pbrMetallicRoughness.roughnessFactor = 0.9;
    material.extras = tinygltf::Value(tinygltf::Value::Object{{"cut", tinygltf::Value(part.cut)}});
    return material;
}

tinygltf::Primitive add_part(tinygltf::Model& model, const GlbPart& part, const Cursor& cursor) {
    tinygltf::Primitive primitive;
    const std::uint64_t normals = cursor.first + part.vertex_bytes(), indices = normals + part.vertex_bytes();
    const int position = add_accessor(model, cursor.first, part.vertex_bytes(), part.corners, false);
    model.accessors.back().minValues.assign(cursor.low.begin(), cursor.low.end());
    model.accessors.back().maxValues.assign(cursor.high.begin(), cursor.high.end());
    primitive.attributes["POSITION"] = position;
    primitive.attributes["NORMAL"] = add_accessor(model, normals, part.vertex_bytes(), part.corners, false);
    primitive.indices = add_accessor(model, indices, part.index_bytes(), 3 * part.triangles(), true);
    primitive.mode = TINYGLTF_MODE_TRIANGLES;
    primitive.material = int(model.materials.size());
    model.materials.push_back(material_of(part));
    return primitive;
}

/// What turns an axis up to glTF's y, each axis to another: a quaternion x, y, z, w. None for y.
std::vector<double> rotation_to_y(int up) {
    constexpr double kHalf = 0.70710678118654752;  // sine and cosine of half a right angle
    if (up == 2) return {-kHalf, 0, 0, kHalf};     // x, y, z -> x, z, -y
    if (up == 0) return {0, 0, kHalf, kHalf};      // x, y, z -> -y, x, z
    return {};
}

/// tinygltf has no larger integers than int.
tinygltf::Value number_value(std::uint64_t number) {
    return number <= std::uint64_t(std::numeric_limits<int>::max()) ? tinygltf::Value(int(number))
                                                                    : tinygltf::Value(double(number));
}

/// Everything but what stands in the buffer. A world without faces is a scene without nodes.
tinygltf::Model describe(const World& world, const GlbParts& parts, const std::vector<Cursor>& cursors, int up) {
    tinygltf::Model model;
    model.asset.version = "2.0";
    model.asset.generator = "Firma " FIRMA_VERSION;
    model.asset.extras = tinygltf::Value(tinygltf::Value::Object{
        {"version", number_value(world.version())},
        {"edits", number_value(world.data().edits())},
        {"hash", tinygltf::Value(fmt::format("{:016x}", hash_world(world)))},
    });
    model.scenes.emplace_back();
    model.scenes[0].name = "world";  // one without anything in it, tinygltf would write as null
    model.defaultScene = 0;
    if (parts.list().empty()) return model;

    tinygltf::Mesh mesh;
    mesh.name = "world";
    for (std::size_t k = 0; k < cursors.size(); ++k)
        mesh.primitives.push_back(add_part(model, parts.list()[k], cursors[k]));
    model.meshes.push_back(mesh);
    tinygltf::Node node;
    node.name = "world";
    node.mesh = 0;
    node.rotation = rotation_to_y(up);
    model.nodes.push_back(node);
    model.scenes[0].nodes.push_back(0);
    return model;
}

}  // namespace

void write_glb(const World& world, const GlbParts& parts, int up, const std::function<void(std::string_view)>& put) {
    std::vector<Cursor> cursors = cursors_of(parts);
    std::vector<unsigned char> buffer(parts.buffer_bytes());
    for (const PlacedFace& face : faces_by_id(world)) {
        const std::size_t part = parts.part_of(*face.record);
        add_face(describe_face({}, *face.block, *face.record), parts.list()[part], cursors[part], buffer);
    }
    tinygltf::Model model = describe(world, parts, cursors, up);
    if (!buffer.empty()) {
        model.buffers.emplace_back();
        model.buffers[0].data = std::move(buffer);
    }
    PutBuffer pieces(put);
    std::ostream stream(&pieces);
    stream.exceptions(std::ios::badbit);  // what `put` throws comes through
    tinygltf::TinyGLTF().WriteGltfSceneToStream(&model, stream, false, true);
}

}  // namespace firma::cli
