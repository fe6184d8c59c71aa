// SPDX-License-Identifier: MIT
// Pieces of one plane side by side become one, as long as that is convex.
#include "join/merge_pieces.h"

#include <algorithm>
#include <numeric>
#include <span>
#include <tuple>

#include "join/line_table.h"

namespace firma {
namespace {

std::uint64_t key_of(std::uint32_t from, std::uint32_t to) {
    return std::uint64_t(from) << 32 | to;
}

double square_length(const JoinTables& tables, std::uint32_t from, std::uint32_t to) {
    const Vec3 along = tables.points.point(to).approximate() - tables.points.point(from).approximate();
    return dot(along, along);
}

/// Which other polygons have a side where two of one plane meet: there a solid stands on both with an edge, and that
/// has to stay an edge of theirs.
class SidesOnLines {
public:
    SidesOnLines(const JoinTables& tables, std::span<const JoinPiece> pieces) : lines_(tables) {
        for (const JoinPiece& it : pieces)
            for (std::size_t k = 0; k < it.piece.sides.size(); ++k) {
                const ConvexPiece& piece = it.piece;
                const std::uint32_t line = lines_.add(piece.plane, piece.sides[k].plane, piece.corner(k));
                Side side{line, piece.corner(k), piece.corner(piece.next(k)), piece.plane};
                if (!lines_.runs_along(line, piece.plane, piece.sides[k].plane)) std::swap(side.from, side.to);
                sides_.push_back(side);
            }
        std::sort(sides_.begin(), sides_.end(), [](const Side& a, const Side& b) {
            return std::tie(a.line, a.plane, a.from, a.to) < std::tie(b.line, b.plane, b.from, b.to);
        });
        first_.assign(lines_.size() + 1, 0);
        for (const Side& side : sides_) ++first_[side.line + 1];
        for (std::size_t k = 1; k < first_.size(); ++k) first_[k] += first_[k - 1];
    }

    /// Whether a polygon of another plane has a side that overlaps this one.
    bool others_at(const ConvexPiece& piece, std::size_t side) {
        std::uint32_t from = piece.corner(side), to = piece.corner(piece.next(side));
        const std::uint32_t line = lines_.add(piece.plane, piece.sides[side].plane, from);
        if (!lines_.runs_along(line, piece.plane, piece.sides[side].plane)) std::swap(from, to);
        for (std::uint32_t k = first_[line]; k < first_[line + 1]; ++k) {
            const Side& other = sides_[k];
            if (other.plane == piece.plane) continue;
            if (lines_.before(line, other.from, to) && lines_.before(line, from, other.to)) return true;
        }
        return false;
    }

private:
    struct Side {
        std::uint32_t line;
        std::uint32_t from, to;  ///< along the line
        PlaneId plane;
    };

    LineTable lines_;
    std::vector<Side> sides_;
    std::vector<std::uint32_t> first_;  ///< a line each, and the end
};

/// The pieces of one plane.
class PlaneMerger {
public:
    PlaneMerger(const JoinTables& tables, std::vector<JoinPiece>& pieces, const KeepSide& keep)
        : tables_(tables), pieces_(pieces), keep_(keep), sides_(tables, pieces) {}

    void merge(std::span<const std::uint32_t> group) {
        piece_of_.clear();
        for (const std::uint32_t index : group) enter(index, pieces_[index].piece, 0);
        for (const std::uint32_t index : group)
            while (!pieces_[index].piece.sides.empty() && merge_longest(index)) {
            }
    }

private:
    struct Shared {
        std::size_t side = 0;
        std::uint32_t other = FlatMap::kNone;
        std::size_t other_side = 0;
        double length = 0;
    };

    void enter(std::uint32_t index, const ConvexPiece& piece, std::size_t from) {
        for (std::size_t k = from; k < piece.sides.size(); ++k)
            piece_of_.at(key_of(piece.corner(k), piece.corner(piece.next(k)))) = index;
    }

    static std::size_t side_at(const ConvexPiece& piece, std::uint32_t corner) {
        std::size_t k = 0;
        while (k < piece.sides.size() && piece.corner(k) != corner) ++k;
        return k;
    }

    bool merge_longest(std::uint32_t index) {
        JoinPiece& one = pieces_[index];
        tried_.clear();
        for (std::size_t k = 0; k < one.piece.sides.size(); ++k) {
            const std::uint32_t from = one.piece.corner(k), to = one.piece.corner(one.piece.next(k));
            const std::uint32_t other = piece_of_.find(key_of(to, from));
            if (other == FlatMap::kNone || other == index) continue;
            const JoinPiece& it = pieces_[other];
            if (it.material != one.material || it.mask != one.mask) continue;
            const std::size_t b = side_at(it.piece, to);
            if (b == it.piece.sides.size() || it.piece.corner(it.piece.next(b)) != from) continue;  // gone meanwhile
            if (keep_(from, to, one.piece.plane) || sides_.others_at(one.piece, k)) continue;
            tried_.push_back({k, other, b, square_length(tables_, from, to)});
        }
        std::sort(tried_.begin(), tried_.end(), [](const Shared& x, const Shared& y) {
            return x.length != y.length ? x.length > y.length : x.side < y.side;
        });
        for (const Shared& shared : tried_)
            if (merge_over(index, shared)) return true;
        return false;
    }

    bool merge_over(std::uint32_t index, const Shared& shared) {
        const ConvexPiece& one = pieces_[index].piece;
        const ConvexPiece& other = pieces_[shared.other].piece;
        const std::size_t a = shared.side, b = shared.other_side;
        // Around the end of the shared side that is one's corner a, and around its other end.
        const int turn_a = turn(one, one.before(a), other, other.next(b));
        const int turn_b = turn(other, other.before(b), one, one.next(a));
        if (turn_a < 0 || turn_b < 0) return false;
        merged_.clear();
        for (std::size_t k = one.next(a); k != a; k = one.next(k)) merged_.push_back(one.sides[k]);
        const std::size_t from = merged_.size();
        for (std::size_t k = other.next(b); k != b; k = other.next(k)) merged_.push_back(other.sides[k]);
        // Where two sides now lie on one line the corner between them goes.
        if (turn_a == 0) merged_.erase(merged_.begin() + std::ptrdiff_t(from));
        if (turn_b == 0) {
            merged_.front().corner = merged_.back().corner;
            merged_.front().plane = merged_.back().plane;
            merged_.pop_back();
        }
        pieces_[index].source = std::min(pieces_[index].source, pieces_[shared.other].source);
        pieces_[shared.other].piece.sides.clear();
        pieces_[index].piece.sides = merged_;
        enter(index, pieces_[index].piece, 0);
        return true;
    }

    int turn(const ConvexPiece& in, std::size_t a, const ConvexPiece& out, std::size_t b) const {
        if (same_plane(in.sides[a].plane, out.sides[b].plane)) return 0;
        return exact_turn(tables_.planes.plane(in.plane), tables_.planes.plane(in.sides[a].plane),
                          tables_.planes.plane(out.sides[b].plane));
    }

    const JoinTables& tables_;
    std::vector<JoinPiece>& pieces_;
    const KeepSide& keep_;
    SidesOnLines sides_;
    FlatMap piece_of_;  ///< by a side's corners, from and to; may name one that has gone
    std::vector<Shared> tried_;
    std::vector<PieceSide> merged_;
};

}  // namespace

void merge_pieces(const JoinTables& tables, std::vector<JoinPiece>& pieces, const KeepSide& keep) {
    std::vector<std::uint32_t> order(pieces.size());
    std::iota(order.begin(), order.end(), 0u);
    std::sort(order.begin(), order.end(), [&](std::uint32_t x, std::uint32_t y) {
        const PlaneId a = pieces[x].piece.plane, b = pieces[y].piece.plane;
        return a != b ? a < b : x < y;
    });
    PlaneMerger merger(tables, pieces, keep);
    for (std::size_t first = 0; first < order.size();) {
        std::size_t end = first;
        while (end < order.size() && pieces[order[end]].piece.plane == pieces[order[first]].piece.plane) ++end;
        merger.merge({order.data() + first, end - first});
        first = end;
    }
    std::erase_if(pieces, [](const JoinPiece& piece) { return piece.piece.sides.empty(); });
}

}  // namespace firma
