// SPDX-License-Identifier: MIT
// Where a face of the world and the cutter's triangles cross.
#include "carve/cut_faces.h"

#include <algorithm>

#include "carve/gather.h"
#include "carve/sort_along.h"
#include "carve/touch_polygon.h"
#include "geometry/exact_shift.h"

namespace firma {
namespace {

constexpr std::int8_t kUnasked = 2;
/// So many corners of a face are as much work as a pair.
constexpr std::uint64_t kCornersAPair = 64;

std::uint64_t pair_key(std::uint32_t a, std::uint32_t b) {
    return std::uint64_t(a) << 32 | b;
}

}  // namespace

void FaceCutter::start() {
    // Room for as many as a cut usually makes: growing bit by bit writes everything twice.
    const std::size_t usual = std::min<std::size_t>(4 * patch_.faces.size(), 4096);
    made_.points.reserve(usual);
    world_crossings_.reserve(usual / 2);
    cutter_crossings_.reserve(usual / 2);
    made_.points.clear();
    world_crossings_.clear();
    cutter_crossings_.clear();
    made_.met.clear();
    made_.real.clear();
    met_at_.clear();
    made_.segments.clear();
    made_.face_cut.assign(patch_.faces.size(), 0);
}

std::uint32_t FaceCutter::world_crossing(std::uint32_t edge, std::uint32_t triangle) {
    std::uint32_t& known = world_crossings_.at(pair_key(edge, triangle));
    if (known != FlatMap::kNone) return known;
    known = std::uint32_t(made_.points.size());
    const PatchEdge& it = patch_.edges[edge];
    CutPoint crossing;
    crossing.planes[0] = it.plane[0];
    crossing.planes[1] = it.plane[1];
    crossing.planes[2] = cutter_.planes[triangle].get();
    crossing.point = ExactPoint(crossing.planes[0]->plane, crossing.planes[1]->plane, crossing.planes[2]->plane);
    crossing.edge = edge;
    crossing.face = triangle;
    crossing.of_world = true;
    made_.points.push_back(std::move(crossing));
    return known;
}

std::uint32_t FaceCutter::cutter_crossing(std::uint32_t edge, std::uint32_t face) {
    std::uint32_t& known = cutter_crossings_.at(pair_key(edge, face));
    if (known != FlatMap::kNone) return known;
    known = std::uint32_t(made_.points.size());
    const CutterSolid::Edge& it = cutter_.edges[edge];
    CutPoint crossing;
    crossing.planes[0] = it.plane[0].get();
    crossing.planes[1] = it.plane[1].get();
    crossing.planes[2] = patch_.faces[face].plane;
    crossing.point = ExactPoint(crossing.planes[0]->plane, crossing.planes[1]->plane, crossing.planes[2]->plane);
    crossing.edge = edge;
    crossing.face = face;
    made_.points.push_back(std::move(crossing));
    return known;
}

std::uint32_t FaceCutter::new_vertex(std::uint32_t crossing) {
    made_.real.push_back(crossing);
    return std::uint32_t(patch_.vertices.size() + cutter_.points.size() + made_.real.size()) - 1;
}

/// Where solids touch along a line there are several edges, but one vertex where they cross a triangle: loops on it
/// must be able to turn from one to the other.
std::uint32_t FaceCutter::vertex_of(std::uint32_t crossing) {
    CutPoint& it = made_.points[crossing];
    if (it.vertex != ~0u) return it.vertex;
    made_.met.push_back(crossing);
    if (!it.of_world) return it.vertex = new_vertex(crossing);
    for (std::uint64_t key = point_key(it.point.rounded()) + mix_bits(it.face);; key = next_key(key)) {
        std::uint32_t& known = met_at_.at(key);
        if (known == FlatMap::kNone) {
            known = crossing;
            return it.vertex = new_vertex(crossing);
        }
        const CutPoint& other = made_.points[known];
        if (other.face == it.face && exact_side(it.planes[0]->plane, other.point) == 0 &&
            exact_side(it.planes[1]->plane, other.point) == 0)
            return it.vertex = other.vertex;
    }
}

bool FaceCutter::touches_face(const PatchFace& face, const ExactPoint& point) {
    points_.clear();
    budget_.take(patch_.uses(face).size() / kCornersAPair);
    for (const PatchUse& use : patch_.uses(face)) points_.push_back(patch_.vertices[patch_.from(use)].point.rounded());
    return touches_polygon(points_, patch_.ends(face), face.plane->plane, point.rounded());
}

bool FaceCutter::touches_triangle(std::uint32_t triangle, const ExactPoint& point) const {
    GridPoint corners[3];
    for (std::size_t k = 0; k < 3; ++k) corners[k] = cutter_.points[cutter_.triangle(triangle)[k]].rounded();
    const std::uint32_t ends[] = {3};
    return touches_polygon(corners, ends, cutter_.planes[triangle]->plane, point.rounded());
}

int FaceCutter::side_of_face(std::uint32_t vertex, const PatchFace& face) {
    std::int8_t& known = cutter_sides_[vertex];
    if (known != kUnasked) return known;
    const ExactPoint& point = cutter_.points[vertex];
    int side = exact_side(*face_plane_, point);
    if (side == 0) side = touches_face(face, point) ? 0 : shifted_side(*face_plane_);
    known = std::int8_t(side);
    asked_.push_back(vertex);
    return side;
}

int FaceCutter::side_of_triangle(std::uint32_t vertex, std::uint32_t triangle) const {
    const Plane& plane = cutter_.planes[triangle]->plane;
    const ExactPoint& point = patch_.vertices[vertex].point;
    const int side = exact_side(plane, point);
    if (side != 0 || touches_triangle(triangle, point)) return side;
    return -shifted_side(plane);
}

/// As exact_order(); 0 where edges of face and triangle meet.
int FaceCutter::order(const OnLine& a, const OnLine& b, const Plane& triangle) const {
    const int order =
        exact_order(*face_plane_, triangle, made_.points[a.crossing].point, *a.across, made_.points[b.crossing].point);
    if (order != 0 || a.of_face != b.of_face) return order;
    const bool shifts = !a.of_face;
    const int side = shifted_side({a.across, shifts}, {face_plane_, false}, {&triangle, true}, {b.across, shifts});
    return side * exact_turn(*face_plane_, triangle, *a.across);
}

Verdict FaceCutter::cut_face(std::uint32_t index) {
    const PatchFace& face = patch_.faces[index];
    start_face(face);
    Verdict verdict = Verdict::kFine;
    // Exact corners lie within half a step of the rounded ones.
    cutter_.tree.for_each_meeting(grown(face.box, 1), [&](std::uint32_t triangle) {
        if (!budget_.take()) return true;
        verdict = cut_pair(index, triangle);
        return verdict != Verdict::kFine;
    });
    return verdict;
}

/// Forgets only what was asked for the face before: there may be many faces, and a cutter of many vertices.
void FaceCutter::start_face(const PatchFace& face) {
    for (const std::uint32_t vertex : asked_) cutter_sides_[vertex] = kUnasked;
    asked_.clear();
    cutter_sides_.resize(cutter_.points.size(), kUnasked);
    face_plane_ = &face.plane->plane;
}

/// Leaves early as soon as one of the two lies wholly on one side of the other.
Verdict FaceCutter::cut_pair(std::uint32_t index, std::uint32_t triangle) {
    const PatchFace& face = patch_.faces[index];
    const auto& corners = cutter_.triangle(triangle);
    int corner_side[3];
    for (std::size_t k = 0; k < 3; ++k) {
        corner_side[k] = side_of_face(corners[k], face);
        if (corner_side[k] == 0) return Verdict::kDegenerate;
    }
    if (corner_side[0] == corner_side[1] && corner_side[1] == corner_side[2]) return Verdict::kFine;

    const auto uses = patch_.uses(face);
    budget_.take(uses.size() / kCornersAPair);
    face_sides_.clear();
    bool front = false, back = false;
    for (const PatchUse& use : uses) {
        const int side = side_of_triangle(patch_.from(use), triangle);
        if (side == 0) return Verdict::kDegenerate;
        (side > 0 ? front : back) = true;
        face_sides_.push_back(std::int8_t(side));
    }
    if (!front || !back) return Verdict::kFine;

    line_.clear();
    std::size_t loop_start = 0;
    for (const std::uint32_t end : patch_.ends(face)) {
        for (std::size_t k = loop_start; k < end; ++k) {
            const std::size_t next = k + 1 < end ? k + 1 : loop_start;
            if (face_sides_[k] == face_sides_[next]) continue;
            const std::uint32_t edge = uses[k].edge;
            const std::uint32_t crossing = world_crossing(edge, triangle);
            line_.push_back({crossing, &patch_.across(edge, face).plane, true});
        }
        loop_start = end;
    }
    for (int k = 0; k < 3; ++k) {
        if (corner_side[k] == corner_side[(k + 1) % 3]) continue;
        const std::uint32_t edge = cutter_.edge_of(triangle, k);
        line_.push_back({cutter_crossing(edge, index), &cutter_.across(cutter_.edges[edge], triangle).plane, false});
    }
    return emit(index, triangle);
}

/// Orders the points along the line and walks them: where the line is inside both, there is a segment.
Verdict FaceCutter::emit(std::uint32_t face, std::uint32_t triangle) {
    const Plane& t = cutter_.planes[triangle]->plane;
    const auto before = [&](const OnLine& a, const OnLine& b) { return order(a, b, t); };
    if (!sort_along(line_.begin(), line_.end(), before)) return Verdict::kDegenerate;
    bool in_face = false, in_triangle = false;
    const OnLine* last = nullptr;
    for (const OnLine& here : line_) {
        if (in_face && in_triangle) {
            const std::uint32_t from = vertex_of(last->crossing);
            made_.segments.push_back({face, triangle, from, vertex_of(here.crossing)});
            made_.face_cut[face] = 1;
        }
        (here.of_face ? in_face : in_triangle) ^= true;
        last = &here;
    }
    return in_face || in_triangle ? Verdict::kBroken : Verdict::kFine;
}

}  // namespace firma
