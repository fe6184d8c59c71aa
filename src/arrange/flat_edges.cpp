// SPDX-License-Identifier: MIT
// Directed pieces in one plane.
#include "arrange/flat_edges.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "base/sort.h"
#include "geometry/exact_loop.h"

namespace firma {
namespace {

constexpr std::uint32_t kNoUse = ~0u;

}  // namespace

/// Of a piece; a whole edge that nothing met gets its line when it is first asked for.
std::uint32_t FlatEdges::line_of(const PieceUse& use) const {
    const Piece& piece = lines_.piece(use.piece);
    if (piece.line != Piece::kNoLine) return piece.line;
    const OverlayEdge& edge = overlay_.edges[use.edge];
    return overlay_.lines.add(edge.plane[0], edge.plane[1], piece.from);
}

/// Whether a use runs as its line does: pieces do, whole edges may not.
bool FlatEdges::runs_with_line(const PieceUse& use) const {
    const Piece& piece = lines_.piece(use.piece);
    if (piece.line != Piece::kNoLine) return use.forward;
    return overlay_.lines.before(line_of(use), piece.from, piece.to) == use.forward;
}

/// Another plane through the piece.
PlaneId FlatEdges::across(const PieceUse& use) const {
    const std::uint32_t line = line_of(use);
    const PlaneId first = overlay_.lines.plane(line, 0);
    return same_plane(first, plane_) ? overlay_.lines.plane(line, 1) : first;
}

/// Whether it runs along plane x across.
bool FlatEdges::runs_with(const PieceUse& use) const {
    return overlay_.lines.runs_along(line_of(use), plane_, across(use)) == runs_with_line(use);
}

/// Sign of the turn from one direction to another: (n x a) x (n x b) = n det(n, a, b).
int FlatEdges::turn(const PieceUse& a, const PieceUse& b) const {
    if (line_of(a) == line_of(b)) return 0;
    const int sign = exact_turn(overlay_.plane(plane_), overlay_.plane(across(a)), overlay_.plane(across(b)));
    return runs_with(a) == runs_with(b) ? sign : -sign;
}

/// Whether a, turning clockwise from the way back along `in`, is met before b.
bool FlatEdges::comes_before(const PieceUse& in, const PieceUse& a, const PieceUse& b) const {
    const auto part = [&](const PieceUse& out) {
        if (out.piece == in.piece) return 4;  // the way back itself: all the way around
        const int sign = turn(in, out);       // against the way back all turns change sign
        return 2 - sign;
    };
    const int part_a = part(a), part_b = part(b);
    if (part_a != part_b) return part_a < part_b;
    return turn(a, b) < 0;
}

bool FlatEdges::trace(std::span<const PieceUse> uses, std::vector<PieceUse>& loops, std::vector<std::uint32_t>& ends) {
    loops.clear();
    ends.clear();
    order_.resize(uses.size());
    std::iota(order_.begin(), order_.end(), 0u);
    sort_range(order_, [&](std::uint32_t a, std::uint32_t b) {
        const std::uint32_t of_a = from(uses[a]), of_b = from(uses[b]);
        return of_a != of_b ? of_a < of_b : a < b;
    });
    next_.assign(uses.size(), kNoUse);
    for (std::uint32_t k = 0; k < uses.size(); ++k) {
        const std::uint32_t at = to(uses[k]);
        auto out = std::lower_bound(order_.begin(), order_.end(), at,
                                    [&](std::uint32_t use, std::uint32_t point) { return from(uses[use]) < point; });
        std::uint32_t best = kNoUse;
        for (; out != order_.end() && from(uses[*out]) == at; ++out)
            if (best == kNoUse || comes_before(uses[k], uses[*out], uses[best])) best = *out;
        if (best == kNoUse) return false;
        next_[k] = best;
    }
    for (std::uint32_t first = 0; first < uses.size(); ++first) {
        if (next_[first] == kNoUse) continue;
        std::uint32_t use = first;
        while (next_[use] != kNoUse) {
            loops.push_back(uses[use]);
            use = std::exchange(next_[use], kNoUse);
        }
        if (use != first) return false;  // two lead to one
        ends.push_back(std::uint32_t(loops.size()));
    }
    return true;
}

std::uint32_t FlatEdges::meet(const PieceUse& use, PlaneId across_plane) {
    return overlay_.tables.points.add(plane_, across(use), across_plane);
}

/// Whether what lies just left of a use lies in what a loop goes around. A ray beside the use's line, so little to the
/// left that it passes all points of the line to their left, is followed on from the use.
bool FlatEdges::encloses(std::span<const PieceUse> loop, const PieceUse& use) {
    const PlaneId plane = across(use);
    const std::uint32_t line = line_of(use);
    const bool along = runs_with_line(use);
    const int left = runs_with(use) ? -1 : 1;  // left of plane x across lies behind across
    const auto is_left = [&](std::uint32_t point) { return overlay_.tables.points.side(plane, point) == left; };
    const std::uint32_t start = to(use);
    bool inside = false;
    bool here = is_left(from(loop[0]));
    for (const PieceUse& side : loop) {
        const std::uint32_t a = from(side), b = to(side);
        const bool there = is_left(b);
        if (here != there) {
            const std::uint32_t right = here ? b : a;
            const std::uint32_t at = overlay_.tables.points.side(plane, right) == 0 ? right : meet(side, plane);
            const bool behind = along ? overlay_.lines.before(line, at, start) : overlay_.lines.before(line, start, at);
            inside ^= !behind;
        }
        here = there;
    }
    return inside;
}

/// Mostly an area in double tells.
bool FlatEdges::runs_left(std::span<const PieceUse> loop) {
    const auto corner = [&](std::size_t k) -> const ExactPoint& { return overlay_.point(from(loop[k])); };
    if (const int turns = surely_turns(loop.size(), corner, overlay_.plane(plane_).front_view()); turns != 0)
        return turns > 0;
    return encloses(loop, loop[0]);
}

bool FlatEdges::group(std::span<const PieceUse> loops, std::span<const std::uint32_t> ends,
                      LoopsByOutline& by_outline) {
    outline_of_.assign(ends.size(), kNoUse);
    const auto loop = [&](std::size_t k) {
        const std::uint32_t first = k == 0 ? 0 : ends[k - 1];
        return loops.subspan(first, ends[k] - first);
    };
    std::vector<std::uint32_t> outlines;
    for (std::uint32_t k = 0; k < ends.size(); ++k) {
        if (ends.size() > 1 && !runs_left(loop(k))) continue;
        outline_of_[k] = k;
        outlines.push_back(k);
    }
    BoxTree boxes;
    if (outlines.size() > 1 && outlines.size() < ends.size()) boxes = boxes_of(loops, ends, outlines);
    for (std::uint32_t k = 0; k < ends.size(); ++k) {
        if (outline_of_[k] != kNoUse) continue;
        std::uint32_t best = kNoUse;
        if (outlines.size() == 1) {
            best = outlines[0];
        } else {
            // Rounding keeps order along each axis: what lies in an outline is, rounded, in its box.
            const PieceUse& hole = loop(k)[0];
            GridBox at;
            at.add(overlay_.point(from(hole)).rounded());
            at.add(overlay_.point(to(hole)).rounded());
            boxes.for_each_meeting(at, [&](std::uint32_t number) {
                const std::uint32_t outline = outlines[number];
                if (!encloses(loop(outline), hole)) return false;
                if (best == kNoUse || encloses(loop(best), loop(outline)[0])) best = outline;
                return false;
            });
        }
        if (best == kNoUse) return false;
        outline_of_[k] = best;
    }
    by_outline.set(outline_of_);
    return true;
}

/// Of the loops listed.
BoxTree FlatEdges::boxes_of(std::span<const PieceUse> loops, std::span<const std::uint32_t> ends,
                            std::span<const std::uint32_t> listed) const {
    std::vector<GridBox> boxes(listed.size());
    for (std::size_t k = 0; k < listed.size(); ++k)
        for (std::uint32_t use = listed[k] == 0 ? 0 : ends[listed[k] - 1]; use < ends[listed[k]]; ++use)
            boxes[k].add(overlay_.point(from(loops[use])).rounded());
    return BoxTree(boxes);
}

}  // namespace firma
