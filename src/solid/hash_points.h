// SPDX-License-Identifier: MIT
// A hash of a solid's set of points that does not see how its surface is divided.
//
// For each directed edge of each face, h(plane, line's direction, end) - h(plane, line's direction, start) is added:
// plane as the face looks, direction without sign. Along a line what is divided cancels, and so does a seam between two
// faces in one plane, as one runs along it the other way. What is left belongs to the corners of the solid, each in its
// region.
#pragma once

#include <cstdint>
#include <vector>

#include "geometry/exact_plane.h"
#include "solid/region.h"

namespace firma {

std::uint64_t hash_plane(const Plane& plane);

/// The direction of a line by its ratio of two coordinates, modulo the prime 2^61 - 1: equal for parallel lines of one
/// plane, whichever way they look and whatever planes name them.
class LineDirection {
public:
    static LineDirection along(const GridPoint& from, const GridPoint& to);
    static LineDirection of(const Plane& a, const Plane& b);

private:
    friend class PointHash;
    std::uint64_t along_[3] = {0, 0, 0};  ///< modulo the prime
};

/// Adds faces up, edge by edge. Inverses are taken many at a time.
class PointHash {
public:
    /// Begins a face.
    /// @param sign  1: it comes; -1: it goes
    void start_face(const Plane& plane, int sign);
    /// An edge of the face, as it runs around it.
    void add_edge(const GridPoint& from, const GridPoint& to, const LineDirection& direction);

    /// Sums by region, once all faces are in.
    const SumsByKey& finish();

private:
    struct Edge {
        std::uint64_t plane;
        std::uint64_t across, along;  ///< the ratio along / across, modulo the prime
        GridPoint from, to;
        bool goes;
    };

    std::uint64_t plane_ = 0;
    int axis_ = 0;
    bool goes_ = false;
    std::vector<Edge> edges_;
    std::vector<std::uint64_t> products_;
    SumsByKey sums_;
    RegionFinder region_of_;
};

}  // namespace firma
