// SPDX-License-Identifier: MIT
// Islands by shared edges, then each island's rim.
//
// An island with one rim of n edges and v corners in all is a disc when it has 2 v - n - 2 triangles (Euler). With a
// handle, or a corner where it touches itself, it would have more.
#include "level/find_islands.h"

#include <algorithm>

#include "base/disjoint_sets.h"
#include "base/sort.h"

namespace firma {
namespace {

using TriangleView = std::span<const std::uint32_t, 3>;

struct Edge {
    std::uint32_t from = 0, to = 0;
    std::uint32_t triangle = 0;
};

bool by_ends(const Edge& a, const Edge& b) {
    return a.from != b.from ? a.from < b.from : a.to < b.to;
}
bool same_ends(const Edge& a, const Edge& b) {
    return a.from == b.from && a.to == b.to;
}

std::vector<TriangleView> gather_triangles(std::span<const std::uint32_t> corners) {
    std::vector<TriangleView> triangles;
    for (std::size_t k = 0; k + 2 < corners.size(); k += 3) {
        const TriangleView t = corners.subspan(k).first<3>();
        if (t[0] != t[1] && t[1] != t[2] && t[2] != t[0]) triangles.push_back(t);
    }
    return triangles;
}

std::vector<Edge> gather_edges(std::span<const TriangleView> triangles) {
    std::vector<Edge> edges;
    for (std::uint32_t k = 0; k < triangles.size(); ++k) {
        const TriangleView t = triangles[k];
        for (const Edge& edge : {Edge{t[0], t[1], k}, Edge{t[1], t[2], k}, Edge{t[2], t[0], k}}) edges.push_back(edge);
    }
    std::sort(edges.begin(), edges.end(), by_ends);
    return edges;
}

// The island of each triangle, counted from 0 in order of their first triangles.
class IslandNumbers {
public:
    explicit IslandNumbers(std::size_t triangles) : sets_(triangles) {}

    void join(std::uint32_t a, std::uint32_t b) { sets_.join(a, b); }

    std::vector<std::uint32_t> count(std::size_t triangles) {
        std::vector<std::uint32_t> number(triangles);
        for (std::uint32_t k = 0; k < triangles; ++k) {
            const std::uint32_t first = sets_.find(k);
            number[k] = first == k ? islands_++ : number[first];
        }
        return number;
    }
    std::uint32_t islands() const { return islands_; }

private:
    DisjointSets sets_;
    std::uint32_t islands_ = 0;
};

// The rim, sorted by ends, as one closed walk; empty when it is not one. As many rim edges enter a corner as leave it,
// so a walk that never has a choice comes home.
std::vector<std::uint32_t> walk_rim(std::span<const Edge> rim) {
    const auto touches = [](const Edge& a, const Edge& b) { return a.from == b.from; };
    if (rim.empty() || std::adjacent_find(rim.begin(), rim.end(), touches) != rim.end()) return {};
    std::vector<std::uint32_t> outline;
    std::uint32_t at = rim[0].from;
    do {
        outline.push_back(at);
        at = std::lower_bound(rim.begin(), rim.end(), Edge{at, 0}, by_ends)->to;
    } while (at != rim[0].from);
    if (outline.size() != rim.size()) return {};
    return outline;
}

std::vector<std::uint32_t> sorted_once(std::vector<std::uint32_t> corners) {
    sort_range(corners);
    corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
    return corners;
}

void trace_outline(Island& island, std::span<const Edge> rim) {
    std::vector<std::uint32_t> outline = walk_rim(rim);
    const std::vector<std::uint32_t> all = sorted_once(island.triangles), outer = sorted_once(outline);
    if (outline.empty() || island.triangles.size() / 3 != 2 * all.size() - outline.size() - 2) return;
    island.outline = std::move(outline);
    std::set_difference(all.begin(), all.end(), outer.begin(), outer.end(), std::back_inserter(island.inner));
}

}  // namespace

std::vector<Island> find_islands(std::span<const std::uint32_t> corners) {
    const std::vector<TriangleView> triangles = gather_triangles(corners);
    const std::vector<Edge> edges = gather_edges(triangles);
    if (std::adjacent_find(edges.begin(), edges.end(), same_ends) != edges.end()) {
        Island all;
        for (const TriangleView t : triangles) all.triangles.insert(all.triangles.end(), t.begin(), t.end());
        return {all};
    }

    IslandNumbers numbers(triangles.size());
    std::vector<Edge> rim_edges;
    for (const Edge& edge : edges) {
        const Edge back = {edge.to, edge.from};
        const auto twin = std::lower_bound(edges.begin(), edges.end(), back, by_ends);
        if (twin != edges.end() && same_ends(*twin, back)) {
            numbers.join(edge.triangle, twin->triangle);
        } else {
            rim_edges.push_back(edge);
        }
    }
    const std::vector<std::uint32_t> number = numbers.count(triangles.size());
    std::vector<Island> islands(numbers.islands());
    std::vector<std::vector<Edge>> rims(numbers.islands());
    for (std::size_t k = 0; k < triangles.size(); ++k) {
        std::vector<std::uint32_t>& into = islands[number[k]].triangles;
        into.insert(into.end(), triangles[k].begin(), triangles[k].end());
    }
    for (const Edge& edge : rim_edges) rims[number[edge.triangle]].push_back(edge);
    for (std::size_t k = 0; k < islands.size(); ++k) trace_outline(islands[k], rims[k]);
    return islands;
}

}  // namespace firma
