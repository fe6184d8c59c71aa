// SPDX-License-Identifier: MIT
// Spreads the work of a batch over the threads that the caller's hook has.
#include "bindings/c/batch.h"

#include <new>

#include "base/lock.h"

namespace firma::c {
namespace {

struct Hook {
    Lock lock;
    firma_tasks tasks{};
};

Hook& hook() {
    alignas(Hook) static std::byte place[sizeof(Hook)];  // never destroyed, never without memory
    static auto& only = *new (place) Hook;
    return only;
}

}  // namespace

void set_batch_tasks(const firma_tasks& tasks) {
    const std::lock_guard<Lock> guard(hook().lock);
    hook().tasks = tasks;
}

void run_batch(std::size_t count, void (*work)(void* context, std::size_t k), void* context) {
    firma_tasks tasks;
    {
        const std::lock_guard<Lock> guard(hook().lock);
        tasks = hook().tasks;
    }
    if (tasks.run && count > 1) {
        tasks.run(count, work, context, tasks.user);
        return;
    }
    for (std::size_t k = 0; k < count; ++k) work(context, k);
}

}  // namespace firma::c
