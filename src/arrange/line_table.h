// SPDX-License-Identifier: MIT
// All lines that sides of polygons lie on, each once, whichever two planes named it; and the order of points on one.
#pragma once

#include <cstdint>
#include <vector>

#include "arrange/exact_tables.h"

namespace firma {

class LineTable {
public:
    explicit LineTable(const ExactTables& tables) : tables_(tables) {}

    /// The line in which two planes meet, that are not parallel.
    /// @param point  a point on it
    std::uint32_t add(PlaneId a, PlaneId b, std::uint32_t point);

    std::size_t size() const { return lines_.size(); }

    /// One of two planes that meet in it.
    PlaneId plane(std::uint32_t line, int k) const { return lines_[line].planes[k]; }

    /// Whether a.normal x b.normal runs the way the line does, for planes that meet in it. A line ascends along the
    /// axis of its largest component, whichever planes name it.
    bool runs_along(std::uint32_t line, PlaneId a, PlaneId b) const;

    /// Whether point `a` comes before point `b`, both on the line.
    bool before(std::uint32_t line, std::uint32_t a, std::uint32_t b) const;

    /// Sign of (a x b) along the line, for normals of planes that hold it.
    int turn(std::uint32_t line, PlaneId a, PlaneId b) const;

private:
    struct Line {
        PlaneId planes[2];  ///< two that meet in it
        int axis;           ///< of its largest component
        bool ascends;       ///< along that axis runs the first one's normal x the second one's
    };

    bool same(const Line& line, PlaneId a, PlaneId b, std::uint32_t point) const;

    const ExactTables& tables_;
    std::vector<Line> lines_;
    FlatMap of_planes_, of_hash_;
};

}  // namespace firma
