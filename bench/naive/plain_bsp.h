// SPDX-License-Identifier: MIT
// A plain BSP tree of polygons, as games of the article's time had for a room: what it takes to build one again.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "firma/vec.h"

namespace firma::bench {

/// A convex polygon in double, and the unit plane dot(normal, x) = offset that it lies on.
struct BspPolygon {
    std::vector<Vec3> corners;
    Vec3 normal;
    double offset = 0;
};
BspPolygon make_bsp_polygon(std::vector<Vec3> corners);

/// Each node's plane is that of one of its polygons, chosen among a few by how many others it splits and how evenly it
/// divides them. Polygons across a plane are split; those on it stay in the node.
/// Source: H. Fuchs, Z. Kedem, B. Naylor, On Visible Surface Generation by A Priori Tree Structures, 1980; the choice
/// as in Quake's qbsp, 1996.
class PlainBsp {
public:
    /// @param candidates      planes looked at for each node
    /// @param most_fragments  building stops there
    void build(std::span<const BspPolygon> polygons, int candidates = 5, std::size_t most_fragments = ~std::size_t(0));

    std::size_t nodes() const { return nodes_.size(); }
    /// Polygons in all nodes: those given, and what splitting made more of them.
    std::size_t fragments() const { return fragments_; }
    int depth() const { return depth_; }
    /// Whether building was stopped.
    bool given_up() const { return given_up_; }

    /// Whether a point lies in front of the surface: in the air.
    bool in_air(const Vec3& point) const;

private:
    struct Node {
        Vec3 normal;
        double offset = 0;
        std::int32_t front = -1, back = -1;  ///< -1: air in front, solid behind
        std::vector<BspPolygon> polygons;
    };
    struct Work {
        std::vector<BspPolygon> polygons;
        std::int32_t parent = -1;
        bool in_front = false;
        int depth = 0;
    };
    void divide(Work& work, int candidates, std::vector<Work>& more);

    std::vector<Node> nodes_;
    std::size_t fragments_ = 0;
    int depth_ = 0;
    bool given_up_ = false;
};

}  // namespace firma::bench
