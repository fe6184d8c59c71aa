// SPDX-License-Identifier: MIT
// Many casts at once.
#include <algorithm>
#include <vector>

#include "firma/queries.h"
#include "world/run_tasks.h"

namespace firma {
namespace {

/// What one call of a batch's work does.
constexpr std::size_t kCastsATask = 256;

struct Batch {
    const World& world;
    std::span<const CastInput> inputs;
    std::span<Hit> hits;
    CastOptions options;
    std::vector<CastCounts> counts;  ///< of each task, when they are wanted
};

void cast_some(void* context, std::size_t task) {
    Batch& batch = *static_cast<Batch*>(context);
    CastOptions options = batch.options;
    if (!batch.counts.empty()) options.counts = &batch.counts[task];
    const std::size_t begin = task * kCastsATask, end = std::min(begin + kCastsATask, batch.inputs.size());
    for (std::size_t k = begin; k < end; ++k)
        batch.hits[k] = cast(batch.world, batch.inputs[k].sphere, batch.inputs[k].path, options);
}

}  // namespace

bool cast_batch(const World& world, std::span<const CastInput> inputs, std::span<Hit> hits, const CastOptions& options,
                const Tasks* tasks) {
    const std::size_t count = (inputs.size() + kCastsATask - 1) / kCastsATask;
    Batch batch{world, inputs, hits, options, {}};
    batch.options.trail = nullptr;
    if (options.counts) batch.counts.resize(count);
    if (hits.size() != inputs.size() || !run_tasks(tasks ? *tasks : Tasks{}, count, cast_some, &batch)) {
        std::fill(hits.begin(), hits.end(), invalid_hit({}));
        return false;
    }
    for (const CastCounts& seen : batch.counts) {
        options.counts->nodes += seen.nodes;
        options.counts->boxes += seen.boxes;
        options.counts->faces += seen.faces;
        options.counts->precise += seen.precise;
    }
    return true;
}

}  // namespace firma
