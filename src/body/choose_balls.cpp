// SPDX-License-Identifier: MIT
// Few balls near many points, by greed.
#include "body/choose_balls.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace firma {
namespace {

using Row = std::array<std::int16_t, PointCloud::kRow>;
constexpr std::size_t kRow = PointCloud::kRow;
static_assert(kRow == 64, "a row is a word of bits");
using Bits = std::vector<std::uint64_t>;

/// Bit k: whether value k is at most bound k.
std::uint64_t bits_within(const Row& values, const Row& bounds) {
    std::array<std::uint8_t, kRow> flags;
    for (std::size_t k = 0; k < kRow; ++k) flags[k] = values[k] <= bounds[k];
    std::uint64_t bits = 0;
    for (std::size_t byte = 0; byte < 8; ++byte) {
        // Eight bytes of 0 or 1, each brought to a bit of the highest one.
        std::uint64_t eight = 0;
        for (std::size_t k = 0; k < 8; ++k) eight |= std::uint64_t(flags[byte * 8 + k]) << 8 * k;
        bits |= (eight * 0x0102040810204080u >> 56) << 8 * byte;
    }
    return bits;
}

std::int16_t most_of(const Row& values) {
    std::int16_t most = INT16_MIN;
    for (std::size_t k = 0; k < kRow; ++k) most = std::max(most, values[k]);
    return most;
}

/// How many are 1: std::popcount() is a call of a function where the machine is not known to count bits itself.
std::uint64_t count_bits(std::uint64_t bits) {
    bits -= bits >> 1 & 0x5555555555555555u;
    bits = (bits & 0x3333333333333333u) + (bits >> 2 & 0x3333333333333333u);
    bits = (bits + (bits >> 4)) & 0x0F0F0F0F0F0F0F0Fu;
    return bits * 0x0101010101010101u >> 56;
}

/// Words in which there are bits.
struct Stretch {
    std::size_t first = 0, end = 0;
    void add(std::size_t word) {
        if (first == end) first = word;
        end = word + 1;
    }
};

std::size_t common(const std::uint64_t* a, const Bits& b, const Stretch& stretch) {
    std::size_t count = 0;
    for (std::size_t k = stretch.first; k < stretch.end; ++k) count += count_bits(a[k] & b[k]);
    return count;
}

}  // namespace

/// Rounded up, so that what is near enough in units is near enough.
std::int16_t BallChoice::in_units(float gap) const {
    constexpr float kBias = 32000;  // so that all are positive, and cutting off rounds down
    const float units = gap * float(1 / unit_) + kBias + 1;
    const float kept = units < 0 ? 0 : units > 2 * kBias ? 2 * kBias : units;
    return std::int16_t(std::int32_t(kept) - std::int32_t(kBias));
}

const BallChoice::Row& BallChoice::gaps(std::size_t ball, std::size_t row) {
    Gaps& gaps = gaps_[ball][row];
    if (gaps.at != Gaps::kNotMade) return made_[gaps.at];
    gaps.at = std::uint32_t(made_.size());
    Row& made = made_.emplace_back();
    PointCloud::Row squares;
    points_.squares(row, balls_[ball].centre, squares);
    const auto radius = float(balls_[ball].radius);
    for (std::size_t k = 0; k < kRow; ++k) made[k] = in_units(std::sqrt(squares[k]) - radius);
    return made;
}

void BallChoice::add_point(const Vec3& point) {
    const std::size_t at = points_.size() % kRow;
    points_.add(point);
    if (at == 0) {
        least_.emplace_back().fill(INT16_MIN);
        for (std::vector<Gaps>& own : gaps_) own.emplace_back();
    }
    std::int16_t& least = least_.back()[at];
    least = INT16_MAX;
    for (std::size_t ball = 0; ball < balls_.size(); ++ball) {
        const std::int16_t gap = in_units(float(length(point - balls_[ball].centre) - balls_[ball].radius));
        Gaps& gaps = gaps_[ball].back();
        gaps.bound = std::min(gaps.bound, gap);
        if (gaps.at != Gaps::kNotMade) made_[gaps.at][at] = gap;
        least = std::min(least, gap);
    }
}

void BallChoice::add_ball(const Sphere& ball) {
    const std::size_t number = balls_.size();
    balls_.push_back(ball);
    gaps_.emplace_back(points_.row_count());
    for (std::size_t row = 0; row < points_.row_count(); ++row) {
        Row& least = least_[row];
        std::int16_t& bound = gaps_[number][row].bound;
        bound = in_units(std::sqrt(points_.least_square(row, ball.centre)) - float(ball.radius));
        if (bound >= most_of(least)) continue;
        const Row& own = gaps(number, row);
        for (std::size_t k = 0; k < kRow; ++k) least[k] = std::min(least[k], own[k]);
    }
}

std::vector<std::uint32_t> BallChoice::cover(double error, std::size_t most) {
    const std::size_t words = points_.row_count();
    Bits near(balls_.size() * words), left(words, ~std::uint64_t(0));
    std::vector<Row> enough = least_;
    const auto asked = std::int16_t(std::min(error / unit_, kMostUnits));
    for (Row& row : enough)
        for (std::int16_t& gap : row) gap = std::max(gap, asked);
    std::vector<Stretch> stretches(balls_.size());
    for (std::size_t word = 0; word < words; ++word) {
        const std::int16_t most_enough = most_of(enough[word]);
        for (std::size_t ball = 0; ball < balls_.size(); ++ball) {
            if (gaps_[ball][word].bound > most_enough) continue;
            const std::uint64_t bits = near[ball * words + word] = bits_within(gaps(ball, word), enough[word]);
            if (bits != 0) stretches[ball].add(word);
        }
    }
    if (const std::size_t rest = points_.size() % kRow; rest != 0) left.back() = (std::uint64_t(1) << rest) - 1;
    const auto of = [&](std::size_t ball) { return near.data() + ball * words; };

    // What a ball would add only falls as others are taken, so an old count that is beaten stays beaten.
    std::vector<std::size_t> counts(balls_.size(), SIZE_MAX);
    std::vector<std::uint32_t> chosen;
    while (chosen.size() < most) {
        std::size_t best = 0, best_count = 0;
        for (std::size_t ball = 0; ball < balls_.size(); ++ball) {
            if (counts[ball] <= best_count) continue;
            counts[ball] = common(of(ball), left, stretches[ball]);
            if (counts[ball] > best_count) best = ball, best_count = counts[ball];
        }
        if (best_count == 0) break;
        chosen.push_back(std::uint32_t(best));
        for (std::size_t k = 0; k < words; ++k) left[k] &= ~of(best)[k];
    }
    return chosen;
}

BallChoice::Chosen BallChoice::choose(std::size_t most, double error, double guess) {
    constexpr double kWithin = 1.03, kStep = 1.2;
    // Too many are needed at `low`, few enough at `best.error`.
    Chosen best{0, {}};
    double low = 0;
    const auto attempt = [&](double at) {
        std::vector<std::uint32_t> balls = cover(at, most + 1);
        if (balls.size() > most) return low = at, false;
        best = {at, std::move(balls)};
        return true;
    };
    double step = kStep;
    if (attempt(std::max(guess, error))) {
        for (; low == 0; step *= step)
            if (const double at = std::max(best.error / step, error); at == best.error || (attempt(at) && at == error))
                low = error;
    } else {
        for (; best.balls.empty(); step *= step) attempt(low * step);
    }
    while (best.error > low * kWithin) attempt(std::sqrt(low * best.error));
    for (std::size_t k = 0; k < points_.size(); ++k)
        best.error = std::max(best.error, least_[k / kRow][k % kRow] * unit_);
    return best;
}

}  // namespace firma
