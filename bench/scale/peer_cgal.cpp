// SPDX-License-Identifier: MIT
// CGAL's AABB tree: rays; it sweeps no spheres.
//
// CGAL's packages are under the GPL: nothing but this program is built with them, and nothing that is handed out.
#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/AABB_triangle_primitive.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/version.h>

#include <algorithm>
#include <optional>

#include "scale/scale_peer.h"

namespace firma::bench {
namespace {

using RayKernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using RayTriangles = std::vector<RayKernel::Triangle_3>;
using RayPrimitive = CGAL::AABB_triangle_primitive<RayKernel, RayTriangles::const_iterator>;
using RayTree = CGAL::AABB_tree<CGAL::AABB_traits<RayKernel, RayPrimitive>>;

/// Up to this length, metres, all hits of the segment are asked for, else the first of the ray.
constexpr double kShortRay = 4;

class CgalScalePeer final : public ScalePeer {
public:
    std::string describe() const override {
        return "CGAL " CGAL_VERSION_STR
               "; AABB_tree, exact predicates, inexact constructions: all_intersections() of "
               "segments up to 4 m, first_intersection() of rays beyond";
    }
    bool has(CastShape shape) const override { return shape == CastShape::kRay; }

    void build(const ScaleScene& scene) override {
        const TriangleMesh& mesh = scene.mesh;
        const auto point = [&](std::size_t corner) {
            const float* p = mesh.positions.data() + 3 * std::size_t(mesh.corners[corner]);
            return RayKernel::Point_3(p[0], p[1], p[2]);
        };
        triangles_.reserve(mesh.triangles());
        for (std::size_t k = 0; k < mesh.corners.size(); k += 3)
            triangles_.emplace_back(point(k), point(k + 1), point(k + 2));
        tree_.emplace(triangles_.cbegin(), triangles_.cend());
        tree_->build();
    }

    void cast(CastShape, std::span<const FloatCast> casts, double* fractions) override {
        for (std::size_t k = 0; k < casts.size(); ++k) {
            const FloatCast& c = casts[k];
            const RayKernel::Point_3 start(c.start[0], c.start[1], c.start[2]);
            const RayKernel::Vector_3 path(c.path[0], c.path[1], c.path[2]);
            const double square = path.squared_length();
            double first = kScaleMiss;
            const auto meet = [&](const RayKernel::Point_3& at) {
                first = std::min(first, (at - start) * path / square);
            };
            const auto take = [&](const auto& found) {
                if (const auto* point = boost::get<RayKernel::Point_3>(&found.first)) meet(*point);
                if (const auto* along = boost::get<RayKernel::Segment_3>(&found.first))
                    meet(along->source()), meet(along->target());
            };
            if (square <= kShortRay * kShortRay) {
                found_.clear();
                tree_->all_intersections(RayKernel::Segment_3(start, start + path), std::back_inserter(found_));
                for (const Found& one : found_) take(one);
            } else if (const auto one = tree_->first_intersection(RayKernel::Ray_3(start, path))) {
                take(*one);
            }
            fractions[k] = first > 1 ? kScaleMiss : first;
        }
    }

private:
    using Found = RayTree::Intersection_and_primitive_id<RayKernel::Segment_3>::Type;

    RayTriangles triangles_;
    std::optional<RayTree> tree_;
    std::vector<Found> found_;
};

}  // namespace

std::unique_ptr<ScalePeer> make_cgal_peer() {
    return std::make_unique<CgalScalePeer>();
}

}  // namespace firma::bench
