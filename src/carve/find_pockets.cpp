// SPDX-License-Identifier: MIT
// What a cut opens, piece by connected piece.
#include "carve/find_pockets.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "base/disjoint_sets.h"
#include "carve/exact_ray.h"
#include "carve/point_within.h"

namespace firma {
namespace {

class PocketFinder {
public:
    PocketFinder(const CutView& view, const NewLoops& loops)
        : view_(view), loops_(loops), sets_(loops.faces.size() + loops.taken.size()) {}

    Pockets find() {
        join_at_edges();
        Pockets pockets = number_shells();
        if (pockets.count > 1) join_cavities(pockets);
        return pockets;
    }

private:
    /// A box around corners' approximate().
    struct Corners {
        Vec3 low{INFINITY, INFINITY, INFINITY}, high{-INFINITY, -INFINITY, -INFINITY};

        void add(const Vec3& p) {
            for (int axis = 0; axis < 3; ++axis) {
                low[axis] = std::min(low[axis], p[axis]);
                high[axis] = std::max(high[axis], p[axis]);
            }
        }
    };
    struct Shell {
        double volume = 0;  ///< cubic input steps, of the pocket: below zero where it lies around the shell
        GridBox box;
        std::vector<std::uint32_t> faces;
        std::vector<Corners> corners;  ///< of each
    };

    std::size_t count() const { return loops_.faces.size() + loops_.taken.size(); }
    bool is_taken(std::size_t k) const { return k >= loops_.faces.size(); }
    const NewFace& face(std::size_t k) const {
        return is_taken(k) ? loops_.taken[k - loops_.faces.size()] : loops_.faces[k];
    }
    /// Whether a face bounds what was taken: pieces of faces that stay do not.
    bool bounds(std::size_t k) const { return is_taken(k) || loops_.faces[k].triangle != ~0u; }

    void join_at_edges() {
        std::vector<std::uint32_t> first(view_.edge_count(), Pockets::kNone);
        for (std::uint32_t k = 0; k < count(); ++k) {
            if (!bounds(k)) continue;
            for (const PatchUse& use : loops_.uses(face(k))) {
                std::uint32_t& known = first[use.edge];
                if (known == Pockets::kNone)
                    known = k;
                else
                    sets_.join(known, k);
            }
        }
    }

    Pockets number_shells() {
        Pockets pockets;
        std::vector<std::uint32_t> number(count(), Pockets::kNone);
        for (std::uint32_t k = 0; k < count(); ++k) {
            if (!bounds(k)) continue;
            std::uint32_t& known = number[sets_.find(k)];
            if (known == Pockets::kNone) known = pockets.count++;
            number[k] = known;
        }
        const auto taken = number.begin() + std::ptrdiff_t(loops_.faces.size());
        pockets.of_face.assign(number.begin(), taken);
        pockets.of_taken.assign(taken, number.end());
        return pockets;
    }

    void join_cavities(Pockets& pockets) const {
        std::vector<Shell> shells(pockets.count);
        const Vec3 middle = view_.point(view_.from(loops_.uses(face(first_bounding()))[0])).approximate();
        for (std::uint32_t k = 0; k < count(); ++k)
            if (bounds(k)) add_face(k, middle, shells[shell_of(pockets, k)]);
        std::vector<std::uint32_t> into(pockets.count);
        std::uint32_t outer = 0;
        for (std::uint32_t k = 0; k < shells.size(); ++k) {
            into[k] = k;
            outer += shells[k].volume > 0;
        }
        if (outer == pockets.count) return;
        for (std::uint32_t k = 0; k < shells.size(); ++k)
            if (!(shells[k].volume > 0)) into[k] = around(shells, k);
        renumber(pockets, into);
    }

    std::uint32_t first_bounding() const {
        std::uint32_t k = 0;
        while (!bounds(k)) ++k;
        return k;
    }
    std::uint32_t shell_of(const Pockets& pockets, std::size_t k) const {
        return is_taken(k) ? pockets.of_taken[k - loops_.faces.size()] : pockets.of_face[k];
    }

    /// Faces of the cutter look into the pocket, those taken out of it.
    void add_face(std::uint32_t k, const Vec3& middle, Shell& shell) const {
        shell.faces.push_back(k);
        const NewFace& it = face(k);
        Corners& corners = shell.corners.emplace_back();
        Vec3 area{0, 0, 0};
        std::uint32_t first = 0;
        const auto uses = loops_.uses(it);
        for (const std::uint32_t end : loops_.ends(it)) {
            for (std::uint32_t c = first; c < end; ++c) {
                const Vec3 a = view_.point(view_.from(uses[c])).approximate() - middle;
                const Vec3 b = view_.point(view_.to(uses[c])).approximate() - middle;
                area = area + cross(a, b);
                shell.box.add(view_.point(view_.from(uses[c])).rounded());
                corners.add(view_.point(view_.from(uses[c])).approximate());
            }
            first = end;
        }
        const double cone = dot(view_.point(view_.from(uses[0])).approximate() - middle, area) / 6;
        shell.volume += is_taken(k) ? cone : -cone;
    }

    /// The smallest pocket around a shell that is turned inward; itself where none is.
    std::uint32_t around(const std::vector<Shell>& shells, std::uint32_t cavity) const {
        std::uint32_t best = cavity;
        for (std::uint32_t k = 0; k < shells.size(); ++k) {
            if (!(shells[k].volume > 0) || !boxes_meet(shells[k].box, shells[cavity].box)) continue;
            if (best != cavity && shells[best].volume <= shells[k].volume) continue;
            if (encloses(shells[k], shells[cavity])) best = k;
        }
        return best;
    }

    /// By corners of the cavity, then by points within its faces: where it touches the shell, some lie on it.
    bool encloses(const Shell& shell, const Shell& cavity) const {
        for (const std::uint32_t k : cavity.faces)
            if (const int side = side_of(shell, view_.point(view_.from(loops_.uses(face(k))[0]))); side != 0)
                return side > 0;
        WithinFinder within;
        std::vector<ExactPoint> corners;
        for (const std::uint32_t k : cavity.faces) {
            corners.clear();
            for (const PatchUse& use : loops_.uses(face(k))) corners.push_back(view_.point(view_.from(use)));
            const std::optional<ExactPoint> point = within.find(face(k).plane->plane, corners, loops_.ends(face(k)));
            if (!point) continue;
            if (const int side = side_of(shell, *point); side != 0) return side > 0;
        }
        return false;
    }

    /// Whether a point lies in a shell: 1, or outside: -1; 0 on it.
    int side_of(const Shell& shell, const ExactPoint& point) const {
        constexpr double kFar = 1e18;  // input steps
        std::vector<ExactRay::Edge> edges;
        for (int way = 0; way < ExactRay::kWays; ++way) {
            const ExactRay ray(point, way);
            CrossingCount crossings;
            for (std::size_t at = 0; at < shell.faces.size(); ++at) {
                if (!ray.may_meet(shell.corners[at].low, shell.corners[at].high)) continue;
                const std::uint32_t k = shell.faces[at];
                edges.clear();
                append_edges(face(k), edges);
                if (!crossings.add(ray.meet(face(k).plane->plane, edges, kFar))) break;
            }
            if (crossings.begins_on_one()) return 0;
            if (crossings.sure()) return crossings.odd() ? 1 : -1;
        }
        return 0;
    }

    void append_edges(const NewFace& of, std::vector<ExactRay::Edge>& edges) const {
        for (const PatchUse& use : loops_.uses(of))
            edges.push_back({&view_.point(view_.from(use)), &view_.point(view_.to(use)), &across(use.edge, of)});
    }

    const Plane& across(std::uint32_t edge, const NewFace& of) const {
        const SolidPlane* const* planes =
            edge < view_.first_new_edge() ? view_.patch().edges[edge].plane : view_.new_edge(edge).plane;
        return planes[exact_parallel(planes[0]->plane, of.plane->plane)]->plane;
    }

    static void renumber(Pockets& pockets, const std::vector<std::uint32_t>& into) {
        std::vector<std::uint32_t> number(into.size(), Pockets::kNone);
        std::uint32_t next = 0;
        for (std::uint32_t k = 0; k < into.size(); ++k)
            if (into[k] == k) number[k] = next++;
        for (std::vector<std::uint32_t>* all : {&pockets.of_face, &pockets.of_taken})
            for (std::uint32_t& pocket : *all)
                if (pocket != Pockets::kNone) pocket = number[into[pocket]];
        pockets.count = next;
    }

    const CutView& view_;
    const NewLoops& loops_;
    DisjointSets sets_;
};

}  // namespace

Pockets find_pockets(const CutView& view, const NewLoops& loops) {
    return PocketFinder(view, loops).find();
}

}  // namespace firma
