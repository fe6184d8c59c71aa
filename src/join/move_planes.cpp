// SPDX-License-Identifier: MIT
// Planes moved a little where they make faces too thin for the surface grid.
#include "join/move_planes.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/random.h"

namespace firma {
namespace {

constexpr std::uint32_t kNoSide = ~0u;
constexpr std::int32_t kFarthest = 2;  ///< input steps that a plane is moved by at most
constexpr double kAlike = 2;  ///< input steps that a brush's corner may be off a plane that takes another's place
constexpr double kClose = 8;  ///< surface steps: corners nearer to each other than this are to blame

bool is_axial(const Plane& plane) {
    return (plane.normal[0] != 0) + (plane.normal[1] != 0) + (plane.normal[2] != 0) == 1;
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

PlaneMover::PlaneMover(const BrushLevel& level, ExactTables& tables) : level_(level), tables_(tables) {
    grow();
}

void PlaneMover::grow() {
    for (auto side = std::uint32_t(plane_of_side_.size()); side < level_.sides.size(); ++side) {
        const PlaneId plane = add_plane(std::to_array(level_.sides[side].points));
        auto& [any, lowest] = sides_of_plane_[plane / 2];
        plane_as_read_.push_back(plane);
        plane_of_side_.push_back(plane);
        next_side_.push_back(any);
        any = side;
        lowest = std::min(lowest, side);
    }
}

PlaneId PlaneMover::add_plane(const std::array<GridPoint, 3>& points) {
    const PlaneId id = tables_.planes.add(plane_through(to_input(points[0]), to_input(points[1]), to_input(points[2])));
    if (id / 2 >= points_of_plane_.size()) {
        points_of_plane_.resize(id / 2 + 1);
        sides_of_plane_.resize(id / 2 + 1);
    }
    PlanePoints& known = points_of_plane_[id / 2];
    if (known.plane == kNoPlane) known = {id, points};
    return id;
}

std::array<GridPoint, 3> PlaneMover::points_of_side(std::uint32_t side) const {
    const PlaneId id = plane_of_side_[side];
    const auto& [plane, points] = points_of_plane_[id / 2];
    if (plane == id) return points;
    return {points[0], points[2], points[1]};
}

void PlaneMover::list_shapes(std::span<const BrushShape> shapes) {
    first_shape_.assign(tables_.planes.size() + 1, 0);
    for (const BrushShape& shape : shapes)
        for (const BrushShape::Face& face : shape.faces) ++first_shape_[face.piece.plane / 2];
    std::uint32_t end = 0;
    for (std::uint32_t& first : first_shape_) end += std::exchange(first, end + first);
    shapes_of_plane_.resize(end);
    for (std::size_t s = shapes.size(); s-- > 0;)
        for (const BrushShape::Face& face : shapes[s].faces)
            shapes_of_plane_[--first_shape_[face.piece.plane / 2]] = std::uint32_t(s);
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
    std::erase_if(candidates_, [&](PlaneId id) {  // planes of no side
        if (id / 2 >= sides_of_plane_.size()) return true;
        return sides_of_plane_[id / 2].any == kNoSide && !changed_[id / 2];
    });
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
            for (std::uint32_t s = first_shape_[plane / 2]; s < first_shape_[plane / 2 + 1] && near; ++s) {
                const BrushShape& shape = shapes[shapes_of_plane_[s]];
                for (const BrushShape::Face& face : shape.faces) {
                    if (!same_plane(face.piece.plane, plane)) continue;
                    near = near && !bounded_by_both(shape, face.piece.plane, other);
                    for (const PieceSide& side : face.piece.sides) {
                        const Vec3& p = tables_.points.point(side.corner).approximate();
                        const double off = (dot(it.direction(), p) + it.d) / size;
                        near = near && std::fabs(off) <= kAlike;
                    }
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
    ++moved_;
    if (same_plane(was, is)) return;  // moved back to where it was: another round moves it elsewhere
    SidesOfPlane &from = sides_of_plane_[was / 2], &to = sides_of_plane_[is / 2];
    while (from.any != kNoSide) {
        const std::uint32_t side = from.any;
        PlaneId& plane = plane_of_side_[side];
        plane = plane == was ? is : from_behind(is);
        moved_sides_.push_back(side);
        from.any = next_side_[side];
        next_side_[side] = to.any;
        to.any = side;
    }
    to.lowest = std::min(to.lowest, std::exchange(from.lowest, kNoSide));
}

/// Along its dominant axis, and parallel to itself: turned a little, it would be far off at the far end of a long face.
void PlaneMover::move_plane(PlaneId plane) {
    const std::uint32_t first = sides_of_plane_[plane / 2].lowest;
    std::array<GridPoint, 3> points = std::to_array(level_.sides[first].points);
    const std::uint64_t random = mix_bits(std::uint64_t(first) << 16 | rounds_);
    std::int32_t steps = std::int32_t(random % (2 * kFarthest)) - kFarthest;
    steps += steps >= 0;
    const int axis = tables_.planes.plane(plane).dominant_axis();
    for (GridPoint& point : points) {
        const std::int64_t moved = std::int64_t(point[axis]) + steps * kSurfacePerInput;
        if (moved < INT32_MIN || moved > INT32_MAX) return;
        point[axis] = std::int32_t(moved);
    }
    replace(plane, add_plane(points));
}

std::vector<bool> PlaneMover::move(std::span<const Outline> outlines, std::span<const BrushShape> shapes) {
    ++rounds_;
    moved_sides_.clear();
    list_shapes(shapes);
    changed_.assign(tables_.planes.size(), false);
    std::vector<bool> helped;
    for (const Outline& outline : outlines) {
        find_candidates(outline);
        helped.push_back(!candidates_.empty());
        const auto done = [&](PlaneId id) { return id / 2 < changed_.size() && changed_[id / 2]; };
        if (candidates_.empty() || std::any_of(candidates_.begin(), candidates_.end(), done)) continue;
        PlaneId one = kNoPlane, instead = kNoPlane;
        for (std::size_t k = candidates_.size(); k-- > 0 && instead == kNoPlane;)
            instead = near_candidate(one = candidates_[k], shapes);
        if (instead == kNoPlane)
            one = candidates_[mix_bits(candidates_[0] + std::uint64_t(rounds_) * 977) % candidates_.size()];
        changed_[one / 2] = true;
        if (instead == kNoPlane)
            move_plane(one);
        else
            replace(one, instead);
    }
    return helped;
}

}  // namespace firma
