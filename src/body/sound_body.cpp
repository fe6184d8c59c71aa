// SPDX-License-Identifier: MIT
// Bodies with numbers that are none.
#include "body/sound_body.h"

#include "geometry/rounding.h"

namespace firma {
namespace {

bool is_in_range(const Vec3& v) {
    return is_finite(v) && max_abs(v) <= kLargestNumber;
}

bool is_in_range(const Quaternion& turn) {
    for (const double part : turn)
        if (!is_finite(part) || std::fabs(part) > kLargestNumber) return false;
    return true;
}

bool is_between(double number, double low, double high) {
    return is_finite(number) && number >= low && number <= high;
}

}  // namespace

bool is_sound(const Body& body) {
    return is_in_range(body.position) && is_in_range(body.rotation) && is_in_range(body.velocity) &&
           is_in_range(body.spin) && is_in_range(body.force) && is_in_range(body.torque) &&
           is_between(body.friction, 0, kLargestNumber) && is_between(body.restitution, 0, 1) &&
           is_between(body.rolling, 0, kLargestNumber);
}

bool is_sound(const Mover& mover) {
    return is_in_range(mover.position) && is_in_range(mover.rotation) && is_in_range(mover.velocity) &&
           is_in_range(mover.spin);
}

bool is_sound(const BodyContact& contact) {
    return is_finite(contact.force) && is_finite(contact.friction) && is_finite(contact.slip) &&
           is_finite(contact.rolling);
}

}  // namespace firma
