// SPDX-License-Identifier: MIT
#include "base/open_file.h"

#include <fcntl.h>

#ifdef _WIN32
#define WIN32_LEAN_AND_MEAN
#include <windows.h>
#endif

namespace firma {

#ifdef _WIN32

std::wstring wide_path(const std::string& path) {
    const int units = MultiByteToWideChar(CP_UTF8, 0, path.data(), int(path.size()), nullptr, 0);
    std::wstring wide(std::size_t(units), L'\0');
    MultiByteToWideChar(CP_UTF8, 0, path.data(), int(path.size()), wide.data(), units);
    return wide;
}

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
