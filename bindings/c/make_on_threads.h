// SPDX-License-Identifier: MIT
// A world of a level, made on the threads that the caller lends.
#pragma once

#include "base/long_work.h"
#include "bindings/c/convert.h"
#include "firma/brush_world.h"
#include "firma/world.h"

namespace firma::c {

/// make_world(), with the hook of firma_set_tasks().
template <class AnyLevel>
Result<World> make_on_threads(const AnyLevel& level, const WorldOptions& options) {
    if constexpr (!kHasLongWork) return make_world(level, options);
    const Tasks tasks = batch_tasks();
    WorldOptions on_threads = options;
    if (tasks.run) on_threads.work.tasks = &tasks;
    return make_world(level, on_threads);
}

}  // namespace firma::c
