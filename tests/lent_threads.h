// SPDX-License-Identifier: MIT
// Threads to lend to what takes Tasks.
#pragma once

#include <atomic>
#include <cstddef>
#include <thread>
#include <vector>

#include "firma/tasks.h"

namespace firma::test {

/// So many, begun anew for each call; each takes the next piece of work.
class LentThreads {
public:
    explicit LentThreads(std::size_t count) : tasks{run, this}, count_(count) {}
    LentThreads(const LentThreads&) = delete;
    LentThreads& operator=(const LentThreads&) = delete;

    const Tasks tasks;

private:
    static void run(std::size_t pieces, void (*work)(void* context, std::size_t k), void* context, void* self) {
        std::atomic<std::size_t> next = 0;
        std::vector<std::thread> threads;
        for (std::size_t t = 0; t < static_cast<LentThreads*>(self)->count_; ++t)
            threads.emplace_back([&] {
                for (std::size_t k = next++; k < pieces; k = next++) work(context, k);
            });
        for (std::thread& thread : threads) thread.join();
    }

    std::size_t count_;
};

}  // namespace firma::test
