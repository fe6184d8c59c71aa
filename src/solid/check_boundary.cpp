// SPDX-License-Identifier: MIT
// Face by face, then edge by edge; the first fault ends it. Where faces are exchanged, what stays is not looked at: an
// edge that none of those faces has is used as it was.
#include "solid/check_boundary.h"

#include <vector>

#include "base/flat_map.h"
#include "base/point_numbers.h"
#include "geometry/exact_loop.h"
#include "geometry/polygon_shape.h"

namespace firma {
namespace {

/// Directed edges that ought to cancel.
class EdgeSum {
public:
    void clear() {
        map_.clear();
        sums_.clear();
    }
    void add(std::uint32_t from, std::uint32_t to, int times) {
        if (from == to) return;
        const std::uint64_t low = from < to ? from : to, high = from < to ? to : from;
        std::uint32_t& known = map_.at(low << 32 | high);
        if (known == FlatMap::kNone) {
            known = std::uint32_t(sums_.size());
            sums_.push_back({std::uint32_t(low), 0});
        }
        sums_[known].sum += from < to ? times : -times;
    }
    /// An end of an edge that does not cancel; ~0: all do.
    std::uint32_t left_over() const {
        for (const Entry& entry : sums_)
            if (entry.sum != 0) return entry.point;
        return ~0u;
    }

private:
    struct Entry {
        std::uint32_t point;
        std::int32_t sum;
    };
    FlatMap map_;
    std::vector<Entry> sums_;
};

class BoundaryChecker {
public:
    explicit BoundaryChecker(const Boundary& boundary)
        : boundary_(boundary), patch_(boundary.patch), uses_(patch_.edges.size()) {}

    std::optional<SolidFault> check() {
        check_faces(std::uint32_t(patch_.faces.size()));
        for (std::uint32_t edge = 0; edge < patch_.edges.size() && !fault_; ++edge) {
            check_uses(edge, uses_[edge]);
            if (!fault_) check_planes(edge);
        }
        // Then all facets together are closed: those of a face have its loops for a rim, and in all loops together each
        // edge, from the rounded point of one vertex to that of another, is there once each way.
        return fault_;
    }

    /// @param first_removed  faces from here on go, those below it come
    std::optional<SolidFault> check_exchange(std::uint32_t first_removed, std::span<const FacetPlace> near) {
        check_faces(first_removed);
        if (fault_) return fault_;
        std::vector<Uses> removed(patch_.edges.size());
        for (std::size_t k = first_removed; k < patch_.faces.size(); ++k)
            for (const PatchUse& use : patch_.uses(patch_.faces[k])) removed[use.edge].add(use);
        std::vector<bool> stays(patch_.edges.size());
        for (const FacetPlace& facet : near) mark_staying(facet, stays);
        for (std::uint32_t edge = 0; edge < patch_.edges.size() && !fault_; ++edge) {
            // Before, it was used once each way: by faces that go, or by some that stay, or by one of each.
            const Uses &added = uses_[edge], &gone = removed[edge];
            const std::uint32_t was_there = gone.any() || stays[edge];
            const Uses after{was_there - gone.forward + added.forward, was_there - gone.back + added.back};
            if (!after.any() && !added.any()) continue;  // it goes with its faces
            check_uses(edge, after);
            if (!fault_ && added.any()) check_planes(edge);
        }
        return fault_;
    }

private:
    struct Uses {
        std::uint32_t forward = 0, back = 0;

        void add(const PatchUse& use) { (use.reversed ? back : forward)++; }
        bool any() const { return forward != 0 || back != 0; }
    };

    void check_faces(std::uint32_t end) {
        rounded_.assign(patch_.vertices.size(), ~0u);
        for (face_ = 0; face_ < end && !fault_; ++face_) {
            check_loops();
            if (!fault_ && !face().stored) check_untouched();
            if (!fault_) check_plane();
            if (!fault_ && face().stored) check_stored(*face().stored);
            if (!fault_) check_facets();
        }
    }

    /// Edges that a face has which is not in the patch: which stay.
    void mark_staying(const FacetPlace& facet, std::vector<bool>& stays) const {
        if (patch_.find(facet) != SolidPatch::kNone) return;
        const auto mark = [&](const std::optional<PatchUse>& use) {
            if (use) stays[use->edge] = true;
        };
        if (const auto* owner = static_cast<const SolidFace*>(facet.block->owner_of(facet.record()))) {
            for (const SolidUse& use : owner->uses) mark(patch_.find(use));
            return;
        }
        const std::size_t corners = facet.record().corner_count;
        for (std::size_t k = 0; k < corners; ++k)
            mark(patch_.find(to_input(facet.block->corner(facet.record(), k)),
                             to_input(facet.block->corner(facet.record(), k + 1 < corners ? k + 1 : 0))));
    }

    const PatchFace& face() const { return patch_.faces[face_]; }

    void report(const char* what, const Vec3& at) {
        if (!fault_) fault_ = {what, face().facet.record().id, at};
    }
    void report_vertex(const char* what, std::uint32_t vertex) {
        report(what, to_metres(patch_.vertices[vertex].point.rounded()));
    }
    void report_point(const char* what, std::uint32_t number) { report(what, to_metres(numbers_.point(number))); }
    Vec3 some_corner() const {
        const FacetPlace& facet = face().facet;
        return to_metres(facet.block->corner(facet.record(), 0));
    }

    void check_loops() {
        const auto uses = patch_.uses(face());
        const auto ends = patch_.ends(face());
        if (ends.empty() || ends.back() != uses.size()) return report("a face without loops", some_corner());
        if (!face().plane || !face().plane->plane.valid()) return report("a face without a plane", some_corner());
        const Plane& plane = face().plane->plane;
        const FlatView view = plane.front_view();
        std::uint32_t first = 0;
        for (const std::uint32_t end : ends) {
            if (end < first || end > uses.size() || end - first < 3)
                return report("a loop of fewer than three edges", some_corner());
            for (std::uint32_t k = first; k < end; ++k) {
                const PatchUse& next = uses[k + 1 < end ? k + 1 : first];
                if (patch_.to(uses[k]) != patch_.from(next)) return report_vertex("a loop is open", patch_.to(uses[k]));
            }
            const auto corner = [&](std::size_t k) -> const ExactPoint& {
                return patch_.vertices[patch_.from(uses[first + k])].point;
            };
            const int turn = surely_turns(end - first, corner, view);
            if (first == 0 && turn < 0)
                return report_vertex("the outer loop runs against the normal", patch_.from(uses[first]));
            if (first != 0 && turn > 0)
                return report_vertex("a hole runs the same way as the outer loop", patch_.from(uses[first]));
            first = end;
        }
    }

    void check_plane() {
        const Plane& plane = face().plane->plane;
        for (const PatchUse& use : patch_.uses(face())) {
            uses_[use.edge].add(use);
            if (!lies_on(plane, patch_.vertices[patch_.from(use)].point))
                return report_vertex("a vertex lies off the plane of its face", patch_.from(use));
        }
    }

    void check_stored(const FaceOwner& owner) {
        const Plane& plane = face().plane->plane;
        if (!(dot(owner.normal, plane.direction()) > 0))
            return report("a face's normal points into the solid", some_corner());
        for (int axis = 0; axis < 3; ++axis)
            if (owner.box.low[axis] > face().box.low[axis] || owner.box.high[axis] < face().box.high[axis])
                return report("a face reaches out of its box", some_corner());
    }

    void check_untouched() {
        const FacetPlace& facet = face().facet;
        for (std::uint32_t k = 0; k < facet.record().corner_count; ++k) {
            const GridPoint corner = facet.block->corner(facet.record(), k);
            if (!on_input_grid(corner))
                return report("a face that no cut touched has a corner off the input grid", to_metres(corner));
        }
    }

    void check_facets() {
        const auto facets = boundary_.facets_of(face_);
        const std::size_t expected = face().stored ? face().stored->facets : 1;
        if (facets.size() != expected) return report("a face has not the facets that it counts", some_corner());
        if (!face().stored) return;  // made of its facet's corners
        inner_.clear();
        add_loops();
        for (const FacetPlace& facet : facets) {
            const FaceRecord& record = facet.record();
            std::uint32_t last = numbers_.number(facet.block->corner(record, record.corner_count - 1u));
            for (std::uint32_t k = 0; k < record.corner_count; ++k) {
                const std::uint32_t next = numbers_.number(facet.block->corner(record, k));
                if (next >= of_face_.size() || of_face_[next] != face_ + 1)
                    return report_point("a facet's corner is no rounded vertex of its face", next);
                inner_.add(last, next, 1);
                last = next;
            }
        }
        if (const std::uint32_t point = inner_.left_over(); point != ~0u)
            report_point("facets do not cover their face", point);
    }
    void add_loops() {
        for (const PatchUse& use : patch_.uses(face())) {
            const std::uint32_t from = rounded_number(patch_.from(use)), to = rounded_number(patch_.to(use));
            if (of_face_.size() < numbers_.count()) of_face_.resize(numbers_.count() + numbers_.count() / 2, 0);
            of_face_[from] = face_ + 1;
            inner_.add(from, to, -1);
        }
    }
    std::uint32_t rounded_number(std::uint32_t vertex) {
        std::uint32_t& known = rounded_[vertex];
        if (known == ~0u) known = numbers_.number(patch_.vertices[vertex].point.rounded());
        return known;
    }

    void check_uses(std::uint32_t index, const Uses& uses) {
        const PatchEdge& edge = patch_.edges[index];
        face_ = edge.face[edge.face[0] == ~0u];
        if (uses.forward != 1 || uses.back != 1)
            report_vertex(
                uses.forward + uses.back == 1 ? "an edge is used once" : "an edge is not used exactly once each way",
                edge.vertex[0]);
    }

    void check_planes(std::uint32_t index) {
        const PatchEdge& edge = patch_.edges[index];
        if (!edge.stored) return;
        if (!edge.plane[0] || !edge.plane[1]) return report_vertex("an edge lacks a plane", edge.vertex[0]);
        if (exact_parallel(edge.plane[0]->plane, edge.plane[1]->plane))
            return report_vertex("an edge's two planes are parallel", edge.vertex[0]);
        for (const std::uint32_t vertex : edge.vertex)
            for (const SolidPlane* plane : edge.plane)
                if (!lies_on(plane->plane, patch_.vertices[vertex].point))
                    return report_vertex("an edge's plane does not hold its vertex", vertex);
    }

    const Boundary& boundary_;
    const SolidPatch& patch_;
    std::uint32_t face_ = 0;
    std::optional<SolidFault> fault_;
    std::vector<Uses> uses_;  ///< of each edge
    PointNumbers numbers_;
    std::vector<std::uint32_t> rounded_;  ///< number of each vertex's rounded point, once it was asked for
    std::vector<std::uint32_t> of_face_;  ///< of each numbered point: 1 + the last face that has it as a vertex
    EdgeSum inner_;
};

}  // namespace

std::optional<SolidFault> check_boundary(const Boundary& boundary) {
    return BoundaryChecker(boundary).check();
}

std::optional<SolidFault> check_exchange(std::vector<FacetPlace> added, std::span<const FacetPlace> removed,
                                         std::span<const FacetPlace> near) {
    Boundary boundary = boundary_of(std::move(added));
    const auto first_removed = std::uint32_t(boundary.patch.faces.size());
    for (const FacetPlace& facet : removed) boundary.patch.add(facet);
    return BoundaryChecker(boundary).check_exchange(first_removed, near);
}

}  // namespace firma
