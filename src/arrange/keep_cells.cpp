// SPDX-License-Identifier: MIT
// From labels to the faces of the result.
#include "arrange/keep_cells.h"

#include <algorithm>
#include <optional>

#include "base/disjoint_sets.h"
#include "base/flat_map.h"
#include "base/sort.h"

namespace firma {
namespace {

constexpr std::uint32_t kNone = ~0u;
constexpr std::uint32_t kMadeEdge = ~0u - 1;

}  // namespace

class CellKeeper::Work {
public:
    Work(Overlay& overlay, const DividedLines& lines, const CellSet& cells, const PieceUsers& users,
         std::span<const CellLabel> labels, const Selection& selection, Arranged& made)
        : overlay_(overlay),
          lines_(lines),
          cells_(cells),
          users_(users),
          labels_(labels),
          selection_(selection),
          made_(made),
          flat_(overlay, lines),
          groups_(cells.cells.size()),
          box_(cells.cells.size()),
          kept_(cells.cells.size(), Kept::kNot) {
        made.stays.assign(overlay.faces.size(), 0);
        uses_ = cells_.all_uses;
        partner_.assign(uses_.size(), kNone);
        next_.assign(uses_.size(), kNone);
        chain_.assign(uses_.size(), kNone);
        dissolved_.assign(uses_.size(), 0);
        across_.assign(uses_.size(), kNone);
        crowded_.assign(uses_.size(), 0);
        seen_.assign(uses_.size(), 0);
        contact_.assign(overlay_.tables.points.size(), 0);
        met_.assign(overlay_.faces.size(), 0);
    }

    PhaseEnd step(WorkSlice& slice) {
        while (stage_ != Stage::kEnd) {
            const bool ended = loop(slice);
            if (broken_) return PhaseEnd::kBroken;
            if (!ended) return PhaseEnd::kGoesOn;
            stage_ = Stage(std::uint8_t(stage_) + 1);
            if (stage_ != Stage::kEdges || !nothing_changes()) continue;
            made_.changes = false;
            stage_ = Stage::kEnd;
        }
        return PhaseEnd::kDone;
    }

private:
    /// Each goes over all cells, edges, pieces or groups; kMerge over the pieces twice.
    enum class Stage : std::uint8_t {
        kSelect,
        kEdges,
        kContacts,
        kMerge,
        kDissolve,
        kPair,
        kGroup,
        kTrace,
        kWrite,
        kEnd
    };

    /// Goes on with the loop of the stage at hand; true at its end.
    bool loop(WorkSlice& slice) {
        const std::size_t pieces = lines_.size();
        switch (stage_) {
            case Stage::kSelect:
                return go_on(next_at_, cells_.cells.size(), slice, [&](std::uint32_t cell) {
                    slice.take(cells_.cells[cell].use_count / 8);
                    select(cell);
                });
            case Stage::kEdges:
                return go_on(next_at_, overlay_.edges.size(), slice, [&](std::uint32_t edge) {
                    if (selection_.reusable(edge))
                        edge_between_.at(pair_key(overlay_.edges[edge].from, overlay_.edges[edge].to)) = edge;
                });
            case Stage::kContacts:
                return go_on(next_at_, pieces, slice, [&](std::uint32_t piece) { find_contacts(piece); });
            case Stage::kMerge:
                // Where faces became one across what both solids share, the rest of what lay between them goes too.
                return go_on(next_at_, 2 * pieces, slice, [&](std::uint32_t k) {
                    const auto piece = std::uint32_t(k < pieces ? k : k - pieces);
                    if (users_.shared(piece) == (k < pieces)) merge_across(piece);
                });
            case Stage::kDissolve:
                // Faces that became one by way of others have edges between them still.
                return go_on(next_at_, pieces, slice, [&](std::uint32_t piece) { dissolve_within(piece); });
            case Stage::kPair:
                return go_on(next_at_, pieces, slice, [&](std::uint32_t piece) {
                    if (!users_.shared(piece))
                        pair_by_edge(piece);
                    else if (!pair_around(piece))
                        broken_ = true;
                });
            case Stage::kGroup:
                gather_groups();
                return true;
            case Stage::kTrace:
                return go_on(next_at_, members_first_.size() - 1, slice, [&](std::uint32_t group) {
                    broken_ = broken_ || !trace(group);
                    slice.take(2 * group_uses_.size());
                });
            case Stage::kWrite:
                return go_on(next_at_, members_first_.size() - 1, slice, [&](std::uint32_t group) {
                    broken_ = broken_ || !write(group);
                    slice.take(2 * loops_.size());
                });
            case Stage::kEnd:
                break;
        }
        return true;
    }

    void select(std::uint32_t cell) {
        const Cell& it = cells_.cells[cell];
        kept_[cell] = selection_.keep(overlay_.faces[it.face].operand, labels_[cell]);
        for (std::uint32_t use = it.first_use; use < it.first_use + it.use_count; ++use) {
            box_[cell].add(overlay_.point(flat_.from(uses_[use])).rounded());
            if (kept_[cell] == Kept::kTurned) uses_[use] = uses_[use].turned();
            uses_[use].id = use;
        }
    }

    PlaneId plane_of(std::uint32_t cell) const {
        const PlaneId plane = overlay_.faces[cells_.cells[cell].face].plane;
        return kept_[cell] == Kept::kTurned ? from_behind(plane) : plane;
    }
    /// Whether all of the first solid stays, and nothing of another comes.
    bool nothing_changes() const {
        for (std::uint32_t cell = 0; cell < cells_.cells.size(); ++cell)
            if (kept_[cell] != (overlay_.faces[cells_.cells[cell].face].operand == 0 ? Kept::kAsItIs : Kept::kNot))
                return false;
        return true;
    }
    bool is_kept(std::uint32_t use) const { return kept_[users_.cell_of(use)] != Kept::kNot; }
    std::uint32_t group_of(std::uint32_t use) { return groups_.find(users_.cell_of(use)); }

    /// Points that lie on pieces where both solids are, and the faces there.
    void find_contacts(std::uint32_t piece) {
        if (!users_.shared(piece)) return;
        for (const std::uint32_t use : users_.at(piece)) met_[cells_.cells[users_.cell_of(use)].face] = 1;
        contact_[lines_.piece(piece).from] = 1;
        contact_[lines_.piece(piece).to] = 1;
    }

    /// What lies in one plane on both sides of the piece, and is alike, is one.
    void merge_across(std::uint32_t piece) {
        for_each_seam(piece, [&](std::uint32_t use, std::uint32_t other) {
            const std::uint32_t a = users_.cell_of(use), b = users_.cell_of(other);
            if (groups_.find(a) == groups_.find(b)) return true;
            if (!may_merge(use, other) || !are_alike(a, b)) return false;
            const GridBox box = box_of_both(a, b);
            if (!of_one_face(a, b) && box.longest_extent() > selection_.longest) return false;
            groups_.join(a, b);
            box_[groups_.find(a)] = box;
            return true;
        });
    }
    void dissolve_within(std::uint32_t piece) {
        for_each_seam(piece, [&](std::uint32_t use, std::uint32_t other) { return group_of(use) == group_of(other); });
    }

    /// Calls `becomes_one` for two uses of the piece, one each way, with cells in one plane: whether the piece vanishes
    /// between them.
    template <class BecomesOne>
    void for_each_seam(std::uint32_t piece, const BecomesOne& becomes_one) {
        const auto uses = users_.at(piece);
        std::optional<bool> complete;
        for (std::size_t i = 0; i < uses.size(); ++i) {
            if (!is_kept(uses[i]) || !uses_[uses[i]].forward || dissolved_[uses[i]]) continue;
            for (std::size_t j = 0; j < uses.size(); ++j) {
                if (!is_kept(uses[j]) || uses_[uses[j]].forward || dissolved_[uses[j]]) continue;
                if (plane_of(users_.cell_of(uses[i])) != plane_of(users_.cell_of(uses[j]))) continue;
                if (uses_[uses[i]].edge != uses_[uses[j]].edge) {
                    if (!complete) complete = is_complete(piece);
                    if (!*complete) continue;
                }
                if (!becomes_one(uses[i], uses[j])) continue;
                dissolved_[uses[i]] = dissolved_[uses[j]] = 1;
                across_[uses[i]] = uses[j];
                across_[uses[j]] = uses[i];
                contact_[lines_.piece(piece).from] = contact_[lines_.piece(piece).to] = 1;
                break;
            }
        }
    }

    /// Across what both solids share, or across an edge of a face that changes anyhow.
    bool may_merge(std::uint32_t use, std::uint32_t other) const {
        if (users_.shared(uses_[use].piece)) return true;
        return uses_[use].edge != FacePiece::kNoEdge && uses_[use].edge == uses_[other].edge &&
               (meets_other(use) || meets_other(other));
    }
    bool meets_other(std::uint32_t use) const { return met_[cells_.cells[users_.cell_of(use)].face] != 0; }

    bool of_one_face(std::uint32_t a, std::uint32_t b) const { return cells_.cells[a].face == cells_.cells[b].face; }
    bool are_alike(std::uint32_t a, std::uint32_t b) const {
        return of_one_face(a, b) || selection_.alike(cells_.cells[a].face, cells_.cells[b].face);
    }
    GridBox box_of_both(std::uint32_t a, std::uint32_t b) {
        GridBox box = box_[groups_.find(a)];
        box.add(box_[groups_.find(b)]);
        return box;
    }

    /// Each wedge of air between two faces is an edge. A face that became one across the piece has no edge there: air
    /// that ends at it goes on from its other side.
    bool pair_around(std::uint32_t piece) {
        spokes_.clear();
        std::size_t edges = 0;
        for (const std::uint32_t use : users_.at(piece)) {
            if (!is_kept(use)) continue;
            const std::uint32_t cell = users_.cell_of(use);
            const bool forward = uses_[use].forward;
            spokes_.push_back({use, cell, forward ? plane_of(cell) : from_behind(plane_of(cell)), forward, 0, 0});
            edges += !dissolved_[use];
        }
        if (edges == 0) return true;
        sort_around(overlay_.lines, lines_.piece(piece).line, spokes_);
        const auto after = [&](std::size_t k) { return k + 1 < spokes_.size() ? k + 1 : 0; };
        for (std::size_t k = 0; k < spokes_.size(); ++k) {
            const CellSpoke &here = spokes_[k], &next = spokes_[after(k)];
            if (here.air_after == next.air_after || here.half == next.half) return false;
            if (!here.air_after || dissolved_[here.use]) continue;
            std::size_t end = after(k);
            while (dissolved_[spokes_[end].use]) end = after(spoke_of(across_[spokes_[end].use]));
            const std::uint32_t other = spokes_[end].use;
            partner_[here.use] = other;
            partner_[other] = here.use;
            crowded_[here.use] = crowded_[other] = edges > 2;
        }
        return true;
    }
    std::size_t spoke_of(std::uint32_t use) const {
        std::size_t k = 0;
        while (spokes_[k].use != use) ++k;
        return k;
    }

    /// Where one solid is alone, its edges are what they were, but for what vanishes between two of them.
    void pair_by_edge(std::uint32_t piece) {
        for (const std::uint32_t use : users_.at(piece)) {
            if (!is_kept(use) || dissolved_[use] || partner_[use] != kNone) continue;
            std::uint32_t other = mate_of(use);
            while (other != kNone && dissolved_[other]) other = mate_of(across_[other]);
            if (other == kNone || partner_[other] != kNone) continue;
            partner_[use] = other;
            partner_[other] = use;
        }
    }
    /// The use beyond the edge that a use came with; none where its face is not here.
    std::uint32_t mate_of(std::uint32_t use) const {
        for (const std::uint32_t other : users_.at(uses_[use].piece))
            if (other != use && is_kept(other) && uses_[other].edge == uses_[use].edge &&
                uses_[other].forward != uses_[use].forward)
                return other;
        return kNone;
    }
    /// Whether all faces at the piece are here. Near what both solids share they are.
    bool is_complete(std::uint32_t piece) const {
        if (users_.shared(piece)) return true;
        const auto uses = users_.at(piece);
        return std::all_of(uses.begin(), uses.end(), [&](std::uint32_t use) { return mate_of(use) != kNone; });
    }

    /// Groups in order of their lowest cell, and the cells of each.
    void gather_groups() {
        std::vector<std::uint32_t> number(cells_.cells.size(), kNone);
        std::uint32_t count = 0;
        for (std::uint32_t cell = 0; cell < cells_.cells.size(); ++cell)
            if (kept_[cell] != Kept::kNot && groups_.find(cell) == cell) number[cell] = count++;
        members_first_.assign(count + 1, 0);
        for (std::uint32_t cell = 0; cell < cells_.cells.size(); ++cell)
            if (kept_[cell] != Kept::kNot) ++members_first_[number[groups_.find(cell)] + 1];
        for (std::size_t k = 1; k < members_first_.size(); ++k) members_first_[k] += members_first_[k - 1];
        members_.resize(members_first_.back());
        std::vector<std::uint32_t> next(members_first_.begin(), members_first_.end() - 1);
        for (std::uint32_t cell = 0; cell < cells_.cells.size(); ++cell)
            if (kept_[cell] != Kept::kNot) members_[next[number[groups_.find(cell)]]++] = cell;
    }
    std::span<const std::uint32_t> members(std::uint32_t group) const {
        return {members_.data() + members_first_[group], members_first_[group + 1] - members_first_[group]};
    }

    /// Sets what follows each use of the group.
    bool trace(std::uint32_t group) {
        group_uses_.clear();
        for (const std::uint32_t cell : members(group)) {
            const Cell& it = cells_.cells[cell];
            for (std::uint32_t use = it.first_use; use < it.first_use + it.use_count; ++use)
                if (!dissolved_[use]) group_uses_.push_back(uses_[use]);
        }
        flat_.start(plane_of(members(group)[0]));
        if (is_whole(group)) {
            follow_cell(cells_.cells[members(group)[0]]);
            return true;
        }
        if (!flat_.trace(group_uses_, loops_, ends_)) return false;
        std::uint32_t first = 0;
        for (const std::uint32_t end : ends_) {
            for (std::uint32_t k = first; k < end; ++k) next_[loops_[k].id] = loops_[k + 1 < end ? k + 1 : first].id;
            first = end;
        }
        return true;
    }
    /// Nothing was taken off a single cell, nor is it turned: its loops are what they were.
    bool is_whole(std::uint32_t group) const {
        const auto cells = members(group);
        return cells.size() == 1 && kept_[cells[0]] == Kept::kAsItIs &&
               group_uses_.size() == cells_.cells[cells[0]].use_count;
    }
    void follow_cell(const Cell& cell) {
        std::uint32_t first = 0;
        for (const std::uint32_t end : cells_.ends(cell)) {
            for (std::uint32_t k = first; k < end; ++k)
                next_[cell.first_use + k] = cell.first_use + (k + 1 < end ? k + 1 : first);
            first = end;
        }
    }

    /// Whether the point between a use and the next one is none of the result's: only their line passes there, between
    /// the same two faces.
    bool passes_through(std::uint32_t use) {
        const std::uint32_t after = next_[use];
        if (after == use) return false;
        const std::uint32_t line = lines_.piece(uses_[use].piece).line;
        if (line == Piece::kNoLine || lines_.piece(uses_[after].piece).line != line) return false;
        if (uses_[use].forward != uses_[after].forward) return false;  // it turns back
        const bool same_edge = uses_[use].edge != FacePiece::kNoEdge && uses_[use].edge == uses_[after].edge;
        if (!same_edge && !contact_[flat_.to(uses_[use])]) return false;
        const std::uint32_t there = partner_[use], there_after = partner_[after];
        if (there == kNone || there_after == kNone) return same_edge && there == there_after;
        return next_[there_after] == there && group_of(there) == group_of(there_after);
    }

    /// The number of the edge that a chain of uses makes, which begins with `first` and ends before a point that stays.
    std::uint32_t edge_of(std::uint32_t first, std::uint32_t last) {
        if (chain_[first] != kNone) return chain_[first];
        const auto number = std::uint32_t(made_.edges.size());
        ArrangedEdge edge;
        edge.from = flat_.from(uses_[first]);
        edge.to = flat_.to(uses_[last]);
        edge.edge = whole_edge(first, last);
        if (edge.edge != ArrangedEdge::kNoEdge) {
            edge.from = overlay_.edges[edge.edge].from;
            edge.to = overlay_.edges[edge.edge].to;
        }
        const std::uint32_t line = lines_.piece(uses_[first].piece).line;
        for (int k = 0; k < 2; ++k)
            edge.plane[k] =
                line == Piece::kNoLine ? overlay_.edges[uses_[first].edge].plane[k] : overlay_.lines.plane(line, k);
        edge.doubled = is_doubled(first, last) || has_twin(first, last);
        made_.edges.push_back(edge);
        for (std::uint32_t use = first;; use = next_[use]) {
            chain_[use] = number;
            if (partner_[use] != kNone) chain_[partner_[use]] = number;
            if (use == last) break;
        }
        return number;
    }
    bool is_doubled(std::uint32_t first, std::uint32_t last) const {
        for (std::uint32_t use = first;; use = next_[use]) {
            const std::uint32_t edge = uses_[use].edge;
            if (crowded_[use] || (edge != FacePiece::kNoEdge && overlay_.edges[edge].doubled)) return true;
            if (use == last) return false;
        }
    }
    /// Whether another edge that may be used again, or one made before, runs between the same points.
    bool has_twin(std::uint32_t first, std::uint32_t last) {
        const std::uint32_t from = flat_.from(uses_[first]), to = flat_.to(uses_[last]);
        std::uint32_t& known = edge_between_.at(pair_key(from, to));
        if (known == FlatMap::kNone) {
            known = kMadeEdge;
            return false;
        }
        return known == kMadeEdge || known != uses_[first].edge;
    }
    static std::uint64_t pair_key(std::uint32_t a, std::uint32_t b) {
        return std::uint64_t(std::min(a, b)) << 32 | std::max(a, b);
    }

    /// The overlay's edge that a chain is, if it is one.
    std::uint32_t whole_edge(std::uint32_t first, std::uint32_t last) const {
        const std::uint32_t edge = uses_[first].edge;
        if (edge == FacePiece::kNoEdge || !selection_.reusable(edge)) return ArrangedEdge::kNoEdge;
        for (std::uint32_t use = first;; use = next_[use]) {
            if (uses_[use].edge != edge || crowded_[use] > overlay_.edges[edge].doubled) return ArrangedEdge::kNoEdge;
            if (partner_[use] != kNone && uses_[partner_[use]].edge != edge) return ArrangedEdge::kNoEdge;
            if (use == last) break;
        }
        const std::uint32_t from = flat_.from(uses_[first]), to = flat_.to(uses_[last]);
        const OverlayEdge& it = overlay_.edges[edge];
        const bool whole = (it.from == from && it.to == to) || (it.from == to && it.to == from);
        return whole ? edge : ArrangedEdge::kNoEdge;
    }

    bool write(std::uint32_t group) {
        const auto cells = members(group);
        ArrangedFace face;
        face.face = cells_.cells[cells[0]].face;
        face.plane = plane_of(cells[0]);
        flat_.start(face.plane);
        // Loops of the uses that edges begin with.
        loops_.clear();
        ends_.clear();
        sides_.clear();
        for (const std::uint32_t cell : cells) {
            const Cell& it = cells_.cells[cell];
            for (std::uint32_t use = it.first_use; use < it.first_use + it.use_count; ++use) {
                if (dissolved_[use] || seen_[use]) continue;
                std::uint32_t start = use;
                while (passes_through(start)) {
                    start = next_[start];
                    if (start == use) return false;  // a loop on one line
                }
                start = next_[start];
                for (std::uint32_t at = start;;) {
                    std::uint32_t last = at;
                    seen_[last] = 1;
                    while (passes_through(last)) {
                        last = next_[last];
                        seen_[last] = 1;
                    }
                    const std::uint32_t edge = edge_of(at, last);
                    loops_.push_back(uses_[at]);
                    sides_.push_back({edge, made_.edges[edge].from != flat_.from(uses_[at]) ||
                                                made_.edges[edge].to != flat_.to(uses_[last])});
                    at = next_[last];
                    if (at == start) break;
                }
                ends_.push_back(std::uint32_t(loops_.size()));
            }
        }
        if (stays_whole(face.face, sides_, cells)) {
            made_.stays[face.face] = 1;
            return true;
        }
        return add_faces(face);
    }

    /// Whether the face is the overlay's, with the same edges.
    bool stays_whole(std::uint32_t index, std::span<const OverlaySide> sides, std::span<const std::uint32_t> cells) {
        const OverlayFace& face = overlay_.faces[index];
        if (sides.size() != face.side_count || kept_[cells[0]] == Kept::kTurned) return false;
        wanted_.clear();
        for (const OverlaySide& side : sides) {
            const std::uint32_t edge = made_.edges[side.edge].edge;
            if (edge == ArrangedEdge::kNoEdge) return false;
            wanted_.push_back(edge);
        }
        std::vector<std::uint32_t> own;
        for (const OverlaySide& side : overlay_.sides(face)) own.push_back(side.edge);
        sort_range(wanted_);
        sort_range(own);
        return wanted_ == own;
    }

    bool add_faces(const ArrangedFace& like) {
        find_whole_loops();
        if (!flat_.group(whole_loops_, piece_ends_, outlines_)) return false;
        for (std::size_t k = 0; k < outlines_.outlines().size(); ++k) {
            ArrangedFace face = like;
            face.first_use = std::uint32_t(made_.all_uses.size());
            face.first_loop = std::uint32_t(made_.loop_ends.size());
            face.loop_count = std::uint32_t(outlines_.loops(k).size());
            append_loops<OverlaySide>(sides_, ends_, outlines_.loops(k), face.first_use, made_.all_uses,
                                      made_.loop_ends);
            face.use_count = std::uint32_t(made_.all_uses.size()) - face.first_use;
            made_.faces.push_back(face);
        }
        return true;
    }
    /// The loops of the group at hand, piece by piece.
    void find_whole_loops() {
        whole_loops_.clear();
        piece_ends_.clear();
        for (std::size_t loop = 0; loop < ends_.size(); ++loop) {
            const std::uint32_t start = loops_[loop == 0 ? 0 : ends_[loop - 1]].id;
            std::uint32_t use = start;
            do {
                whole_loops_.push_back(uses_[use]);
                use = next_[use];
            } while (use != start);
            piece_ends_.push_back(std::uint32_t(whole_loops_.size()));
        }
    }

    Overlay& overlay_;
    const DividedLines& lines_;
    const CellSet& cells_;
    const PieceUsers& users_;
    const std::span<const CellLabel> labels_;
    const Selection& selection_;
    Arranged& made_;
    Stage stage_ = Stage::kSelect;
    std::uint32_t next_at_ = 0;  ///< in the loop of the stage
    bool broken_ = false;
    FlatEdges flat_;
    DisjointSets groups_;
    std::vector<GridBox> box_;  ///< of a group, by the cell that stands for it
    std::vector<Kept> kept_;
    std::vector<PieceUse> uses_;           ///< of all cells, as they are kept
    std::vector<std::uint32_t> partner_;   ///< of each use: the one beyond the edge
    std::vector<std::uint32_t> next_;      ///< of each use: what follows in its loop
    std::vector<std::uint32_t> chain_;     ///< of each use: its edge
    std::vector<std::uint8_t> dissolved_;  ///< what lies beyond is the same face
    FlatMap edge_between_;                 ///< of two points: one that may be used again, or kMadeEdge
    std::vector<std::uint32_t> across_;    ///< of one that is dissolved: the use that lies beyond
    std::vector<std::uint8_t> crowded_;    ///< of each use: there are other edges at its piece
    std::vector<std::uint8_t> contact_, seen_;
    std::vector<std::uint8_t> met_;  ///< of the overlay's faces: whether they have a piece that both solids share
    std::vector<std::uint32_t> members_first_, members_;
    std::vector<PieceUse> group_uses_, loops_, whole_loops_;
    std::vector<std::uint32_t> ends_, piece_ends_, wanted_;  ///< of loops_, of whole_loops_
    std::vector<OverlaySide> sides_;
    std::vector<CellSpoke> spokes_;
    LoopsByOutline outlines_;
};

CellKeeper::CellKeeper(Overlay& overlay, const DividedLines& lines, const CellSet& cells, const PieceUsers& users,
                       std::span<const CellLabel> labels, Selection selection)
    : selection_(std::move(selection)),
      work_(std::make_unique<Work>(overlay, lines, cells, users, labels, selection_, made_)) {}

CellKeeper::~CellKeeper() = default;

PhaseEnd CellKeeper::step(WorkSlice& slice) {
    return work_->step(slice);
}

}  // namespace firma
