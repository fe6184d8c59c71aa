// SPDX-License-Identifier: MIT
// Spreads pieces of work over the threads that a caller has, and watches that the caller does all of it.
#include "base/run_tasks.h"

#include <atomic>
#include <memory>

namespace firma {
namespace {

enum class Progress : std::uint8_t { kWaiting, kBegun, kDone, kFailed };

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
    struct Tell {  // also where the work throws, so that nobody waits for it
        std::atomic<Progress>& progress;
        Progress how = Progress::kFailed;
        ~Tell() { progress.store(how, std::memory_order_release); }
    } tell{watched.progress[k]};
    watched.work(watched.context, k);
    tell.how = Progress::kDone;
}

/// Waits for what has begun and is not done, which would otherwise write into memory that is gone.
/// @return whether all had been done when the hook returned
bool all_done(const Watched& watched) {
    bool done = true;
    for (std::size_t k = 0; k < watched.count; ++k) {
        Progress progress = Progress::kWaiting;
        // From now on too late to begin.
        const bool missing = watched.progress[k].compare_exchange_strong(progress, Progress::kDone);
        const bool was_done = !missing && progress == Progress::kDone;
        while (progress == Progress::kBegun) progress = watched.progress[k].load(std::memory_order_acquire);
        done = done && was_done;
    }
    return done;
}

}  // namespace

bool run_tasks(const Tasks& tasks, std::size_t count, void (*work)(void* context, std::size_t k), void* context) {
    if (tasks.run && count > 1) {
        Watched watched{count, work, context, std::make_unique<std::atomic<Progress>[]>(count)};
        // What run() throws must not leave while others write into `watched`.
        struct Wait {
            const Watched& watched;
            ~Wait() { all_done(watched); }
        } wait{watched};
        tasks.run(count, work_watched, &watched, tasks.user);
        return all_done(watched);
    }
    for (std::size_t k = 0; k < count; ++k) work(context, k);
    return true;
}

}  // namespace firma
