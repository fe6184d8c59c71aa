// SPDX-License-Identifier: MIT
// Meshes and solids as bytes, and back.
#include "log/cutter_bytes.h"

#include <vector>

#include "carve/cutter_data.h"
#include "firma/save.h"
#include "firma/world.h"

namespace firma {
namespace {

constexpr std::uint8_t kMeshCutter = 0, kSolidCutter = 1;
constexpr std::size_t kVertexBytes = 24, kLeastTriangleBytes = 3;

Cutter take_mesh(ByteReader& in, std::string name) {
    const std::uint64_t vertex_count = in.whole(), triangle_count = in.whole();
    if (vertex_count > in.left() / kVertexBytes ||
        triangle_count > (in.left() - vertex_count * kVertexBytes) / kLeastTriangleBytes) {
        in.fail("a mesh has more vertices or triangles than bytes follow");
        return {};
    }
    std::vector<Vec3> vertices(static_cast<std::size_t>(vertex_count));
    for (Vec3& vertex : vertices)
        for (int axis = 0; axis < 3; ++axis) vertex[axis] = in.f64();
    std::vector<CutterTriangle> triangles(static_cast<std::size_t>(triangle_count));
    for (CutterTriangle& triangle : triangles)
        for (std::uint32_t& corner : triangle) {
            const std::uint64_t at = in.whole();
            if (at >= vertex_count) in.fail("a triangle names a vertex that is not there");
            corner = std::uint32_t(at);
        }
    if (!in.ok()) return {};
    Result<Cutter> made = make_cutter(vertices, triangles, std::move(name));
    if (made) return std::move(made).value();
    in.fail("a mesh is no cutter: " + made.error().text());
    return {};
}

Cutter take_solid(ByteReader& in, std::string name) {
    const std::size_t where = in.place();
    const Result<World> world = unpack_world(in.bytes(in.left()), in.name());
    if (!world) {
        in.fail_at(where, world.error().code, "a solid is no .firma file: " + world.error().text());
        return {};
    }
    Result<Cutter> made = cutter_from_solid(world.value().solid(), std::move(name));
    if (made) return std::move(made).value();
    in.fail_at(where, ErrorCode::kMalformed, "a solid is no cutter: " + made.error().text());
    return {};
}

}  // namespace

void put_cutter(ByteWriter& out, const Cutter& cutter) {
    const CutterData& data = *cutter.data();
    out.u8(data.solid ? kSolidCutter : kMeshCutter);
    put_text(out, data.name);
    if (data.solid) return put_bytes(out, pack_world(make_world(*data.solid).value()));
    put_whole(out, data.vertices.size());
    put_whole(out, data.triangles.size());
    for (const Vec3& vertex : data.vertices)
        for (int axis = 0; axis < 3; ++axis) out.f64(vertex[axis]);
    for (const CutterTriangle& triangle : data.triangles)
        for (const std::uint32_t corner : triangle) put_whole(out, corner);
}

Cutter take_cutter(ByteReader& in) {
    const std::uint8_t kind = in.u8();
    std::string name = in.text();
    if (!in.ok()) return {};
    if (kind > kSolidCutter) {
        in.fail(ErrorCode::kUnsupported, "a kind of cutter that this Firma does not know");
        return {};
    }
    Cutter cutter = kind == kSolidCutter ? take_solid(in, std::move(name)) : take_mesh(in, std::move(name));
    if (in.ok() && !in.at_end()) in.fail("bytes behind a cutter");
    return in.ok() ? cutter : Cutter();
}

}  // namespace firma
