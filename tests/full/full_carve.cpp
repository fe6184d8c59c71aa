// SPDX-License-Identifier: MIT
// Thousands of cuts of every family, judged one by one. Prints a claim a family and one in total.
//
//   full_carve --count 20000 --seed 1 [--threads 2] [--from 0] [--to N] [--family NAME] [--level levels/first.obj]
//              [--show 3 (of each family)]
#include "tests/full/family_run.h"

int main(int count, char** words) {
    using namespace firma;
    full::FamilyOptions options;
    options.count = 20000;
    if (!full::read_options(count, words, options, options.words())) {
        std::fprintf(stderr,
                     "full_carve [--count N] [--seed N] [--threads N] [--from CASE] [--to CASE] [--family NAME] "
                     "[--level FILE] [--show N]\n");
        return 2;
    }
    const Result<Level> ours = read_level(options.level);
    if (!ours) {
        std::fprintf(stderr, "%s\n", ours.error().text().c_str());
        return 2;
    }
    reference::report_contradictions();
    std::vector<full::JudgedFamily> families;
    for (const scenes::CutFamily& family : scenes::cut_families())
        families.push_back({std::string(family.name), [&](std::uint64_t seed, std::uint64_t index) {
                                return reference::judge_case(family, seed, index, ours.value());
                            }});
    // Refusals must stay few.
    full::FamilyRun run(options, {"carve_cuts", 0.1, 0.02}, families);
    if (run.empty()) {
        std::fprintf(stderr, "full_carve: no such family\n");
        return 2;
    }
    return run.run();
}
