// SPDX-License-Identifier: MIT
// Few balls near many points, by greed.
#include "body/choose_balls.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

namespace firma {
namespace {

using Bits = std::vector<std::uint64_t>;

/// Bit k: whether value k is at most bound k.
std::uint64_t bits_within(const float* values, const float* bounds, std::size_t count) {
    std::array<std::uint8_t, 64> flags{};
    for (std::size_t k = 0; k < count; ++k) flags[k] = values[k] <= bounds[k];
    std::uint64_t bits = 0;
    for (std::size_t byte = 0; byte < 8; ++byte) {
        // Eight bytes of 0 or 1, each brought to a bit of the highest one.
        std::uint64_t eight = 0;
        for (std::size_t k = 0; k < 8; ++k) eight |= std::uint64_t(flags[byte * 8 + k]) << 8 * k;
        bits |= (eight * 0x0102040810204080u >> 56) << 8 * byte;
    }
    return bits;
}

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
        for (std::size_t word = 0; word < words; ++word) {
            const std::size_t first = word * 64, count = std::min<std::size_t>(64, points_.size() - first);
            near[ball * words + word] = bits_within(&gaps_[ball][first], &enough[first], count);
        }
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

BallChoice::Chosen BallChoice::choose(std::size_t most, double error, double guess) const {
    constexpr double kWithin = 1.03;
    const std::vector<float> least = least_gaps();
    // Too many are needed at `low`, few enough at `best.error`.
    Chosen best{0, {}};
    double low = 0;
    const auto attempt = [&](double at) {
        std::vector<std::uint32_t> balls = cover(at, least, most + 1);
        if (balls.size() > most) return low = at, false;
        best = {at, std::move(balls)};
        return true;
    };
    if (guess <= error || !attempt(guess / kWithin)) {
        if (guess <= error && attempt(error)) low = error;
        for (double step = kWithin; best.balls.empty(); step *= step) attempt(low * step);
    } else {
        for (double step = kWithin; low == 0; step *= step)
            if (const double at = std::max(best.error / step, error); attempt(at) && at == error) low = error;
    }
    while (best.error > low * kWithin) attempt(std::sqrt(low * best.error));
    for (const float gap : least) best.error = std::max(best.error, double(gap));
    return best;
}

}  // namespace firma
