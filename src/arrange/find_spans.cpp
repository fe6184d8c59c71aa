// SPDX-License-Identifier: MIT
// Where faces of different solids meet.
#include "arrange/find_spans.h"

#include <algorithm>

#include "base/sort.h"
#include "index/box_tree.h"

namespace firma {

void SpanFinder::start() {
    touched_.assign(overlay_.faces.size(), 0);
    line_of_edge_.assign(overlay_.edges.size(), kNoLine);
}

void SpanFinder::put_on_line(std::uint32_t line, std::uint32_t point) {
    if (points_on_.size() <= line) points_on_.resize(line + 1);
    points_on_[line].push_back(point);
}

std::uint32_t SpanFinder::register_edge(std::uint32_t index) {
    std::uint32_t& line = line_of_edge_[index];
    if (line != kNoLine) return line;
    const OverlayEdge& edge = overlay_.edges[index];
    line = overlay_.lines.add(edge.plane[0], edge.plane[1], edge.from);
    put_on_line(line, edge.from);
    put_on_line(line, edge.to);
    return line;
}

void SpanFinder::know_edges(std::uint32_t face) {
    for (const OverlaySide& side : overlay_.sides(overlay_.faces[face])) register_edge(side.edge);
}

/// Its edges count as spans.
void SpanFinder::touch(std::uint32_t index) {
    if (touched_[index]) return;
    touched_[index] = 1;
    const OverlayFace& face = overlay_.faces[index];
    for (const OverlaySide& side : overlay_.sides(face)) {
        const std::uint32_t line = register_edge(side.edge);
        const std::uint32_t from = overlay_.from(side), to = overlay_.to(side);
        const bool along = overlay_.lines.before(line, from, to);
        // A loop has its face to the left.
        spans_.push_back({index, line, along ? from : to, along ? to : from,
                          std::uint8_t(along ? kCoversLeft : kCoversRight), side.edge, along == side.reversed});
    }
}

void SpanFinder::emit(std::uint32_t face, std::uint32_t line, const Interval& part) {
    touch(face);
    spans_.push_back({face, line, part.from, part.to, part.covers});
}

/// An end of a span divides the line, and the face's edges that it lies on.
void SpanFinder::end_at(const LineWalk& walk, std::uint32_t line, const Interval& part) {
    for (const std::uint32_t end : {part.from, part.to}) {
        put_on_line(line, end);
        walk.for_each_edge_at(end, [&](std::uint32_t edge) { put_on_line(register_edge(edge), end); });
    }
}

void SpanFinder::meet(std::uint32_t a, std::uint32_t b) {
    const PlaneId one = overlay_.faces[a].plane, other = overlay_.faces[b].plane;
    if (same_plane(one, other)) {
        coplanar_.emplace_back(a, b);
        return;
    }
    // The smaller one tells sooner whether they are apart.
    if (!other_walk_.start(b, one) || !walk_.start(a, other)) return;
    const std::uint32_t line = overlay_.lines.add(one, other, walk_.some_point());
    const std::vector<Interval>&of_a = walk_.finish(line), &of_b = other_walk_.finish(line);
    const LineTable& lines = overlay_.lines;
    for (std::size_t i = 0, j = 0; i < of_a.size() && j < of_b.size();) {
        const std::uint32_t from = lines.before(line, of_a[i].from, of_b[j].from) ? of_b[j].from : of_a[i].from;
        const bool a_ends = lines.before(line, of_a[i].to, of_b[j].to);
        const std::uint32_t to = a_ends ? of_a[i].to : of_b[j].to;
        if (lines.before(line, from, to)) {
            emit(a, line, {from, to, of_a[i].covers});
            emit(b, line, {from, to, of_b[j].covers});
            end_at(walk_, line, {from, to, 0});
            end_at(other_walk_, line, {from, to, 0});
        }
        (a_ends ? i : j)++;
    }
}

PlaneId SpanFinder::across(std::uint32_t line, PlaneId face) const {
    const PlaneId first = overlay_.lines.plane(line, 0);
    return same_plane(first, face) ? overlay_.lines.plane(line, 1) : first;
}

void SpanFinder::order_by_face() {
    first_.assign(overlay_.faces.size() + 1, 0);
    for (const FaceSpan& span : spans_) ++first_[span.face + 1];
    for (std::size_t k = 1; k < first_.size(); ++k) first_[k] += first_[k - 1];
    std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
    std::vector<FaceSpan> ordered(spans_.size());
    for (const FaceSpan& span : spans_) ordered[next[span.face]++] = span;
    spans_.swap(ordered);
}

bool SpanFinder::finish(WorkSlice& slice) {
    switch (stage_) {
        case Stage::kTouch:
            touch_coplanar();
            stage_ = Stage::kLend;
            [[fallthrough]];
        case Stage::kLend:
            if (!go_on(next_, 2 * coplanar_.size(), slice, [&](std::size_t k) {
                    const auto& [a, b] = coplanar_[k / 2];
                    lend(k % 2 ? b : a, k % 2 ? a : b, slice);
                }))
                return false;
            coplanar_.clear();
            order_by_face();
            stage_ = Stage::kCross;
            [[fallthrough]];
        case Stage::kCross:
            break;
    }
    return cross_next(slice);
}

void SpanFinder::touch_coplanar() {
    // The outline of an overlap comes from the neighbours' pairs; but where an edge of one solid runs over a face of
    // its own in this plane (a fin on a floor), only the other solid's face knows of it.
    for (const auto& [a, b] : coplanar_) {
        touch(a);
        touch(b);
    }
    order_by_face();
}

/// Each line of the one is walked through the other, once.
void SpanFinder::lend(std::uint32_t from, std::uint32_t to, WorkSlice& slice) {
    const LineTable& lines = overlay_.lines;
    const PlaneId plane = overlay_.faces[to].plane;
    std::vector<FaceSpan> lent(spans_.begin() + first_[from], spans_.begin() + first_[from + 1]);
    slice.take(lent.size());
    sort_range(lent, [](const FaceSpan& a, const FaceSpan& b) {
        return a.line != b.line ? a.line < b.line : a.from != b.from ? a.from < b.from : a.to < b.to;
    });
    for (std::size_t k = 0; k < lent.size();) {
        const std::uint32_t line = lent[k].line;
        std::size_t end = k;
        while (end < lent.size() && lent[end].line == line) ++end;
        if (walk_.start(to, across(line, plane))) {
            const std::vector<Interval>& intervals = walk_.finish(line);
            for (std::uint32_t last_from = ~0u, last_to = ~0u; k < end; ++k) {
                if (lent[k].from == last_from && lent[k].to == last_to) continue;
                last_from = lent[k].from;
                last_to = lent[k].to;
                for (const Interval& interval : intervals) {
                    const std::uint32_t first =
                        lines.before(line, last_from, interval.from) ? interval.from : last_from;
                    const std::uint32_t last = lines.before(line, last_to, interval.to) ? last_to : interval.to;
                    if (!lines.before(line, first, last)) continue;
                    emit(to, line, {first, last, interval.covers});
                    end_at(walk_, line, {first, last, 0});
                }
            }
        }
        k = end;
    }
}

bool SpanFinder::cross_next(WorkSlice& slice) {
    constexpr std::size_t kPairsAUnit = 32;
    for (; next_ < overlay_.faces.size(); ++next_) {
        if (!touched_[next_]) continue;
        if (boxed_of_ != next_) {
            boxed_of_ = next_;
            gather_crossing(std::uint32_t(next_));
            slice.take(1 + boxed_.size() / 4);
        }
        if (!go_on(next_boxed_, boxed_.size(), slice, [&](std::size_t i) {
                std::size_t j = i + 1;
                for (; j < boxed_.size() && boxed_[j].box.low[axis_] <= boxed_[i].box.high[axis_]; ++j)
                    if (boxes_meet(boxed_[i].box, boxed_[j].box))
                        cross_two(spans_[boxed_[i].span], spans_[boxed_[j].span]);
                slice.take((j - i) / kPairsAUnit);
            }))
            return false;
    }
    return true;
}

/// Only spans that run through the face's inside: what meets its rim was found by walking along it.
void SpanFinder::gather_crossing(std::uint32_t face) {
    boxed_.clear();
    GridBox all;
    for (std::uint32_t k = first_[face]; k < first_[face + 1]; ++k) {
        if (spans_[k].covers != kCoversBoth) continue;
        BoxedSpan boxed{{}, k};
        for (const std::uint32_t end : {spans_[k].from, spans_[k].to}) {
            boxed.box.add(overlay_.point(end).rounded());
            all.add(overlay_.point(end).rounded());
        }
        boxed_.push_back(boxed);
    }
    if (boxed_.size() < 2) return;
    axis_ = all.longest_axis();
    sort_range(boxed_, [&](const BoxedSpan& a, const BoxedSpan& b) {
        return a.box.low[axis_] != b.box.low[axis_] ? a.box.low[axis_] < b.box.low[axis_] : a.span < b.span;
    });
}

void SpanFinder::cross_two(const FaceSpan& a, const FaceSpan& b) {
    if (a.line == b.line) return;
    if (a.from == b.from || a.from == b.to || a.to == b.from || a.to == b.to) return;  // and meet nowhere else
    const PlaneId plane = overlay_.faces[a.face].plane;
    const PlaneId across_a = across(a.line, plane), across_b = across(b.line, plane);
    PointTable& points = overlay_.tables.points;
    const int from_b = points.side(across_a, b.from), to_b = points.side(across_a, b.to);
    if (from_b * to_b > 0) return;
    const int from_a = points.side(across_b, a.from), to_a = points.side(across_b, a.to);
    if (from_a * to_a > 0) return;
    if (from_b == 0 && to_b == 0) return;  // parallel lines do not come here: these would be one
    const std::uint32_t at = from_b == 0   ? b.from
                             : to_b == 0   ? b.to
                             : from_a == 0 ? a.from
                             : to_a == 0   ? a.to
                                           : points.add(plane, across_a, across_b);
    put_on_line(a.line, at);
    put_on_line(b.line, at);
}

}  // namespace firma
