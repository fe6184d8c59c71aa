// SPDX-License-Identifier: MIT
// Large faces are halved toward a cut before it is made.
#include "carve/tile_faces.h"

#include <algorithm>
#include <cstdlib>
#include <tuple>

#include "base/sort.h"
#include "carve/gather.h"
#include "carve/polygon_reaches.h"
#include "index/box_tree.h"

namespace firma {
namespace {

constexpr int kMostTried = 8;

class Tiler {
public:
    Tiler(const Node* root, const CutterSolid& cutter, std::int32_t steps, SolidPatch& patch)
        : root_(root),
          box_(grown(cutter.box, steps)),
          bevelled_(cutter.bevelled),
          steps_(steps),
          largest_(largest_face(cutter)),
          patch_(patch) {}

    void tile() {
        for (std::uint32_t face = 0; face < patch_.faces.size(); ++face)
            if (too_large(face)) halve(face);  // pieces come at the end, and have their turn
        if (!split_any_) return;
        add_neighbours();
        for (std::uint32_t face = 0; face < patch_.faces.size(); ++face)
            if (!patch_.faces[face].replaced) take_over_splits(face);
    }

private:
    /// Where a loop changes from one side of a plane to the other: at a corner, or within the edge that begins there.
    struct Crossing {
        std::uint32_t corner = 0;  ///< in uses_
        bool at_corner = false;
        bool to_front = false;
        GridPoint place;
        std::uint32_t next = 0;     ///< of the same loop
        std::uint32_t partner = 0;  ///< at the other end of the part of the line that lies in the face
        std::uint32_t vertex = 0;
        PatchUse before, after;  ///< halves of the edge
    };

    bool too_large(std::uint32_t index) {
        const PatchFace& face = patch_.faces[index];
        if (face.loop_count == 0 || face.box.longest_extent() <= largest_ || !boxes_meet(face.box, box_)) return false;
        loop_.clear();
        for (const PatchUse& use : patch_.uses(face).first(patch_.ends(face)[0]))
            loop_.push_back(patch_.vertices[patch_.from(use)].point.approximate());
        return polygon_reaches_into(loop_, box_) && polygon_reaches_into(loop_, bevelled_, steps_);
    }

    /// The face's loops with every split edge as its halves.
    void expand(const PatchFace& face) {
        uses_.clear();
        ends_.clear();
        std::uint32_t k = 0;
        for (const std::uint32_t end : patch_.ends(face)) {
            for (; k < end; ++k) expand(patch_.uses(face)[k]);
            ends_.push_back(std::uint32_t(uses_.size()));
        }
    }
    void expand(const PatchUse& use) {
        const PatchEdge& edge = patch_.edges[use.edge];
        if (!edge.split()) return uses_.push_back(use);
        expand({edge.half[use.reversed], use.reversed});
        expand({edge.half[!use.reversed], use.reversed});
    }

    /// At the roundest place within its middle half: so cuts share what others were divided by, in whichever order.
    void halve(std::uint32_t index) {
        const GridBox box = patch_.faces[index].box;
        const int axis = box.longest_axis();
        const std::int64_t low = box.low[axis], quarter = (std::int64_t(box.high[axis]) - low) / 4;
        const std::int64_t first = (low + quarter) / kSurfacePerInput + 1;
        const std::int64_t last = (low + 3 * quarter) / kSurfacePerInput - 1;
        expand(patch_.faces[index]);
        int left = kMostTried;
        for (int bits = 30; bits >= 0 && left > 0; --bits) {
            const std::int64_t step = std::int64_t(1) << bits;
            for (std::int64_t k = (first + step - 1) >> bits; k << bits <= last && left > 0; ++k) {
                if (k % 2 == 0 && bits < 30) continue;  // rounder yet: tried before
                --left;
                const Ref<const SolidPlane> plane(new SolidPlane(axis_plane(axis, std::int32_t(k << bits))));
                if (divides_in_two(plane->plane)) return divide(index, plane);
            }
        }
    }

    static bool near(const GridPoint& a, const GridPoint& b) {
        for (int axis = 0; axis < 3; ++axis)
            if (std::abs(std::int64_t(a[axis]) - b[axis]) >= kSurfacePerInput) return false;
        return true;
    }

    /// Whether what lies on either side is one piece, and no vertex that the plane makes lies within a step of the
    /// input grid of another one: rounded, such a piece may have no sound facets.
    bool divides_in_two(const Plane& plane) {
        sides_.clear();
        for (const PatchUse& use : uses_) sides_.push_back(exact_side(plane, patch_.vertices[patch_.from(use)].point));
        crossings_.clear();
        std::uint32_t first = 0;
        for (const std::uint32_t end : ends_) {
            if (!cross_loop(plane, first, end)) return false;
            first = end;
        }
        return pair_crossings() && loops_on(true) == 1 && loops_on(false) == 1;
    }

    bool cross_loop(const Plane& plane, std::uint32_t first, std::uint32_t end) {
        const auto first_crossing = std::uint32_t(crossings_.size());
        for (std::uint32_t k = first; k < end; ++k) {
            const int here = sides_[k], there = sides_[k + 1 < end ? k + 1 : first];
            const GridPoint from = patch_.vertices[patch_.from(uses_[k])].point.rounded();
            Crossing made;
            made.corner = k;
            made.to_front = there > 0;
            made.next = std::uint32_t(crossings_.size()) + 1;
            if (here == 0) {
                if (sides_[k > first ? k - 1 : end - 1] * there >= 0) return false;  // it touches the plane there
                made.at_corner = true;
                made.place = from;
            } else if (here * there < 0) {
                patch_.settle_planes(uses_[k].edge);
                const PatchEdge& edge = patch_.edges[uses_[k].edge];
                made.place = ExactPoint(edge.plane[0]->plane, edge.plane[1]->plane, plane).rounded();
                if (near(made.place, from) || near(made.place, patch_.vertices[patch_.to(uses_[k])].point.rounded()))
                    return false;
            } else {
                continue;
            }
            crossings_.push_back(made);
        }
        if (crossings_.size() > first_crossing) crossings_.back().next = first_crossing;
        return true;
    }

    /// Along the line every other part lies in the face.
    bool pair_crossings() {
        GridBox all;
        for (const Crossing& it : crossings_) all.add(it.place);
        if (crossings_.size() < 2) return false;
        const int axis = all.longest_axis();
        order_.clear();
        for (std::uint32_t k = 0; k < crossings_.size(); ++k) order_.push_back(k);
        sort_range(order_, [&](std::uint32_t a, std::uint32_t b) {
            const std::int32_t at_a = crossings_[a].place[axis], at_b = crossings_[b].place[axis];
            return at_a != at_b ? at_a < at_b : a < b;
        });
        for (std::size_t k = 0; k + 1 < order_.size(); ++k)
            if (std::int64_t(crossings_[order_[k + 1]].place[axis]) - crossings_[order_[k]].place[axis] <
                kSurfacePerInput)
                return false;
        for (std::size_t k = 0; k + 1 < order_.size(); k += 2) {
            Crossing &a = crossings_[order_[k]], &b = crossings_[order_[k + 1]];
            if (a.to_front == b.to_front) return false;
            a.partner = order_[k + 1];
            b.partner = order_[k];
        }
        return order_.size() % 2 == 0;
    }

    /// How many loops the parts on one side make, with those of the line.
    int loops_on(bool front) {
        int count = 0;
        seen_.assign(crossings_.size(), false);
        for (std::uint32_t start = 0; start < crossings_.size(); ++start) {
            if (seen_[start] || crossings_[start].to_front != front) continue;
            ++count;
            for (std::uint32_t at = start; !seen_[at]; at = crossings_[crossings_[at].next].partner) seen_[at] = true;
        }
        return count;
    }

    void divide(std::uint32_t index, const Ref<const SolidPlane>& plane) {
        const SolidPlane* across = patch_.keep(plane);
        for (Crossing& it : crossings_) {
            it.after = uses_[it.corner];
            if (it.at_corner) {
                it.vertex = patch_.from(it.after);
            } else {
                std::tie(it.before, it.after) = split_edge(uses_[it.corner], plane);
                it.vertex = patch_.to(it.before);
            }
        }
        inner_.assign(crossings_.size(), 0);
        for (std::uint32_t k = 0; k < crossings_.size(); ++k)
            if (const std::uint32_t partner = crossings_[k].partner; k < partner)
                inner_[k] = inner_[partner] =
                    add_edge(crossings_[k].vertex, crossings_[partner].vertex, patch_.faces[index].plane, across);
        for (const bool front : {false, true}) {
            std::vector<PatchUse> uses;
            std::vector<std::uint32_t> ends;
            add_outline(front, uses);
            ends.push_back(std::uint32_t(uses.size()));
            std::uint32_t first = 0;
            for (const std::uint32_t end : ends_) {
                if (lies_wholly(first, end, front)) {
                    uses.insert(uses.end(), uses_.begin() + first, uses_.begin() + end);
                    ends.push_back(std::uint32_t(uses.size()));
                }
                first = end;
            }
            add_piece(index, uses, ends);
        }
        patch_.faces[index].replaced = true;
    }

    /// Along the loops on one side, and from each to the next along the plane.
    void add_outline(bool front, std::vector<PatchUse>& uses) const {
        std::uint32_t start = 0;
        while (crossings_[start].to_front != front) ++start;
        std::uint32_t at = start;
        do {
            const Crossing &begins = crossings_[at], &ends = crossings_[begins.next];
            uses.push_back(begins.after);
            for (std::uint32_t k = after(begins.corner); k != ends.corner; k = after(k)) uses.push_back(uses_[k]);
            if (!ends.at_corner) uses.push_back(ends.before);
            const std::uint32_t edge = inner_[begins.next];
            uses.push_back({edge, patch_.edges[edge].vertex[0] != ends.vertex});
            at = ends.partner;
        } while (at != start);
    }
    std::uint32_t after(std::uint32_t corner) const {
        std::uint32_t first = 0;
        for (const std::uint32_t end : ends_) {
            if (corner < end) return corner + 1 < end ? corner + 1 : first;
            first = end;
        }
        return 0;
    }
    bool lies_wholly(std::uint32_t first, std::uint32_t end, bool front) const {
        for (std::uint32_t k = first; k < end; ++k)
            if (sides_[k] != (front ? 1 : -1)) return false;
        return true;
    }

    std::uint32_t add_edge(std::uint32_t a, std::uint32_t b, const SolidPlane* p, const SolidPlane* q) {
        PatchEdge edge;
        edge.vertex[0] = a;
        edge.vertex[1] = b;
        edge.plane[0] = p;
        edge.plane[1] = q;
        patch_.edges.push_back(std::move(edge));
        return std::uint32_t(patch_.edges.size()) - 1;
    }

    /// Both halves of an edge that crosses the plane, used the way the whole one was.
    std::pair<PatchUse, PatchUse> split_edge(const PatchUse& use, const Ref<const SolidPlane>& plane) {
        split_any_ = true;
        patch_.settle_planes(use.edge);
        const PatchEdge edge = patch_.edges[use.edge];
        PatchVertex vertex;
        vertex.planes[0] = Ref<const SolidPlane>(edge.plane[0]);
        vertex.planes[1] = Ref<const SolidPlane>(edge.plane[1]);
        vertex.planes[2] = plane;
        vertex.point = ExactPoint(edge.plane[0]->plane, edge.plane[1]->plane, plane->plane);
        const std::uint32_t middle = std::uint32_t(patch_.vertices.size());
        patch_.vertices.push_back(std::move(vertex));
        const std::uint32_t a = add_edge(edge.vertex[0], middle, edge.plane[0], edge.plane[1]);
        const std::uint32_t b = add_edge(middle, edge.vertex[1], edge.plane[0], edge.plane[1]);
        patch_.edges[use.edge].half[0] = a;
        patch_.edges[use.edge].half[1] = b;
        split_.push_back(use.edge);
        if (use.reversed) return {{b, true}, {a, true}};
        return {{a, false}, {b, false}};
    }

    void add_piece(std::uint32_t index, std::span<const PatchUse> uses, std::span<const std::uint32_t> ends) {
        const PatchFace& whole = patch_.faces[index];
        patch_.add_piece(whole.parent == ~0u ? index : whole.parent, uses, ends);
    }

    /// Whoever uses an edge that was split and is not here yet.
    void add_neighbours() {
        std::vector<FacetPlace> found;
        for (std::size_t k = 0; k < split_.size(); ++k) {
            const PatchEdge& edge = patch_.edges[split_[k]];
            GridBox at;
            at.add(patch_.vertices[patch_.edges[edge.half[0]].vertex[1]].point.rounded());
            gather_facets(root_, grown(at, 2), found);
        }
        sort_range(found, [](const FacetPlace& a, const FacetPlace& b) { return a.record().id < b.record().id; });
        for (const FacetPlace& place : found) patch_.add(place);
    }

    /// A face with split edges becomes one with their halves.
    void take_over_splits(std::uint32_t index) {
        const PatchFace face = patch_.faces[index];
        bool any = false;
        for (const PatchUse& use : patch_.uses(face)) any |= patch_.edges[use.edge].split();
        if (!any) return;
        expand(face);
        add_piece(index, uses_, ends_);
        patch_.faces[index].replaced = true;
    }

    const Node* const root_;
    const GridBox box_;
    const BevelledBox& bevelled_;
    const std::int32_t steps_;
    const double largest_;  ///< a face may be so long, metres
    SolidPatch& patch_;
    bool split_any_ = false;
    std::vector<std::uint32_t> split_;
    std::vector<Vec3> loop_;  ///< input steps
    // Of the face at hand:
    std::vector<PatchUse> uses_;
    std::vector<std::uint32_t> ends_;
    std::vector<int> sides_;
    std::vector<Crossing> crossings_;
    std::vector<std::uint32_t> order_, inner_;
    std::vector<bool> seen_;
};

}  // namespace

double largest_face(const CutterSolid& cutter) {
    return std::max(kLargestTile, kLargestInCutters * cutter.box.longest_extent());
}

void tile_faces(const Node* root, const CutterSolid& cutter, std::int32_t steps, SolidPatch& patch) {
    Tiler(root, cutter, steps, patch).tile();
}

KeptPieces keep_pieces(const SolidPatch& patch, std::span<const std::uint32_t> gone) {
    std::vector<bool> goes(patch.faces.size(), false);
    for (const std::uint32_t face : gone) goes[face] = true;
    KeptPieces kept;
    for (std::uint32_t index = 0; index < patch.faces.size(); ++index) {
        const PatchFace& face = patch.faces[index];
        const bool is_piece = face.parent != ~0u;
        if (face.replaced && !is_piece) kept.replaced.push_back(index);
        if (!face.replaced && is_piece && !goes[index]) kept.pieces.push_back(index);
    }
    return kept;
}

}  // namespace firma
