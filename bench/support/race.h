// SPDX-License-Identifier: MIT
// Times several ways of doing one thing, in turn, round after round: what disturbs the machine disturbs all of them.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

namespace firma::bench {

struct Contender {
    std::string name;
    std::function<void()> run;
};

struct Lap {
    double seconds = 0;  ///< processor time of one run, median over the rounds
    double ratio = 1;    ///< to the first contender in the same round, median over the rounds
};

/// Runs every contender once to warm up, then `rounds` times, each round beginning with another one.
std::vector<Lap> race(std::span<const Contender> contenders, int rounds);

/// Processor time of this thread, seconds.
double thread_seconds();

double median(std::vector<double> values);

/// Keeps the optimiser from dropping what was computed.
template <class Value>
inline void keep(const Value& value) {
    asm volatile("" : : "r,m"(value) : "memory");
}

}  // namespace firma::bench
