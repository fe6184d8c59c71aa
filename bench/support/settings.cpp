// SPDX-License-Identifier: MIT
// What every benchmark program understands on its command line.
#include "support/settings.h"

#include <cstdio>
#include <cstdlib>
#include <cstring>

namespace firma::bench {
namespace {

[[noreturn]] void refuse(const char* program, const char* argument) {
    std::fprintf(stderr, "%s: what is %s? Try --help\n", program, argument);
    std::exit(2);
}

}  // namespace

Settings read_settings(int argc, char** argv, const char* purpose) {
    Settings settings;
    settings.repository = FIRMA_REPOSITORY;
    settings.shared.append(settings.repository).append("/../shared");
    int rounds = 0;
    for (int k = 1; k < argc; ++k) {
        const bool has_next = k + 1 < argc;
        if (!std::strcmp(argv[k], "--help")) {
            std::printf("%s\n\n%s [--quick] [--rounds N] [--csv DIR] [--shared DIR]\n", purpose, argv[0]);
            std::exit(0);
        }
        if (!std::strcmp(argv[k], "--quick"))
            settings.quick = true;
        else if (!std::strcmp(argv[k], "--rounds") && has_next)
            rounds = std::atoi(argv[++k]);
        else if (!std::strcmp(argv[k], "--csv") && has_next)
            settings.csv = argv[++k];
        else if (!std::strcmp(argv[k], "--shared") && has_next)
            settings.shared = argv[++k];
        else if (argv[k][0] != '-' && settings.rest.empty())
            settings.rest = argv[k];
        else
            refuse(argv[0], argv[k]);
    }
    settings.rounds = rounds > 0 ? rounds : settings.quick ? 1 : 9;
    return settings;
}

}  // namespace firma::bench
