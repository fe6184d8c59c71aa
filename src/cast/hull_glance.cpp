// SPDX-License-Identifier: MIT
#include "cast/hull_glance.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "base/seldom.h"
#include "cast/sizes_of.h"
#include "cast/time_range.h"
#include "geometry/rounding.h"

namespace firma {
namespace {

/// Edge and side that are so nearly parallel that their common perpendicular is off by more than this share are left to
/// all facets.
constexpr double kDirectionError = 0x1p-30;

/// Between which times the hull may touch, as far as directions told.
struct MayTouch {
    double from = 0, to = 0;

    /// @param now     how far outside the hull is at the start along a direction
    /// @param change  how that changes with the sweep's parameter
    /// @return whether any time is left
    bool narrow(const Estimate& now, const Estimate& change) {
        const double least = now.value - now.error;  // the hull is no nearer
        if (least > 0) {
            const double speed = change.error - change.value;
            if (!(speed > 0)) return false;
            from = std::max(from, least / speed * (1 - rounding(8)));
        } else if (const double speed = change.value - change.error; speed > 0) {
            to = std::min(to, -least / speed * (1 + rounding(8)));
        }
        return from <= to;
    }
};

/// Which corner of a hull is lowest along a direction, and how low.
struct LowestCorner {
    double height = 0;
    std::size_t corner = 0;

    FIRMA_SELDOM LowestCorner(const HullShape& hull, const Vec3& u) : height(dot(u, hull.corners[0])) {
        for (std::size_t k = 1; k < hull.corners.size(); ++k) {
            const double here = dot(u, hull.corners[k]);
            if (here < height) {
                height = here;
                corner = k;
            }
        }
    }
};

/// How far the polygon reaches along a direction, from its first corner.
struct Reach {
    double low = 0, high = 0;

    FIRMA_SELDOM Reach(const PolygonShape& polygon, const Vec3& u) {
        for (const Vec3& corner : polygon.corners.subspan(1)) {
            const double here = dot(u, corner - polygon.corners[0]);
            low = std::min(low, here);
            high = std::max(high, here);
        }
    }
};

/// When a facet's plane is reached, where double tells for sure that it is.
struct Landing {
    double t = 0;
    double blur = 0;    ///< of t
    double unsure = 0;  ///< of the distance at the start
    bool sharp = true;  ///< whether t is good enough for an answer

    static std::optional<Landing> on(const HullAgainstPolygon& pair, const Estimate& height, const Estimate& fall) {
        const Sweep& sweep = pair.sweep();
        if (!(height.value > height.error && fall.value < -4 * fall.error)) return {};
        if (at_end(height, fall, sweep.end).sign() >= 0) return {};
        const TimeRange crossed = crossing(height, fall);
        const double size = max_abs(pair.seen()) + pair.hull().reach;
        const double blur = crossed.high - crossed.low;
        const bool sharp = blur * sweep.direction_length <= kTimeError * size;
        return Landing{height.value / -fall.value, blur, height.error, sharp};
    }
};

/// One look at one pair.
class HullLook {
public:
    HullLook(const HullAgainstPolygon& pair, int facing, double latest)
        : pair_(pair),
          sweep_(pair.sweep()),
          hull_(pair.hull()),
          polygon_(pair.polygon()),
          speeds_(sizes_of(sweep_.direction)),
          left_{0, std::min(latest, sweep_.end)},
          facing_(facing) {}

    HullGlance run() {
        // The plane, from the side that the hull comes from; beyond it there is nothing to be met.
        const SumFacet plane = pair_.facet({SumFacet::kPlane, std::int8_t(facing_ > 0 ? -1 : 1), 0, 0});
        const LowestCorner lowest(hull_, plane.direction);
        const Estimate height = pair_.outside_by(plane, lowest.height), fall = pair_.change(plane);
        if (!left_.narrow(height, fall)) return {HullGlance::kBeside, 0, {}};
        std::optional<Landing> landing;
        if (facing_ != 0) landing = Landing::on(pair_, height, fall);

        std::uint64_t sides = 0;  // those that may be met
        for (std::size_t k = 0; k < polygon_.corners.size(); ++k) {
            const Vec3 e = side(k), m = cross(e, polygon_.normal);
            const Estimate outside{dot(m, pair_.seen()) + LowestCorner(hull_, m).height - Reach(polygon_, m).high,
                                   rounding(8) * dot(sizes_of(m), pair_.sizes())};
            const Estimate change{dot(m, sweep_.direction), rounding(4) * dot(sizes_of(m), speeds_)};
            if (!left_.narrow(outside, change) || passes(e)) return {HullGlance::kBeside, 0, {}};
            const bool beyond = landing ? !is_within(k, m, *landing, hull_.corners[lowest.corner])
                                        : outside.value > 0 && change.value < 0;
            if (beyond) sides |= std::uint64_t(1) << k;
        }
        if (landing && sides == 0) {
            if (!landing->sharp && !is_lowest_alone(plane.direction, lowest, landing->unsure)) return {};
            return met(*landing, plane.name);
        }
        for (std::size_t k = 0; k < polygon_.corners.size(); ++k) {
            if (!(sides >> k & 1)) continue;
            const std::optional<SumFacet::Name> edge = edge_over(k);
            if (!edge) continue;
            if (const std::optional<Landing> crossed = crosses(*edge)) return met(*crossed, *edge);
        }
        return {};
    }

private:
    Vec3 side(std::size_t k) const { return polygon_.corners[polygon_.next(k)] - polygon_.corners[k]; }
    HullGlance met(const Landing& landing, const SumFacet::Name& by) const {
        return {landing.sharp ? HullGlance::kOnIt : HullGlance::kBlurred, std::min(landing.t, sweep_.end), by};
    }

    bool is_lowest_alone(const Vec3& u, const LowestCorner& lowest, double unsure) const {
        for (std::size_t k = 0; k < hull_.corners.size(); ++k)
            if (k != lowest.corner && dot(u, hull_.corners[k]) <= lowest.height + 2 * unsure) return false;
        return true;
    }
    /// Whether no corners but their own are as far along u as the edge and the side of a facet, to rounding.
    bool touch_alone(const Vec3& u, const SumFacet::Name& name, double unsure) const {
        const HullShape::Edge& edge = hull_.edges[name.hull];
        const double low = dot(u, hull_.corners[edge.from]) + 2 * unsure;
        for (std::size_t k = 0; k < hull_.corners.size(); ++k)
            if (k != edge.from && k != edge.to && dot(u, hull_.corners[k]) <= low) return false;
        const Vec3& from = polygon_.corners[name.side];
        for (std::size_t k = 0; k < polygon_.corners.size(); ++k)
            if (k != name.side && k != polygon_.next(name.side) && dot(u, polygon_.corners[k] - from) >= -2 * unsure)
                return false;
        return true;
    }

    /// Whether the hull stays on one side of the polygon, seen along the path and side e.
    bool passes(const Vec3& e) const {
        const Vec3 u = cross(e, sweep_.direction);
        const Reach reach(polygon_, u);
        const double at = dot(u, pair_.seen());
        // Along the path u is level but for its own rounding.
        const double unsure = rounding(8) * (dot(sizes_of(u), pair_.sizes()) +
                                             sweep_.end * dot(sizes_of_cross(e, sweep_.direction), speeds_));
        return at + LowestCorner(hull_, u).height > reach.high + unsure ||
               at - LowestCorner(hull_, -u).height < reach.low - unsure;
    }

    /// Whether a corner of the hull is surely on the inner side of side k when it lands.
    /// @param m  e x n: off from that by what rounding did to n and to it
    bool is_within(std::size_t k, const Vec3& m, const Landing& landing, const Vec3& corner) const {
        const Vec3 at = pair_.seen() + corner + sweep_.direction * landing.t;
        const Vec3 most = sizes_of_cross(side(k), polygon_.normal);
        const double unsure =
            rounding(32) * dot(most, pair_.sizes() + speeds_ * landing.t) + 2 * landing.blur * dot(most, speeds_);
        return dot(m, at - (polygon_.corners[k] - polygon_.corners[0])) < -unsure;
    }

    /// The edge that comes down on side k, if any does: of those that support the hull across it the last to get there.
    std::optional<SumFacet::Name> edge_over(std::size_t k) const {
        const Vec3 e = side(k), from = pair_.seen() - (polygon_.corners[k] - polygon_.corners[0]);
        bool ahead[HullShape::kMaxTriangles];
        for (std::size_t t = 0; t < hull_.triangles.size(); ++t) ahead[t] = dot(hull_.triangles[t].normal, e) > 0;
        std::optional<SumFacet::Name> last;
        double latest = 0;
        for (std::size_t g = 0; g < hull_.edges.size(); ++g) {
            const HullShape::Edge& edge = hull_.edges[g];
            if (ahead[edge.left] == ahead[edge.right]) continue;
            if ((dot(edge.along, polygon_.normal) > 0) != ahead[edge.left]) continue;
            const double turn = ahead[edge.left] ? 1 : -1;
            const Vec3 u = cross(e, edge.along) * turn;
            const double height = dot(u, from + hull_.corners[edge.from]), fall = dot(u, sweep_.direction);
            if (!(height > 0 && fall < 0) || !(height > latest * -fall)) continue;
            latest = height / -fall;
            last = SumFacet::Name{SumFacet::kEdges, std::int8_t(turn), std::uint8_t(g), std::uint8_t(k)};
        }
        return last;
    }

    /// When an edge of the hull meets a side of the polygon: if it surely crosses it there, and nothing meets before.
    std::optional<Landing> crosses(const SumFacet::Name& name) const {
        const SumFacet facet = pair_.facet(name);
        const HullShape::Edge& edge = hull_.edges[name.hull];
        const Vec3 &u = facet.direction, &o = hull_.corners[edge.from];
        const Vec3 v = polygon_.corners[name.side] - polygon_.corners[0], e = side(name.side);
        const double uu = dot(u, u);
        if (!(max_abs(facet.error) < kDirectionError * max_abs(u))) return {};
        const Estimate height = pair_.outside(facet);
        const std::optional<Landing> landing = Landing::on(pair_, height, pair_.change(facet));
        if (!landing || !touch_alone(u, name, landing->unsure)) return {};
        // x along the hull's edge and y along the side, times uu.
        const Vec3 at = pair_.seen() + o + sweep_.direction * landing->t - v;
        const double x = name.turn * dot(cross(at, e), u), y = name.turn * dot(cross(at, edge.along), u);
        const Vec3 off = (pair_.sizes() + speeds_ * landing->t) * rounding(32) + speeds_ * (2 * landing->blur);
        const double blur = 4 * kDirectionError * uu;  // of u
        const double x_unsure = dot(sizes_of_cross(off, e), sizes_of(u)) + blur;
        const double y_unsure = dot(sizes_of_cross(off, edge.along), sizes_of(u)) + blur;
        if (x > x_unsure && x < uu - x_unsure && y > y_unsure && y < uu - y_unsure) return landing;
        return {};
    }

    const HullAgainstPolygon& pair_;
    const Sweep& sweep_;
    const HullShape& hull_;
    const PolygonShape& polygon_;
    const Vec3 speeds_;
    MayTouch left_;
    const int facing_;
};

}  // namespace

HullGlance glance(const HullAgainstPolygon& pair, int facing, double latest) {
    return HullLook(pair, facing, latest).run();
}

}  // namespace firma
