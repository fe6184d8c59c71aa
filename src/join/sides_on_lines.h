// SPDX-License-Identifier: MIT
// Which polygons have sides on a line: kept while polygons come and go.
#pragma once

#include <cstdint>
#include <vector>

#include "arrange/line_table.h"
#include "join/convex_piece.h"

namespace firma {

/// A side of a polygon on its line.
struct LineSide {
    std::uint32_t line = 0;
    std::uint32_t owner = 0;         ///< the polygon
    std::uint32_t from = 0, to = 0;  ///< corners, along the line
    PlaneId plane = kNoPlane;        ///< the polygon's
    PlaneId across = kNoPlane;       ///< the side's
    bool forward = false;            ///< the polygon runs along the line there
    std::uint32_t next = kNone;      ///< another one on the line
    static constexpr std::uint32_t kNone = ~0u;
};

class SidesOnLines {
public:
    explicit SidesOnLines(LineTable& lines) : lines_(lines) {}

    /// @return the number of the polygon's first side; the others follow it
    std::uint32_t add(std::uint32_t owner, const ConvexPiece& piece);
    /// @param first, count  of all sides of a polygon
    void remove(std::uint32_t first, std::size_t count);

    const LineSide& side(std::uint32_t index) const { return sides_[index]; }
    std::size_t size() const { return sides_.size(); }
    std::size_t line_count() const { return first_.size(); }

    /// Calls `function(number of the side, side)` for each on a line, until it returns true.
    template <class Function>
    bool for_each_on(std::uint32_t line, const Function& function) const {
        for (std::uint32_t k = line < first_.size() ? first_[line] : LineSide::kNone; k != LineSide::kNone;
             k = sides_[k].next)
            if (function(k, sides_[k])) return true;
        return false;
    }

    /// Whether two sides of one line have more than a point in common.
    bool overlap(const LineSide& a, const LineSide& b) const {
        return lines_.before(a.line, a.from, b.to) && lines_.before(a.line, b.from, a.to);
    }

    /// As it would be added.
    LineSide make(std::uint32_t owner, const ConvexPiece& piece, std::size_t k);

private:
    LineTable& lines_;
    std::vector<LineSide> sides_;       ///< of all polygons that ever were
    std::vector<std::uint32_t> first_;  ///< a line each
};

}  // namespace firma
