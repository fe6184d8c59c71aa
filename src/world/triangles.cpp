// SPDX-License-Identifier: MIT
// Faces as triangles, in order of material and id.
#include "firma/triangles.h"

#include <utility>

#include "base/sort.h"
#include "geometry/triangulate_convex.h"
#include "world/lay_texture.h"

namespace firma {
namespace {

std::array<float, 3> to_floats(const Vec3& v) {
    return {float(v.x), float(v.y), float(v.z)};
}

/// Exact: corners of faces lie on the surface grid.
GridPoint to_grid(const Vec3& corner) {
    return {std::int32_t(corner.x * kSurfaceSteps), std::int32_t(corner.y * kSurfaceSteps),
            std::int32_t(corner.z * kSurfaceSteps)};
}

class Collector {
public:
    Collector(const World& world, const TriangleOptions& options) : world_(world), options_(options) {}

    bool operator()(const FaceView& face) {
        if (!(face.mask & options_.mask) || (!face.solid && !options_.castable_only)) return true;
        faces_.push_back({face, std::uint32_t(corners_.size()), std::uint32_t(face.corners.size())});
        corners_.insert(corners_.end(), face.corners.begin(), face.corners.end());
        return true;
    }

    TriangleMesh take() {
        sort_range(faces_, [](const Collected& a, const Collected& b) {
            return a.info.material != b.info.material ? a.info.material < b.info.material : a.info.id < b.info.id;
        });
        for (const Collected& face : faces_) add(face);
        return std::move(made_);
    }

private:
    struct Collected {
        FaceInfo info;
        std::uint32_t first_corner, corner_count;
    };

    void add(const Collected& face) {
        const std::span corners = std::span<const Vec3>(corners_).subspan(face.first_corner, face.corner_count);
        grid_.clear();
        for (const Vec3& corner : corners) grid_.push_back(to_grid(corner));
        divided_.clear();
        triangulate_convex(grid_, divided_);

        const auto first_vertex = std::uint32_t(made_.positions.size());
        const auto first_triangle = std::uint32_t(made_.corners.size());
        for (const Vec3& corner : corners) {
            made_.positions.push_back(to_floats(corner - options_.origin));
            made_.normals.push_back(to_floats(face.info.normal));
        }
        for (const std::array<std::uint32_t, 3>& triangle : divided_) {
            made_.corners.push_back(
                {first_vertex + triangle[0], first_vertex + triangle[1], first_vertex + triangle[2]});
            made_.faces.push_back(face.info.id);
        }
        const auto triangle_count = std::uint32_t(divided_.size());
        made_.sources.push_back({face.info.id, face.info.room, face.info.source, face.info.source_edit,
                                 face.info.material, face.info.mask, face.info.two_sided, face.info.solid,
                                 first_triangle, triangle_count, first_vertex, face.corner_count});
        if (options_.uvs) made_.sources.back().uv_unit = add_uvs(face.info, corners);
        if (made_.runs.empty() || made_.runs.back().material != face.info.material)
            made_.runs.push_back({face.info.material, first_triangle, 0, first_vertex, 0});
        made_.runs.back().triangle_count += triangle_count;
        made_.runs.back().vertex_count += face.corner_count;
    }

    /// @return what they count
    TextureUnit add_uvs(const FaceInfo& face, std::span<const Vec3> corners) {
        const LaidTexture laid = lay_texture(world_, face, corners, options_.texture_sizes);
        for (const Vec3& corner : corners) made_.uvs.push_back(laid.at(corner));
        return laid.lies.unit;
    }

    const World& world_;
    const TriangleOptions& options_;
    std::vector<Collected> faces_;
    std::vector<Vec3> corners_;
    std::vector<GridPoint> grid_;
    std::vector<std::array<std::uint32_t, 3>> divided_;
    TriangleMesh made_;
};

template <class... Where>
TriangleMesh collect(const World& world, const TriangleOptions& options, const Where&... where) {
    Collector collector(world, options);
    if (is_finite(options.origin) && max_abs(options.origin) <= kMaxTriangleOrigin)
        each_face(world, where..., collector);
    return collector.take();
}

}  // namespace

TriangleMesh triangles_of(const World& world, const TriangleOptions& options) {
    return collect(world, options);
}
TriangleMesh triangles_of(const World& world, RoomId room, const TriangleOptions& options) {
    return collect(world, options, room);
}
TriangleMesh triangles_of(const World& world, const Region& region, const TriangleOptions& options) {
    return collect(world, options, region);
}

}  // namespace firma
