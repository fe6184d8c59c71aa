// SPDX-License-Identifier: MIT
// Measurements in a process of their own.
#include "support/own_process.h"

#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>

namespace firma::bench {
namespace {

[[noreturn]] void fail(const char* what) {
    std::perror(what);
    std::exit(1);
}

}  // namespace

std::vector<std::string> in_own_process(const std::function<std::vector<std::string>()>& measure) {
    int ends[2];
    if (pipe(ends) != 0) fail("pipe");
    std::fflush(nullptr);
    const pid_t child = fork();
    if (child < 0) fail("fork");
    if (child == 0) {
        close(ends[0]);
        std::FILE* out = fdopen(ends[1], "w");
        for (const std::string& cell : measure()) std::fprintf(out, "%s\n", cell.c_str());
        std::_Exit(std::fclose(out) == 0 ? 0 : 1);
    }
    close(ends[1]);
    std::vector<std::string> cells;
    std::FILE* in = fdopen(ends[0], "r");
    std::string cell;
    for (int c = std::fgetc(in); c != EOF; c = std::fgetc(in)) {
        if (c != '\n') {
            cell += char(c);
            continue;
        }
        cells.push_back(cell);
        cell.clear();
    }
    std::fclose(in);
    int status = 0;
    if (waitpid(child, &status, 0) != child || status != 0) {
        std::fprintf(stderr, "a measurement's process failed\n");
        std::exit(1);
    }
    return cells;
}

}  // namespace firma::bench
