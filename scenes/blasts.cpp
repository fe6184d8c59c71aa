// SPDX-License-Identifier: MIT
// Seeded blasts for a world with rooms and doors.
#include "scenes/blasts.h"

#include <algorithm>
#include <cmath>

namespace firma::scenes {
namespace {

constexpr double kSmallest = 0.3, kLargest = 6;  // metres
constexpr double kBlastStep = 0.25;              // metres, of the lattice
constexpr double kFilled = 0.2;
constexpr double kShotFrom = 0.5;

/// A point of a polygon, and which way its front looks.
struct PolygonSpot {
    Vec3 point, normal;
    Vec3 outward;  ///< from the polygon's middle, unit; of a spot on the rim
};

Vec3 unit_or(const Vec3& v, const Vec3& other) {
    const double size = length(v);
    return size > 0 ? v * (1 / size) : other;
}

Vec3 middle_of(const std::vector<Vec3>& polygon) {
    Vec3 sum{0, 0, 0};
    for (const Vec3& corner : polygon) sum = sum + corner;
    return sum * (1 / double(polygon.size()));
}

Vec3 normal_of(const std::vector<Vec3>& polygon) {
    Vec3 twice{0, 0, 0};
    for (std::size_t k = 2; k < polygon.size(); ++k)
        twice = twice + cross(polygon[k - 1] - polygon[0], polygon[k] - polygon[0]);
    return unit_or(twice, {0, 0, 1});
}

PolygonSpot spot_within(const std::vector<Vec3>& polygon, Rng& rng) {
    const std::uint32_t k = 2 + rng.below(std::uint32_t(polygon.size()) - 2);
    double u = rng.uniform(), v = rng.uniform();
    if (u + v > 1) {
        u = 1 - u;
        v = 1 - v;
    }
    const Vec3 &a = polygon[0], &b = polygon[k - 1], &c = polygon[k];
    return {a + (b - a) * u + (c - a) * v, normal_of(polygon), {0, 0, 1}};
}

/// One in three is a corner.
PolygonSpot spot_on_rim(const std::vector<Vec3>& polygon, Rng& rng) {
    const std::uint32_t k = rng.below(std::uint32_t(polygon.size()));
    const double along = rng.chance(0.33) ? 0 : rng.uniform();
    const Vec3 &a = polygon[k], &b = polygon[(k + 1) % polygon.size()];
    const Vec3 point = a + (b - a) * along;
    return {point, normal_of(polygon), unit_or(point - middle_of(polygon), {0, 0, 1})};
}

Vec3 on_lattice(const Vec3& p) {
    Vec3 result;
    for (int axis = 0; axis < 3; ++axis) result[axis] = std::floor(p[axis] / kBlastStep + 0.5) * kBlastStep;
    return result;
}

/// Its farthest vertex.
double reach_of(const Cutter& cutter) {
    double reach = 0;
    for (const Vec3& v : cutter.vertices()) reach = std::max(reach, length(v));
    return reach;
}

class BlastMaker {
public:
    BlastMaker(const BlastPlaces& places, Rng& rng) : places_(places), rng_(rng) {}

    RoomBlast make(BlastFamily family, const RoomBlast* before) {
        family_ = family;
        reach_ = kSmallest + (kLargest - kSmallest) * cube(rng_.uniform());
        RoomBlast blast = family == BlastFamily::kAgain && before ? again(*before)
                          : family == BlastFamily::kLattice       ? on_the_lattice()
                                                                  : anywhere();
        blast.family = family;
        const Vec3 way = rng_.direction();
        const double away = reach_ * rng_.uniform(0.3, 3);
        if (rng_.chance(kShotFrom)) blast.from = blast.cut.pose.position + way * away;
        return blast;
    }

private:
    static double cube(double x) { return x * x * x; }

    RoomBlast anywhere() {
        RoomBlast blast;
        CutOrder& cut = blast.cut;
        cut.cutter = rng_.chance(0.5) ? make_crater(CutterShape::kRocky, rng_.next()) : any_cutter(rng_);
        cut.pose.position = place();
        if (!rng_.chance(0.25)) cut.pose.rotation = random_turn(rng_.next());
        cut.pose.scale = reach_ / reach_of(cut.cutter);
        if (rng_.chance(kFilled)) cut.kind = CarveKind::kFill;
        return blast;
    }

    std::vector<Vec3> wall() {
        const Level& level = places_.cuts.inside;
        const LevelFace& face = level.faces[rng_.below(std::uint32_t(level.faces.size()))];
        std::vector<Vec3> polygon;
        for (std::uint32_t k = 0; k < face.corner_count; ++k)
            polygon.push_back(firma::to_metres(level.vertices[level.corners[face.first_corner + k]]));
        return polygon;
    }
    std::vector<Vec3> one_of(const std::vector<std::vector<Vec3>>& polygons) {
        return polygons.empty() ? wall() : polygons[rng_.below(std::uint32_t(polygons.size()))];
    }

    Vec3 place() {
        const double in = rng_.uniform(-1, 1), far = rng_.uniform(0.9, 2.5);
        const Vec3 way = rng_.direction();
        switch (family_) {
            case BlastFamily::kAir:
            case BlastFamily::kSolid: {
                const PolygonSpot spot = spot_within(wall(), rng_);
                return spot.point + spot.normal * (reach_ * (family_ == BlastFamily::kAir ? far : -far));
            }
            case BlastFamily::kCorner:
                return wall()[0] + way * (reach_ * 0.5 * std::fabs(in));
            case BlastFamily::kDoorway: {
                const PolygonSpot spot = spot_within(one_of(places_.cuts.portals), rng_);
                return spot.point + spot.normal * (reach_ * 0.5 * in);
            }
            case BlastFamily::kRim: {
                const PolygonSpot spot = spot_on_rim(one_of(places_.cuts.portals), rng_);
                return rng_.chance(0.5) ? spot.point : spot.point + way * (reach_ * 0.3 * in);
            }
            case BlastFamily::kOverPortal:
                return beside(one_of(places_.cuts.portals));
            case BlastFamily::kClosedDoor:
                return beside(one_of(places_.doors));
            default: {
                const PolygonSpot spot = spot_within(wall(), rng_);
                return spot.point + spot.normal * (reach_ * 0.9 * in);
            }
        }
    }

    /// In the wall next to an opening, and mostly through it.
    Vec3 beside(const std::vector<Vec3>& portal) {
        const PolygonSpot spot = spot_on_rim(portal, rng_);
        const double away = rng_.uniform(0.4, 1.3), across = rng_.uniform(-0.4, 0.4);
        return spot.point + spot.outward * (reach_ * away) + spot.normal * (reach_ * across);
    }

    RoomBlast on_the_lattice() {
        RoomBlast blast;
        CutOrder& cut = blast.cut;
        if (rng_.chance(kFilled)) cut.kind = CarveKind::kFill;
        const std::vector<Vec3> polygon = rng_.chance(0.6) ? one_of(places_.cuts.portals) : wall();
        const double which = rng_.uniform();
        if (which < 0.25) {
            fit_box(polygon, cut);
            if (rng_.chance(0.3)) cut.kind = CarveKind::kFill;
            return blast;
        }
        Vec3 half;
        for (int axis = 0; axis < 3; ++axis)
            half[axis] = kBlastStep * double(1 + rng_.below(std::uint32_t(1 + reach_ * 0.5 / kBlastStep)));
        const Vec3 way = rng_.direction();
        const PolygonSpot spot = rng_.chance(0.5) ? spot_on_rim(polygon, rng_) : spot_within(polygon, rng_);
        cut.pose.position = on_lattice(spot.point + way * (0.5 * reach_ * rng_.uniform()));
        if (which < 0.75) {
            cut.cutter = box_cutter(half);
            if (which < 0.5) lay_on(spot, half, cut.pose.position);
            return blast;
        }
        const Cutter shape = any_cutter(rng_);
        cut.cutter = snapped_cutter(shape, reach_ / reach_of(shape), kBlastStep);
        if (!cut.cutter.valid()) cut.cutter = box_cutter(half);
        return blast;
    }

    /// A box as large as a polygon, or a quarter larger or smaller on some sides.
    void fit_box(const std::vector<Vec3>& polygon, CutOrder& cut) {
        Box box;
        for (const Vec3& corner : polygon) box.add(corner);
        for (int axis = 0; axis < 3; ++axis) {
            const bool flat = !(box.high[axis] - box.low[axis] > 0);
            const bool grows = rng_.chance(0.3);
            if (flat || grows) {
                box.low[axis] -= kBlastStep * double(1 + rng_.below(3));
                box.high[axis] += kBlastStep * double(flat ? 1 + rng_.below(3) : rng_.below(2));
            }
            const double size = box.high[axis] - box.low[axis];
            if (size > 2 * kLargest) box.high[axis] = box.low[axis] + 2 * kLargest;
        }
        cut.cutter = box_cutter((box.high - box.low) * 0.5);
        cut.pose.position = (box.low + box.high) * 0.5;
    }

    /// A side of the box in the plane of the spot's polygon, where that is square to an axis.
    void lay_on(const PolygonSpot& spot, const Vec3& half, Vec3& position) {
        for (int axis = 0; axis < 3; ++axis)
            if (std::fabs(spot.normal[axis]) > 0.999)
                position[axis] = spot.point[axis] + (rng_.chance(0.5) ? half[axis] : -half[axis]);
    }

    RoomBlast again(const RoomBlast& before) {
        RoomBlast blast = before;
        CutOrder& cut = blast.cut;
        blast.from.reset();
        reach_ = std::max(kSmallest, reach_of(cut.cutter) * cut.pose.scale);
        const double which = rng_.uniform();
        const Vec3 way = rng_.direction();
        if (which < 0.3) cut.kind = cut.kind == CarveKind::kCarve ? CarveKind::kFill : CarveKind::kCarve;
        if (which > 0.2 && which < 0.5) cut.pose.position.x += (which < 0.35 ? 1 : -1) / kInputSteps;
        if (which >= 0.5 && which < 0.9) cut.pose.position = cut.pose.position + way * (reach_ * rng_.uniform(0.1, 1));
        if (which >= 0.8) cut.pose.rotation = random_turn(rng_.next());
        return blast;
    }

    const BlastPlaces& places_;
    Rng& rng_;
    BlastFamily family_ = BlastFamily::kWall;
    double reach_ = 1;
};

}  // namespace

BlastPlaces blast_places(const World& world) {
    BlastPlaces places;
    places.cuts = cut_places(world);
    for (std::uint32_t portal = 0; portal < portal_count(world); ++portal)
        if (!portal_info(world, {portal})->open)
            for (std::vector<Vec3>& polygon : portal_polygons(world, {portal}))
                places.doors.push_back(std::move(polygon));
    return places;
}

std::vector<RoomBlast> room_blasts(const BlastPlaces& places, std::size_t count, Rng& rng) {
    BlastMaker maker(places, rng);
    std::vector<RoomBlast> blasts;
    while (blasts.size() < count) {
        const auto family = BlastFamily(rng.below(std::uint32_t(kBlastNames.size())));
        blasts.push_back(maker.make(family, blasts.empty() ? nullptr : &blasts.back()));
    }
    return blasts;
}

World with_closed_doors(const World& world, double share, Rng& rng) {
    World made = world;
    for (std::uint32_t portal = 0; portal < portal_count(world); ++portal)
        if (rng.chance(share)) made = *set_portal_open(made, {portal}, false);
    return made;
}

}  // namespace firma::scenes
