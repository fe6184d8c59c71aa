// SPDX-License-Identifier: MIT
// Cutters from meshes, every number and index checked before it is used, and from solids.
#include <algorithm>
#include <string>
#include <utility>

#include "base/point_numbers.h"
#include "carve/cutter_data.h"
#include "carve/gather.h"
#include "firma/cutter.h"
#include "geometry/rounding.h"
#include "solid/solid_data.h"

namespace firma {
namespace {

constexpr std::uint32_t kUnused = ~0u;

/// The name goes in front of the place: "crater.obj: triangle 5".
Error named(const std::string& name, Error error) {
    if (!name.empty()) error.place = error.place.empty() ? name : name + ": " + error.place;
    return error;
}

std::string triangle_text(std::size_t t) {
    return "triangle " + std::to_string(t);
}

std::optional<Error> check_numbers(std::span<const Vec3> vertices, std::span<const CutterTriangle> triangles) {
    if (triangles.size() > kMaxCutterTriangles)
        return Error{ErrorCode::kTooLarge, "",
                     std::to_string(triangles.size()) + " triangles; a cutter has at most " +
                         std::to_string(kMaxCutterTriangles)};
    if (triangles.size() < 4) return Error{ErrorCode::kMalformed, "", "a closed mesh has at least 4 triangles"};
    for (std::size_t t = 0; t < triangles.size(); ++t) {
        const CutterTriangle& corners = triangles[t];
        for (const std::uint32_t corner : corners) {
            if (corner >= vertices.size())
                return Error{ErrorCode::kMalformed, triangle_text(t),
                             "names vertex " + std::to_string(corner) + " of " + std::to_string(vertices.size())};
            const Vec3& v = vertices[corner];
            if (!is_finite(v) || max_abs(v) > kLargestNumber)
                return Error{ErrorCode::kOutOfRange, "vertex " + std::to_string(corner),
                             "a number is not finite, or too large"};
        }
        if (corners[0] == corners[1] || corners[1] == corners[2] || corners[2] == corners[0])
            return Error{ErrorCode::kMalformed, triangle_text(t), "names a vertex twice"};
    }
    return std::nullopt;
}

/// Takes over mesh and edges with the vertices in use only, in their order.
void copy_used(std::span<const Vec3> vertices, std::span<const CutterTriangle> triangles, CutterData& data) {
    std::vector<std::uint32_t> number(vertices.size(), kUnused);
    for (const CutterTriangle& corners : triangles)
        for (const std::uint32_t corner : corners) number[corner] = 0;
    for (std::size_t v = 0; v < vertices.size(); ++v) {
        if (number[v] == kUnused) continue;
        number[v] = std::uint32_t(data.vertices.size());
        data.vertices.push_back(vertices[v]);
    }
    data.triangles.reserve(triangles.size());
    for (const auto& [a, b, c] : triangles) data.triangles.push_back({number[a], number[b], number[c]});
    for (CutterEdge& edge : data.topology.edges) {
        edge.a = number[edge.a];
        edge.b = number[edge.b];
    }
}

/// Sign of the enclosed volume of a closed mesh; 0 when rounding could have made it.
int volume_sign(const CutterData& data) {
    const Vec3 origin = data.vertices[0];
    double reach = 0;
    for (const Vec3& v : data.vertices) reach = std::max(reach, max_abs(v - origin));
    if (!(reach >= kSmallestNumber)) return 0;
    double sum = 0, size = 0;
    const auto around = [&](std::uint32_t v) {
        const Vec3 d = data.vertices[v] - origin;
        return Vec3{d.x / reach, d.y / reach, d.z / reach};
    };
    for (const auto& [a, b, c] : data.triangles) {
        const Vec3 p = around(a), q = around(b), r = around(c);
        sum += dot(p, cross(q, r));
        size += max_abs(p) * max_abs(q) * max_abs(r);
    }
    // Each determinant is six products of three parts, none of which exceeds the factors of `size`; differences and
    // quotients add three roundings to each part, and the sum one a triangle.
    const double bound = 6 * size * rounding(int(data.triangles.size()) + 20);
    return sum > bound ? 1 : sum < -bound ? -1 : 0;
}

void turn_over(CutterData& data) {
    for (CutterTriangle& corners : data.triangles) std::swap(corners[1], corners[2]);
    for (CutterEdge& edge : data.topology.edges) std::swap(edge.left, edge.right);
    // Corners a b c are a c b now: the sides a b and c a have changed places.
    for (auto& edges : data.topology.triangle_edges) std::swap(edges[0], edges[2]);
}

}  // namespace

Cutter::Cutter(std::shared_ptr<const CutterData> data) : data_(std::move(data)) {}

std::span<const Vec3> Cutter::vertices() const {
    return data_ ? std::span<const Vec3>(data_->vertices) : std::span<const Vec3>();
}

std::span<const CutterTriangle> Cutter::triangles() const {
    return data_ ? std::span<const CutterTriangle>(data_->triangles) : std::span<const CutterTriangle>();
}

const std::string& Cutter::name() const {
    static const std::string none;
    return data_ ? data_->name : none;
}

Result<Cutter> make_cutter(std::span<const Vec3> vertices, std::span<const CutterTriangle> triangles,
                           std::string name) {
    if (auto error = check_numbers(vertices, triangles)) return named(name, std::move(*error));
    auto topology = cutter_topology(triangles, vertices.size());
    if (!topology) return named(name, topology.error());
    auto data = std::make_shared<CutterData>();
    data->topology = std::move(topology).value();
    copy_used(vertices, triangles, *data);
    const int sign = volume_sign(*data);
    if (sign == 0) return named(name, {ErrorCode::kMalformed, "", "the mesh encloses no volume"});
    if (sign < 0) turn_over(*data);
    data->name = std::move(name);
    return Cutter(std::move(data));
}

Result<Cutter> cutter_from_solid(const Solid& solid, std::string name) {
    const auto refuse = [&](ErrorCode code, std::string reason) { return named(name, {code, "", std::move(reason)}); };
    if (solid.rock_outside()) return refuse(ErrorCode::kInvalid, "its rock reaches to infinity");
    if (solid.face_count() == 0) return refuse(ErrorCode::kInvalid, "nothing of it is solid");
    std::size_t count = 0;
    const std::vector<FacetPlace> facets = all_facets(solid.data().faces.root.get());
    for (const FacetPlace& facet : facets) count += facet.record().corner_count - 2;
    if (count > kMaxCutterTriangles)
        return refuse(ErrorCode::kTooLarge, std::to_string(count) + " triangles; a cutter has at most " +
                                                std::to_string(kMaxCutterTriangles));
    auto data = std::make_shared<CutterData>();
    PointNumbers corners;
    for (const FacetPlace& facet : facets) {
        const FaceRecord& record = facet.record();
        const auto corner = [&](std::size_t k) { return corners.number(facet.block->corner(record, k)); };
        for (std::size_t k = 2; k < record.corner_count; ++k)
            data->triangles.push_back({corner(0), corner(k - 1), corner(k)});
    }
    for (std::uint32_t k = 0; k < corners.count(); ++k) data->vertices.push_back(to_metres(corners.point(k)));
    data->solid = solid;
    data->name = std::move(name);
    return Cutter(std::move(data));
}

}  // namespace firma
