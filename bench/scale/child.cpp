// SPDX-License-Identifier: MIT
// Work in a process of its own.
#include "scale/child.h"

#include <malloc.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <sstream>

namespace firma::bench {
namespace {

double status_bytes(const std::string& key) {
    std::ifstream file("/proc/self/status");
    std::string line;
    while (std::getline(file, line))
        if (line.starts_with(key)) return std::atof(line.c_str() + key.size()) * 1024;
    return 0;
}

void write_rows(int to, const std::vector<Cells>& rows) {
    std::string text;
    for (const Cells& row : rows) {
        for (const std::string& cell : row) text.append(cell).push_back('\t');
        text.push_back('\n');
    }
    for (std::size_t done = 0; done < text.size();) {
        const ssize_t wrote = write(to, text.data() + done, text.size() - done);
        if (wrote <= 0) _exit(3);
        done += std::size_t(wrote);
    }
}

}  // namespace

std::vector<Cells> rows_of_child(const std::string& what, const std::function<void(std::vector<Cells>&)>& work) {
    int ends[2];
    std::fflush(nullptr);
    if (pipe(ends) != 0) std::perror("pipe"), std::exit(1);
    const pid_t child = fork();
    if (child < 0) std::perror("fork"), std::exit(1);
    if (child == 0) {
        close(ends[0]);
        std::vector<Cells> rows;
        work(rows);
        std::fflush(nullptr);
        write_rows(ends[1], rows);
        _exit(0);  // without the ends of libraries' threads and tables
    }
    close(ends[1]);
    std::string text;
    char piece[4096];
    for (ssize_t got; (got = read(ends[0], piece, sizeof piece)) > 0;) text.append(piece, std::size_t(got));
    close(ends[0]);
    int status = 0;
    waitpid(child, &status, 0);
    if (!WIFEXITED(status) || WEXITSTATUS(status) != 0) {
        std::fprintf(stderr, "bench_scale: %s ended with %s %d\n", what.c_str(), WIFEXITED(status) ? "code" : "signal",
                     WIFEXITED(status) ? WEXITSTATUS(status) : WTERMSIG(status));
        return {};
    }
    std::vector<Cells> rows;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
        Cells& row = rows.emplace_back();
        std::istringstream cells(line);
        for (std::string cell; std::getline(cells, cell, '\t');) row.push_back(cell);
    }
    return rows;
}

double process_seconds() {
    timespec now;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return double(now.tv_sec) + 1e-9 * double(now.tv_nsec);
}

double resident_bytes() {
    malloc_trim(0);
    return status_bytes("RssAnon:");
}

double peak_bytes() {
    return status_bytes("VmHWM:") - status_bytes("RssFile:");
}

void forget_peak() {
    std::ofstream("/proc/self/clear_refs") << "5";
}

}  // namespace firma::bench
