// SPDX-License-Identifier: MIT
// Measurements in a process of their own, as what ran before in one leaves its memory scattered.
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace firma::bench {

/// What `measure` returns, of a child process (POSIX). Ends the program where that fails.
std::vector<std::string> in_own_process(const std::function<std::vector<std::string>()>& measure);

}  // namespace firma::bench
