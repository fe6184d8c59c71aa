// SPDX-License-Identifier: MIT
// The first touch of a shape with one face of a part that turns: step by step along separating directions.
#include "moving/touch_turning.h"

#include <cmath>

#include "moving/convex_distance.h"

namespace firma {
namespace {

/// Metres from fraction 0 to 1: what comes nearer more slowly than this rests. A part of that is rounding.
constexpr double kRestSpeed = 0x1p-30;
constexpr double kSpeedRounding = 0x1p-47;

/// One face, and the shape at one time after the other.
class FaceInTurn {
public:
    FaceInTurn(const TurningShape& shape, const PolygonShape& face, bool two_sided, double bend)
        : shape_(shape),
          face_(face),
          normal_(face.unit_normal()),
          two_sided_(two_sided),
          bend_(bend),
          touch_(touch_of(shape)) {}

    /// @param steps  that may be made, made less by those that were
    TurningTouch first_touch(double from, double to, std::int64_t& steps) const {
        Place now = place_at(from);
        bool left_alone = now.gap <= touch_;
        double lowest = now.gap - touch_ / 2;
        for (; steps > 0; --steps) {
            double next;
            if (now.gap > touch_) {
                left_alone = false;
                next = steps_to(now, shape_.radius + touch_ / 2);
                if (next <= now.at.time) return touch(now);  // the search for nearest points came to no end
            } else {
                if (!left_alone && may_face(now)) return touch(now);
                if (!left_alone) lowest = now.gap - touch_ / 2;
                left_alone = true;
                const bool faces = faces_at(now);
                if (faces && (now.speed < -rest_speed() || now.gap < lowest)) return touch(now);
                next = faces ? steps_to(now, now.lowest - touch_ / 8) : now.at.time + short_step();
            }
            if (now.at.time == to) return {};
            now = place_at(next < to ? next : to);
        }
        return touch(now);
    }

private:
    /// How shape and face lie to each other at a time.
    struct Place {
        explicit Place(const ShapeAt& shape) : at(shape) {}

        ShapeAt at;
        double gap = 0;      ///< of the surfaces, no less than it is; below 0 by the depth where they overlap
        Vec3 normal;         ///< unit, away from the face
        double highest = 0;  ///< of the face's corners along it
        double lowest = 0;   ///< of the shape's corners along it, less that: a lower bound of the cores' distance
        Vec3 point;          ///< of the core, nearest to the face
        double speed = 0;    ///< the least along the normal, of the corners that are nearest along it
        double facing = 0;   ///< the least along the face's normal, of the same
    };

    double rest_speed() const {
        return kRestSpeed + kSpeedRounding * (length(shape_.velocity) + shape_.angle * length(shape_.start[0]));
    }
    /// In so much time a distance at rest changes by an eighth of that at most.
    double short_step() const { return bend_ > 0 ? std::sqrt(touch_ / 4 / bend_) : 2; }

    Place place_at(double time) const {
        Place place(ShapeAt(shape_, time));
        // Seen from near by, so that nothing is lost far from the origin.
        const Vec3 origin = place.at.corner[0];
        CornerList core, outline;
        for (const Vec3& corner : place.at.corners()) core.add(corner - origin);
        for (const Vec3& corner : face_.corners) outline.add(corner - origin);
        const ConvexDistance found = convex_distance(core.all(), outline.all());
        place.point = origin + found.point;
        place.normal = found.apart ? found.normal : way_out(place);
        look_along(place);
        place.gap = (found.apart ? found.distance : place.lowest) - shape_.radius;
        return place;
    }

    double highest_along(const Vec3& direction) const {
        double highest = -INFINITY;
        for (const Vec3& corner : face_.corners) {
            const double at = dot(corner, direction);
            highest = at > highest ? at : highest;
        }
        return highest;
    }
    double lowest_along(const ShapeAt& at, const Vec3& direction) const {
        double lowest = INFINITY;
        for (const Vec3& corner : at.corners()) {
            const double here = dot(corner, direction);
            lowest = here < lowest ? here : lowest;
        }
        return lowest;
    }

    void look_along(Place& place) const {
        place.highest = highest_along(place.normal);
        place.lowest = lowest_along(place.at, place.normal) - place.highest;
        place.speed = place.facing = INFINITY;
        for (const Vec3& corner : place.at.corners()) {
            if (dot(corner, place.normal) - place.highest > place.lowest + touch_) continue;
            const Vec3 velocity = place.at.velocity_of(corner);
            const double speed = dot(velocity, place.normal), facing = dot(velocity, normal_);
            place.speed = speed < place.speed ? speed : place.speed;
            place.facing = facing < place.facing ? facing : place.facing;
        }
    }

    /// Of a core that the face reaches into: the shortest along the face's normal, either way, and across its sides;
    /// along the normal where the middle is behind a one-sided face.
    Vec3 way_out(const Place& place) const {
        Vec3 middle;
        for (const Vec3& corner : place.at.corners()) middle += corner * (1.0 / double(place.at.corner.count()));
        const bool behind = dot(middle - face_.corners[0], normal_) < 0;
        if (behind && !two_sided_) return normal_;
        Vec3 best = behind ? -normal_ : normal_;
        double out = lowest_along(place.at, best) - highest_along(best);
        const auto look = [&](const Vec3& direction) {
            const double there = lowest_along(place.at, direction) - highest_along(direction);
            if (there > out) out = there, best = direction;
        };
        look(-best);
        for (std::size_t k = 0; k < face_.corners.size(); ++k) {
            const Vec3 across = cross(face_.corners[face_.next(k)] - face_.corners[k], normal_);
            const double size = length(across);
            if (size > 0) look(across * (1 / size));
        }
        return best;
    }

    bool faces_at(const Place& place) const { return two_sided_ || place.facing < 0; }
    /// Whether the shape goes against the face now, or may before a short step is over.
    bool may_face(const Place& place) const { return two_sided_ || place.facing < bend_ * short_step() + rest_speed(); }

    /// A time up to which no corner comes below a level along the normal; the time now where one is there.
    double steps_to(const Place& place, double level) const {
        double least = 2;
        for (const Vec3& corner : place.at.corners()) {
            const double above = dot(corner, place.normal) - place.highest - level;
            const double speed = dot(place.at.velocity_of(corner), place.normal);
            if (!(above > 0)) return place.at.time;
            const double root = std::sqrt(speed * speed + 2 * bend_ * above);
            const double h = speed < 0 ? 2 * above / (root - speed) : bend_ > 0 ? (speed + root) / bend_ : 2;
            least = h < least ? h : least;
        }
        return place.at.time + least;
    }

    TurningTouch touch(const Place& place) const {
        return {true, place.at.time, place.normal, place.point, place.speed};
    }

    const TurningShape& shape_;
    const PolygonShape& face_;
    const Vec3 normal_;
    const bool two_sided_;
    const double bend_;
    const double touch_;  ///< metres: so near is in touch
};

}  // namespace

TurningTouch touch_turning(const TurningShape& shape, const PolygonShape& face, bool two_sided, double from, double to,
                           double bend, std::int64_t& steps) {
    return FaceInTurn(shape, face, two_sided, bend).first_touch(from, to, steps);
}

}  // namespace firma
