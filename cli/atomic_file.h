// SPDX-License-Identifier: MIT
// A file that appears whole or not at all: written aside, flushed, then renamed into place.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "base/file_aside.h"

namespace firma::cli {

/// Makes SIGINT, SIGTERM and SIGHUP remove what is half-written and end with code 2; a closed pipe or a file grown too
/// large becomes an error of the write. Call once, first thing in main().
void end_cleanly_on_signals();

/// A few at a time. Until commit() a file that was there before stays as it was.
class AtomicFile {
public:
    /// Opens at once, so that an output that cannot be written is known before the work.
    ///
    /// @param path  "-" and /dev/stdout are standard output; devices and pipes are written directly; everything else
    /// aside
    /// @throws Failure for a folder, a missing folder, no permission
    explicit AtomicFile(const std::string& path);
    /// Without commit(), leaves nothing behind.
    ~AtomicFile();
    AtomicFile(const AtomicFile&) = delete;
    AtomicFile& operator=(const AtomicFile&) = delete;

    /// @throws Failure when the disk is full, the pipe closed ...
    void write(std::string_view text);
    /// Flushes: from here on only the renaming can fail. With several files: all of them first, then commit() each.
    void finish();
    /// Finishes and puts the file in its place.
    void commit();

private:
    void open_aside(const std::string& target);
    void put(const char* from, std::size_t size);
    [[noreturn]] void fail(int code) const;

    std::string name_;    ///< as the user gave it
    std::string target_;  ///< what to rename to; empty when written directly
    std::string buffer_;
    std::optional<FileAside> aside_;
    int file_ = -1;  ///< what is written directly
    int slot_ = -1;  ///< of the aside among the names that a signal removes
    bool finished_ = false;
};

/// Whether a path given as an output means standard output.
bool is_standard_output(const std::string& path);

/// Makes a folder, and those that it lies in, where they are missing.
/// @throws Failure with the system's reason
void make_folder(const std::string& folder);

/// Refuses an output that is one of the inputs.
void refuse_overwriting(const std::string& out, const std::string& input);

}  // namespace firma::cli
