// SPDX-License-Identifier: MIT
// Edits for users: in one go, in slices, or several that become one version.
#include "firma/carve.h"

#include <chrono>
#include <cmath>

#include "base/assert.h"
#include "carve/subtract.h"

namespace firma {

struct CarveJob::State {
    Subtraction work;
    bool finished = false;
};

CarveJob::CarveJob(World world, Cutter cutter, const Pose& pose, const CarveOptions& options, CarveKind kind)
    : state_(new State{Subtraction(world, cutter, pose, options, kind)}) {}
CarveJob::~CarveJob() = default;
CarveJob::CarveJob(CarveJob&&) noexcept = default;
CarveJob& CarveJob::operator=(CarveJob&&) noexcept = default;

bool CarveJob::run(double microseconds) {
    if (microseconds == INFINITY) {
        while (state_->work.step()) {
        }
        return state_->finished = true;
    }
    const auto start = std::chrono::steady_clock::now();
    while (!state_->finished) {
        state_->finished = !state_->work.step();
        const std::chrono::duration<double, std::micro> spent = std::chrono::steady_clock::now() - start;
        if (!(spent.count() < microseconds)) break;
    }
    return state_->finished;
}

bool CarveJob::finished() const {
    return state_->finished;
}

CarveResult CarveJob::result() const {
    FIRMA_ASSERT(state_->finished, "an edit has no result yet: call run() until it returns true");
    if (state_->finished) return state_->work.take_result();
    CarveResult none;
    none.error = {ErrorCode::kInvalid, "", "the edit is not finished"};
    return none;
}

CarveResult carve(const World& world, const Cutter& cutter, const Pose& pose, const CarveOptions& options) {
    CarveJob job(world, cutter, pose, options, CarveKind::kCarve);
    job.run(INFINITY);
    return job.result();
}

CarveResult fill(const World& world, const Cutter& cutter, const Pose& pose, const CarveOptions& options) {
    CarveJob job(world, cutter, pose, options, CarveKind::kFill);
    job.run(INFINITY);
    return job.result();
}

}  // namespace firma
