// SPDX-License-Identifier: MIT
// A solid in two along a plane. On the line in which a face meets the plane, what lies to the left of it is bounded by
// intervals of the line: where sides that come to the line and leave it again do not cancel, one begins or ends.
#include "convex/split_sides.h"

#include <algorithm>
#include <utility>

#include "base/sort.h"

namespace firma {
namespace {

/// Of one face at one point of the line: how many sides of its parts end there, less those that begin.
struct LineEvent {
    std::uint32_t point = 0;
    int front = 0, back = 0;
};

/// A line, and a point on it.
using LinePoint = std::pair<std::uint32_t, std::uint32_t>;

/// A side in the dividing plane.
struct FlatSide {
    FaceSide side;
    std::uint32_t line = 0;
    bool front = false;
};

class SideSplitter {
public:
    SideSplitter(ConvexSpace& space, const SolidSides& solid, PlaneId plane, SidesSplit& split)
        : space_(space), solid_(solid), by_(plane), split_(split) {}

    bool run() {
        split_ = {};
        judge_points();
        for (std::uint32_t first = 0, end; first < solid_.size(); first = end) {
            end = first + 1;
            while (end < solid_.size() && solid_.sides[end].plane == solid_.sides[first].plane) ++end;
            const PlaneId plane = solid_.sides[first].plane;
            if (same_plane(plane, by_)) {
                for (std::uint32_t k = first; k < end; ++k)
                    flat_.push_back({solid_.sides[k], line_beside(k), plane != by_});
            } else if (!split_face(first, end)) {
                return false;
            }
        }
        divide_flat_sides();
        return close();
    }

private:
    int side_of(std::uint32_t point) const { return sides_of_[point]; }

    void judge_points() {
        sides_of_.assign(space_.tables.points.size(), kUnknown);
        for (const FaceSide& side : solid_.sides)
            if (std::int8_t& known = sides_of_[side.from]; known == kUnknown)
                known = std::int8_t(space_.tables.points.side(by_, side.from));
    }

    std::uint32_t line_beside(std::uint32_t k) const {
        return space_.lines.add(solid_.sides[k].plane, solid_.across(k), solid_.sides[k].from);
    }

    bool split_face(std::uint32_t first, std::uint32_t end) {
        events_.clear();
        const PlaneId plane = solid_.sides[first].plane;
        for (std::uint32_t k = first; k < end; ++k) {
            const FaceSide& side = solid_.sides[k];
            const int here = side_of(side.from), there = side_of(side.to);
            if (here == 0 && there == 0) continue;
            if (here * there < 0) {
                const std::uint32_t crossing = space_.tables.points.add(plane, solid_.across(k), by_);
                if (crossing == PointTable::kNone) return false;
                add_part({plane, side.from, crossing}, here, 0);
                add_part({plane, crossing, side.to}, 0, there);
            } else {
                add_part(side, here, there);
            }
        }
        return events_.empty() || add_intervals(plane);
    }

    void add_part(const FaceSide& side, int here, int there) {
        const bool front = here + there > 0;
        (front ? split_.front : split_.back).push_back(side);
        if (here == 0) add_event(side.from, front, -1);
        if (there == 0) add_event(side.to, front, 1);
    }

    void add_event(std::uint32_t point, bool front, int change) {
        events_.push_back({point, front ? change : 0, front ? 0 : change});
    }

    bool add_intervals(PlaneId plane) {
        const std::uint32_t line = space_.lines.add(plane, by_, events_[0].point);
        // Along the cross product of the dividing plane's normal and the face's, the front lies to the left.
        const bool along = space_.lines.turn(line, by_, plane) > 0;
        sort_range(events_, [&](const LineEvent& a, const LineEvent& b) {
            if (a.point != b.point)
                return along ? space_.lines.before(line, a.point, b.point)
                             : space_.lines.before(line, b.point, a.point);
            return std::pair(a.front, a.back) < std::pair(b.front, b.back);
        });
        int front = 0, back = 0;
        for (std::size_t k = 0; k < events_.size();) {
            const std::uint32_t point = events_[k].point;
            for (; k < events_.size() && events_[k].point == point; ++k) {
                front += events_[k].front;
                back -= events_[k].back;  // intervals behind run the other way
            }
            if (front < 0 || front > 1 || back < 0 || back > 1) return false;
            if (k == events_.size()) break;
            const std::uint32_t next = events_[k].point;
            if (front == 1) flat_.push_back({{plane, point, next}, line, true});
            if (back == 1) flat_.push_back({{plane, next, point}, line, false});
        }
        return front == 0 && back == 0;
    }

    /// All sides in the plane end at every point that any of their line ends at.
    void divide_flat_sides() {
        std::vector<LinePoint> points;
        for (const FlatSide& flat : flat_) {
            points.emplace_back(flat.line, flat.side.from);
            points.emplace_back(flat.line, flat.side.to);
        }
        for (std::uint32_t k = 0; k < solid_.size(); ++k)
            if (is_resolved(k))
                for (const std::uint32_t point : {solid_.sides[k].from, solid_.sides[k].to})
                    points.emplace_back(line_beside(k), point);
        sort_once(points);
        const auto before = [&](const LinePoint& a, const LinePoint& b) {
            return a.first != b.first ? a.first < b.first : space_.lines.before(a.first, a.second, b.second);
        };
        sort_range(points, before);
        const auto each = [&](std::uint32_t line, std::uint32_t from, std::uint32_t to, const auto& function) {
            const bool up = space_.lines.before(line, from, to);
            const auto low = std::lower_bound(points.begin(), points.end(), LinePoint{line, up ? from : to}, before);
            for (auto at = low; at->second != (up ? to : from); ++at)
                up ? function(at->second, (at + 1)->second) : function((at + 1)->second, at->second);
        };
        for (const FlatSide& flat : flat_)
            each(flat.line, flat.side.from, flat.side.to, [&](std::uint32_t from, std::uint32_t to) {
                (flat.front ? split_.front : split_.back).push_back({flat.side.plane, from, to});
                (flat.front ? net_front_ : net_back_).push_back({by_, from, to});
            });
        for (std::uint32_t k = 0; k < solid_.size(); ++k)
            if (is_resolved(k))
                each(line_beside(k), solid_.sides[k].from, solid_.sides[k].to,
                     [&](std::uint32_t from, std::uint32_t to) { resolved_.push_back(std::minmax(from, to)); });
        sort_once(resolved_);
    }

    bool is_resolved(std::uint32_t k) const {
        return solid_.bend[k] < 0 && side_of(solid_.sides[k].from) == 0 && side_of(solid_.sides[k].to) == 0;
    }

    /// What sides in the plane leave open is the cap: the same of both halves.
    bool close() {
        settle_sides(net_front_);
        settle_sides(net_back_);
        if (net_front_.size() != net_back_.size()) return false;
        for (const FaceSide& side : net_front_)
            if (!std::binary_search(net_back_.begin(), net_back_.end(), FaceSide{by_, side.to, side.from}))
                return false;
        // The half in front was left open along its sides: its cap has them the other way around, and that of the half
        // behind has them as they are.
        split_.cap = net_front_;
        for (const FaceSide& side : split_.cap) {
            split_.back.push_back({by_, side.from, side.to});
            split_.front.push_back({from_behind(by_), side.to, side.from});
            split_.resolves.push_back(std::binary_search(
                resolved_.begin(), resolved_.end(),
                std::pair<std::uint32_t, std::uint32_t>(std::min(side.from, side.to), std::max(side.from, side.to))));
        }
        settle_sides(split_.front);
        settle_sides(split_.back);
        return true;
    }

    static constexpr std::int8_t kUnknown = 2;

    ConvexSpace& space_;
    const SolidSides& solid_;
    const PlaneId by_;
    SidesSplit& split_;
    std::vector<std::int8_t> sides_of_;
    std::vector<LineEvent> events_;
    std::vector<FlatSide> flat_;
    FaceSides net_front_, net_back_;
    std::vector<std::pair<std::uint32_t, std::uint32_t>> resolved_;
};

}  // namespace

bool split_sides(ConvexSpace& space, const SolidSides& solid, PlaneId plane, SidesSplit& split) {
    return SideSplitter(space, solid, plane, split).run();
}

}  // namespace firma
