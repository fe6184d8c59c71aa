// SPDX-License-Identifier: MIT
// A side and what is in front of it and behind it is a prism: faces that look against the side are clipped to it.
#include "moving/touch_sides.h"

#include <algorithm>
#include <cmath>

#include "base/hasher.h"

namespace firma {
namespace {

/// Of the product of both normals: a face looks against a side from 120 degrees on. Of a box, each normal does so
/// against one of its sides.
constexpr double kAgainst = -0.5;
/// Square metres: less is a touch along an edge, or rounding.
constexpr double kMinTouch = 1e-6;

/// What of a polygon is not in front of a plane.
void clip_to_plane(std::vector<Vec3>& polygon, const Vec3& normal, double limit, std::vector<Vec3>& left) {
    left.clear();
    const auto height = [&](const Vec3& p) { return dot(p, normal) - limit; };
    for (std::size_t k = 0; k < polygon.size(); ++k) {
        const Vec3 &a = polygon[k], &b = polygon[k + 1 < polygon.size() ? k + 1 : 0];
        const double from = height(a), to = height(b);
        if (from <= 0) left.push_back(a);
        if ((from < 0 && to > 0) || (from > 0 && to < 0)) left.push_back(a + (b - a) * (from / (from - to)));
    }
    polygon.swap(left);
}

double area_of(const std::vector<Vec3>& polygon) {
    Vec3 sum;
    for (std::size_t k = 1; k + 1 < polygon.size(); ++k)
        sum += cross(polygon[k] - polygon[0], polygon[k + 1] - polygon[0]);
    return 0.5 * length(sum);
}

/// Seen from the first corner of a side, so that nothing is lost far from the origin.
class SidePrism {
public:
    SidePrism(const SupportSide& side, double reach, double behind)
        : side_(side),
          reach_(reach),
          behind_(std::max(side.depth, behind)),
          box_(box_of_sides({&side, 1}, reach, behind)) {
        const std::size_t count = side.corners.size();
        for (std::size_t k = 0; k < count; ++k) {
            const Vec3 edge = side.corners[k + 1 < count ? k + 1 : 0] - side.corners[k];
            const Vec3 out = cross(edge, side.normal);
            if (length(out) > 0) walls_.push_back({out, dot(out, side.corners[k] - side.corners[0])});
        }
    }

    const Box& box() const { return box_; }

    /// The part of a face that lies in it.
    bool clip_face(const FaceView& face, TouchedPart& part) {
        if (!(dot(face.normal, side_.normal) < kAgainst)) return false;
        const Vec3& first = side_.corners[0];
        part.corners.clear();
        for (const Vec3& corner : face.corners) part.corners.push_back(corner - first);
        clip_to_plane(part.corners, side_.normal, reach_, left_);
        clip_to_plane(part.corners, -side_.normal, behind_, left_);
        for (const Wall& wall : walls_) clip_to_plane(part.corners, wall.out, wall.limit, left_);
        part.area = area_of(part.corners);
        if (!(part.area >= kMinTouch)) return false;
        part.lowest = INFINITY;
        for (Vec3& corner : part.corners) {
            part.lowest = std::min(part.lowest, dot(corner, side_.normal));
            corner = corner + first;
        }
        return true;
    }

private:
    struct Wall {
        Vec3 out;
        double limit;
    };

    const SupportSide& side_;
    const double reach_, behind_;
    const Box box_;
    std::vector<Wall> walls_;
    std::vector<Vec3> left_;
};

std::uint64_t hash_of(const FaceView& face) {
    Hasher hash;
    hash.add(face.id.value, face.source);
    hash.add(face.source_edit, face.material);
    hash.add(face.mask, std::uint32_t(face.two_sided) | std::uint32_t(face.solid) << 1);
    for (const Vec3& corner : face.corners)
        for (int axis = 0; axis < 3; ++axis) hash.add(corner[axis]);
    return hash.value();
}

}  // namespace

std::vector<SupportSide> sides_of_box(const Box& box) {
    std::vector<SupportSide> sides;
    for (int axis = 0; axis < 3; ++axis)
        for (const bool high : {false, true}) {
            const int u = (axis + 1) % 3, v = (axis + 2) % 3;
            SupportSide side;
            for (int k = 0; k < 4; ++k) {
                Vec3 corner;
                corner[axis] = high ? box.high[axis] : box.low[axis];
                // Around the axis, or back.
                const bool first = k == 1 || k == 2, second = k >= 2;
                corner[u] = (high ? first : second) ? box.high[u] : box.low[u];
                corner[v] = (high ? second : first) ? box.high[v] : box.low[v];
                side.corners.push_back(corner);
            }
            side.normal[axis] = high ? 1 : -1;
            side.depth = 0.5 * (box.high[axis] - box.low[axis]);
            sides.push_back(std::move(side));
        }
    return sides;
}

Box box_of_sides(std::span<const SupportSide> sides, double reach, double behind) {
    Box box;
    for (const SupportSide& side : sides)
        for (const Vec3& corner : side.corners) {
            box.add(corner + side.normal * reach);
            box.add(corner - side.normal * std::max(side.depth, behind));
        }
    return box;
}

std::vector<TouchedPart> touched_parts(const World& world, std::span<const SupportSide> sides, double reach,
                                       double behind, std::uint32_t mask) {
    std::vector<TouchedPart> all;
    TouchedPart part;
    for (const SupportSide& side : sides) {
        SidePrism prism(side, reach, behind);
        const std::size_t first = all.size();
        each_face(world, prism.box(), [&](const FaceView& face) {
            if ((face.mask & mask) != 0 && prism.clip_face(face, part)) {
                part.face = face.ref();
                part.hash = hash_of(face);
                all.push_back(part);
            }
            return true;
        });
        std::sort(all.begin() + std::ptrdiff_t(first), all.end(), [](const TouchedPart& a, const TouchedPart& b) {
            return a.face.id != b.face.id ? a.face.id < b.face.id : a.hash < b.hash;
        });
    }
    return all;
}

}  // namespace firma
