// SPDX-License-Identifier: MIT
// What main() knows of a verb: its place on the command line and what runs it.
#pragma once

#include <functional>
#include <string_view>

namespace CLI {
class App;
}

namespace firma::cli {

struct Verb {
    CLI::App* command = nullptr;
    std::function<int()> run;  ///< the exit code: 0 or 1; everything worse is thrown
};

inline constexpr std::string_view kExitCodes =
    "Exit codes: 0 done; 2 a bad call or bad input, with `firma: place: reason` on stderr.\n";

/// Writes to standard output at once; throws Failure where that is not possible.
void print(std::string_view text);

/// Adds --json with its help.
void add_json_flag(CLI::App& command, bool& json);

/// Adds -o and --out.
void add_out_option(CLI::App& command, std::string& out, const char* help, bool required);

/// Where messages for people go: not to standard output when the result itself goes there.
bool may_print_beside(const std::string& out);
/// @throws Failure when --json and the output both want standard output
void refuse_json_beside(bool json, const std::string& out);

}  // namespace firma::cli
