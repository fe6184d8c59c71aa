// SPDX-License-Identifier: MIT
// How many faces reach into a placed cutter.
#include "world/count_reaching.h"

#include <algorithm>
#include <span>
#include <utility>

#include "carve/polygon_reaches.h"
#include "firma/grid.h"

namespace firma {
namespace {

/// One step asks so many faces, fewer once it has seen so many pairs of face and triangle.
constexpr int kFacesAStep = 16;
constexpr std::uint64_t kPairsAStep = 64;

/// Twice the area, along the normal.
Vec3 area_of(std::span<const Vec3> corners) {
    Vec3 area;
    for (std::size_t k = 2; k < corners.size(); ++k)
        area = area + cross(corners[k - 1] - corners[0], corners[k] - corners[0]);
    return area;
}

/// Keeps of the segment from + t * along, t in [low, high], what has at + t * slope >= 0.
void clip(double at, double slope, double& low, double& high) {
    if (slope > 0) low = std::max(low, -at / slope);
    if (slope < 0) high = std::min(high, -at / slope);
    if (slope == 0 && at < 0) high = low - 1;
}

/// Whether a triangle passes through a convex polygon, in double: nothing but a count depends on it. It cuts the
/// polygon's plane in a segment, of which some part lies within all sides.
bool passes_through(const Vec3 (&triangle)[3], std::span<const Vec3> polygon) {
    const Vec3 normal = area_of(polygon);
    double height[3];
    for (int k = 0; k < 3; ++k) height[k] = dot(normal, triangle[k] - polygon[0]);
    Vec3 ends[2];
    int count = 0;
    for (int k = 0; k < 3; ++k) {
        const int next = (k + 1) % 3;
        const double a = height[k], b = height[next];
        if (a == 0 && count < 2) ends[count++] = triangle[k];
        if (((a < 0 && b > 0) || (a > 0 && b < 0)) && count < 2)
            ends[count++] = triangle[k] + (triangle[next] - triangle[k]) * (a / (a - b));
    }
    const auto [low_height, high_height] = std::minmax({height[0], height[1], height[2]});
    if (!(low_height < 0 && high_height > 0) || count < 2) return false;
    const Vec3 along = ends[1] - ends[0];
    double low = 0, high = 1;
    for (std::size_t k = 0; k < polygon.size(); ++k) {
        const Vec3& corner = polygon[k];
        const Vec3 inward = cross(normal, polygon[k + 1 < polygon.size() ? k + 1 : 0] - corner);
        clip(dot(inward, ends[0] - corner), dot(inward, along), low, high);
    }
    return low < high;
}

}  // namespace

ReachCount::ReachCount(std::vector<FacetPlace> near, const CutterSolid& cutter, std::uint64_t max_pairs)
    : cutter_(cutter), budget_(max_pairs), near_(std::move(near)) {}

bool ReachCount::step() {
    const std::uint64_t before = budget_.taken();
    for (int left = kFacesAStep; left > 0 && budget_.taken() - before < kPairsAStep; --left) {
        if (next_ == near_.size()) return false;
        count_ += reaches(near_[next_++]);
    }
    return next_ < near_.size();
}

bool ReachCount::reaches(const FacetPlace& facet) {
    corners_.clear();
    GridBox box;
    Vec3 middle;
    facet.block->for_each_corner(facet.record(), [&](const GridPoint& p) {
        box.add(p);
        corners_.push_back(Vec3{double(p.x), double(p.y), double(p.z)} * (1.0 / kSurfacePerInput));
        middle = middle + corners_.back();
    });
    middle = middle * (1.0 / double(corners_.size()));
    loop_ = corners_;
    if (!polygon_reaches_into(loop_, cutter_.box)) return false;
    loop_ = corners_;
    if (!polygon_reaches_into(loop_, cutter_.bevelled, 0)) return false;
    if (crosses_cutter(box) || budget_.spent()) return true;
    // The cutter's surface does not meet it: all of it lies inside, or none.
    const InputPoint point{std::int32_t(middle.x), std::int32_t(middle.y), std::int32_t(middle.z)};
    return side_of_cutter(cutter_, ExactPoint(point)) > 0;
}

bool ReachCount::crosses_cutter(const GridBox& box) {
    return cutter_.tree.for_each_meeting(box, [&](std::uint32_t t) {
        if (!budget_.take()) return true;
        Vec3 triangle[3];
        for (std::size_t k = 0; k < 3; ++k) triangle[k] = cutter_.points[cutter_.triangle(t)[k]].approximate();
        return passes_through(triangle, corners_);
    });
}

}  // namespace firma
