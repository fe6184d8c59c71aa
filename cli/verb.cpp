// SPDX-License-Identifier: MIT
// What all verbs share.
#include "cli/verb.h"

#include <cerrno>
#include <cstdio>
#include <cstring>

#include "cli/atomic_file.h"
#include "cli/failure.h"

namespace firma::cli {

void print(std::string_view text) {
    const bool whole = std::fwrite(text.data(), 1, text.size(), stdout) == text.size();
    if (!whole || std::fflush(stdout) != 0)
        throw Failure("standard output", std::string("cannot be written: ") + std::strerror(errno));
}

void add_json_flag(Command& command, bool& json) {
    command.add_flag("--json", json,
                     "one JSON object on standard output, and nothing else there (nothing at all on code 2)");
}

void add_out_option(Command& command, std::string& out, const char* help, bool required) {
    command.add_option("-o,--out", out, "FILE", help, required);
}

bool may_print_beside(const std::string& out) {
    return !is_standard_output(out);
}

void refuse_json_beside(bool json, const std::string& out) {
    if (json && is_standard_output(out)) throw Failure("--json", "and --out both want standard output; name a file");
}

}  // namespace firma::cli
