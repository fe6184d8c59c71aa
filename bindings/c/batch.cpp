// SPDX-License-Identifier: MIT
// Spreads the work of a batch over the threads that the caller's hook has, and watches that the hook does it.
#include "bindings/c/batch.h"

#include <atomic>
#include <memory>
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

enum class Progress : std::uint8_t { kWaiting, kBegun, kDone };

/// The work as the hook is given it: a number too large or called before does nothing.
struct Watched {
    std::size_t count;
    void (*work)(void* context, std::size_t k);
    void* context;
    std::unique_ptr<std::atomic<Progress>[]> progress;
};

void work_watched(void* context, std::size_t k) {
    Watched& watched = *static_cast<Watched*>(context);
    if (k >= watched.count) return;
    Progress expected = Progress::kWaiting;
    if (!watched.progress[k].compare_exchange_strong(expected, Progress::kBegun, std::memory_order_acquire)) return;
    watched.work(watched.context, k);
    watched.progress[k].store(Progress::kDone, std::memory_order_release);
}

/// Waits for what has begun and is not done, which would otherwise write into memory that is gone.
/// @return whether all had been done when the hook returned
bool all_done(const Watched& watched) {
    bool done = true;
    for (std::size_t k = 0; k < watched.count; ++k) {
        Progress progress = Progress::kWaiting;
        // From now on too late to begin.
        const bool missing = watched.progress[k].compare_exchange_strong(progress, Progress::kDone);
        done = done && !missing && progress == Progress::kDone;
        while (progress == Progress::kBegun) progress = watched.progress[k].load(std::memory_order_acquire);
    }
    return done;
}

}  // namespace

void set_batch_tasks(const firma_tasks& tasks) {
    const std::lock_guard<Lock> guard(hook().lock);
    hook().tasks = tasks;
}

bool run_batch(std::size_t count, void (*work)(void* context, std::size_t k), void* context) {
    firma_tasks tasks;
    {
        const std::lock_guard<Lock> guard(hook().lock);
        tasks = hook().tasks;
    }
    if (tasks.run && count > 1) {
        Watched watched{count, work, context, std::make_unique<std::atomic<Progress>[]>(count)};
        tasks.run(count, work_watched, &watched, tasks.user);
        return all_done(watched);
    }
    for (std::size_t k = 0; k < count; ++k) work(context, k);
    return true;
}

}  // namespace firma::c
