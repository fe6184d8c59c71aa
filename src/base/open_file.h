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

#ifdef _WIN32
/// A name as Windows takes it, in UTF-16; what is no UTF-8 becomes U+FFFD, which no file has in its name.
std::wstring wide_path(const std::string& path);
#endif

}  // namespace firma
