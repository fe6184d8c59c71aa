// SPDX-License-Identifier: MIT
// What real levels have that a player meets: steps, stairs, slopes, folds and crests, edges of ledges, narrow gaps, low
// ceilings, each found by rays and by a player that fits all along.
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <vector>

#include "firma/players.h"
#include "firma/queries.h"
#include "firma/rooms.h"
#include "tests/reference/rooms_outside.h"

namespace firma::test {

/// A place on a floor, and a level way over it that it is found for.
struct Feature {
    Vec3 at;          ///< metres: where the floor's height changes; of a slope, a gap or a ceiling its middle
    Vec3 way;         ///< unit, level: up the step or the slope, off the ledge, along the gap
    double size;      ///< metres: the step's height, the ledge's drop, the gap's width, the ceiling's height; a slope's
                      ///< rise over its run
    double deep = 0;  ///< metres: a tread, of stairs
};

enum class FeatureKind { kStep, kStairs, kLedge, kFold, kCrest, kSlope, kSteep, kGap, kLowCeiling };

class FeatureSearch {
public:
    explicit FeatureSearch(const World& level) : world_(level), outside_(reference::rooms_outside(level)) {}

    /// At most six, none within 3 m of another.
    std::vector<Feature> find(FeatureKind kind) const {
        switch (kind) {
            case FeatureKind::kStep:
                return steps();
            case FeatureKind::kStairs:
                return stairs();
            case FeatureKind::kLedge:
                return ledges();
            case FeatureKind::kFold:
                return folds(false);
            case FeatureKind::kCrest:
                return folds(true);
            case FeatureKind::kSlope:
                return slopes(0.1, 0.95, kRun);
            case FeatureKind::kSteep:
                return slopes(1.1, 4, 0.3);
            case FeatureKind::kGap:
                return gaps();
            case FeatureKind::kLowCeiling:
                return low_ceilings();
        }
        return {};
    }

private:
    /// Upright faces with flat floors of two heights, 0.1 to 0.44 m apart.
    std::vector<Feature> steps() const {
        return from_edges([&](const Face& face, const Vec3& at, const Vec3& out) -> std::optional<Feature> {
            if (face.normal.z != 1) return {};
            const std::optional<double> below = floor_below(at + out * 0.1, 0.5);
            if (!below || at.z - *below < 0.1 || at.z - *below > 0.44) return {};
            const double height = at.z - *below;
            const Feature step{{at.x, at.y, *below}, out * -1.0, height};
            return keep_if(step, kRun, [height](double far) { return far < 0 ? 0 : height; });
        });
    }
    /// Three steps or more of one height and depth, one after the other; at the foot of one between others.
    std::vector<Feature> stairs() const {
        return from_edges([&](const Face& face, const Vec3& at, const Vec3& out) -> std::optional<Feature> {
            if (face.normal.z != 1) return {};
            const std::optional<double> below = floor_below(at + out * 0.1, 0.5);
            if (!below || at.z - *below < 0.1 || at.z - *below > 0.44) return {};
            const double height = at.z - *below;
            const Hit riser = cast(world_, Ray{at + Vec3{0, 0, 0.05}, out * -0.7});
            if (!riser) return {};
            const double deep = dot(riser.point - at, out * -1.0);
            if (deep < 0.15) return {};
            const Feature stairs{{at.x, at.y, *below}, out * -1.0, height, deep};
            return keep_if(stairs, 1.6 * deep, [&](double far) {
                const double step = std::floor(far / deep), rest = far - step * deep;
                return rest < 0.01 || rest > deep - 0.01 ? NAN : (step + 1) * height;
            });
        });
    }
    /// Edges of flat floors with a flat floor 0.8 to 6 m below.
    std::vector<Feature> ledges() const {
        return from_edges([&](const Face& face, const Vec3& at, const Vec3& out) -> std::optional<Feature> {
            if (face.normal.z != 1) return {};
            const std::optional<double> below = floor_below(at + out * 0.1, 6.5);
            if (!below || at.z - *below < 0.8 || at.z - *below > 6) return {};
            const double drop = at.z - *below;
            return keep_if({at, out, drop}, kRun, [drop](double far) { return far < 0 ? 0 : -drop; });
        });
    }
    /// Where a slope that can be walked begins on a flat floor (rises along the way), or ends in one (falls behind it).
    std::vector<Feature> folds(bool crest) const {
        return from_edges([&](const Face& face, const Vec3& at, const Vec3& out) -> std::optional<Feature> {
            if (!is_slope(face, 0.72, 0.996)) return {};
            const Vec3 gradient = Vec3{-face.normal.x, -face.normal.y, 0} * (1 / face.normal.z);
            const double rise = dot(gradient, out * -1.0);
            if (length(gradient - out * -rise) > 1e-6 || (rise < 0) != crest) return {};
            return keep_if({at, crest ? out : out * -1.0, std::fabs(rise)}, kRun,
                           [&](double far) { return crest ? std::min(far, 0.0) * -rise : std::max(far, 0.0) * rise; });
        });
    }
    /// Plane ground between two rises over runs, as long as a player needs for some steps.
    std::vector<Feature> slopes(double least, double most, double run) const {
        std::vector<Feature> found;
        for (const Face& face : world_.faces()) {
            if (!face.solid || face.normal.z < 0.15 || face.normal.z > 0.999) continue;
            const double flat = std::hypot(face.normal.x, face.normal.y), rise = flat / face.normal.z;
            if (rise < least || rise > most) continue;
            Vec3 middle;
            for (const Vec3& corner : face.corners) middle += corner * (1.0 / double(face.corners.size()));
            add(found, keep_if({middle, Vec3{-face.normal.x, -face.normal.y, 0} * (1 / flat), rise}, run,
                               [rise](double far) { return far * rise; }));
        }
        return found;
    }
    /// Flat floors between two plane walls 0.64 to 1.26 m apart, and along them 0.5 m to each side.
    std::vector<Feature> gaps() const {
        return from_floors([&](const Vec3& at, const Vec3& way) -> std::optional<Feature> {
            constexpr double kMostWide = 1.26;
            const Vec3 side = Vec3{way.y, way.x, 0} * kMostWide, chest = at + Vec3{0, 0, 1};
            const Hit left = cast(world_, Ray{chest, side});
            if (!left) return {};
            const Hit right = cast(world_, Ray{chest, side * -1.0});
            if (!right) return {};
            const double width = length(left.point - right.point);
            if (width < 0.64 || width > kMostWide) return {};
            const Vec3 middle = (left.point + right.point) * 0.5 - Vec3{0, 0, 1};
            const Feature gap{middle, way, width};
            if (!fits_along(gap, 0.5, 0.315, [](double) { return 0; })) return {};
            for (double far = -0.5; far <= 0.5; far += 0.125)
                for (double high = 0.05; high < 1.8; high += 0.35)
                    for (const double to : {1.0, -1.0}) {
                        const Vec3 from = middle + way * far + Vec3{0, 0, high};
                        const Hit wall = cast(world_, Ray{from, side * to});
                        if (!wall || std::fabs(length(wall.point - from) - width / 2) > 1e-6) return {};
                    }
            return gap;
        });
    }
    /// Flat floors below flat ceilings at 1.85 to 2.6 m, a metre to each side.
    std::vector<Feature> low_ceilings() const {
        return from_floors([&](const Vec3& at, const Vec3& way) -> std::optional<Feature> {
            const Hit hit = cast(world_, Ray{at + Vec3{0, 0, 0.1}, {0, 0, 3}});
            if (!hit || hit.point.z - at.z < 1.85 || hit.point.z - at.z > 2.6 || hit.face_normal.z != -1) return {};
            const Feature ceiling{at, way, hit.point.z - at.z};
            if (!fits_along(ceiling, 1, 0.35, [](double) { return 0; })) return {};
            for (double far = -1; far <= 1; far += 0.125)
                for (double off = -0.35; off <= 0.35; off += 0.175) {
                    const Vec3 from = at + way * far + Vec3{way.y, way.x, 0} * off + Vec3{0, 0, 0.1};
                    const Hit over = cast(world_, Ray{from, {0, 0, 3}});
                    if (!over || std::fabs(over.point.z - hit.point.z) > 1e-6) return {};
                }
            return ceiling;
        });
    }

    using Profile = std::function<double(double)>;
    static constexpr double kRun = 1;     // metres to each side of what is found
    static constexpr double kWide = 0.4;  // likewise, half
    static constexpr double kApart = 3;
    static constexpr std::size_t kMost = 6;

    static bool is_slope(const Face& face, double least, double most) {
        return face.normal.z > least && face.normal.z < most;
    }
    std::optional<double> floor_below(const Vec3& at, double far) const {
        const Hit hit = cast(world_, Ray{at + Vec3{0, 0, 0.05}, {0, 0, -far}});
        if (!hit || hit.face_normal.z != 1) return {};
        return hit.point.z;
    }
    static bool is_apart(const std::vector<Feature>& found, const Vec3& at) {
        return std::all_of(found.begin(), found.end(),
                           [&](const Feature& other) { return length(other.at - at) > kApart; });
    }
    static void add(std::vector<Feature>& found, const std::optional<Feature>& feature) {
        if (feature && found.size() < kMost && is_apart(found, feature->at)) found.push_back(*feature);
    }
    template <class Make>
    std::vector<Feature> from_edges(const Make& make) const {
        std::vector<Feature> found;
        for (const Face& face : world_.faces()) {
            if (!face.solid || face.normal.z < 0.5) continue;
            Vec3 middle;
            for (const Vec3& corner : face.corners) middle += corner * (1.0 / double(face.corners.size()));
            for (std::size_t k = 0; k < face.corners.size(); ++k) {
                const Vec3 a = face.corners[k], b = face.corners[(k + 1) % face.corners.size()], edge = b - a;
                const double flat = std::hypot(edge.x, edge.y);
                if (std::fabs(edge.z) > 1e-9 || flat < 0.3) continue;
                Vec3 out = Vec3{edge.y, -edge.x, 0} * (1 / flat);
                const Vec3 at = (a + b) * 0.5;
                if (dot(out, middle - at) > 0) out = out * -1.0;
                add(found, make(face, at, out));
            }
        }
        return found;
    }
    /// Of points of a grid on floors, looked at along x and along y.
    template <class Make>
    std::vector<Feature> from_floors(const Make& make) const {
        constexpr double kEvery = 0.5;
        std::vector<Feature> found;
        for (const Face& face : world_.faces()) {
            if (!face.solid || face.normal.z != 1) continue;
            Vec3 low = face.corners[0], high = low;
            for (const Vec3& corner : face.corners)
                for (int axis = 0; axis < 2; ++axis) {
                    low[axis] = std::min(low[axis], corner[axis]);
                    high[axis] = std::max(high[axis], corner[axis]);
                }
            for (double x = low.x + 0.1; x < high.x; x += kEvery)
                for (double y = low.y + 0.1; y < high.y; y += kEvery) {
                    if (found.size() == kMost) return found;
                    const Vec3 at{x, y, low.z};
                    if (!is_apart(found, at)) continue;
                    const Hit hit = cast(world_, Ray{at + Vec3{0, 0, 0.05}, {0, 0, -0.1}});
                    if (!hit || hit.face.id != face.id) continue;
                    add(found, make(at, Vec3{1, 0, 0}));
                    add(found, make(at, Vec3{0, 1, 0}));
                }
        }
        return found;
    }
    std::optional<Feature> keep_if(const Feature& feature, double run, const Profile& height) const {
        if (fits_along(feature, run, kWide, height)) return feature;
        return {};
    }
    /// Whether the floor is as high as said, and a player as wide as that fits there, all along.
    bool fits_along(const Feature& feature, double run, double wide, const Profile& height) const {
        constexpr double kEvery = 0.125;
        const Vec3 side{-feature.way.y, feature.way.x, 0};
        const PlayerShape shape = make_player_box({.radius = wide, .height = 1.84, .crouched_height = 1}).value();
        for (double far = -run + 0.01; far < run; far += kEvery) {
            const Vec3 on = feature.at + feature.way * far;
            double top = -INFINITY;
            for (double off = -wide; off <= wide; off += wide / 3)
                for (const double near : {-wide, 0.0, wide}) {
                    const double z = height(far + near);
                    if (std::isnan(z)) continue;
                    top = std::max(top, z);
                    if (std::fabs(far + near) > run || std::fabs(far + near) < 0.01) continue;
                    const Vec3 over = on + side * off + feature.way * near + Vec3{0, 0, z + 0.09};
                    const Hit hit = cast(world_, Ray{over, {0, 0, -0.2}});
                    if (!hit || !hit.face.valid() || std::fabs(hit.point.z - feature.at.z - z) > 1e-5) return false;
                }
            const Vec3 feet = on + Vec3{0, 0, top + 0.004};
            const Location middle = locate(world_, feet + Vec3{0, 0, 0.9});
            if (middle.where != Where::kAir || outside_[middle.room.value]) return false;
            if (!player_fits(world_, shape, feet)) return false;
        }
        return true;
    }

    const World& world_;
    const std::vector<bool> outside_;
};

}  // namespace firma::test
