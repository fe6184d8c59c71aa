// SPDX-License-Identifier: MIT
// Where faces of different solids meet: parts of lines, each known to every face that is to be divided along it.
//
// Points and lines are one for all faces: whatever lies on a line divides it for all of them in the same way.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "arrange/walk_line.h"
#include "base/work_slice.h"

namespace firma {

/// Part of a line in a face's closure: one of its own edges, or where another face meets it.
struct FaceSpan {
    std::uint32_t face = 0;
    std::uint32_t line = 0;
    std::uint32_t from = 0, to = 0;  ///< points, in the line's order
    std::uint8_t covers = 0;         ///< Cover
    std::uint32_t edge = kNoEdge;    ///< the face's own, along which it runs
    bool reversed = false;           ///< that edge runs against the line
    static constexpr std::uint32_t kNoEdge = ~0u;
};

class SpanFinder {
public:
    explicit SpanFinder(Overlay& overlay) : overlay_(overlay), walk_(overlay), other_walk_(overlay) {}

    /// Once all faces are in the overlay.
    void start();
    /// Two faces whose boxes meet, of different solids, or both of those that bound nothing.
    void meet(std::uint32_t a, std::uint32_t b);
    /// Whatever divides the lines of a face's edges, as other faces meet, divides these edges.
    void know_edges(std::uint32_t face);
    /// Once all pairs met: faces in one plane learn of each other's spans, then spans that cross within a face divide
    /// each other.
    /// @return whether all of it is done; else call it again
    bool finish(WorkSlice& slice);

    /// Whether a face has spans: else nothing meets more of it than a point.
    bool touched(std::uint32_t face) const { return touched_[face] != 0; }
    /// Of one that is, after finish().
    std::span<const FaceSpan> spans_of(std::uint32_t face) const {
        return {spans_.data() + first_[face], first_[face + 1] - first_[face]};
    }
    /// A plane that holds the line, and is not the face's.
    PlaneId across(std::uint32_t line, PlaneId face) const;
    /// On the line of an edge; none unless a face at it is touched.
    std::uint32_t line_of(std::uint32_t edge) const { return line_of_edge_[edge]; }
    static constexpr std::uint32_t kNoLine = ~0u;
    /// All points on each line, some more than once, in no order.
    std::vector<std::vector<std::uint32_t>>& points_on() { return points_on_; }

private:
    void touch(std::uint32_t face);
    std::uint32_t register_edge(std::uint32_t edge);
    void put_on_line(std::uint32_t line, std::uint32_t point);
    void emit(std::uint32_t face, std::uint32_t line, const Interval& part);
    void end_at(const LineWalk& walk, std::uint32_t line, const Interval& part);
    enum class Stage : std::uint8_t { kTouch, kLend, kCross };
    struct BoxedSpan {
        GridBox box;
        std::uint32_t span;
    };

    void touch_coplanar();
    void lend(std::uint32_t from, std::uint32_t to, WorkSlice& slice);
    bool cross_next(WorkSlice& slice);
    void gather_crossing(std::uint32_t face);
    void cross_two(const FaceSpan& a, const FaceSpan& b);
    void order_by_face();

    Overlay& overlay_;
    LineWalk walk_, other_walk_;
    std::vector<std::uint8_t> touched_;
    std::vector<std::uint32_t> line_of_edge_;
    std::vector<std::vector<std::uint32_t>> points_on_;
    std::vector<FaceSpan> spans_;
    std::vector<std::uint32_t> first_;  ///< in spans_, of each face, once in order
    std::vector<std::pair<std::uint32_t, std::uint32_t>> coplanar_;
    Stage stage_ = Stage::kTouch;
    std::size_t next_ = 0;                    ///< in the loop of the stage
    std::vector<BoxedSpan> boxed_;            ///< spans that may cross, of one face, in order along an axis
    std::size_t boxed_of_ = ~std::size_t(0);  ///< which face
    int axis_ = 0;                            ///< that one
    std::size_t next_boxed_ = 0;
};

}  // namespace firma
