// SPDX-License-Identifier: MIT
// Gathers the drawn surfaces of the first model.
//
// All that is drawn is kept, whatever its shader's flags say: in a .bsp, "nodraw" surfaces are not drawn and so not
// there, and whether sky, water or a curtain stops a mover is for its user to say, by material name.
#include "level/bsp_surfaces.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "level/judge_input.h"

namespace firma {
namespace {

// Eight times what the engine itself can hold.
constexpr std::size_t kMostCorners = std::size_t(1) << 22;

// Units, across a surface that its compiler took for flat. Corners are moved to eighths of a unit, more than once; the
// most seen in fifty maps is 0.48.
constexpr double kMostUneven = 1;

class SurfaceGatherer {
public:
    SurfaceGatherer(const BspFile& file, BspSurfaces& out)
        : file_(file), mesh_vertices_(file.records<BspMeshVertex>()), out_(out) {}

    std::optional<Error> add(std::uint32_t entry, const BspFace& face) {
        switch (face.type) {
            case BspFace::kPlanar:
                return add_triangles(entry, face, FaceKind::kPolygon);
            case BspFace::kSoup:
                return add_triangles(entry, face, FaceKind::kTriangleSoup);
            case BspFace::kPatch:
                return add_patch(entry, face);
            case BspFace::kFlare:
                ++out_.ignored;
                return std::nullopt;
            default:
                return malformed(entry, "type " + std::to_string(face.type) + "; types are 1 to 4");
        }
    }

private:
    Error malformed(std::uint32_t entry, std::string reason) const {
        return file_.fault(ErrorCode::kMalformed, BspLump::kFaces, entry, std::move(reason));
    }

    // What both shapes of surface need: a shader, vertices, and room for the corners.
    std::optional<Error> judge(std::uint32_t entry, const BspFace& face, std::size_t corners) const {
        if (face.shader < 0 || std::size_t(face.shader) >= out_.shaders.size()) {
            return malformed(entry,
                             "shader " + std::to_string(face.shader) + " of " + std::to_string(out_.shaders.size()));
        }
        if (const auto bad = bad_range("vertices", face.first_vertex, face.vertex_count, out_.positions.size())) {
            return malformed(entry, *bad);
        }
        if (corners > kMostCorners - out_.corners.size()) {
            return file_.fault(ErrorCode::kTooLarge, BspLump::kFaces, entry,
                               "surfaces have more than " + std::to_string(kMostCorners) + " corners in all");
        }
        return std::nullopt;
    }

    BspSurface& push(std::uint32_t entry, const BspFace& face, FaceKind kind, std::size_t corners) {
        BspSurface surface;
        surface.face = entry;
        surface.kind = kind;
        surface.shader = std::uint32_t(face.shader);
        surface.first_corner = std::uint32_t(out_.corners.size());
        surface.corner_count = std::uint32_t(corners);
        return out_.surfaces.emplace_back(surface);
    }

    std::optional<Error> add_triangles(std::uint32_t entry, const BspFace& face, FaceKind kind) {
        if (const auto bad =
                bad_range("mesh vertices", face.first_mesh_vertex, face.mesh_vertex_count, mesh_vertices_.size())) {
            return malformed(entry, *bad);
        }
        const auto count = std::size_t(face.mesh_vertex_count);
        if (count % 3 != 0) return malformed(entry, std::to_string(count) + " mesh vertices are not whole triangles");
        if (auto error = judge(entry, face, count)) return error;
        if (count == 0) {
            ++out_.ignored;
            return std::nullopt;
        }
        push(entry, face, kind, count);
        // Quake's triangles run clockwise seen from the front: the last two corners change places.
        for (std::size_t k = 0; k < count; ++k) {
            const std::size_t at = std::size_t(face.first_mesh_vertex) + (k % 3 == 0 ? k : k % 3 == 1 ? k + 1 : k - 1);
            const std::int32_t vertex = mesh_vertices_[at].vertex;
            if (vertex < 0 || vertex >= face.vertex_count) {
                return file_.fault(ErrorCode::kMalformed, BspLump::kMeshVertices, at,
                                   "vertex " + std::to_string(vertex) + " of the " + std::to_string(face.vertex_count) +
                                       " of face " + std::to_string(entry));
            }
            out_.corners.push_back(std::uint32_t(face.first_vertex) + std::uint32_t(vertex));
        }
        if (kind == FaceKind::kPolygon) out_.surfaces.back().flat = is_flat(out_.surfaces.back(), face);
        return std::nullopt;
    }

    std::optional<Error> add_patch(std::uint32_t entry, const BspFace& face) {
        const std::int64_t width = face.patch_width, height = face.patch_height;
        if (width < 3 || height < 3 || width % 2 == 0 || height % 2 == 0) {
            return malformed(entry, "patch of " + std::to_string(width) + " x " + std::to_string(height) +
                                        " control points; both must be odd and 3 or more");
        }
        if (width * height != face.vertex_count) {
            return malformed(entry, "patch of " + std::to_string(width) + " x " + std::to_string(height) +
                                        " control points, but " + std::to_string(face.vertex_count) + " vertices");
        }
        const auto count = std::size_t(face.vertex_count);
        if (auto error = judge(entry, face, count)) return error;
        BspSurface& surface = push(entry, face, FaceKind::kPatch, count);
        surface.width = std::uint32_t(width);
        surface.height = std::uint32_t(height);
        for (std::size_t k = 0; k < count; ++k)
            out_.corners.push_back(std::uint32_t(face.first_vertex) + std::uint32_t(k));
        return std::nullopt;
    }

    bool is_flat(const BspSurface& surface, const BspFace& face) const {
        const auto [x, y, z] = face.normal;
        if (x == 0 && y == 0 && z == 0) return false;
        double low = INFINITY, high = -INFINITY;
        for (const std::uint32_t corner : out_.corners_of(surface)) {
            const double height = dot(out_.positions[corner], {x, y, z});
            low = std::min(low, height);
            high = std::max(high, height);
        }
        return low <= high && high - low <= kMostUneven;
    }

    const BspFile& file_;
    BspRecords<BspMeshVertex> mesh_vertices_;
    BspSurfaces& out_;
};

// Every vertex of the lump, used or not: a file with a bad number in it is a bad file.
std::optional<Error> read_vertices(const BspFile& file, BspSurfaces& out) {
    const auto vertices = file.records<BspVertex>();
    out.positions.reserve(vertices.size());
    out.snapped.reserve(vertices.size());
    out.uvs.reserve(vertices.size());
    for (std::size_t k = 0; k < vertices.size(); ++k) {
        const BspVertex vertex = vertices[k];
        const auto [x, y, z] = vertex.position;
        const Vec3 position = {x, y, z};
        const std::optional<GridPoint> point = snap(position * out.scale);
        if (!point) {
            return file.fault(ErrorCode::kOutOfRange, BspLump::kVertices, k, point_fault(position, out.scale));
        }
        out.positions.push_back(position);
        out.snapped.push_back(*point);
        out.uvs.push_back({double(vertex.uv[0]), double(vertex.uv[1])});
    }
    return std::nullopt;
}

}  // namespace

Result<BspSurfaces> read_surfaces(const BspFile& file, const ReadOptions& options) {
    if (auto error = judge_options(options, file.name())) return *std::move(error);
    const auto faces = file.records<BspFace>();
    const auto models = file.records<BspModel>();
    if (models.size() == 0)
        return file.fault(ErrorCode::kMalformed, BspLump::kModels, "is empty; the first model is the level");
    const BspModel model = models[0];
    if (const auto bad = bad_range("faces", model.first_face, model.face_count, faces.size())) {
        return file.fault(ErrorCode::kMalformed, BspLump::kModels, 0, *bad);
    }

    BspSurfaces out;
    out.scale = options.scale == 0 ? kQuakeUnit : options.scale;
    if (auto error = read_vertices(file, out)) return *std::move(error);
    const auto shaders = file.records<BspShader>();
    for (std::size_t k = 0; k < shaders.size(); ++k) out.shaders.emplace_back(shaders[k].name);
    out.face_count = std::uint32_t(faces.size());
    out.of_other_models = faces.size() - std::size_t(model.face_count);
    out.ignored = out.of_other_models;

    SurfaceGatherer gatherer(file, out);
    for (std::int32_t k = 0; k < model.face_count; ++k) {
        const auto entry = std::uint32_t(model.first_face + k);
        if (auto error = gatherer.add(entry, faces[entry])) return *std::move(error);
    }
    if (out.surfaces.empty()) {
        return file.fault(ErrorCode::kMalformed, BspLump::kFaces, "the first model has no surface to cast against");
    }
    return out;
}

}  // namespace firma
