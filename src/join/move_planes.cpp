// SPDX-License-Identifier: MIT
// Planes moved a little where they make faces too thin for the surface grid.
#include "join/move_planes.h"

#include <algorithm>
#include <cmath>

#include "base/random.h"

namespace firma {
namespace {

constexpr std::int32_t kFarthest = 2;  ///< input steps that a plane is moved by at most
constexpr double kAlike = 2;  ///< input steps that a brush's corner may be off a plane that takes another's place
constexpr double kClose = 8;  ///< surface steps: corners nearer to each other than this are to blame

bool is_axial(const Plane& plane) {
    return (plane.normal[0] != 0) + (plane.normal[1] != 0) + (plane.normal[2] != 0) == 1;
}

Plane plane_of(const BrushSide& side) {
    return plane_through(to_input(side.points[0]), to_input(side.points[1]), to_input(side.points[2]));
}

bool close(const GridPoint& a, const GridPoint& b) {
    for (int axis = 0; axis < 3; ++axis) {
        const double apart = double(a[axis]) - double(b[axis]);
        if (apart > kClose || apart < -kClose) return false;
    }
    return true;
}

double facing(const Plane& a, const Plane& b) {
    return dot(a.direction(), b.direction());
}

}  // namespace

PlaneMover::PlaneMover(const BrushLevel& level, JoinTables& tables) : level_(level), tables_(tables) {
    for (const BrushSide& side : level.sides) plane_of_side_.push_back(tables.planes.add(plane_of(side)));
}

/// The planes of corners that lie close together; when none do, of the outline and its sides. What is parallel to two
/// axes is left alone: such planes are as their author meant them.
void PlaneMover::find_candidates(const Outline& outline) {
    candidates_.clear();
    const PointTable& points = tables_.points;
    const auto add = [&](std::uint32_t corner) {
        if (points.point(corner).on_grid()) return;
        for (int k = 0; k < 3; ++k) candidates_.push_back(points.plane(corner, k) & ~1u);
    };
    const std::vector<std::uint32_t>& corners = outline.corners;
    for (std::size_t a = 0; a < corners.size(); ++a)
        for (std::size_t b = a + 1; b < corners.size(); ++b)
            if (close(points.point(corners[a]).rounded(), points.point(corners[b]).rounded())) {
                add(corners[a]);
                add(corners[b]);
            }
    if (candidates_.empty()) {
        candidates_.push_back(outline.plane & ~1u);
        for (const std::uint32_t corner : corners) add(corner);
    }
    std::sort(candidates_.begin(), candidates_.end());
    candidates_.erase(std::unique(candidates_.begin(), candidates_.end()), candidates_.end());
    std::erase_if(candidates_,
                  [&](PlaneId id) { return id / 2 >= side_of_plane_.size() || side_of_plane_[id / 2] == ~0u; });
    axial_.clear();
    for (const PlaneId id : candidates_)
        if (is_axial(tables_.planes.plane(id))) axial_.push_back(id);
    std::erase_if(candidates_, [&](PlaneId id) { return is_axial(tables_.planes.plane(id)); });
}

/// Whether a brush lies between one of its planes and another: as one they would leave nothing of it.
bool PlaneMover::bounded_by_both(const BrushShape& shape, PlaneId one, PlaneId other) const {
    for (const BrushShape::Face& face : shape.faces)
        if (same_plane(face.piece.plane, other) &&
            facing(tables_.planes.plane(face.piece.plane), tables_.planes.plane(one)) < 0)
            return true;
    return false;
}

/// Another of the outline's planes that could take the place of this one: no corner of a face in it is far from that.
PlaneId PlaneMover::near_candidate(PlaneId plane, std::span<const BrushShape> shapes) const {
    for (const auto* list : {&axial_, &candidates_})
        for (const PlaneId other : *list) {
            if (other >= plane && list == &candidates_) continue;  // one of two is to stay
            const Plane& it = tables_.planes.plane(other);
            const double size = length(it.direction());
            bool near = true;
            for (std::size_t s = 0; s < shapes.size() && near; ++s)
                for (const BrushShape::Face& face : shapes[s].faces) {
                    if (!same_plane(face.piece.plane, plane)) continue;
                    near = near && !bounded_by_both(shapes[s], face.piece.plane, other);
                    for (const PieceSide& side : face.piece.sides) {
                        const Vec3& p = tables_.points.point(side.corner).approximate();
                        const double off = (dot(it.direction(), p) + it.d) / size;
                        near = near && std::fabs(off) <= kAlike;
                    }
                }
            if (near) return other;
        }
    return kNoPlane;
}

/// @param is  or the same from behind: whichever looks the same way
void PlaneMover::replace(PlaneId was, PlaneId is) {
    const Plane &p = tables_.planes.plane(was), &q = tables_.planes.plane(is);
    if (facing(p, q) < 0) is = from_behind(is);
    for (PlaneId& other : plane_of_side_)
        if (same_plane(other, was)) other = other == was ? is : from_behind(is);
    ++moved_;
}

/// Along its dominant axis, and parallel to itself: turned a little, it would be far off at the far end of a long face.
void PlaneMover::move_plane(PlaneId plane) {
    const std::uint32_t first = side_of_plane_[plane / 2];
    BrushSide side = level_.sides[first];
    const std::uint64_t random = mix_bits(std::uint64_t(first) << 16 | rounds_);
    std::int32_t steps = std::int32_t(random % (2 * kFarthest)) - kFarthest;
    steps += steps >= 0;
    const int axis = tables_.planes.plane(plane).dominant_axis();
    for (GridPoint& point : side.points) {
        const std::int64_t moved = std::int64_t(point[axis]) + steps * kSurfacePerInput;
        if (moved < INT32_MIN || moved > INT32_MAX) return;
        point[axis] = std::int32_t(moved);
    }
    replace(plane, tables_.planes.add(plane_of(side)));
}

std::vector<bool> PlaneMover::move(std::span<const Outline> outlines, std::span<const BrushShape> shapes) {
    ++rounds_;
    side_of_plane_.assign(tables_.planes.size(), ~0u);
    for (std::size_t side = plane_of_side_.size(); side-- > 0;)
        side_of_plane_[plane_of_side_[side] / 2] = std::uint32_t(side);
    std::vector<bool> helped;
    std::vector<PlaneId> changed;
    for (const Outline& outline : outlines) {
        find_candidates(outline);
        helped.push_back(!candidates_.empty());
        const auto done = [&](PlaneId id) { return std::find(changed.begin(), changed.end(), id) != changed.end(); };
        if (candidates_.empty() || std::any_of(candidates_.begin(), candidates_.end(), done)) continue;
        PlaneId one = kNoPlane, instead = kNoPlane;
        for (std::size_t k = candidates_.size(); k-- > 0 && instead == kNoPlane;)
            instead = near_candidate(one = candidates_[k], shapes);
        if (instead == kNoPlane)
            one = candidates_[mix_bits(candidates_[0] + std::uint64_t(rounds_) * 977) % candidates_.size()];
        changed.push_back(one);
        if (instead == kNoPlane)
            move_plane(one);
        else
            replace(one, instead);
    }
    return helped;
}

}  // namespace firma
