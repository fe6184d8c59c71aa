// SPDX-License-Identifier: MIT
// Large faces are halved toward a cut before it is made.
#include "carve/tile_faces.h"

#include <algorithm>
#include <cstdlib>

#include "base/sort.h"
#include "carve/gather.h"
#include "carve/polygon_reaches.h"
#include "index/box_tree.h"

namespace firma {
namespace {

/// The axis along which a box is longest, and how long it is there.
std::pair<int, double> longest_axis(const GridBox& box) {
    int best = 0;
    for (int axis = 1; axis < 3; ++axis)
        if (box.extent(axis) > box.extent(best)) best = axis;
    return {best, box.extent(best)};
}

class Tiler {
public:
    Tiler(const Node* root, const CutterSolid& cutter, std::int32_t steps, SolidPatch& patch)
        : root_(root), box_(grown(cutter.box, steps)), bevelled_(cutter.bevelled), steps_(steps), patch_(patch) {}

    void tile() {
        for (std::uint32_t face = 0; face < patch_.faces.size(); ++face)
            if (too_large(face)) halve(face);  // pieces come at the end, and have their turn
        if (!split_any_) return;
        add_neighbours();
        for (std::uint32_t face = 0; face < patch_.faces.size(); ++face)
            if (!patch_.faces[face].replaced) take_over_splits(face);
    }

private:
    bool too_large(std::uint32_t index) {
        const PatchFace& face = patch_.faces[index];
        if (face.loop_count != 1 || longest_axis(face.box).second <= kLargestTile || !boxes_meet(face.box, box_))
            return false;
        loop_.clear();
        for (const PatchUse& use : patch_.uses(face))
            loop_.push_back(patch_.vertices[patch_.from(use)].point.approximate());
        return polygon_reaches_into(loop_, box_) && polygon_reaches_into(loop_, bevelled_, steps_);
    }

    /// The face's loop with every split edge as its halves.
    void expand(const PatchFace& face, std::vector<PatchUse>& uses) const {
        uses.clear();
        for (const PatchUse& use : patch_.uses(face)) expand(use, uses);
    }
    void expand(const PatchUse& use, std::vector<PatchUse>& uses) const {
        const PatchEdge& edge = patch_.edges[use.edge];
        if (!edge.split()) return uses.push_back(use);
        expand({edge.half[use.reversed], use.reversed}, uses);
        expand({edge.half[!use.reversed], use.reversed}, uses);
    }

    void halve(std::uint32_t index) {
        const GridBox box = patch_.faces[index].box;
        const int axis = longest_axis(box).first;
        const std::int64_t middle = (std::int64_t(box.low[axis]) + box.high[axis]) / 2;
        const std::int64_t step = (std::int64_t(box.high[axis]) - box.low[axis]) / 16;
        expand(patch_.faces[index], uses_);
        for (const int steps : {0, 1, -1, 2, -2}) {
            const auto at = std::int32_t((middle + steps * step) / kSurfacePerInput);
            const Ref<const SolidPlane> plane(new SolidPlane(axis_plane(axis, at)));
            sides_.clear();
            for (const PatchUse& use : uses_)
                sides_.push_back(exact_side(plane->plane, patch_.vertices[patch_.from(use)].point));
            if (sign_changes() == 2 && !crowds(plane->plane)) return divide(index, plane);
        }
    }

    static bool near(const GridPoint& a, const GridPoint& b) {
        for (int axis = 0; axis < 3; ++axis)
            if (std::abs(std::int64_t(a[axis]) - b[axis]) >= kSurfacePerInput) return false;
        return true;
    }

    /// Whether a vertex that the plane makes would lie within a step of the input grid of another one: rounded, such a
    /// piece may have no sound facets, wherever the cutter is moved.
    bool crowds(const Plane& plane) {
        std::vector<GridPoint> made;
        for (std::size_t k = 0; k < uses_.size(); ++k) {
            const int here = sides_[k], there = sides_[(k + 1) % sides_.size()];
            const GridPoint from = patch_.vertices[patch_.from(uses_[k])].point.rounded();
            if (here == 0) made.push_back(from);
            if (here * there >= 0) continue;
            patch_.settle_planes(uses_[k].edge);
            const PatchEdge& edge = patch_.edges[uses_[k].edge];
            const GridPoint point = ExactPoint(edge.plane[0]->plane, edge.plane[1]->plane, plane).rounded();
            if (near(point, from) || near(point, patch_.vertices[patch_.to(uses_[k])].point.rounded())) return true;
            made.push_back(point);
        }
        return made.size() == 2 && near(made[0], made[1]);
    }

    int sign_changes() const {
        int last = 0, changes = 0;
        for (std::size_t k = 0; k < 2 * sides_.size(); ++k) {  // once around to find a sign, once to count
            const int side = sides_[k % sides_.size()];
            if (side == 0) continue;
            if (k >= sides_.size() && side != last) ++changes;
            last = side;
        }
        return changes;
    }

    /// Goes around, from corner to corner: where the side changes, a piece ends and the other goes on.
    void divide(std::uint32_t index, const Ref<const SolidPlane>& plane) {
        std::vector<PatchUse> piece[2];  // behind the plane, and in front
        std::uint32_t crossing[2];       // where the loop goes to the front, and to the back
        const std::size_t count = uses_.size();
        std::size_t first = 0;
        while (sides_[first] == 0) ++first;
        int at = sides_[first];
        for (std::size_t k = 0; k < count; ++k) {
            const PatchUse use = uses_[(first + k) % count];
            const int next = sides_[(first + k + 1) % count];
            if (next == -at) {
                const auto [before, after] = split_edge(use, plane);
                piece[at > 0].push_back(before);
                crossing[at < 0] = patch_.to(before);
                at = next;
                piece[at > 0].push_back(after);
                continue;
            }
            piece[at > 0].push_back(use);
            if (next != 0 || !changes_at((first + k + 1) % count, at)) continue;
            crossing[at < 0] = patch_.to(use);
            at = -at;
        }
        // crossing[1]: to the front; crossing[0]: to the back. The new edge closes both pieces.
        const std::uint32_t inner = add_edge(crossing[0], crossing[1], patch_.faces[index].plane, patch_.keep(plane));
        close(piece[1], {inner, false});
        close(piece[0], {inner, true});
        for (const std::vector<PatchUse>& uses : piece) add_piece(index, uses);
        patch_.faces[index].replaced = true;
    }

    /// Whether the loop, on the plane at corner k, leaves it on the other side than `at`.
    bool changes_at(std::size_t k, int at) const {
        while (sides_[k] == 0) k = (k + 1) % sides_.size();
        return sides_[k] != at;
    }

    /// Puts the closing edge where the piece's loop has its gap.
    void close(std::vector<PatchUse>& uses, const PatchUse& closing) {
        std::size_t gap = 0;
        while (patch_.from(uses[gap]) != patch_.to(closing)) ++gap;
        std::rotate(uses.begin(), uses.begin() + std::ptrdiff_t(gap), uses.end());
        uses.push_back(closing);
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

    void add_piece(std::uint32_t index, const std::vector<PatchUse>& uses) {
        const std::uint32_t ends[] = {std::uint32_t(uses.size())};
        add_piece(index, uses, ends);
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
        std::vector<PatchUse> uses;
        std::vector<std::uint32_t> ends;
        std::uint32_t k = 0;
        for (const std::uint32_t end : patch_.ends(face)) {
            for (; k < end; ++k) expand(patch_.uses(face)[k], uses);
            ends.push_back(std::uint32_t(uses.size()));
        }
        add_piece(index, uses, ends);
        patch_.faces[index].replaced = true;
    }

    const Node* const root_;
    const GridBox box_;
    const BevelledBox& bevelled_;
    const std::int32_t steps_;
    SolidPatch& patch_;
    bool split_any_ = false;
    std::vector<std::uint32_t> split_;
    std::vector<PatchUse> uses_;
    std::vector<int> sides_;
    std::vector<Vec3> loop_;  ///< input steps
};

}  // namespace

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
