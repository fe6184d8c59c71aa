// SPDX-License-Identifier: MIT
// Times several ways of doing one thing, in turn, round after round.
#include "support/race.h"

#include <time.h>

#include <algorithm>

namespace firma::bench {

double thread_seconds() {
    timespec now;
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return double(now.tv_sec) + 1e-9 * double(now.tv_nsec);
}

double median(std::vector<double> values) {
    if (values.empty()) return 0;
    const auto middle = values.begin() + std::ptrdiff_t(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

std::vector<Lap> race(std::span<const Contender> contenders, int rounds) {
    const std::size_t count = contenders.size();
    for (const Contender& contender : contenders) contender.run();
    std::vector<std::vector<double>> seconds(count), ratios(count);
    for (int round = 0; round < rounds; ++round) {
        std::vector<double> now(count);
        for (std::size_t k = 0; k < count; ++k) {
            const std::size_t turn = (k + std::size_t(round)) % count;
            const double before = thread_seconds();
            contenders[turn].run();
            now[turn] = thread_seconds() - before;
        }
        for (std::size_t k = 0; k < count; ++k) {
            seconds[k].push_back(now[k]);
            ratios[k].push_back(now[k] / now[0]);
        }
    }
    std::vector<Lap> laps(count);
    for (std::size_t k = 0; k < count; ++k) laps[k] = {median(seconds[k]), median(ratios[k])};
    return laps;
}

}  // namespace firma::bench
