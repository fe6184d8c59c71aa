// SPDX-License-Identifier: MIT
// A long piece of work under way: its parts on the threads that a caller has, told of as they are done.
#pragma once

#include <atomic>
#include <cstddef>
#include <mutex>

#include "base/lock.h"
#include "base/run_tasks.h"

namespace firma {

/// Whether work is lent to threads and told of: the module for browsers and node has no threads, and has to be small.
#if defined(__wasm__)
inline constexpr bool kHasLongWork = false;
#else
inline constexpr bool kHasLongWork = true;
#endif

class LongWork {
public:
    /// @param count  what all of it comes to, as progress() tells it
    LongWork(const WorkOptions& options, std::size_t count) : options_(options), count_(count) {}
    LongWork(const LongWork&) = delete;
    LongWork& operator=(const LongWork&) = delete;

    /// Whether there is anything to gain or to tell.
    static bool asked(const WorkOptions& options) { return kHasLongWork && (options.tasks || options.progress); }

    /// Calls part(k) for each k below count, once, on any threads; what comes after a stop is left out.
    /// @return whether all was done
    template <class Part>
    bool each(std::size_t count, const Part& part) {
        struct Context {
            LongWork& work;
            const Part& part;
        } context{*this, part};
        const auto call = [](void* given, std::size_t k) {
            Context& it = *static_cast<Context*>(given);
            if (!it.work.stopped()) it.part(k);
        };
        const Tasks none;
        if (!run_tasks(options_.tasks ? *options_.tasks : none, count, call, &context)) failed_ = stopped_ = true;
        return !stopped();
    }

    /// So much more is done.
    void add(std::size_t done);

    /// Told to stop, or left without threads.
    bool stopped() const { return stopped_; }
    /// Tasks::run returned before all its work had.
    bool failed() const { return failed_; }

private:
    const WorkOptions options_;
    const std::size_t count_;
    Lock telling_;
    std::size_t done_ = 0;  ///< by the one who tells
    std::atomic<bool> stopped_ = false, failed_ = false;
};

}  // namespace firma
