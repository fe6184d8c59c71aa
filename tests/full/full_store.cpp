// SPDX-License-Identifier: MIT
// Readers in two threads while an editor cuts and drops history; every answer is compared with what its version answers
// alone. Built with the preset "thread", the thread sanitizer watches: it ends the program with an error. Prints one
// claim.
//
//   full_store --count 1000 --seed 1
#include <cstdio>
#include <cstdlib>
#include <string>

#include "tests/threads/store_race.h"

int main(int count, char** words) {
    unsigned long long cuts = 1000, seed = 1;
    for (int k = 1; k < count; k += 2) {
        const std::string word = words[k];
        if (k + 1 >= count || (word != "--count" && word != "--seed")) {
            std::fprintf(stderr, "full_store [--count N] [--seed N]\n");
            return 2;
        }
        (word == "--count" ? cuts : seed) = std::strtoull(words[k + 1], nullptr, 10);
    }
#if defined(__SANITIZE_THREAD__)
    const char* watched = "yes";
#else
    const char* watched = "no";
#endif
    const firma::test::StoreRace race = firma::test::run_store_race(int(cuts), seed);
    const bool sound = race.wrong == 0 && !race.records.empty() && race.history.versions < cuts;
    std::printf(
        "claim=store_threads family=total count=%llu seed=%llu answers=%zu wrong=%llu versions_read=%llu "
        "versions_kept=%zu "
        "most_waiting=%zu thread_sanitizer=%s result=%s\n",
        cuts, seed, race.records.size(), static_cast<unsigned long long>(race.wrong),
        static_cast<unsigned long long>(race.versions_read), race.history.versions, race.most_waiting, watched,
        sound ? "pass" : "fail");
    return sound ? EXIT_SUCCESS : EXIT_FAILURE;
}
