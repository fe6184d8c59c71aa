// SPDX-License-Identifier: MIT
// What main() knows of a verb: its place on the command line and what runs it.
#pragma once

#include <functional>
#include <string>
#include <string_view>

#include "cli/command.h"

namespace firma::cli {

struct Verb {
    Command command;
    std::function<int()> run;  ///< the exit code: 0 or 1; everything worse is thrown
};

inline constexpr const char* kExitCodes = R"(
Exit codes: 0 done; 2 a bad call or bad input, with `firma: place: reason` on stderr.
)";

/// Writes to standard output at once; throws Failure where that is not possible.
void print(std::string_view text);

/// Adds --json with its help.
void add_json_flag(Command& command, bool& json);

/// Adds -o and --out.
void add_out_option(Command& command, std::string& out, const char* help, bool required);

/// Where messages for people go: not to standard output when the result itself goes there.
bool may_print_beside(const std::string& out);
/// @throws Failure when --json and the output both want standard output
void refuse_json_beside(bool json, const std::string& out);

}  // namespace firma::cli
