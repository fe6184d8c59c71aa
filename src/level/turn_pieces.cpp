// SPDX-License-Identifier: MIT
// Closed pieces in each other: from the outermost inward, each must be turned as where it lies asks for. Solid and air
// are told apart by how often the pieces around wind around a point of it, counted along a ray. Pieces do not cross, so
// those around a point lie in each other: one ray from the innermost tells of all of them which lies in which.
#include <algorithm>

#include "base/sort.h"
#include "geometry/mesh_shells.h"
#include "level/solid_pieces.h"

namespace firma {
namespace {

class PieceTurner {
public:
    PieceTurner(const SolidMesh& mesh, const FaceTree& good, SolidPieces& pieces)
        : mesh_(mesh),
          good_(good),
          pieces_(pieces),
          nested_(pieces.pieces.size()),
          most_on_rays_(pieces.limits.most(good.faces.size())) {}

    bool turn() {
        measure();
        const std::uint32_t outermost = find_outermost();
        if (outermost == ~0u) return false;
        rock_outside_ = volume_[outermost] < 0;
        // What lies in a piece has less volume: outer ones first.
        std::vector<std::uint32_t> order;
        for (std::uint32_t piece = 0; piece < pieces_.pieces.size(); ++piece)
            if (!pieces_.pieces[piece].note) order.push_back(piece);
        sort_range(order, [&](std::uint32_t a, std::uint32_t b) { return is_larger(a, b); });
        find_edges();
        for (std::size_t k = order.size(); k-- > 0;) find_around(order[k]);
        for (const std::uint32_t piece : order) judge(piece);
        return rock_outside_;
    }

private:
    static constexpr std::uint32_t kNone = ~0u;

    /// Where a piece lies.
    struct Nested {
        bool known = false;
        std::uint32_t in = kNone;  ///< the innermost piece around it
        int winding = 0;           ///< how often this one winds around what lies in it
        bool accepted = false;
        int around = 0;  ///< how often the accepted pieces around it wind around it
    };

    Int128 size(std::uint32_t piece) const { return volume_[piece] < 0 ? -volume_[piece] : volume_[piece]; }
    bool is_larger(std::uint32_t a, std::uint32_t b) const { return size(a) != size(b) ? size(a) > size(b) : a < b; }

    /// Six times the volume of each piece about some point, cubic input steps.
    void measure() {
        volume_.assign(pieces_.pieces.size(), 0);
        for (const std::uint32_t face : good_.faces)
            volume_[pieces_.of_face[face]] += six_times_cone(mesh_.points, mesh_.corners(face), mesh_.points[0]);
    }

    /// Nothing lies around the piece with the least vertex. Of several that share it the largest holds the others, or
    /// all are turned alike.
    std::uint32_t find_outermost() const {
        std::uint32_t outermost = ~0u;
        InputPoint least;
        for (const std::uint32_t face : good_.faces) {
            const std::uint32_t piece = pieces_.of_face[face];
            if (!pieces_.good(face)) continue;
            for (const std::uint32_t corner : mesh_.corners(face)) {
                const InputPoint& p = mesh_.points[corner];
                if (outermost != ~0u && (p > least || (p == least && size(piece) <= size(outermost)))) continue;
                least = p;
                outermost = piece;
            }
        }
        return outermost;
    }

    /// An edge of each piece that no other piece shares: nothing else passes through its middle.
    void find_edges() {
        edge_.assign(pieces_.pieces.size(), kNone);
        for_each_edge(mesh_.sides, [&](std::span<const EdgeSide> sides) {
            std::uint32_t& known = edge_[pieces_.of_face[sides[0].owner]];
            if (sides.size() == 2 && known == kNone) known = std::uint32_t(&sides[0] - mesh_.sides.data());
        });
    }

    /// Pieces around which some piece was found to lie are known, too.
    void find_around(std::uint32_t piece) {
        if (nested_[piece].known || edge_[piece] == kNone || pieces_.work.on_rays > most_on_rays_) return;
        around_.clear();
        follow_ray(piece);
        sort_range(around_, [&](std::uint32_t a, std::uint32_t b) { return is_larger(a, b); });
        std::uint32_t outer = kNone;
        for (const std::uint32_t inner : around_) {
            Nested& nested = nested_[inner];
            if (!nested.known) nested.in = outer;
            nested.known = true;
            nested.winding = crossings_[inner];
            outer = inner;
        }
        nested_[piece].in = outer;
        nested_[piece].known = true;
        for (const std::uint32_t met : met_) crossings_[met] = 0;
        met_.clear();
    }

    /// Finds the pieces around a piece: those that a ray from the middle of its edge leaves more often than it enters
    /// them, or less often. What is not larger is not around it.
    void follow_ray(std::uint32_t piece) {
        const EdgeSide& edge = mesh_.sides[edge_[piece]];
        const EdgeRay ray(mesh_.points[edge.low], mesh_.points[edge.high]);
        crossings_.resize(pieces_.pieces.size());
        good_.tree.for_each_meeting(ray.box(), [&](std::uint32_t number) {
            ++pieces_.work.on_rays;
            const std::uint32_t face = good_.faces[number], other = pieces_.of_face[face];
            if (other == piece || !pieces_.good(face) || !is_larger(other, piece)) return false;
            const int passed = ray.passage(mesh_.points, mesh_.polygon(face));
            if (passed != 0) met_.push_back(other);
            crossings_[other] += passed;
            return false;
        });
        sort_range(met_);
        met_.erase(std::unique(met_.begin(), met_.end()), met_.end());
        for (const std::uint32_t other : met_)
            if (crossings_[other] != 0) around_.push_back(other);
    }

    /// After those around it.
    void judge(std::uint32_t piece) {
        const auto refuse = [&](SolidNoteKind what) {
            const std::uint32_t face = pieces_.pieces[piece].first;
            const Vec3 at = mesh_.metres(mesh_.corners(face)[0]);
            pieces_.refuse(piece, {what, 0, mesh_.level->faces[face].source, 0, at, at});
        };
        Nested& nested = nested_[piece];
        if (nested.in != kNone) {
            const Nested& outer = nested_[nested.in];
            nested.around = outer.around + (outer.accepted ? outer.winding : 0);
        }
        if (edge_[piece] == kNone) return refuse(SolidNoteKind::kWrongWay);
        if (!nested.known) return refuse(SolidNoteKind::kTooComplex);
        const int wanted = volume_[piece] > 0 ? 0 : 1;
        if ((rock_outside_ ? 1 : 0) + nested.around != wanted) return refuse(SolidNoteKind::kWrongWay);
        nested.accepted = true;
    }

    const SolidMesh& mesh_;
    const FaceTree& good_;
    SolidPieces& pieces_;
    std::vector<Nested> nested_;
    const std::uint64_t most_on_rays_;
    std::vector<Int128> volume_;
    std::vector<std::uint32_t> edge_;  ///< a side along it
    std::vector<std::uint32_t> around_, met_;
    std::vector<int> crossings_;  ///< of the ray with a piece: 1 outward, -1 inward
    bool rock_outside_ = false;
};

}  // namespace

bool refuse_wrong_way(const SolidMesh& mesh, const FaceTree& tree, SolidPieces& pieces) {
    return PieceTurner(mesh, tree, pieces).turn();
}

}  // namespace firma
