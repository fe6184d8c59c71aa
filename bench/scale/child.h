// SPDX-License-Identifier: MIT
// Work in a process of its own, so that what it takes is only its own; and what a process holds.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace firma::bench {

using Cells = std::vector<std::string>;

/// Runs `work` in a child of this process and gives back the rows that it adds.
/// @return no rows when the child ended otherwise than by itself, which is said on stderr with `what`
std::vector<Cells> rows_of_child(const std::string& what, const std::function<void(std::vector<Cells>&)>& work);

/// Processor time of all threads of this process, seconds.
double process_seconds();

/// Bytes of memory of its own that this process holds, without files, once the allocator gave back what it can.
double resident_bytes();
/// The most that it held since forget_peak().
double peak_bytes();
void forget_peak();

}  // namespace firma::bench
