// SPDX-License-Identifier: MIT
// Pieces of one plane side by side become one, as long as that is convex.
//
// What a piece becomes depends on the pieces that it can reach from side to side in its plane, over sides that need not
// stay. A side has to stay where a polygon of another plane has a side on it: there a solid stands on both with an
// edge, and that has to stay an edge of theirs. A side that grows by merging still overlaps what the shorter one did,
// so what stops the short one stops the long one, too.
#include "join/merge_pieces.h"

#include <algorithm>

namespace firma {
namespace {

std::uint64_t key_of(std::uint32_t from, std::uint32_t to) {
    return std::uint64_t(from) << 32 | to;
}

std::size_t side_at(const ConvexPiece& piece, std::uint32_t corner) {
    std::size_t k = 0;
    while (k < piece.sides.size() && piece.corner(k) != corner) ++k;
    return k;
}

bool may_merge(const JoinPiece& a, const JoinPiece& b) {
    return a.piece.plane == b.piece.plane && a.material == b.material && a.mask == b.mask && a.texture == b.texture;
}

}  // namespace

bool same_piece(const JoinPiece& a, const JoinPiece& b) {
    const auto same_side = [](const PieceSide& x, const PieceSide& y) {
        return x.corner == y.corner && x.plane == y.plane;
    };
    return a.piece.plane == b.piece.plane && a.source == b.source && a.material == b.material && a.mask == b.mask &&
           a.texture == b.texture &&
           std::equal(a.piece.sides.begin(), a.piece.sides.end(), b.piece.sides.begin(), b.piece.sides.end(),
                      same_side);
}

std::uint32_t PieceMerger::add(JoinPiece piece, std::uint64_t order) {
    const auto number = std::uint32_t(entries_.size());
    Entry& entry = entries_.emplace_back();
    entry.first_side = sides_.add(number, piece.piece);
    entry.piece = std::move(piece);
    entry.order = order;
    entry.next = number;
    added_.push_back(number);
    ++live_;
    return number;
}

void PieceMerger::remove(std::uint32_t piece) {
    Entry& entry = entries_[piece];
    sides_.remove(entry.first_side, entry.piece.piece.sides.size());
    entry.live = false;
    removed_.push_back(piece);
    --live_;
}

void PieceMerger::merge_again(std::uint32_t piece) {
    Entry& entry = entries_[piece];
    if (entry.again || !entry.live) return;
    entry.again = true;
    again_.push_back(piece);
}

/// What was added, what had become one with what was removed, and all that has a side on a side of these; then whatever
/// can be reached from there.
void PieceMerger::find_again(const KeepSide& keep) {
    again_.clear();
    for (const std::uint32_t piece : added_) merge_again(piece);
    if (again_.size() == live_) return;  // nothing stays as it is
    const auto reach_neighbours = [&](std::uint32_t piece) {
        const Entry& entry = entries_[piece];
        for (std::uint32_t k = 0; k < entry.piece.piece.sides.size(); ++k) {
            const LineSide& side = sides_.side(entry.first_side + k);
            sides_.for_each_on(side.line, [&](std::uint32_t, const LineSide& other) {
                if (!entries_[other.owner].again && sides_.overlap(side, other)) merge_again(other.owner);
                return false;
            });
        }
    };
    for (const std::uint32_t piece : removed_) reach_neighbours(piece);
    for (const std::uint32_t piece : added_)
        if (entries_[piece].live) reach_neighbours(piece);
    for (const std::uint32_t piece : removed_)
        for (std::uint32_t k = entries_[piece].next; k != piece; k = entries_[k].next) merge_again(k);
    for (std::size_t k = 0; k < again_.size(); ++k) follow_sides(again_[k], keep);  // more are added by the way
}

void PieceMerger::follow_sides(std::uint32_t piece, const KeepSide& keep) {
    for (std::uint32_t k = entries_[piece].next; k != piece; k = entries_[k].next) merge_again(k);
    const Entry& entry = entries_[piece];
    const ConvexPiece& outline = entry.piece.piece;
    for (std::uint32_t k = 0; k < outline.sides.size(); ++k) {
        const LineSide& side = sides_.side(entry.first_side + k);
        std::uint32_t found = LineSide::kNone;
        const bool stays = sides_.for_each_on(side.line, [&](std::uint32_t, const LineSide& other) {
            if (other.owner == piece || !sides_.overlap(side, other)) return false;
            if (other.plane != side.plane) return true;
            if (!entries_[other.owner].again && may_merge(entry.piece, entries_[other.owner].piece))
                found = other.owner;
            return false;
        });
        if (stays || found == LineSide::kNone) continue;
        if (keep(outline.corner(k), outline.corner(outline.next(k)), outline.plane)) continue;
        sides_.for_each_on(side.line, [&](std::uint32_t, const LineSide& other) {
            if (other.plane == side.plane && sides_.overlap(side, other) &&
                may_merge(entry.piece, entries_[other.owner].piece))
                merge_again(other.owner);
            return false;
        });
    }
}

std::span<const std::uint32_t> PieceMerger::merge(const KeepSide& keep) {
    find_again(keep);
    changed_.clear();
    before_.clear();
    std::sort(again_.begin(), again_.end(), [&](std::uint32_t x, std::uint32_t y) {
        const PlaneId a = entries_[x].piece.piece.plane, b = entries_[y].piece.piece.plane;
        return a != b ? a < b : entries_[x].order < entries_[y].order;
    });
    for (const std::uint32_t piece : again_) {
        Entry& entry = entries_[piece];
        before_.push_back(std::move(entry.merged));
        entry.merged = entry.piece;
        entry.next = piece;
    }
    for (std::size_t first = 0; first < again_.size();) {
        const auto plane_of = [&](std::size_t k) { return entries_[again_[k]].piece.piece.plane; };
        std::size_t end = first;
        while (end < again_.size() && plane_of(end) == plane_of(first)) ++end;
        merge_plane({again_.data() + first, end - first}, keep);
        first = end;
    }
    for (std::size_t k = 0; k < again_.size(); ++k) {
        Entry& entry = entries_[again_[k]];
        entry.again = false;
        if (!same_piece(entry.merged, before_[k])) changed_.push_back(again_[k]);
    }
    for (const std::uint32_t piece : removed_) {
        Entry& entry = entries_[piece];
        entry.next = piece;
        if (!entry.merged.piece.sides.empty()) changed_.push_back(piece);
        entry.piece = entry.merged = {};
    }
    work_ += again_.size();
    added_.clear();
    removed_.clear();
    return changed_;
}

void PieceMerger::merge_plane(std::span<const std::uint32_t> group, const KeepSide& keep) {
    piece_of_.clear();
    for (const std::uint32_t index : group) enter(index);
    for (const std::uint32_t index : group)
        while (!entries_[index].merged.piece.sides.empty() && merge_longest(index, keep)) {
        }
}

void PieceMerger::enter(std::uint32_t index) {
    const ConvexPiece& piece = entries_[index].merged.piece;
    for (std::size_t k = 0; k < piece.sides.size(); ++k)
        piece_of_.at(key_of(piece.corner(k), piece.corner(piece.next(k)))) = index;
}

/// Between rounded corners: so it does not depend on which planes named them.
double PieceMerger::square_length(std::uint32_t from, std::uint32_t to) const {
    const Vec3 along = to_metres(tables_.points.point(to).rounded()) - to_metres(tables_.points.point(from).rounded());
    return dot(along, along);
}

/// Whether a polygon of another plane has a side that overlaps this one.
bool PieceMerger::others_at(const ConvexPiece& piece, std::size_t k) {
    const LineSide side = sides_.make(0, piece, k);
    return sides_.for_each_on(side.line, [&](std::uint32_t, const LineSide& other) {
        return other.plane != side.plane && sides_.overlap(side, other);
    });
}

bool PieceMerger::merge_longest(std::uint32_t index, const KeepSide& keep) {
    const JoinPiece& one = entries_[index].merged;
    tried_.clear();
    for (std::size_t k = 0; k < one.piece.sides.size(); ++k) {
        const std::uint32_t from = one.piece.corner(k), to = one.piece.corner(one.piece.next(k));
        const std::uint32_t other = piece_of_.find(key_of(to, from));
        if (other == FlatMap::kNone || other == index) continue;
        const JoinPiece& it = entries_[other].merged;
        if (!may_merge(it, one)) continue;
        const std::size_t b = side_at(it.piece, to);
        if (b == it.piece.sides.size() || it.piece.corner(it.piece.next(b)) != from) continue;  // gone meanwhile
        if (keep(from, to, one.piece.plane) || others_at(one.piece, k)) continue;
        tried_.push_back({k, other, b, square_length(from, to)});
    }
    std::sort(tried_.begin(), tried_.end(), [](const Shared& x, const Shared& y) {
        return x.length != y.length ? x.length > y.length : x.side < y.side;
    });
    for (const Shared& shared : tried_)
        if (merge_over(index, shared)) return true;
    return false;
}

bool PieceMerger::merge_over(std::uint32_t index, const Shared& shared) {
    JoinPiece& one = entries_[index].merged;
    JoinPiece& other = entries_[shared.other].merged;
    const ConvexPiece &p = one.piece, &q = other.piece;
    const std::size_t a = shared.side, b = shared.other_side;
    // Around the end of the shared side that is one's corner a, and around its other end.
    const int turn_a = turn(p, p.before(a), q, q.next(b));
    const int turn_b = turn(q, q.before(b), p, p.next(a));
    if (turn_a < 0 || turn_b < 0) return false;
    merged_.clear();
    for (std::size_t k = p.next(a); k != a; k = p.next(k)) merged_.push_back(p.sides[k]);
    const std::size_t from = merged_.size();
    for (std::size_t k = q.next(b); k != b; k = q.next(k)) merged_.push_back(q.sides[k]);
    // Where two sides now lie on one line the corner between them goes.
    if (turn_a == 0) merged_.erase(merged_.begin() + std::ptrdiff_t(from));
    if (turn_b == 0) {
        merged_.front().corner = merged_.back().corner;
        merged_.front().plane = merged_.back().plane;
        merged_.pop_back();
    }
    one.source = std::min(one.source, other.source);
    one.piece.sides = merged_;
    other.piece.sides.clear();
    std::swap(entries_[index].next, entries_[shared.other].next);  // two rings become one
    enter(index);
    return true;
}

int PieceMerger::turn(const ConvexPiece& in, std::size_t a, const ConvexPiece& out, std::size_t b) const {
    if (same_plane(in.sides[a].plane, out.sides[b].plane)) return 0;
    return exact_turn(tables_.planes.plane(in.plane), tables_.planes.plane(in.sides[a].plane),
                      tables_.planes.plane(out.sides[b].plane));
}

void merge_pieces(const ExactTables& tables, std::vector<JoinPiece>& pieces, const KeepSide& keep) {
    LineTable lines(tables);
    PieceMerger merger(tables, lines);
    for (std::uint32_t k = 0; k < pieces.size(); ++k) merger.add(std::move(pieces[k]), k);
    merger.merge(keep);
    for (std::uint32_t k = 0; k < pieces.size(); ++k) pieces[k] = merger.merged(k);
    std::erase_if(pieces, [](const JoinPiece& piece) { return piece.piece.sides.empty(); });
}

}  // namespace firma
