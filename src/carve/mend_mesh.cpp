// SPDX-License-Identifier: MIT
// A closed mesh that snapping folded, mended.
//
// Snapping moves corners by up to half a step along each axis. So it turns thin triangles over, or puts them through
// their neighbours, and no others: where these go, the rest is apart again. A thin triangle has either two corners that
// are near each other, or one that is near the opposite edge.
#include "carve/mend_mesh.h"

#include <algorithm>
#include <initializer_list>
#include <iterator>
#include <map>
#include <set>
#include <tuple>
#include <utility>

#include "geometry/polygons_cross.h"
#include "index/box_tree.h"

namespace firma {
namespace {

constexpr std::uint32_t kNoTriangle = ~0u;
constexpr int kPasses = 64;

class MeshMender {
public:
    MeshMender(std::span<const InputPoint> points, std::vector<CutterTriangle>& triangles)
        : points_(points), triangles_(triangles) {}

    int mend() {
        for (int pass = 0; pass < kPasses; ++pass) {
            drop_collapsed();
            find_edges();
            find_bad();
            if (bad_.empty()) break;
            const int before = mended_;
            touched_.clear();
            for (const Bad& bad : bad_)
                if (!mend(bad.thinner)) mend(bad.other);
            if (mended_ == before) break;
        }
        drop_collapsed();
        return mended_;
    }

private:
    /// A pair that crosses; `other` is kNoTriangle for one without area.
    struct Bad {
        double height;
        std::uint32_t thinner, other;
    };

    double square_length(std::uint32_t a, std::uint32_t b) const {
        double sum = 0;
        for (int axis = 0; axis < 3; ++axis) {
            const double along = double(std::int64_t(points_[b][axis]) - points_[a][axis]);
            sum += along * along;
        }
        return sum;
    }

    /// Side k runs from corner k to the next.
    int longest_side(const CutterTriangle& t) const {
        int longest = 0;
        for (int k = 1; k < 3; ++k)
            if (side_length(t, k) > side_length(t, longest)) longest = k;
        return longest;
    }
    int shortest_side(const CutterTriangle& t) const {
        int shortest = 0;
        for (int k = 1; k < 3; ++k)
            if (side_length(t, k) < side_length(t, shortest)) shortest = k;
        return shortest;
    }
    double side_length(const CutterTriangle& t, int k) const {  // squared
        return square_length(t[std::size_t(k)], t[std::size_t((k + 1) % 3)]);
    }

    /// Above the longest side, squared: input steps.
    double square_height(const CutterTriangle& t) const {
        const AreaVector n = area_vector(points_[t[0]], points_[t[1]], points_[t[2]]);
        const double area = double(n.x) * double(n.x) + double(n.y) * double(n.y) + double(n.z) * double(n.z);
        return area / std::max(1.0, side_length(t, longest_side(t)));
    }

    /// Triangles that name a corner twice enclose nothing, as do two of the same corners that look at each other.
    void drop_collapsed() {
        std::map<CutterTriangle, std::vector<std::uint32_t>> same;  // by corners, the lowest first, as they run
        std::vector<std::uint8_t> goes(triangles_.size(), 0);
        for (std::uint32_t t = 0; t < triangles_.size(); ++t) {
            CutterTriangle& corners = triangles_[t];
            if (corners[0] == corners[1] || corners[1] == corners[2] || corners[2] == corners[0]) {
                goes[t] = 1;
                continue;
            }
            std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
            std::vector<std::uint32_t>& against = same[{corners[0], corners[2], corners[1]}];
            if (against.empty()) {
                same[corners].push_back(t);
            } else {
                goes[against.back()] = goes[t] = 1;
                against.pop_back();
            }
        }
        std::size_t kept = 0;
        for (std::size_t t = 0; t < triangles_.size(); ++t)
            if (!goes[t]) triangles_[kept++] = triangles_[t];
        triangles_.resize(kept);
    }

    void find_edges() {
        triangle_of_.clear();
        neighbours_.assign(points_.size(), {});
        for (std::uint32_t t = 0; t < triangles_.size(); ++t)
            for (std::size_t k = 0; k < 3; ++k) {
                const std::uint32_t a = triangles_[t][k], b = triangles_[t][(k + 1) % 3];
                const auto [place, is_new] = triangle_of_.insert({{a, b}, t});
                if (!is_new) place->second = kNoTriangle;  // where shells touch
                neighbours_[a].insert(b);
                neighbours_[b].insert(a);
            }
    }

    void find_bad() {
        bad_.clear();
        std::vector<MeshPolygon> polygons;
        std::vector<GridBox> boxes;
        std::vector<std::uint32_t> number;
        for (std::uint32_t t = 0; t < triangles_.size(); ++t) {
            const CutterTriangle& corners = triangles_[t];
            const AreaVector normal = area_vector(points_[corners[0]], points_[corners[1]], points_[corners[2]]);
            if ((normal.x | normal.y | normal.z) == 0) {
                bad_.push_back({0, t, kNoTriangle});
                continue;
            }
            polygons.push_back({corners, normal});
            number.push_back(t);
            GridBox& box = boxes.emplace_back();
            for (const std::uint32_t corner : corners) box.add(to_surface(points_[corner]));
        }
        const BoxTree tree(boxes);
        for (std::uint32_t p = 0; p < polygons.size(); ++p)
            tree.for_each_meeting(boxes[p], [&](std::uint32_t q) {
                if (q <= p || !polygons_cross(points_, polygons[p], polygons[q])) return false;
                std::uint32_t a = number[p], b = number[q];
                double height = square_height(triangles_[a]), other = square_height(triangles_[b]);
                if (other < height) {
                    std::swap(a, b);
                    std::swap(height, other);
                }
                bad_.push_back({height, a, b});
                return false;
            });
        std::sort(bad_.begin(), bad_.end(), [](const Bad& a, const Bad& b) {
            return std::tie(a.height, a.thinner, a.other) < std::tie(b.height, b.thinner, b.other);
        });
    }

    /// Each corner takes part in one change a pass: what was found out about it holds.
    bool claim(std::initializer_list<std::uint32_t> corners) {
        for (const std::uint32_t corner : corners)
            if (touched_.count(corner) > 0) return false;
        for (const std::uint32_t corner : corners) {
            touched_.insert(corner);
            touched_.insert(neighbours_[corner].begin(), neighbours_[corner].end());
        }
        ++mended_;
        return true;
    }

    /// @return whether the triangle is gone, or will be looked at again
    bool mend(std::uint32_t t) {
        if (t == kNoTriangle) return false;
        const CutterTriangle corners = triangles_[t];
        for (const std::uint32_t corner : corners)
            if (touched_.count(corner) > 0) return true;
        if (square_height(corners) > double(kThin * kThin)) return merge(corners, shortest_side(corners));
        const int longest = longest_side(corners), shortest = shortest_side(corners);
        if (side_length(corners, shortest) <= double(kThin * kThin))
            return merge(corners, shortest) || turn(t, longest);
        return turn(t, longest) || merge(corners, shortest);
    }

    /// (i, j, k) and (j, i, s), of which the first is flat on the other, become (i, s, k) and (s, j, k): where both are
    /// less flat. So no edges are turned to and fro where many corners lie in a row.
    bool turn(std::uint32_t t, int side) {
        const CutterTriangle& it = triangles_[t];
        const std::uint32_t i = it[std::size_t(side)], j = it[std::size_t((side + 1) % 3)],
                            k = it[std::size_t((side + 2) % 3)];
        const auto found = triangle_of_.find({j, i});
        const auto own = triangle_of_.find({i, j});
        if (found == triangle_of_.end() || found->second == kNoTriangle || own->second == kNoTriangle) return false;
        const std::uint32_t across = found->second;
        std::uint32_t s = kNoTriangle;
        for (const std::uint32_t corner : triangles_[across])
            if (corner != i && corner != j) s = corner;
        if (s == k || neighbours_[k].count(s) > 0) return false;
        const double flattest = std::min(square_height(it), square_height(triangles_[across]));
        if (!(std::min(square_height({i, s, k}), square_height({s, j, k})) > flattest)) return false;
        if (!claim({i, j, k, s})) return false;
        triangles_[t] = {i, s, k};
        triangles_[across] = {s, j, k};
        return true;
    }

    /// The ends of a side become one, where the mesh around it stays one: only the two triangles beside it go.
    bool merge(const CutterTriangle& corners, int side) {
        if (side_length(corners, side) > double(kLongestMerged * kLongestMerged)) return false;
        std::uint32_t a = corners[std::size_t(side)], b = corners[std::size_t((side + 1) % 3)];
        if (b < a) std::swap(a, b);
        std::vector<std::uint32_t> common;
        std::set_intersection(neighbours_[a].begin(), neighbours_[a].end(), neighbours_[b].begin(),
                              neighbours_[b].end(), std::back_inserter(common));
        if (common.size() != 2 || !claim({a, b})) return false;
        for (CutterTriangle& triangle : triangles_)
            for (std::uint32_t& corner : triangle)
                if (corner == b) corner = a;
        return true;
    }

    const std::span<const InputPoint> points_;
    std::vector<CutterTriangle>& triangles_;
    int mended_ = 0;

    // Of this pass:
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> triangle_of_;  ///< by side, as it runs
    std::vector<std::set<std::uint32_t>> neighbours_;                               ///< of each point
    std::vector<Bad> bad_;                                                          ///< the thinnest first
    std::set<std::uint32_t> touched_;
};

}  // namespace

int mend_mesh(std::span<const InputPoint> points, std::vector<CutterTriangle>& triangles) {
    return MeshMender(points, triangles).mend();
}

}  // namespace firma
