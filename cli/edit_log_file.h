// SPDX-License-Identifier: MIT
// Edit logs as files, and what `firma check` and `firma log show` tell of them.
#pragma once

#include <cstddef>
#include <string>

#include "cli/atomic_file.h"
#include "cli/json.h"
#include "firma/edit_log.h"

namespace firma::cli {

/// `firma carve --log` writes a checkpoint after every so many commands.
inline constexpr std::size_t kCheckpointEvery = 100;

/// Whether a name ends in .firmalog, capitals or not.
bool names_edit_log(const std::string& path);

struct LoadedLog {
    EditLog log;
    std::size_t bytes = 0;
};
/// @throws Failure with the reader's place and reason
LoadedLog read_edit_log(const std::string& path);

void write_edit_log(const EditLog& log, AtomicFile& file);

/// What it is, without commands and checkpoints.
Json edit_log_json(const std::string& path, const LoadedLog& loaded);
std::string edit_log_text(const std::string& path, const LoadedLog& loaded);

/// One command; `hash` of the checkpoint after it, if there is one.
Json command_json(const EditCommand& command);
std::string command_text(const EditCommand& command);

/// 16 hexadecimal digits
std::string hash_digits(std::uint64_t hash);

/// @return the exit code
int check_edit_log(const std::string& path, bool json);

}  // namespace firma::cli
