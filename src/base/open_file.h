// SPDX-License-Identifier: MIT
// Files opened by names in UTF-8, on Windows as elsewhere.
#pragma once

#include <cstdio>
#include <string>

namespace firma {

/// Opens a file to read its bytes. @return null, and errno has the reason
std::FILE* open_stream(const std::string& path);

/// Opens a file to read its bytes, not for child processes. @return a descriptor; -1, and errno has the reason
int open_descriptor(const std::string& path);

}  // namespace firma
