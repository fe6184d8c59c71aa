// SPDX-License-Identifier: MIT
// How the polygons of a joined level meet, line by line: around each piece of a line between neighbouring corners the
// polygons are put in order, and air and solid must alternate.
#include "join/arrangement.h"

#include <algorithm>
#include <numeric>

namespace firma {
namespace {

constexpr std::uint32_t kNoEdge = ~0u;

/// A half plane, turned by a right angle about the line, is the normal of the plane that it is known by.
class LineAngles final : public SpokeAngles {
public:
    LineAngles(const LineTable& lines, const ExactTables& tables, std::uint32_t line)
        : lines_(lines), tables_(tables), line_(line) {}

    int turn(PlaneId a, PlaneId b) const override { return lines_.turn(line_, a, b); }
    bool same_half(PlaneId a, PlaneId b) const override {
        const Plane &p = tables_.planes.plane(a), &q = tables_.planes.plane(b);
        const int axis = p.dominant_axis();
        return (p.normal[axis] > 0) == (q.normal[axis] > 0);
    }

private:
    const LineTable& lines_;
    const ExactTables& tables_;
    const std::uint32_t line_;
};

}  // namespace

std::uint32_t Arranger::add(const ConvexPiece& piece, bool face) {
    const auto number = std::uint32_t(polygons_.size());
    Polygon polygon;
    polygon.first_side = sides_.add(number, piece);
    polygon.side_count = std::uint32_t(piece.sides.size());
    polygon.face = face;
    polygons_.push_back(polygon);
    divisions_.resize(sides_.size());
    note_lines(number);
    note_outline(number);
    return number;
}

void Arranger::remove(std::uint32_t polygon) {
    Polygon& it = polygons_[polygon];
    it.live = false;
    sides_.remove(it.first_side, it.side_count);
    note_lines(polygon);
}

void Arranger::note_lines(std::uint32_t polygon) {
    const Polygon& it = polygons_[polygon];
    line_.resize(sides_.line_count());
    for (std::uint32_t k = it.first_side; k < it.first_side + it.side_count; ++k) {
        Line& line = line_[sides_.side(k).line];
        if (line.dirty) continue;
        line.dirty = true;
        dirty_.push_back(sides_.side(k).line);
    }
}

void Arranger::note_outline(std::uint32_t polygon) {
    if (polygons_[polygon].noted) return;
    polygons_[polygon].noted = true;
    noted_.push_back(polygon);
}

std::span<const std::uint32_t> Arranger::update() {
    std::size_t kept = 0;
    for (std::size_t k = 0; k < open_.size(); ++k) {
        if (line_[line_of_open_[k]].dirty) continue;
        if (kept != k) open_[kept] = std::move(open_[k]);
        line_of_open_[kept++] = line_of_open_[k];
    }
    open_.resize(kept);
    line_of_open_.resize(kept);
    for (const std::uint32_t line : dirty_) arrange_line(line);
    work_ += dirty_.size();
    dirty_.clear();
    changed_.clear();
    for (const std::uint32_t polygon : noted_) {
        polygons_[polygon].noted = false;
        if (polygons_[polygon].live) changed_.push_back(polygon);
    }
    noted_.clear();
    return changed_;
}

void Arranger::arrange_line(std::uint32_t line) {
    on_line_.clear();
    corners_.clear();
    sides_.for_each_on(line, [&](std::uint32_t k, const LineSide& side) {
        on_line_.push_back(k);
        corners_.push_back(side.from);
        corners_.push_back(side.to);
        return false;
    });
    std::sort(corners_.begin(), corners_.end());
    corners_.erase(std::unique(corners_.begin(), corners_.end()), corners_.end());
    std::sort(corners_.begin(), corners_.end(),
              [&](std::uint32_t a, std::uint32_t b) { return lines_.before(line, a, b); });
    for (std::uint32_t k = 0; k < corners_.size(); ++k) place_of_.at(corners_[k]) = k;

    line_[line].dirty = false;
    line_[line].first_seen = std::uint32_t(seen_.size());
    in_piece_.clear();
    for (const std::uint32_t index : on_line_) {
        const std::uint32_t first = place_of_.find(sides_.side(index).from);
        const std::uint32_t last = place_of_.find(sides_.side(index).to);
        divide_side(index, first, last);
        for (std::uint32_t k = first; k < last; ++k) in_piece_.push_back({k, index});
    }
    place_of_.clear();
    std::sort(in_piece_.begin(), in_piece_.end());
    for (std::size_t first = 0; first < in_piece_.size();) {
        std::size_t end = first;
        spokes_.clear();
        for (; end < in_piece_.size() && in_piece_[end].first == in_piece_[first].first; ++end) {
            const LineSide& side = sides_.side(in_piece_[end].second);
            const bool portal = !polygons_[side.owner].face;
            spokes_.push_back({side.forward ? side.plane : from_behind(side.plane), in_piece_[end].second,
                               portal || !side.forward, portal || side.forward});
        }
        arrange_piece(line, in_piece_[first].first);
        first = end;
    }
    line_[line].seen_count = std::uint32_t(seen_.size()) - line_[line].first_seen;
}

/// @param first, last  corners of the line
void Arranger::divide_side(std::uint32_t side, std::uint32_t first, std::uint32_t last) {
    Division& division = divisions_[side];
    division.first = first;
    const std::uint32_t* corners = corners_.data() + first;
    const std::uint32_t count = last - first;
    if (division.count == count && std::equal(corners, corners + count + 1, corners_along_.data() + division.corners)) {
        std::fill_n(edge_of_piece_.data() + division.pieces, count, kNoEdge);
        return;
    }
    note_outline(sides_.side(side).owner);
    division.count = count;
    division.corners = std::uint32_t(corners_along_.size());
    corners_along_.insert(corners_along_.end(), corners, corners + count + 1);
    division.pieces = std::uint32_t(edge_of_piece_.size());
    edge_of_piece_.resize(edge_of_piece_.size() + count, kNoEdge);
}

void Arranger::arrange_piece(std::uint32_t line, std::uint32_t piece) {
    if (!sort_spokes(spokes_, LineAngles(lines_, tables_, line))) return note_open(line, piece);
    pair_faces(piece);
    for (std::size_t k = 0; k < spokes_.size(); ++k) {
        const Spoke &here = spokes_[k], &next = spokes_[k + 1 < spokes_.size() ? k + 1 : 0];
        if (here.air_after) seen_.push_back({side_after(here), side_before(next)});
    }
}

// Turning about the line, the front of a polygon that runs along it comes after it, that of one that runs against it
// before it.
std::uint32_t Arranger::side_after(const Spoke& spoke) const {
    const LineSide& side = sides_.side(spoke.owner);
    return 2 * side.owner + !side.forward;
}
std::uint32_t Arranger::side_before(const Spoke& spoke) const {
    const LineSide& side = sides_.side(spoke.owner);
    return 2 * side.owner + side.forward;
}

/// Each face that runs along the line bounds one wedge of air with the next face that runs against it.
void Arranger::pair_faces(std::uint32_t piece) {
    around_.clear();
    for (const Spoke& spoke : spokes_)
        if (polygons_[sides_.side(spoke.owner).owner].face) around_.push_back(spoke.owner);
    for (std::size_t k = 0; k < around_.size(); ++k) {
        const LineSide& side = sides_.side(around_[k]);
        if (!side.forward) continue;
        const std::uint32_t other = around_[k + 1 < around_.size() ? k + 1 : 0];
        const auto edge = std::uint32_t(edges_.size());
        edges_.push_back({{corners_[piece], corners_[piece + 1]},
                          {side.owner, sides_.side(other).owner},
                          side.across,
                          around_.size() > 2});
        for (const std::uint32_t index : {around_[k], other})
            edge_of_piece_[divisions_[index].pieces + piece - divisions_[index].first] = edge;
    }
}

void Arranger::note_open(std::uint32_t line, std::uint32_t piece) {
    OpenEdge edge{{corners_[piece], corners_[piece + 1]}, {}};
    for (const Spoke& spoke : spokes_) edge.polygons.push_back(sides_.side(spoke.owner).owner);
    open_.push_back(std::move(edge));
    line_of_open_.push_back(line);
}

void Arranger::outline(std::uint32_t polygon, std::vector<std::uint32_t>& corners) const {
    corners.clear();
    const Polygon& it = polygons_[polygon];
    for (std::uint32_t k = it.first_side; k < it.first_side + it.side_count; ++k) {
        const Division& division = divisions_[k];
        for (std::uint32_t i = 0; i < division.count; ++i)
            corners.push_back(corners_along_[division.corners + (sides_.side(k).forward ? i : division.count - i)]);
    }
}

Arrangement Arranger::arrangement(std::span<const std::uint32_t> order) const {
    Arrangement made;
    std::vector<std::uint32_t> number(polygons_.size(), ~0u), number_of_edge(edges_.size(), kNoEdge);
    std::uint32_t faces = 0;
    for (std::uint32_t k = 0; k < order.size(); ++k) {
        number[order[k]] = k;
        faces += polygons_[order[k]].face;
    }
    made.first_step.reserve(order.size() + 1);
    made.first_step.push_back(0);
    for (const std::uint32_t polygon : order) {
        const Polygon& it = polygons_[polygon];
        for (std::uint32_t k = it.first_side; k < it.first_side + it.side_count; ++k) {
            const Division& division = divisions_[k];
            const bool forward = sides_.side(k).forward;
            for (std::uint32_t i = 0; i < division.count; ++i) {
                const std::uint32_t piece = forward ? i : division.count - 1 - i;
                std::uint32_t edge = edge_of_piece_[division.pieces + piece];
                if (edge != kNoEdge) {
                    std::uint32_t& known = number_of_edge[edge];
                    if (known == kNoEdge) {
                        known = std::uint32_t(made.edges.size());
                        JoinEdge& copy = made.edges.emplace_back(edges_[edge]);
                        for (std::uint32_t& face : copy.face) face = number[face];
                    }
                    edge = known;
                }
                made.steps.push_back({corners_along_[division.corners + piece + !forward], edge});
            }
        }
        made.first_step.push_back(std::uint32_t(made.steps.size()));
    }
    made.seen_together = DisjointSets(faces + 2 * (order.size() - faces));
    const auto side = [&](std::uint32_t seen) {
        const std::uint32_t polygon = number[seen / 2];
        return polygon < faces ? polygon : faces + 2 * (polygon - faces) + seen % 2;
    };
    for (const Line& line : line_)
        for (std::uint32_t k = line.first_seen; k < line.first_seen + line.seen_count; ++k)
            made.seen_together.join(side(seen_[k].first), side(seen_[k].second));
    return made;
}

Arrangement arrange(const ExactTables& tables, std::span<const JoinPiece> faces, std::span<const ConvexPiece> portals,
                    std::vector<OpenEdge>& open) {
    LineTable lines(tables);
    Arranger arranger(tables, lines);
    for (const JoinPiece& face : faces) arranger.add(face.piece, true);
    for (const ConvexPiece& portal : portals) arranger.add(portal, false);
    arranger.update();
    open.insert(open.end(), arranger.open().begin(), arranger.open().end());
    std::vector<std::uint32_t> order(faces.size() + portals.size());
    std::iota(order.begin(), order.end(), 0u);
    return arranger.arrangement(order);
}

}  // namespace firma
