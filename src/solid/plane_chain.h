// SPDX-License-Identifier: MIT
// Directed edges in one plane: whether they cancel as sets of points, however lines are divided. Exact.
//
// Faces in a plane and others taken away from them are the same set of points where their edges, those of the others
// turned, cancel along every line. Each edge adds 1 at its end and takes 1 away at its start: what runs along a line
// cancels just where these come to 0 at each of its points.
#pragma once

#include <cstdint>
#include <deque>
#include <vector>

#include "geometry/exact_point.h"

namespace firma {

/// Keeps its scratch from plane to plane, and has no limit of size but memory.
class PlaneChain {
public:
    /// Begins with a plane, which the caller keeps.
    void start(const Plane& plane);

    /// An edge between two points of the grid.
    void add(const InputPoint& from, const InputPoint& to);
    /// @param from, to  kept by the caller, as are the planes
    /// @param p, q      two planes that meet in the edge; one of them may be that of the face
    void add(const ExactPoint& from, const ExactPoint& to, const Plane& p, const Plane& q);

    bool cancels();

private:
    struct End {
        InputPoint grid;
        const ExactPoint* point = nullptr;  ///< null: on the grid

        double at(int axis) const { return point ? point->approximate()[axis] : grid[axis]; }
        ExactPoint exact() const { return point ? *point : ExactPoint(grid); }
    };
    struct Edge {
        End from, to;
        /// Of the line, as seen: the first that is not 0 is positive. From its ends where both are on the grid, else
        /// the cross product of the normals of plane and `across`, or that turned.
        Int128 u = 0, v = 0;
        const Plane* across = nullptr;  ///< holds the line and is not parallel to the plane; null: not made yet
        bool against = false;           ///< that cross product runs against (u, v)

        bool on_grid() const { return !from.point && !to.point; }
    };
    struct Event {
        End end;
        int weight = 0;
    };

    static End end_of(const ExactPoint& point);
    void set_across(Edge& edge, const Plane& across) const;
    const Plane& across_of(Edge& edge);
    int turn(const Edge& a, const Edge& b) const;
    int side(Edge& edge, const End& point);
    int compare_lines(Edge& a, Edge& b);
    int compare_places(Edge& line, const End& a, const End& b);
    bool cancels_along(std::size_t first, std::size_t end);

    const Plane* plane_ = nullptr;
    int u_ = 0, v_ = 1;  ///< axes, as seen from the front
    std::vector<Edge> edges_;
    std::vector<std::uint32_t> order_;
    std::vector<Event> events_;
    std::deque<Plane> made_;
};

}  // namespace firma
