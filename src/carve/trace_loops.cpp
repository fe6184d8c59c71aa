// SPDX-License-Identifier: MIT
// From labels and segments to the loops of new faces.
#include "carve/trace_loops.h"

#include <algorithm>
#include <utility>

#include "carve/group_loops.h"

namespace firma {
namespace {

class Tracer {
public:
    Tracer(const CutInput& in, const Crossings& crossings, const CutOrder& order, const Labels& labels, NewLoops& made)
        : in_(in),
          crossings_(crossings),
          order_(order),
          labels_(labels),
          made_(made),
          view_(in, crossings, made),
          patch_(in.patch),
          cutter_(in.cutter),
          out_of_(view_.vertex_count()) {}

    Verdict trace() {
        split_edges();
        join_segments();
        add_segments();
        for (std::uint32_t face = 0; face < patch_.faces.size(); ++face) {
            if (patch_.faces[face].replaced) continue;
            if (const Verdict verdict = trace_world(face); verdict != Verdict::kFine) return verdict;
        }
        for (std::uint32_t t = 0; t < cutter_.planes.size(); ++t)
            if (const Verdict verdict = trace_cutter(t); verdict != Verdict::kFine) return verdict;
        return Verdict::kFine;
    }

private:
    struct Parts {
        std::uint32_t first = 0, count = 0;  ///< new edges, in order along the old one
    };

    /// Parts of an edge that lie where `keep` says, one after the other from its first vertex.
    Parts split(const CutOrder::Range& range, std::uint32_t a, std::uint32_t b, bool keeps, const SolidPlane* p,
                const SolidPlane* q) {
        Parts parts{std::uint32_t(made_.edges.size()), 0};
        std::uint32_t from = a;
        for (std::uint32_t k = 0; k <= range.count; ++k) {
            const std::uint32_t to = k < range.count ? crossings_.points[order_.along[range.first + k]].vertex : b;
            if (keeps) {
                made_.edges.push_back({from, to, {p, q}});
                ++parts.count;
            }
            keeps = !keeps;
            from = to;
        }
        return parts;
    }

    /// Whether the part of a cutter edge or a whole one with this label at its start becomes part of the solid's new
    /// boundary.
    bool wanted(CutSide label) const { return (label == CutSide::kInside) != in_.fill; }

    void split_edges() {
        world_parts_.assign(patch_.edges.size(), {});
        if (in_.divides) taken_parts_.assign(patch_.edges.size(), {});
        for (std::uint32_t e = 0; e < patch_.edges.size(); ++e) {
            if (order_.world_cuts[e].count == 0) continue;
            const PatchEdge& edge = patch_.edges[e];
            const bool outside = labels_.world[edge.vertex[0]] == CutSide::kOutside;
            const auto split_it = [&](bool keeps) {
                return split(order_.world_cuts[e], edge.vertex[0], edge.vertex[1], keeps, edge.plane[0], edge.plane[1]);
            };
            world_parts_[e] = split_it(outside);
            if (!in_.divides) continue;
            taken_parts_[e] = split_it(!outside);
            note_division(e, outside);
        }
        cutter_parts_.assign(cutter_.edges.size(), {});
        const std::uint32_t base = view_.first_cutter_vertex();
        for (std::uint32_t e = 0; e < cutter_.edges.size(); ++e) {
            const CutterSolid::Edge& edge = cutter_.edges[e];
            if (cutter_.is_seam(edge)) continue;
            const bool keeps = wanted(labels_.cutter[edge.a]);
            if (order_.cutter_cuts[e].count == 0 && !keeps) continue;
            cutter_parts_[e] = split(order_.cutter_cuts[e], base + edge.a, base + edge.b, keeps, edge.plane[0].get(),
                                     edge.plane[1].get());
        }
    }

    /// Parts outside and inside in turn.
    void note_division(std::uint32_t edge, bool outside) {
        const std::uint32_t count = order_.world_cuts[edge].count + 1;
        made_.divisions.push_back({edge, std::uint32_t(made_.parts.size()), count});
        std::uint32_t next_out = world_parts_[edge].first, next_in = taken_parts_[edge].first;
        for (std::uint32_t k = 0; k < count; ++k, outside = !outside)
            made_.parts.push_back({view_.first_new_edge() + (outside ? next_out++ : next_in++), false});
    }

    /// Segments that a seam of the cutter divides are one.
    void join_segments() {
        segments_ = crossings_.segments;
        if (!cutter_.polygons.any()) return;
        const auto on_seam = [&](std::uint32_t vertex) {
            const CutPoint& crossing = view_.crossing(vertex);
            return !crossing.of_world && cutter_.is_seam(cutter_.edges[crossing.edge]);
        };
        std::vector<std::uint32_t> starting(crossings_.real.size(), kNoPiece);
        for (std::uint32_t k = 0; k < segments_.size(); ++k)
            if (on_seam(segments_[k].from)) starting[segments_[k].from - view_.first_real()] = k;
        for (const Segment& segment : segments_) {
            if (on_seam(segment.from)) continue;
            Segment& whole = joined_.emplace_back(segment);
            whole.triangle = cutter_.polygons.of(segment.triangle);
            while (on_seam(whole.to)) {
                const std::uint32_t next = starting[whole.to - view_.first_real()];
                if (next == kNoPiece) break;
                whole.to = segments_[next].to;
            }
        }
        segments_ = joined_;
    }

    void add_segments() {
        segment_edge_ = view_.first_new_edge() + std::uint32_t(made_.edges.size());
        by_triangle_.assign(cutter_.planes.size() + 1, 0);
        by_face_.assign(patch_.faces.size() + 1, 0);
        for (const Segment& segment : segments_) {
            made_.edges.push_back(
                {segment.from, segment.to, {patch_.faces[segment.face].plane, cutter_.planes[segment.triangle].get()}});
            ++by_triangle_[segment.triangle + 1];
            ++by_face_[segment.face + 1];
        }
        order(by_triangle_, of_triangle_, [](const Segment& s) { return s.triangle; });
        order(by_face_, of_face_, [](const Segment& s) { return s.face; });
    }

    template <class Key>
    void order(std::vector<std::uint32_t>& first, std::vector<std::uint32_t>& ordered, const Key& key) {
        for (std::size_t k = 1; k < first.size(); ++k) first[k] += first[k - 1];
        ordered.resize(segments_.size());
        std::vector<std::uint32_t> next(first.begin(), first.end() - 1);
        for (std::uint32_t k = 0; k < segments_.size(); ++k) ordered[next[key(segments_[k])]++] = k;
    }

    void take_parts(const Parts& parts, bool reversed) {
        for (std::uint32_t k = 0; k < parts.count; ++k)
            pieces_.push_back({view_.first_new_edge() + parts.first + k, reversed});
    }

    Verdict trace_world(std::uint32_t index) {
        const PatchFace& face = patch_.faces[index];
        bool inside = false, outside = false;
        pieces_.clear();
        for (const PatchUse& use : patch_.uses(face)) {
            const bool out = labels_.world[patch_.from(use)] == CutSide::kOutside;
            (out ? outside : inside) = true;
            if (order_.world_cuts[use.edge].count != 0)
                take_parts(world_parts_[use.edge], use.reversed);
            else if (out)
                pieces_.push_back(use);
        }
        if (!crossings_.face_cut[index]) {
            if (!inside) return Verdict::kFine;
            made_.gone.push_back(index);
            if (!outside) return in_.opens ? trace_taken(index) : Verdict::kFine;
        } else {
            made_.gone.push_back(index);
        }
        for (std::uint32_t k = by_face_[index]; k < by_face_[index + 1]; ++k)
            pieces_.push_back({segment_edge_ + of_face_[k], true});
        const Verdict verdict = trace_pieces({Ref<const SolidPlane>(face.plane), 0, 0, 0, 0, index, ~0u});
        return verdict == Verdict::kFine && in_.opens ? trace_taken(index) : verdict;
    }

    /// What of a face that goes lies inside the cutter.
    Verdict trace_taken(std::uint32_t index) {
        const PatchFace& face = patch_.faces[index];
        pieces_.clear();
        for (const PatchUse& use : patch_.uses(face)) {
            if (order_.world_cuts[use.edge].count != 0)
                take_parts(taken_parts_[use.edge], use.reversed);
            else if (labels_.world[patch_.from(use)] != CutSide::kOutside)
                pieces_.push_back(use);
        }
        for (std::uint32_t k = by_face_[index]; k < by_face_[index + 1]; ++k)
            pieces_.push_back({segment_edge_ + of_face_[k], false});
        const std::size_t faces = made_.faces.size();
        const Verdict verdict = trace_pieces({Ref<const SolidPlane>(face.plane), 0, 0, 0, 0, index, ~0u});
        for (std::size_t k = faces; k < made_.faces.size(); ++k) made_.taken.push_back(std::move(made_.faces[k]));
        made_.faces.resize(faces);
        return verdict;
    }

    /// @param t  a polygon's lowest triangle; of others nothing is made
    Verdict trace_cutter(std::uint32_t t) {
        pieces_.clear();
        cutter_.polygons.for_each(t, [&](std::uint32_t member) {
            for (int k = 0; k < 3; ++k) {
                const std::uint32_t edge = cutter_.edge_of(member, k);
                const bool forward = cutter_.edges[edge].left == member;
                take_parts(cutter_parts_[edge], forward != in_.fill);
            }
        });
        for (std::uint32_t k = by_triangle_[t]; k < by_triangle_[t + 1]; ++k)
            pieces_.push_back({segment_edge_ + of_triangle_[k], false});
        if (pieces_.empty()) return Verdict::kFine;
        Ref<const SolidPlane> plane = cutter_.planes[t];
        if (!in_.fill) plane = Ref<const SolidPlane>(new SolidPlane(flipped(plane->plane)));
        return trace_pieces({std::move(plane), 0, 0, 0, 0, ~0u, t});
    }

    /// Follows the pieces around: each has one that comes next.
    Verdict trace_pieces(const NewFace& like) {
        if (const Verdict found = find_next(like); found != Verdict::kFine) return found;
        loops_.clear();
        loop_ends_.clear();
        for (std::uint32_t first = 0; first < pieces_.size(); ++first) {
            for (std::uint32_t piece = first; next_[piece] != kNoPiece;) {
                loops_.push_back(pieces_[piece]);
                piece = std::exchange(next_[piece], kNoPiece);
            }
            if (loops_.size() > (loop_ends_.empty() ? 0 : loop_ends_.back()))
                loop_ends_.push_back(std::uint32_t(loops_.size()));
        }
        if (loops_.empty()) return Verdict::kFine;
        return group_loops(view_, like, loops_, loop_ends_, made_);
    }

    /// Mostly each vertex has one way out and one way in.
    Verdict find_next(const NewFace& like) {
        next_.assign(pieces_.size(), kNoPiece);
        same_start_.assign(pieces_.size(), kNoPiece);
        bool several = false;
        for (std::uint32_t k = 0; k < pieces_.size(); ++k) {
            std::uint32_t& out = out_of_[view_.from(pieces_[k])];
            several |= out != 0;
            same_start_[k] = out - 1;  // none: kNoPiece
            out = k + 1;
        }
        Verdict found = Verdict::kFine;
        for (std::uint32_t k = 0; k < pieces_.size() && found == Verdict::kFine; ++k) {
            next_[k] = out_of_[view_.to(pieces_[k])] - 1;
            if (next_[k] == kNoPiece)
                found = Verdict::kBroken;
            else if (several && same_start_[next_[k]] != kNoPiece && !choose_next(k, like))
                found = Verdict::kDegenerate;
        }
        for (const PatchUse& piece : pieces_) out_of_[view_.from(piece)] = 0;
        if (found != Verdict::kFine) return found;
        used_.assign(pieces_.size(), 0);
        std::size_t ends = 0;
        for (const std::uint32_t next : next_) ends += used_[next]++ != 0;
        return ends == 0 ? Verdict::kFine : Verdict::kBroken;
    }

    /// Where solids touch along a line that crosses this face there are several ways out of one vertex. The inside of
    /// the face lies to the left of a piece: the next one is the first met when the way back turns clockwise. Segments
    /// run along face normal x triangle normal.
    /// @return false where others are among them: a loop of the face itself comes to the vertex twice
    bool choose_next(std::uint32_t piece, const NewFace& like) {
        if (!is_segment(piece)) return false;
        std::uint32_t best = kNoPiece;
        for (std::uint32_t out = next_[piece]; out != kNoPiece; out = same_start_[out]) {
            if (!is_segment(out)) return false;
            if (best == kNoPiece || comes_before(piece, out, best, like)) best = out;
        }
        next_[piece] = best;
        return true;
    }
    bool is_segment(std::uint32_t piece) const { return pieces_[piece].edge >= segment_edge_; }

    /// Whether a, turning clockwise from the way back along `in`, is met before b.
    bool comes_before(std::uint32_t in, std::uint32_t a, std::uint32_t b, const NewFace& like) const {
        // Against the way back all turns change sign: 1 within half a turn clockwise, 2 opposite, 3 beyond.
        const auto part = [&](std::uint32_t out) { return 2 - turn(in, out, like); };
        const int part_a = part(a), part_b = part(b);
        return part_a != part_b ? part_a < part_b : turn(a, b, like) < 0;
    }

    /// Sign of the turn from one segment's direction to another's, seen against the normal of the new face:
    /// (a x t) x (b x t) = t det(a, b, t).
    int turn(std::uint32_t a, std::uint32_t b, const NewFace& like) const {
        const NewEdge &one = view_.new_edge(pieces_[a].edge), &other = view_.new_edge(pieces_[b].edge);
        const Plane& t = cutter_.planes[like.triangle]->plane;
        const int sign = exact_turn(one.plane[0]->plane, other.plane[0]->plane, t);
        const bool turned = pieces_[a].reversed != pieces_[b].reversed;
        return (in_.fill ? sign : -sign) * (turned ? -1 : 1);
    }

    static constexpr std::uint32_t kNoPiece = ~0u;

    const CutInput& in_;
    const Crossings& crossings_;
    const CutOrder& order_;
    const Labels& labels_;
    NewLoops& made_;
    const CutView view_;
    const SolidPatch& patch_;
    const CutterSolid& cutter_;
    std::vector<Parts> world_parts_, taken_parts_, cutter_parts_;
    std::span<const Segment> segments_;  ///< those of the crossings, or joined_
    std::vector<Segment> joined_;
    std::uint32_t segment_edge_ = 0;  ///< number of the first segment's edge
    std::vector<std::uint32_t> by_triangle_, of_triangle_, by_face_, of_face_;
    std::vector<PatchUse> pieces_, loops_;
    std::vector<std::uint32_t> loop_ends_;
    std::vector<std::uint32_t> next_;        ///< of each piece
    std::vector<std::uint32_t> same_start_;  ///< of each piece: another one that starts at its vertex
    std::vector<std::uint8_t> used_;
    std::vector<std::uint32_t> out_of_;  ///< a vertex's way out, as 1 + its place in pieces_; 0: none
};

}  // namespace

Verdict trace_loops(const CutInput& in, const Crossings& crossings, const CutOrder& order, const Labels& labels,
                    NewLoops& loops) {
    loops.edges.clear();
    loops.all_uses.clear();
    loops.loop_ends.clear();
    loops.faces.clear();
    loops.gone.clear();
    loops.taken.clear();
    loops.divisions.clear();
    loops.parts.clear();
    return Tracer(in, crossings, order, labels, loops).trace();
}

}  // namespace firma
