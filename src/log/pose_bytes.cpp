// SPDX-License-Identifier: MIT
// Poses on grids, and as bytes.
#include "log/pose_bytes.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "base/round_half_even.h"
#include "firma/edit_log.h"

namespace firma {
namespace {

constexpr double kTurnSteps = 32768;      ///< of a turn's parts
constexpr double kMostTurn = 32767;       ///< steps of one part
constexpr double kLeastTurn = 16384;      ///< of the longest part: of length 1 it is at least a half
constexpr double kFarthestStep = 0x1p26;  ///< positions and scales from here on stay as they are

bool same_bits(double a, double b) {
    return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}
bool same_bits(const Quaternion& a, const Quaternion& b) {
    return std::equal(a.begin(), a.end(), b.begin(), [](double p, double q) { return same_bits(p, q); });
}

/// On the grid, or nothing where it stays as it is.
std::optional<double> grid_steps(double metres) {
    const double steps = metres * kInputSteps;
    if (!(std::fabs(steps) < kFarthestStep)) return {};
    const double whole = round_half_even(steps) + 0.0;  // no -0
    if (!(std::fabs(whole) < kFarthestStep)) return {};
    return whole;
}

bool lies_on_grid(double metres) {
    const std::optional<double> steps = grid_steps(metres);
    return steps && same_bits(*steps / kInputSteps, metres);
}

/// Whether a turn is one of parts of 16 bits.
bool has_sixteen_bits(const Quaternion& turn) {
    double longest = 0;
    for (const double part : turn) {
        const double steps = part * kTurnSteps;
        if (!(std::fabs(steps) <= kMostTurn) || round_half_even(steps) != steps) return false;
        longest = std::max(longest, std::fabs(steps));
    }
    return longest >= kLeastTurn;
}

Quaternion quantised_turn(const Quaternion& turn) {
    const Quaternion none = Pose().rotation;
    if (turn == none) return none;
    Quaternion made = turn;
    if (!has_sixteen_bits(turn)) {
        double reach = 0;
        for (const double part : turn) {
            if (!is_finite(part)) return turn;
            reach = std::max(reach, std::fabs(part));
        }
        if (reach == 0) return turn;
        double square = 0;
        for (double& part : made) {
            part /= reach;
            square += part * part;
        }
        const double size = std::sqrt(square);
        for (double& part : made) part = round_half_even(part / size * kMostTurn) / kTurnSteps;
    }
    for (double& part : made) part += 0.0;
    return made;
}

}  // namespace

Pose quantised(const Pose& pose) {
    Pose made = pose;
    std::optional<double> steps[3];
    for (int axis = 0; axis < 3; ++axis) steps[axis] = grid_steps(pose.position[axis]);
    if (steps[0] && steps[1] && steps[2])
        for (int axis = 0; axis < 3; ++axis) made.position[axis] = *steps[axis] / kInputSteps;
    made.rotation = quantised_turn(pose.rotation);
    if (const std::optional<double> scale = grid_steps(pose.scale); scale && *scale > 0)
        made.scale = *scale / kInputSteps;
    return made;
}

PoseForm form_of(const Pose& pose, std::optional<std::uint64_t> seed) {
    PoseForm form;
    const Quaternion& turn = pose.rotation;
    if (same_bits(turn, Pose().rotation))
        form.turn = PoseForm::Turn::kNone;
    else if (seed && same_bits(turn, random_turn(*seed)))
        form.turn = PoseForm::Turn::kOfSeed;
    else if (has_sixteen_bits(turn) && same_bits(turn, quantised_turn(turn)))
        form.turn = PoseForm::Turn::kSixteenBits;
    else
        form.turn = PoseForm::Turn::kWhole;
    for (int axis = 0; axis < 3; ++axis) form.whole_position |= !lies_on_grid(pose.position[axis]);
    form.whole_scale = !(pose.scale > 0) || !lies_on_grid(pose.scale);
    return form;
}

void put_pose(ByteWriter& out, const Pose& pose, const PoseForm& form) {
    for (int axis = 0; axis < 3; ++axis) {
        if (form.whole_position)
            out.f64(pose.position[axis]);
        else
            put_signed(out, std::int64_t(pose.position[axis] * kInputSteps));
    }
    for (const double part : pose.rotation) {
        if (form.turn == PoseForm::Turn::kSixteenBits) out.u16(std::uint16_t(std::int16_t(part * kTurnSteps)));
        if (form.turn == PoseForm::Turn::kWhole) out.f64(part);
    }
    if (form.whole_scale)
        out.f64(pose.scale);
    else
        put_whole(out, std::uint64_t(pose.scale * kInputSteps));
}

Pose take_pose(ByteReader& in, const PoseForm& form, std::optional<std::uint64_t> seed) {
    Pose pose;
    const std::size_t where = in.place();
    for (int axis = 0; axis < 3; ++axis) {
        if (form.whole_position) {
            pose.position[axis] = in.f64();
            continue;
        }
        const std::int64_t steps = in.signed_whole();
        constexpr auto kMost = std::int64_t(kFarthestStep);
        if (steps <= -kMost || steps >= kMost) {
            in.fail_at(where, ErrorCode::kMalformed, "a position lies beyond the grid");
            return pose;
        }
        pose.position[axis] = double(steps) / kInputSteps;
    }
    switch (form.turn) {
        case PoseForm::Turn::kNone:
            break;
        case PoseForm::Turn::kOfSeed:
            if (!seed) in.fail("a turn by seed, and the cutter has none");
            if (seed) pose.rotation = random_turn(*seed);
            break;
        case PoseForm::Turn::kSixteenBits:
            for (double& part : pose.rotation) part = in.i16() / kTurnSteps;
            if (in.ok() && !has_sixteen_bits(pose.rotation)) in.fail("a turn whose parts are too small");
            break;
        case PoseForm::Turn::kWhole:
            for (double& part : pose.rotation) part = in.f64();
            break;
    }
    if (form.whole_scale) {
        pose.scale = in.f64();
    } else {
        const std::uint64_t steps = in.whole();
        if (in.ok() && (steps == 0 || steps >= std::uint64_t(kFarthestStep))) in.fail("a scale beyond the grid");
        pose.scale = double(steps) / kInputSteps;
    }
    return pose;
}

}  // namespace firma
