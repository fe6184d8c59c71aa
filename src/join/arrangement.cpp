// SPDX-License-Identifier: MIT
// How the polygons of a joined level meet, line by line: around each piece of a line between neighbouring corners the
// polygons are put in order, and air and solid must alternate.
// Source: for the order around an edge as what makes a space of cells out of polygons, P. Hachenberger, L. Kettner,
// K. Mehlhorn, Boolean Operations on 3D Selective Nef Complexes, 2007.
#include "join/arrangement.h"

#include <algorithm>

namespace firma {
namespace {

/// A polygon's side on its line.
struct LineUse {
    std::uint32_t line;
    std::uint32_t polygon;
    std::uint32_t from, to;             ///< corners, along the polygon
    PlaneId plane;                      ///< the polygon's
    bool forward;                       ///< along the line
    std::uint32_t first = 0, last = 0;  ///< where it begins and ends among the line's corners
    std::uint32_t pieces = 0;           ///< its first one in `edge_of_piece`, in order along the line
};

/// A polygon around a piece of a line.
struct Spoke {
    std::uint32_t use;
    PlaneId turned;  ///< its half plane, turned by a right angle about the line, is this plane's normal
};

class Arranger {
public:
    Arranger(const JoinTables& tables, std::span<const JoinPiece> faces, std::span<const ConvexPiece> portals,
             std::vector<OpenEdge>& open)
        : tables_(tables), faces_(faces), portals_(portals), open_(open), lines_(tables) {
        result_.seen_together = DisjointSets(faces.size() + 2 * portals.size());
    }

    Arrangement arrange() {
        find_uses();
        for (std::size_t first = 0; first < by_line_.size();) {
            std::size_t end = first;
            while (end < by_line_.size() && uses_[by_line_[end]].line == uses_[by_line_[first]].line) ++end;
            arrange_line({by_line_.data() + first, end - first});
            first = end;
        }
        write_outlines();
        return std::move(result_);
    }

private:
    const ConvexPiece& polygon(std::size_t index) const {
        return index < faces_.size() ? faces_[index].piece : portals_[index - faces_.size()];
    }
    bool is_face(std::uint32_t index) const { return index < faces_.size(); }

    void find_uses() {
        for (std::uint32_t p = 0; p < faces_.size() + portals_.size(); ++p) {
            const ConvexPiece& it = polygon(p);
            for (std::size_t k = 0; k < it.sides.size(); ++k) {
                const std::uint32_t line = lines_.add(it.plane, it.sides[k].plane, it.corner(k));
                const bool forward = lines_.runs_along(line, it.plane, it.sides[k].plane);
                uses_.push_back({line, p, it.corner(k), it.corner(it.next(k)), it.plane, forward});
            }
        }
        by_line_.resize(uses_.size());
        std::vector<std::uint32_t> start(lines_.size() + 1);
        for (const LineUse& use : uses_) ++start[use.line + 1];
        for (std::size_t k = 1; k < start.size(); ++k) start[k] += start[k - 1];
        for (std::uint32_t k = 0; k < uses_.size(); ++k) by_line_[start[uses_[k].line]++] = k;
    }

    void arrange_line(std::span<const std::uint32_t> uses) {
        const std::uint32_t line = uses_[uses[0]].line;
        corners_.clear();
        for (const std::uint32_t use : uses) {
            corners_.push_back(uses_[use].from);
            corners_.push_back(uses_[use].to);
        }
        std::sort(corners_.begin(), corners_.end());
        corners_.erase(std::unique(corners_.begin(), corners_.end()), corners_.end());
        std::sort(corners_.begin(), corners_.end(),
                  [&](std::uint32_t a, std::uint32_t b) { return lines_.before(line, a, b); });
        for (std::uint32_t k = 0; k < corners_.size(); ++k) place_of_.at(corners_[k]) = k;

        in_piece_.clear();
        for (const std::uint32_t index : uses) {
            LineUse& use = uses_[index];
            use.first = place_of_.find(use.forward ? use.from : use.to);
            use.last = place_of_.find(use.forward ? use.to : use.from);
            use.pieces = std::uint32_t(edge_of_piece_.size());
            edge_of_piece_.resize(edge_of_piece_.size() + (use.last - use.first), ~0u);
            for (std::uint32_t k = use.first; k < use.last; ++k) in_piece_.push_back({k, index});
            kept_corners_.insert(kept_corners_.end(), corners_.begin() + use.first, corners_.begin() + use.last + 1);
        }
        place_of_.clear();
        std::sort(in_piece_.begin(), in_piece_.end());
        for (std::size_t first = 0; first < in_piece_.size();) {
            std::size_t end = first;
            spokes_.clear();
            for (; end < in_piece_.size() && in_piece_[end].first == in_piece_[first].first; ++end) {
                const std::uint32_t use = in_piece_[end].second;
                spokes_.push_back({use, uses_[use].forward ? uses_[use].plane : from_behind(uses_[use].plane)});
            }
            arrange_piece(line, in_piece_[first].first);
            first = end;
        }
    }

    /// The quarter or half of the circle, counted from the first spoke, that a spoke lies in.
    int half(std::uint32_t line, PlaneId zero, PlaneId spoke) const {
        if (zero == spoke) return 0;
        const int turn = lines_.turn(line, zero, spoke);
        if (turn != 0) return turn > 0 ? 1 : 3;
        return parallel_same_way(zero, spoke) ? 0 : 2;
    }
    bool parallel_same_way(PlaneId a, PlaneId b) const {
        const Plane &p = tables_.planes.plane(a), &q = tables_.planes.plane(b);
        const int axis = p.dominant_axis();
        return (p.normal[axis] > 0) == (q.normal[axis] > 0);
    }

    void arrange_piece(std::uint32_t line, std::uint32_t piece) {
        const PlaneId zero = spokes_[0].turned;
        std::sort(spokes_.begin(), spokes_.end(), [&](const Spoke& a, const Spoke& b) {
            if (a.turned == b.turned) return a.use < b.use;
            const int x = half(line, zero, a.turned), y = half(line, zero, b.turned);
            if (x != y) return x < y;
            return lines_.turn(line, a.turned, b.turned) > 0;
        });
        const std::size_t count = spokes_.size();
        bool sound = true;
        for (std::size_t k = 0; k < count; ++k) {
            const Spoke &a = spokes_[k], &b = spokes_[k + 1 < count ? k + 1 : 0];
            const std::uint32_t after = side_after(a), before = side_before(b);
            if ((after == kSolid) != (before == kSolid)) sound = false;
            if (count > 1 && a.turned == b.turned) sound = false;  // one on the other
        }
        if (!sound) return note_open(piece);
        pair_faces(line, piece);
        for (std::size_t k = 0; k < count; ++k) {
            const std::uint32_t after = side_after(spokes_[k]),
                                before = side_before(spokes_[k + 1 < count ? k + 1 : 0]);
            if (after != kSolid) result_.seen_together.join(after, before);
        }
    }

    static constexpr std::uint32_t kSolid = ~0u;

    // Turning about the line, the front of a polygon that runs along it comes after it, that of one that runs against
    // it before it.
    std::uint32_t side_after(const Spoke& spoke) const { return side(spoke, uses_[spoke.use].forward); }
    std::uint32_t side_before(const Spoke& spoke) const { return side(spoke, !uses_[spoke.use].forward); }
    std::uint32_t side(const Spoke& spoke, bool front) const {
        const std::uint32_t polygon = uses_[spoke.use].polygon;
        if (is_face(polygon)) return front ? polygon : kSolid;
        return std::uint32_t(faces_.size()) + 2 * (polygon - std::uint32_t(faces_.size())) + !front;
    }

    /// Each face that runs along the line bounds one wedge of air with the next face that runs against it.
    void pair_faces(std::uint32_t line, std::uint32_t piece) {
        around_.clear();
        for (const Spoke& spoke : spokes_)
            if (is_face(uses_[spoke.use].polygon)) around_.push_back(spoke.use);
        for (std::size_t k = 0; k < around_.size(); ++k) {
            const LineUse& use = uses_[around_[k]];
            if (!use.forward) continue;
            const LineUse& next = uses_[around_[k + 1 < around_.size() ? k + 1 : 0]];
            const auto edge = std::uint32_t(result_.edges.size());
            result_.edges.push_back({{corners_[piece], corners_[piece + 1]},
                                     {use.polygon, next.polygon},
                                     {lines_.plane(line, 0), lines_.plane(line, 1)},
                                     around_.size() > 2});
            edge_of_piece_[use.pieces + piece - use.first] = edge;
            edge_of_piece_[next.pieces + piece - next.first] = edge;
        }
    }

    void note_open(std::uint32_t piece) {
        OpenEdge edge{{corners_[piece], corners_[piece + 1]}, {}};
        for (const Spoke& spoke : spokes_) edge.polygons.push_back(uses_[spoke.use].polygon);
        open_.push_back(std::move(edge));
    }

    /// Uses stand in order of polygons and their sides; their pieces were found line by line.
    void write_outlines() {
        // kept_corners_ holds for each use, in the order of by_line_, the corners along its line.
        std::vector<std::uint32_t> first_corner(uses_.size());
        std::uint32_t at = 0;
        for (const std::uint32_t use : by_line_) {
            first_corner[use] = at;
            at += uses_[use].last - uses_[use].first + 1;
        }
        std::uint32_t polygon = 0;
        result_.first_step.push_back(0);
        for (std::uint32_t k = 0; k < uses_.size(); ++k) {
            const LineUse& use = uses_[k];
            if (use.polygon != polygon) {
                polygon = use.polygon;
                result_.first_step.push_back(std::uint32_t(result_.steps.size()));
            }
            const std::uint32_t pieces = use.last - use.first;
            for (std::uint32_t i = 0; i < pieces; ++i) {
                const std::uint32_t piece = use.forward ? i : pieces - 1 - i;
                result_.steps.push_back(
                    {kept_corners_[first_corner[k] + piece + !use.forward], edge_of_piece_[use.pieces + piece]});
            }
        }
        result_.first_step.push_back(std::uint32_t(result_.steps.size()));
        if (uses_.empty()) result_.first_step.pop_back();
    }

    const JoinTables& tables_;
    const std::span<const JoinPiece> faces_;
    const std::span<const ConvexPiece> portals_;
    std::vector<OpenEdge>& open_;
    LineTable lines_;
    Arrangement result_;
    std::vector<LineUse> uses_;
    std::vector<std::uint32_t> by_line_;
    std::vector<std::uint32_t> edge_of_piece_;  ///< of each use in turn, along the line
    std::vector<std::uint32_t> kept_corners_;   ///< likewise, one more a use

    // Of the line at hand.
    std::vector<std::uint32_t> corners_;
    FlatMap place_of_;
    std::vector<std::pair<std::uint32_t, std::uint32_t>> in_piece_;
    std::vector<Spoke> spokes_;
    std::vector<std::uint32_t> around_;
};

}  // namespace

Arrangement arrange(const JoinTables& tables, std::span<const JoinPiece> faces, std::span<const ConvexPiece> portals,
                    std::vector<OpenEdge>& open) {
    return Arranger(tables, faces, portals, open).arrange();
}

}  // namespace firma
