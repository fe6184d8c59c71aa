// SPDX-License-Identifier: MIT
// Cuts in our level under different trees, and with the index built anew in between: after every one all worlds agree,
// to the byte. Prints one claim.
//
//   full_index --count 1000 --seed 1
#include <cstdio>
#include <cstdlib>
#include <string>

#include "firma/level.h"
#include "tests/full/options.h"
#include "tests/reference/judge_index.h"

int main(int count, char** words) {
    using namespace firma;
    using ull = unsigned long long;
    full::Options options;
    options.count = 1000;
    if (!full::read_options(count, words, options, {})) {
        std::fprintf(stderr, "full_index [--count N] [--seed N]\n");
        return 2;
    }
    const Result<Level> ours = read_level(FIRMA_ROOT "/levels/first.obj");
    if (!ours) {
        std::fprintf(stderr, "full_index: %s\n", ours.error().text().c_str());
        return 2;
    }
    const auto make = [&](const TreeOptions& tree) { return make_world(ours.value(), {.tree = tree}).value(); };
    const std::size_t cuts = std::size_t(options.count);
    const reference::IndexTally tally =
        reference::judge_index(make, reference::cuts_of_our_level(ours.value(), options.seed, cuts));
    for (const std::string& failure : tally.failures) std::printf("failure %s\n", failure.c_str());
    const bool pass = tally.failed == 0 && tally.cuts == options.count && tally.done * 2 >= tally.cuts;
    std::printf(
        "claim=index_is_free family=total count=%llu seed=%llu done=%llu nothing=%llu refused=%llu rebuilds=%llu "
        "packed=%llu failed=%llu result=%s\n",
        ull(tally.cuts), ull(options.seed), ull(tally.done), ull(tally.nothing), ull(tally.refused),
        ull(tally.rebuilds), ull(tally.packed), ull(tally.failed), pass ? "pass" : "fail");
    return pass ? EXIT_SUCCESS : EXIT_FAILURE;
}
