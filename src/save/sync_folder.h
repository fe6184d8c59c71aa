// SPDX-License-Identifier: MIT
// Making a renaming last.
#pragma once

#include <string>

namespace firma {

/// Flushes the folder that a file lies in, so that its name is there after a power cut as well.
/// @return 0, or the system's reason; file systems that cannot flush folders count as having done so
int sync_folder_of(const std::string& path);

}  // namespace firma
