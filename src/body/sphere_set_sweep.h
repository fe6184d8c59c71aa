// SPDX-License-Identifier: MIT
// What sweeps of sets of spheres have in common, whatever they meet.
#pragma once

#include <span>
#include <type_traits>

#include "body/body_tolerance.h"
#include "firma/cast_set.h"
#include "moving/arc.h"

namespace firma {

/// Whether numbers are finite and no radius is below zero.
inline bool can_be_cast(std::span<const Sphere> spheres, const RigidMotion& motion) {
    if (!is_usable(motion)) return false;
    for (const Sphere& sphere : spheres)
        if (!is_finite(sphere.centre) || !(sphere.radius >= 0) || !is_finite(sphere.radius)) return false;
    return true;
}

/// A cast that was refused.
template <class Found>
Found invalid_hit() {
    Found hit;
    hit.status = Status::kInvalid;
    hit.fraction = hit.safe_fraction = 0;
    return hit;
}

/// So far before the touch that the offset is left.
/// @param speed  at which they come together there, metres in all of the motion
inline double fraction_before(double touch, double offset, double speed) {
    const double back = speed > 0 ? offset / speed : 1;
    return back < touch ? touch - back : 0;
}

/// The first touch of a sphere whose centre goes along an arc, between two times: by chords, the sphere thicker by as
/// much as these are off, in halves until that is at most kMaxBulge.
///
/// A chord that leads away from a face meets it not, though the arc beside it may first come nearer, by a bulge at
/// most. On a piece that comes nearer first, so did the end of the piece before, whose thick sphere was then clear of
/// the face. What the motion begins with is looked at alone, on a bit of the arc that is straight but for rounding.
/// Left out is an arc that turns towards a face at the end of a piece and away again in the next, see docs/bodies.md.
/// @param from  below `to`; 0 where the motion begins
/// @param may_meet  (from, to, sphere, path): whether the thick sphere may meet anything between these times
/// @param cast_chord  (from, to, sphere, path): its hit, in fractions of the chord
template <class MayMeet, class CastChord>
auto first_on_arc(const Arc& arc, double radius, double from, double to, const MayMeet& may_meet,
                  const CastChord& cast_chord) -> decltype(cast_chord(from, to, Sphere{}, Vec3{})) {
    const double bulge = arc.bulge(from, to);
    const Sphere thick{arc.at(from), radius + bulge};
    const auto cast_to = [&](double end) {
        auto hit = cast_chord(from, end, thick, arc.at(end) - thick.centre);
        if (!hit.touched()) return hit;
        hit.fraction = from + hit.fraction * (end - from);
        hit.status = hit.fraction > 0 ? Status::kHit : Status::kInitialOverlap;
        return hit;
    };
    if (bulge > kMaxBulge) {
        if (!may_meet(from, to, thick, arc.at(to) - thick.centre)) return {};
        const double middle = (from + to) * 0.5;
        auto first = first_on_arc(arc, radius, from, middle, may_meet, cast_chord);
        if (first.status != Status::kMiss) return first;
        return first_on_arc(arc, radius, middle, to, may_meet, cast_chord);
    }
    const double straight_to = arc.time_of_bulge(kDistanceRounding);
    if (from == 0 && straight_to < to) {
        auto first = cast_to(straight_to);
        if (first.status != Status::kMiss) return first;
    }
    return cast_to(to);
}

/// The first touch of any sphere of a set, earlier than what is given; of equal ones, of the first sphere.
/// @param first  `sphere` is set, and what a hit of one sphere has
/// @param cast_one  (arc of the centre, radius, fraction of the touch before): the hit of one sphere, its safe fraction
/// too, or one that is kInvalid, which then comes back
template <class Found, class CastOne>
void first_of_set(std::span<const Sphere> spheres, const RigidMotion& motion, Found& first, const CastOne& cast_one) {
    const TurnMatrix rotation = matrix_of(normalised(motion.rotation));
    const TurnRate rate(motion.turn);
    for (std::uint32_t k = 0; k < spheres.size(); ++k) {
        const Arc arc(motion.position, motion.path, rate, rotation * spheres[k].centre);
        const auto hit = cast_one(arc, spheres[k].radius, first.fraction);
        if (hit.status == Status::kInvalid) {
            first = invalid_hit<Found>();
            return;
        }
        if (!hit.touched() || (first.touched() && !(hit.fraction < first.fraction))) continue;
        static_cast<std::remove_cv_t<decltype(hit)>&>(first) = hit;
        first.sphere = k;
        if (first.fraction == 0) return;
    }
}

}  // namespace firma
