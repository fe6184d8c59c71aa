// SPDX-License-Identifier: MIT
// The way of a point that moves straight while it turns.
#pragma once

#include <cmath>

#include "firma/motion.h"

namespace firma {

/// How a motion turns: an axis and an angle.
struct TurnRate {
    Vec3 axis{};       ///< unit; zero when nothing turns
    double angle = 0;  ///< radians, of the whole motion

    explicit TurnRate(const Vec3& turn) : angle(length(turn)) {
        if (angle > 0) axis = turn * (1 / angle);
    }
};

/// p(t) = origin + t path + R(t turn) offset
class Arc {
public:
    /// @param offset  from the origin at the start, in the world's axes
    Arc(const Vec3& origin, const Vec3& path, const TurnRate& rate, const Vec3& offset)
        : origin_(origin), path_(path), offset_(offset), rate_(rate), across_(cross(rate.axis, offset)) {
        away_ = cross(rate.axis, across_);
        radius_ = length(across_);
    }

    Vec3 at(double t) const {
        const Vec3 straight = origin_ + path_ * t + offset_;
        if (radius_ == 0 || t == 0) return straight;
        const SineCosine turned = sine_cosine(rate_.angle * t);
        return straight + across_ * turned.sine + away_ * (1 - turned.cosine);
    }
    Vec3 velocity_at(double t) const {
        if (radius_ == 0) return path_;
        const SineCosine turned = sine_cosine(rate_.angle * t);
        return path_ + (across_ * turned.cosine + away_ * turned.sine) * rate_.angle;
    }
    /// How far p is from the chord between two times, at most, each at its pace: |p''| is constant, and between its
    /// ends a chord is off by no more than |p''| (t1 - t0)^2 / 8.
    double bulge(double from, double to) const {
        const double angle = rate_.angle * (to - from);
        return radius_ * angle * angle * (1.0 / 8);
    }
    /// From 0 to it bulge() is that; infinite where nothing turns.
    double time_of_bulge(double bulge) const { return std::sqrt(8 * bulge / radius_) / rate_.angle; }

private:
    Vec3 origin_, path_, offset_;
    TurnRate rate_;
    Vec3 across_, away_;
    double radius_ = 0;  ///< of the circle
};

/// Whether a motion can be worked with.
bool is_usable(const RigidMotion& motion);

}  // namespace firma
