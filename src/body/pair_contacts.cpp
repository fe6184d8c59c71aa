// SPDX-License-Identifier: MIT
// Bodies near each other.
#include "body/pair_contacts.h"

#include <algorithm>
#include <tuple>

#include "base/sort.h"
#include "body/longest_axis.h"

namespace firma {

std::vector<std::pair<std::uint32_t, std::uint32_t>> near_pairs(std::vector<BodyBall> balls) {
    Box box;
    for (const BodyBall& ball : balls) box.add(ball.centre);
    const int axis = box.empty() ? 0 : longest_axis(box.high - box.low);
    const auto low = [&](const BodyBall& ball) { return ball.centre[axis] - ball.reach; };
    sort_range(balls, [&](const BodyBall& a, const BodyBall& b) {
        return low(a) != low(b) ? low(a) < low(b) : a.slot < b.slot;
    });
    std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs;
    for (std::size_t i = 0; i < balls.size(); ++i) {
        const BodyBall& a = balls[i];
        const double end = a.centre[axis] + a.reach;
        for (std::size_t j = i + 1; j < balls.size() && low(balls[j]) <= end; ++j) {
            const BodyBall& b = balls[j];
            if (!(a.awake || b.awake) || !(a.mask & b.mask)) continue;
            const Vec3 apart = a.centre - b.centre;
            const double reach = a.reach + b.reach;
            if (dot(apart, apart) <= reach * reach) pairs.push_back(std::minmax(a.slot, b.slot));
        }
    }
    sort_range(pairs);
    return pairs;
}

namespace {

/// The deepest remain, in no particular order.
void keep_deepest(std::vector<NearContact>& found, std::size_t first, std::size_t count) {
    const auto from = found.begin() + std::ptrdiff_t(first), until = from + std::ptrdiff_t(count);
    std::nth_element(from, until, found.end(), [](const NearContact& a, const NearContact& b) {
        return std::tuple(a.gap, a.at.sphere, a.at.other_sphere) < std::tuple(b.gap, b.at.sphere, b.at.other_sphere);
    });
    found.erase(until, found.end());
}

}  // namespace

void find_pair_contacts(const PlacedBody& a, const PlacedBody& b, double margin, std::vector<NearContact>& found) {
    const SphereSet &of_a = a.shape->spheres, &of_b = b.shape->spheres;
    const std::size_t before = found.size();
    for (std::uint32_t i = 0; i < of_a.size(); ++i) {
        const Vec3 one = a.centre_of(i);
        const double reach_to_b = of_a[i].radius + b.shape->reach + margin;
        const Vec3 to_b = one - b.position;
        if (dot(to_b, to_b) > reach_to_b * reach_to_b) continue;
        const Vec3 in_b = b.matrix.back(to_b);
        for (std::uint32_t j = 0; j < of_b.size(); ++j) {
            const Vec3 apart_in_b = in_b - of_b[j].centre;
            const double radii = of_a[i].radius + of_b[j].radius, reach = radii + margin;
            const double square = dot(apart_in_b, apart_in_b);
            if (square > reach * reach) continue;
            const double distance = std::sqrt(square);
            NearContact contact;
            contact.at.body = a.slot;
            contact.at.other = b.slot;
            contact.at.sphere = i;
            contact.at.other_sphere = j;
            contact.a = a.mover;
            contact.b = b.mover;
            contact.at.normal = distance > 0 ? b.matrix * (apart_in_b * (1 / distance)) : Vec3{0, 0, 1};
            contact.centre_a = one;
            contact.centre_b = b.centre_of(j);
            contact.radius_a = of_a[i].radius;
            contact.radius_b = of_b[j].radius;
            contact.gap = distance - radii;
            contact.at.point = contact.centre_b + contact.at.normal * (of_b[j].radius + contact.gap * 0.5);
            found.push_back(contact);
        }
        if (found.size() - before > 2 * kMaxPairContacts) keep_deepest(found, before, kMaxPairContacts);
    }
    if (found.size() - before > kMaxPairContacts) keep_deepest(found, before, kMaxPairContacts);
}

}  // namespace firma
