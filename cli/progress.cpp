// SPDX-License-Identifier: MIT
// Draws at most ten times a second, and nothing at all in the first half second.
#include "cli/progress.h"

#include <fmt/core.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <utility>

namespace firma::cli {

namespace {

constexpr auto kPatience = std::chrono::milliseconds(500);
constexpr auto kInterval = std::chrono::milliseconds(100);
constexpr std::uint64_t kWidth = 30;

bool on_terminal() {
    const char* terminal = std::getenv("TERM");
    return isatty(STDERR_FILENO) && (terminal == nullptr || std::strcmp(terminal, "dumb") != 0);
}

}  // namespace

Progress::Progress(std::string what, std::uint64_t total)
    : what_(std::move(what)), total_(total), shown_(on_terminal() && total > 0), next_(Clock::now() + kPatience) {}

Progress::~Progress() {
    if (drawn_) std::fputs("\r\x1b[K", stderr);
}

void Progress::add(std::uint64_t count) {
    const std::uint64_t done = done_.fetch_add(count) + count;
    if (!shown_) return;
    const std::unique_lock lock(mutex_, std::try_to_lock);  // whoever holds it is drawing already
    if (lock && Clock::now() >= next_) draw(done);
}

void Progress::draw(std::uint64_t done) {
    const double share = std::min(1.0, double(done) / double(total_));
    const auto full = std::uint64_t(share * double(kWidth));
    const std::string bar = std::string(full, '#') + std::string(kWidth - full, '.');
    std::fputs(fmt::format("\r{} [{}] {:3.0f}%\x1b[K", what_, bar, 100 * share).c_str(), stderr);
    std::fflush(stderr);
    drawn_ = true;
    next_ = Clock::now() + kInterval;
}

}  // namespace firma::cli
