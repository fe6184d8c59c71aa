// SPDX-License-Identifier: MIT
// Few balls near many points, by greed.
#include "body/choose_balls.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace firma {
namespace {

using Bits = std::vector<std::uint64_t>;

std::size_t common(std::span<const std::uint64_t> a, const Bits& b) {
    std::size_t count = 0;
    for (std::size_t k = 0; k < b.size(); ++k) count += std::size_t(std::popcount(a[k] & b[k]));
    return count;
}

}  // namespace

void BallChoice::add_point(const Vec3& point) {
    points_.push_back(point);
    for (std::size_t k = 0; k < balls_.size(); ++k)
        gaps_[k].push_back(float(length(point - balls_[k].centre) - balls_[k].radius));
}

void BallChoice::add_ball(const Sphere& ball) {
    balls_.push_back(ball);
    std::vector<float>& gaps = gaps_.emplace_back(points_.size());
    for (std::size_t k = 0; k < points_.size(); ++k) gaps[k] = float(length(points_[k] - ball.centre) - ball.radius);
}

std::vector<float> BallChoice::least_gaps() const {
    std::vector<float> least(points_.size(), INFINITY);
    for (const std::vector<float>& gaps : gaps_)
        for (std::size_t k = 0; k < least.size(); ++k) least[k] = std::min(least[k], gaps[k]);
    return least;
}

std::vector<std::uint32_t> BallChoice::cover(double error, const std::vector<float>& least, std::size_t most) const {
    const std::size_t words = (points_.size() + 63) / 64;
    Bits near(balls_.size() * words), left(words);
    std::vector<float> enough(points_.size());
    for (std::size_t k = 0; k < points_.size(); ++k) enough[k] = std::max(float(error), least[k]);
    for (std::size_t ball = 0; ball < balls_.size(); ++ball)
        for (std::size_t k = 0; k < points_.size(); ++k)
            near[ball * words + k / 64] |= std::uint64_t(gaps_[ball][k] <= enough[k]) << k % 64;
    for (std::size_t k = 0; k < points_.size(); ++k) left[k / 64] |= std::uint64_t(1) << k % 64;
    const auto of = [&](std::size_t ball) { return std::span(near).subspan(ball * words, words); };

    // What a ball would add only falls as others are taken, so an old count that is beaten stays beaten.
    std::vector<std::size_t> counts(balls_.size(), SIZE_MAX);
    std::vector<std::uint32_t> chosen;
    while (chosen.size() < most) {
        std::size_t best = 0, best_count = 0;
        for (std::size_t ball = 0; ball < balls_.size(); ++ball) {
            if (counts[ball] <= best_count) continue;
            counts[ball] = common(of(ball), left);
            if (counts[ball] > best_count) best = ball, best_count = counts[ball];
        }
        if (best_count == 0) break;
        chosen.push_back(std::uint32_t(best));
        for (std::size_t k = 0; k < words; ++k) left[k] &= ~of(best)[k];
    }
    return chosen;
}

BallChoice::Chosen BallChoice::choose(std::size_t most, double error) const {
    const std::vector<float> least = least_gaps();
    Chosen best{error, cover(error, least, most + 1)};
    double low = error, high = error;
    for (const std::vector<float>& gaps : gaps_)
        for (const float gap : gaps) high = std::max(high, double(gap));
    while (best.balls.size() > most || (high > low * 1.02 && best.error > error)) {
        const double middle = high > low * 1.02 ? std::sqrt(low * high) : high;
        std::vector<std::uint32_t> balls = cover(middle, least, most + 1);
        if (balls.size() > most && middle < high) {
            low = middle;
            continue;
        }
        high = middle;
        best = {middle, std::move(balls)};
    }
    for (const float gap : least) best.error = std::max(best.error, double(gap));
    return best;
}

}  // namespace firma
