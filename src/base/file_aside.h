// SPDX-License-Identifier: MIT
// A file that appears whole or not at all: written aside, flushed, renamed, its folder flushed.
#pragma once

#include <sys/stat.h>

#include <cstddef>
#include <functional>
#include <span>
#include <string>

namespace firma {

/// A file written under a passing name. Functions that return int return 0, or the system's reason.
class FileAside {
public:
    /// @param path  the passing name; must lie in the folder of the place it will take
    explicit FileAside(std::string path) : path_(std::move(path)) {}
    /// Removes it, unless it was renamed.
    ~FileAside();
    FileAside(const FileAside&) = delete;
    FileAside& operator=(const FileAside&) = delete;

    /// Opens it empty and holds a lock on it, which ends with the process: what a killed writer left is taken over,
    /// never two write it at once, and nothing piles up. Waits for another writer.
    int open_locked();
    /// Opens a file that was not there; EEXIST when one was.
    int open_new();

    bool is_open() const { return descriptor_ >= 0; }
    const std::string& path() const { return path_; }

    /// Gives it the permissions of the file whose place it takes, as far as the system lets it.
    void set_mode(mode_t mode);
    int write(std::span<const std::byte> bytes);
    /// To the disk: after this only the renaming can fail.
    int flush();
    /// Puts it in its place and flushes the folder, so that the name lasts.
    int rename_to(const std::string& target);

private:
    bool is_at_path(int descriptor) const;

    const std::string path_;
    int descriptor_ = -1;
    bool renamed_ = false;
};

/// Writes all bytes to a descriptor, however often a signal interrupts. @return 0, or the system's reason
int write_all(int descriptor, std::span<const std::byte> bytes);

/// Makes of a path the one behind all links; leaves it where there is nothing yet.
/// @return 0, or the system's reason, as of a link that leads nowhere: to be followed, not replaced
int resolve_links(std::string& path);

/// Writes PATH.part, locked, and puts it in the place of `path` when `write` has returned 0. What was there before
/// stays until then, and for good when anything fails; its permissions stay in any case.
/// @return 0, or the system's reason, or what `write` returned; EISDIR for a folder, EINVAL for a device or a pipe
int write_whole_file(const std::string& path, const std::function<int(FileAside&)>& write);

}  // namespace firma
