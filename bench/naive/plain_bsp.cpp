// SPDX-License-Identifier: MIT
// A plain BSP tree of polygons.
#include "naive/plain_bsp.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace firma::bench {
namespace {

constexpr double kOnPlane = 1e-5;  // metres: nearer corners count as on it

enum class Side { kOn, kFront, kBack, kAcross };

Side side_of(const BspPolygon& polygon, const Vec3& normal, double offset) {
    bool front = false, back = false;
    for (const Vec3& corner : polygon.corners) {
        const double distance = dot(normal, corner) - offset;
        front = front || distance > kOnPlane;
        back = back || distance < -kOnPlane;
    }
    return front ? (back ? Side::kAcross : Side::kFront) : back ? Side::kBack : Side::kOn;
}

void split(const BspPolygon& polygon, const Vec3& normal, double offset, BspPolygon& front, BspPolygon& back) {
    front = {{}, polygon.normal, polygon.offset};
    back = {{}, polygon.normal, polygon.offset};
    const std::size_t count = polygon.corners.size();
    for (std::size_t k = 0; k < count; ++k) {
        const Vec3 &a = polygon.corners[k], &b = polygon.corners[(k + 1) % count];
        const double da = dot(normal, a) - offset, db = dot(normal, b) - offset;
        if (da >= -kOnPlane) front.corners.push_back(a);
        if (da <= kOnPlane) back.corners.push_back(a);
        if ((da > kOnPlane && db < -kOnPlane) || (da < -kOnPlane && db > kOnPlane)) {
            const Vec3 meet = a + (b - a) * (da / (da - db));
            front.corners.push_back(meet);
            back.corners.push_back(meet);
        }
    }
}

/// The fewer splits and the more even halves the better: qbsp's weights.
std::size_t choose(const std::vector<BspPolygon>& polygons, int candidates) {
    std::size_t best = 0;
    double best_cost = INFINITY;
    const std::size_t step = std::max<std::size_t>(1, polygons.size() / std::size_t(candidates));
    for (std::size_t k = step / 2; k < polygons.size(); k += step) {
        std::size_t fronts = 0, backs = 0, splits = 0;
        for (const BspPolygon& other : polygons) {
            const Side side = side_of(other, polygons[k].normal, polygons[k].offset);
            fronts += side == Side::kFront;
            backs += side == Side::kBack;
            splits += side == Side::kAcross;
        }
        const double cost = 8.0 * double(splits) + std::fabs(double(fronts) - double(backs));
        if (cost < best_cost) {
            best_cost = cost;
            best = k;
        }
    }
    return best;
}

}  // namespace

BspPolygon make_bsp_polygon(std::vector<Vec3> corners) {
    BspPolygon polygon;
    Vec3 area;  // Newell's method: the first three corners may lie on a line
    for (std::size_t k = 2; k < corners.size(); ++k)
        area = area + cross(corners[k - 1] - corners[0], corners[k] - corners[0]);
    polygon.normal = area * (1 / length(area));
    polygon.offset = dot(polygon.normal, corners[0]);
    polygon.corners = std::move(corners);
    return polygon;
}

void PlainBsp::divide(Work& work, int candidates, std::vector<Work>& more) {
    const auto index = std::int32_t(nodes_.size());
    if (work.parent >= 0) (work.in_front ? nodes_[work.parent].front : nodes_[work.parent].back) = index;
    depth_ = std::max(depth_, work.depth);
    const BspPolygon& chosen = work.polygons[choose(work.polygons, candidates)];
    Node node;
    node.normal = chosen.normal;
    node.offset = chosen.offset;
    Work front{{}, index, true, work.depth + 1}, back{{}, index, false, work.depth + 1};
    for (BspPolygon& polygon : work.polygons) {
        // The chosen one is on its own plane whatever rounding says.
        switch (&polygon == &chosen ? Side::kOn : side_of(polygon, node.normal, node.offset)) {
            case Side::kFront:
                front.polygons.push_back(std::move(polygon));
                break;
            case Side::kBack:
                back.polygons.push_back(std::move(polygon));
                break;
            case Side::kAcross:
                front.polygons.emplace_back();
                back.polygons.emplace_back();
                split(polygon, node.normal, node.offset, front.polygons.back(), back.polygons.back());
                ++fragments_;
                break;
            case Side::kOn:
                node.polygons.push_back(polygon);  // a copy: `chosen` is still asked for
                break;
        }
    }
    nodes_.push_back(std::move(node));
    if (!front.polygons.empty()) more.push_back(std::move(front));
    if (!back.polygons.empty()) more.push_back(std::move(back));
}

void PlainBsp::build(std::span<const BspPolygon> polygons, int candidates, std::size_t most_fragments) {
    nodes_.clear();
    fragments_ = polygons.size();
    depth_ = 0;
    given_up_ = false;
    if (polygons.empty()) return;
    std::vector<Work> more;
    more.push_back({{polygons.begin(), polygons.end()}, -1, false, 1});
    while (!more.empty()) {
        if (fragments_ > most_fragments) {
            given_up_ = true;
            return;
        }
        Work work = std::move(more.back());
        more.pop_back();
        divide(work, candidates, more);
    }
}

bool PlainBsp::in_air(const Vec3& point) const {
    std::int32_t at = nodes_.empty() ? -1 : 0;
    bool front = true;
    while (at >= 0) {
        front = dot(nodes_[at].normal, point) > nodes_[at].offset;
        at = front ? nodes_[at].front : nodes_[at].back;
    }
    return front;
}

}  // namespace firma::bench
