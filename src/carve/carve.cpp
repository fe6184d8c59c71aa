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
    bool broken = false;  ///< true while a step is done, and for good when an exception leaves it

    void step() {
        broken = true;
        finished = !work.step();
        broken = false;
    }
};

CarveJob::CarveJob(World world, Cutter cutter, const Pose& pose, const CarveOptions& options, CarveKind kind)
    : state_(new State{Subtraction(world, cutter, pose, options, kind)}) {}
CarveJob::~CarveJob() = default;
CarveJob::CarveJob(CarveJob&&) noexcept = default;
CarveJob& CarveJob::operator=(CarveJob&&) noexcept = default;

bool CarveJob::run(double microseconds) {
    const auto start = std::chrono::steady_clock::now();
    while (!finished()) {
        state_->step();
        if (microseconds == INFINITY) continue;
        const std::chrono::duration<double, std::micro> spent = std::chrono::steady_clock::now() - start;
        if (!(spent.count() < microseconds)) break;
    }
    return finished();
}

bool CarveJob::finished() const {
    return state_->finished || state_->broken;
}

bool CarveJob::broken() const {
    return state_->broken;
}

CarveResult CarveJob::result() const {
    FIRMA_ASSERT(finished(), "an edit has no result yet: call run() until it returns true");
    CarveResult result = state_->work.take_result();
    if (state_->finished) return result;
    result.status = CarveStatus::kRefused;
    result.error = state_->broken ? Error{ErrorCode::kNoMemory, "", "memory ran out in the middle of the edit"}
                                  : Error{ErrorCode::kInvalid, "", "the edit is not finished"};
    return result;
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
