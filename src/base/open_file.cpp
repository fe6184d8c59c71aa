// SPDX-License-Identifier: MIT
#include "base/open_file.h"

#include <fcntl.h>

#ifdef _WIN32
#include "base/wide_path_windows.h"
#endif

namespace firma {

#ifdef _WIN32

std::FILE* open_stream(const std::string& path) {
    return _wfopen(wide_path(path).c_str(), L"rb");
}

int open_descriptor(const std::string& path) {
    return _wopen(wide_path(path).c_str(), _O_RDONLY | _O_BINARY | _O_NOINHERIT);
}

#else

std::FILE* open_stream(const std::string& path) {
    return std::fopen(path.c_str(), "rb");
}

int open_descriptor(const std::string& path) {
    return open(path.c_str(), O_RDONLY | O_CLOEXEC);
}

#endif

}  // namespace firma
