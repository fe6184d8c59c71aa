// SPDX-License-Identifier: MIT
// From cells and their edges to the loops of faces.
#include "arrange/write_cells.h"

#include <algorithm>

#include "base/sort.h"

namespace firma {
namespace {

constexpr std::uint32_t kMadeEdge = ~0u - 1;

}  // namespace

CellWriter::CellWriter(KeptCells& in, Arranged& made)
    : in_(in),
      made_(made),
      next_(in.uses.size(), KeptCells::kNone),
      chain_(in.uses.size(), KeptCells::kNone),
      seen_(in.uses.size(), 0) {}

void CellWriter::know_edge(std::uint32_t edge) {
    if (!in_.selection.reusable(edge)) return;
    const OverlayEdge& it = in_.overlay.edges[edge];
    edge_between_.at(pair_key(it.from, it.to)) = edge;
}

void CellWriter::gather_groups() {
    std::vector<std::uint32_t> number(in_.cells.cells.size(), KeptCells::kNone);
    std::uint32_t count = 0;
    for (std::uint32_t cell = 0; cell < in_.cells.cells.size(); ++cell)
        if (in_.kept[cell] != Kept::kNot && in_.groups.find(cell) == cell) number[cell] = count++;
    members_first_.assign(count + 1, 0);
    for (std::uint32_t cell = 0; cell < in_.cells.cells.size(); ++cell)
        if (in_.kept[cell] != Kept::kNot) ++members_first_[number[in_.groups.find(cell)] + 1];
    for (std::size_t k = 1; k < members_first_.size(); ++k) members_first_[k] += members_first_[k - 1];
    members_.resize(members_first_.back());
    std::vector<std::uint32_t> next(members_first_.begin(), members_first_.end() - 1);
    for (std::uint32_t cell = 0; cell < in_.cells.cells.size(); ++cell)
        if (in_.kept[cell] != Kept::kNot) members_[next[number[in_.groups.find(cell)]]++] = cell;
}

bool CellWriter::trace(std::uint32_t group) {
    group_uses_.clear();
    for (const std::uint32_t cell : members(group)) {
        const Cell& it = in_.cells.cells[cell];
        for (std::uint32_t use = it.first_use; use < it.first_use + it.use_count; ++use)
            if (!in_.dissolved[use]) group_uses_.push_back(in_.uses[use]);
    }
    in_.flat.start(in_.plane_of(members(group)[0]));
    if (is_whole(group)) {
        follow_cell(in_.cells.cells[members(group)[0]]);
        return true;
    }
    if (!in_.flat.trace(group_uses_, loops_, ends_)) return false;
    std::uint32_t first = 0;
    for (const std::uint32_t end : ends_) {
        for (std::uint32_t k = first; k < end; ++k) next_[loops_[k].id] = loops_[k + 1 < end ? k + 1 : first].id;
        first = end;
    }
    return true;
}

bool CellWriter::write(std::uint32_t group) {
    const auto cells = members(group);
    ArrangedFace face;
    face.face = in_.cells.cells[cells[0]].face;
    face.plane = in_.plane_of(cells[0]);
    in_.flat.start(face.plane);
    // Loops of the uses that edges begin with.
    loops_.clear();
    ends_.clear();
    sides_.clear();
    for (const std::uint32_t cell : cells) {
        const Cell& it = in_.cells.cells[cell];
        for (std::uint32_t use = it.first_use; use < it.first_use + it.use_count; ++use) {
            if (in_.dissolved[use] || seen_[use]) continue;
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
                loops_.push_back(in_.uses[at]);
                sides_.push_back({edge, made_.edges[edge].from != in_.flat.from(in_.uses[at]) ||
                                            made_.edges[edge].to != in_.flat.to(in_.uses[last])});
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

std::span<const std::uint32_t> CellWriter::members(std::uint32_t group) const {
    return {members_.data() + members_first_[group], members_first_[group + 1] - members_first_[group]};
}

bool CellWriter::is_whole(std::uint32_t group) const {
    const auto cells = members(group);
    return cells.size() == 1 && in_.kept[cells[0]] == Kept::kAsItIs &&
           group_uses_.size() == in_.cells.cells[cells[0]].use_count;
}

void CellWriter::follow_cell(const Cell& cell) {
    std::uint32_t first = 0;
    for (const std::uint32_t end : in_.cells.ends(cell)) {
        for (std::uint32_t k = first; k < end; ++k)
            next_[cell.first_use + k] = cell.first_use + (k + 1 < end ? k + 1 : first);
        first = end;
    }
}

bool CellWriter::passes_through(std::uint32_t use) {
    const std::uint32_t after = next_[use];
    if (after == use) return false;
    const std::uint32_t line = in_.lines.piece(in_.uses[use].piece).line;
    if (line == Piece::kNoLine || in_.lines.piece(in_.uses[after].piece).line != line) return false;
    if (in_.uses[use].forward != in_.uses[after].forward) return false;  // it turns back
    const bool same_edge = in_.uses[use].edge != FacePiece::kNoEdge && in_.uses[use].edge == in_.uses[after].edge;
    if (!same_edge && !in_.contact[in_.flat.to(in_.uses[use])]) return false;
    const std::uint32_t there = in_.partner[use], there_after = in_.partner[after];
    if (in_.selection.keeps_ends && ends_stay(use, after)) return false;
    if (there == KeptCells::kNone || there_after == KeptCells::kNone) return same_edge && there == there_after;
    return next_[there_after] == there && in_.group_of(there) == in_.group_of(there_after);
}

bool CellWriter::may_stay(std::uint32_t use) const {
    const std::uint32_t edge = in_.uses[use].edge;
    return edge != FacePiece::kNoEdge && in_.selection.reusable(edge);
}

bool CellWriter::ends_stay(std::uint32_t use, std::uint32_t after) const {
    const std::uint32_t there = in_.partner[use], there_after = in_.partner[after], edge = in_.uses[use].edge;
    const std::uint32_t piece = in_.uses[use].piece, next = in_.uses[after].piece;
    const bool one_edge = may_stay(use) && in_.uses[after].edge == edge;
    // What lies beyond is not here: the edge stays as it is.
    if (one_edge && there == KeptCells::kNone && there_after == KeptCells::kNone) return false;
    if (in_.users.shared(piece) != in_.users.shared(next)) return true;
    if (in_.selection.keeps_corners && (has_corner(piece, next) || has_corner(next, piece))) return true;
    const bool one_beyond = there != KeptCells::kNone && there_after != KeptCells::kNone &&
                            in_.uses[there].edge == edge && in_.uses[there_after].edge == edge;
    return !(one_edge && one_beyond) && (has_ending(piece, next) || has_ending(next, piece));
}

/// Of faces that go, too: what stood at their edges may stay.
bool CellWriter::has_ending(std::uint32_t piece, std::uint32_t next) const {
    const auto beyond = in_.users.at(next);
    for (const std::uint32_t one : in_.users.at(piece))
        if (may_stay(one) && std::none_of(beyond.begin(), beyond.end(), [&](std::uint32_t other) {
                return in_.uses[other].edge == in_.uses[one].edge;
            }))
            return true;
    return false;
}

/// An outline may touch a line with a corner: then one cell lies at both pieces, or two do, and none goes on there.
bool CellWriter::has_corner(std::uint32_t piece, std::uint32_t next) const {
    for (const std::uint32_t use : in_.users.at(piece)) {
        const Cell& cell = in_.cells.cells[in_.users.cell_of(use)];
        if (in_.overlay.faces[cell.face].operand == 0 && !in_.is_kept(use) && !goes_on(use, next)) return true;
    }
    return false;
}

/// Whether what stands before or after a use in its loop is another piece's.
bool CellWriter::goes_on(std::uint32_t use, std::uint32_t next) const {
    const Cell& cell = in_.cells.cells[in_.users.cell_of(use)];
    const std::uint32_t at = use - cell.first_use;
    std::uint32_t first = 0;
    for (const std::uint32_t end : in_.cells.ends(cell)) {
        if (at < end) {
            const std::uint32_t before = at > first ? at - 1 : end - 1, after = at + 1 < end ? at + 1 : first;
            return in_.uses[cell.first_use + before].piece == next || in_.uses[cell.first_use + after].piece == next;
        }
        first = end;
    }
    return false;
}

std::uint32_t CellWriter::edge_of(std::uint32_t first, std::uint32_t last) {
    if (chain_[first] != KeptCells::kNone) return chain_[first];
    const auto number = std::uint32_t(made_.edges.size());
    ArrangedEdge edge;
    edge.from = in_.flat.from(in_.uses[first]);
    edge.to = in_.flat.to(in_.uses[last]);
    edge.edge = whole_edge(first, last);
    if (edge.edge != ArrangedEdge::kNoEdge) {
        edge.from = in_.overlay.edges[edge.edge].from;
        edge.to = in_.overlay.edges[edge.edge].to;
    }
    const std::uint32_t line = in_.lines.piece(in_.uses[first].piece).line;
    for (int k = 0; k < 2; ++k)
        edge.plane[k] = line == Piece::kNoLine ? in_.overlay.edges[in_.uses[first].edge].plane[k]
                                               : in_.overlay.lines.plane(line, k);
    edge.doubled = is_doubled(first, last) || has_twin(first, last);
    made_.edges.push_back(edge);
    for (std::uint32_t use = first;; use = next_[use]) {
        chain_[use] = number;
        if (in_.partner[use] != KeptCells::kNone) chain_[in_.partner[use]] = number;
        if (use == last) break;
    }
    return number;
}

bool CellWriter::is_doubled(std::uint32_t first, std::uint32_t last) const {
    for (std::uint32_t use = first;; use = next_[use]) {
        const std::uint32_t edge = in_.uses[use].edge;
        if (in_.crowded[use] || (edge != FacePiece::kNoEdge && in_.overlay.edges[edge].doubled)) return true;
        if (use == last) return false;
    }
}

bool CellWriter::has_twin(std::uint32_t first, std::uint32_t last) {
    const std::uint32_t from = in_.flat.from(in_.uses[first]), to = in_.flat.to(in_.uses[last]);
    std::uint32_t& known = edge_between_.at(pair_key(from, to));
    if (known == FlatMap::kNone) {
        known = kMadeEdge;
        return false;
    }
    return known == kMadeEdge || known != in_.uses[first].edge;
}

std::uint64_t CellWriter::pair_key(std::uint32_t a, std::uint32_t b) {
    return std::uint64_t(std::min(a, b)) << 32 | std::max(a, b);
}

std::uint32_t CellWriter::whole_edge(std::uint32_t first, std::uint32_t last) const {
    const std::uint32_t edge = in_.uses[first].edge;
    if (edge == FacePiece::kNoEdge || !in_.selection.reusable(edge)) return ArrangedEdge::kNoEdge;
    for (std::uint32_t use = first;; use = next_[use]) {
        if (in_.uses[use].edge != edge || in_.crowded[use] > in_.overlay.edges[edge].doubled)
            return ArrangedEdge::kNoEdge;
        if (in_.partner[use] != KeptCells::kNone && in_.uses[in_.partner[use]].edge != edge)
            return ArrangedEdge::kNoEdge;
        if (use == last) break;
    }
    const std::uint32_t from = in_.flat.from(in_.uses[first]), to = in_.flat.to(in_.uses[last]);
    const OverlayEdge& it = in_.overlay.edges[edge];
    const bool whole = (it.from == from && it.to == to) || (it.from == to && it.to == from);
    return whole ? edge : ArrangedEdge::kNoEdge;
}

bool CellWriter::stays_whole(std::uint32_t index, std::span<const OverlaySide> sides,
                             std::span<const std::uint32_t> cells) {
    const OverlayFace& face = in_.overlay.faces[index];
    if (sides.size() != face.side_count || in_.kept[cells[0]] == Kept::kTurned) return false;
    wanted_.clear();
    for (const OverlaySide& side : sides) {
        const std::uint32_t edge = made_.edges[side.edge].edge;
        if (edge == ArrangedEdge::kNoEdge) return false;
        wanted_.push_back(edge);
    }
    std::vector<std::uint32_t> own;
    for (const OverlaySide& side : in_.overlay.sides(face)) own.push_back(side.edge);
    sort_range(wanted_);
    sort_range(own);
    return wanted_ == own;
}

bool CellWriter::add_faces(const ArrangedFace& like) {
    find_whole_loops();
    if (!in_.flat.group(whole_loops_, piece_ends_, outlines_)) return false;
    for (std::size_t k = 0; k < outlines_.outlines().size(); ++k) {
        ArrangedFace face = like;
        face.first_use = std::uint32_t(made_.all_uses.size());
        face.first_loop = std::uint32_t(made_.loop_ends.size());
        face.loop_count = std::uint32_t(outlines_.loops(k).size());
        append_loops<OverlaySide>(sides_, ends_, outlines_.loops(k), face.first_use, made_.all_uses, made_.loop_ends);
        face.use_count = std::uint32_t(made_.all_uses.size()) - face.first_use;
        made_.faces.push_back(face);
    }
    return true;
}

void CellWriter::find_whole_loops() {
    whole_loops_.clear();
    piece_ends_.clear();
    for (std::size_t loop = 0; loop < ends_.size(); ++loop) {
        const std::uint32_t start = loops_[loop == 0 ? 0 : ends_[loop - 1]].id;
        std::uint32_t use = start;
        do {
            whole_loops_.push_back(in_.uses[use]);
            use = next_[use];
        } while (use != start);
        piece_ends_.push_back(std::uint32_t(whole_loops_.size()));
    }
}

}  // namespace firma
