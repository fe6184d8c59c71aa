// SPDX-License-Identifier: MIT
// Where a line runs through a face: in it, along its rim, or past it.
#pragma once

#include <cstdint>
#include <vector>

#include "arrange/overlay.h"

namespace firma {

/// Which side of a line, seen from the front of a plane that holds it, a face covers.
enum Cover : std::uint8_t { kCoversNothing = 0, kCoversLeft = 1, kCoversRight = 2, kCoversBoth = 3 };

/// Part of a line that lies in a face's closure and holds no corner of it but at its ends.
struct Interval {
    std::uint32_t from = 0, to = 0;  ///< points, in the line's order
    std::uint8_t covers = 0;         ///< Cover
};

/// Keeps its scratch from call to call.
class LineWalk {
public:
    explicit LineWalk(Overlay& overlay) : overlay_(overlay) {}

    /// Where a face meets a plane that is not parallel to its own, found along the line of both.
    ///
    /// @return false when it does not, not even in a point
    bool start(std::uint32_t face, PlaneId across);
    /// A point of the line, after start() said true.
    std::uint32_t some_point() const { return events_[0].point; }
    /// The intervals, in the line's order.
    /// @param line  that of the face's plane and the other
    const std::vector<Interval>& finish(std::uint32_t line);

    /// Calls `function(edge)` for each edge of the face that passes through this point of the line and does not lie on
    /// it, after finish().
    template <class Function>
    void for_each_edge_at(std::uint32_t point, const Function& function) const {
        for (const Event& event : events_)
            if (event.point == point && event.edge != kNoEdge) function(event.edge);
    }

private:
    static constexpr std::uint32_t kNoEdge = ~0u;
    enum : std::uint8_t { kAbove = 1, kBelow = 2 };

    /// What changes at a point: whether the face covers what lies just above the line, and just below.
    struct Event {
        std::uint32_t point = 0;
        std::uint32_t edge = kNoEdge;  ///< that is crossed there, between its ends
        std::uint8_t toggles = 0;
    };

    std::uint32_t crossing(std::uint32_t edge, PlaneId across);

    Overlay& overlay_;
    std::uint32_t face_ = 0;
    PlaneId across_ = kNoPlane;
    FlatMap crossings_;  ///< points, by edge and plane
    std::vector<std::int8_t> signs_;
    std::vector<Event> events_;
    std::vector<Interval> intervals_;
};

}  // namespace firma
