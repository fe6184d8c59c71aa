// SPDX-License-Identifier: MIT
// The caller's hook that batches are spread over.
#include "bindings/c/batch_tasks.h"

#include <cstddef>
#include <mutex>
#include <new>

#include "base/lock.h"

namespace firma::c {
namespace {

struct Hook {
    Lock lock;
    Tasks tasks{};
};

Hook& hook() {
    alignas(Hook) static std::byte place[sizeof(Hook)];  // never destroyed, never without memory
    static auto& only = *new (place) Hook;
    return only;
}

}  // namespace

void set_batch_tasks(const firma_tasks& tasks) {
    const std::lock_guard<Lock> guard(hook().lock);
    hook().tasks = {tasks.run, tasks.user};
}

Tasks batch_tasks() {
    const std::lock_guard<Lock> guard(hook().lock);
    return hook().tasks;
}

}  // namespace firma::c
