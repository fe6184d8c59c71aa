// SPDX-License-Identifier: MIT
// What every benchmark program understands on its command line.
#pragma once

#include <string>

namespace firma::bench {

struct Settings {
    bool quick = false;      ///< a short run, to see that the program works
    int rounds = 9;          ///< of a race
    std::string csv;         ///< folder for tables as CSV; empty for none
    std::string shared;      ///< the folder of shared test material
    std::string repository;  ///< where levels/ lies
    std::string rest;        ///< the program's own argument, when there is one

    std::size_t few(std::size_t many) const { return quick ? many / 50 + 1 : many; }
};

/// --quick, --rounds N, --csv DIR, --shared DIR, one argument more. Ends the program with code 2 on anything else, and
/// with 0 after --help.
Settings read_settings(int argc, char** argv, const char* purpose);

}  // namespace firma::bench
