// SPDX-License-Identifier: MIT
// A progress bar on stderr: only on a terminal, only for work that takes a while.
#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>
#include <mutex>
#include <string>

namespace firma::cli {

/// Counts towards a total; the bar goes away with the object.
class Progress {
public:
    Progress(std::string what, std::uint64_t total);
    ~Progress();
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    /// From any thread.
    void add(std::uint64_t count);

private:
    using Clock = std::chrono::steady_clock;
    void draw(std::uint64_t done);

    const std::string what_;
    const std::uint64_t total_;
    const bool shown_;
    std::atomic<std::uint64_t> done_{0};
    std::mutex mutex_;  ///< of the terminal and what follows
    Clock::time_point next_;
    bool drawn_ = false;
};

}  // namespace firma::cli
