// SPDX-License-Identifier: MIT
#include "base/wide_path_windows.h"

#define WIN32_LEAN_AND_MEAN
#include <windows.h>

namespace firma {

std::wstring wide_path(const std::string& path) {
    const int units = MultiByteToWideChar(CP_UTF8, 0, path.data(), int(path.size()), nullptr, 0);
    std::wstring wide(std::size_t(units), L'\0');
    MultiByteToWideChar(CP_UTF8, 0, path.data(), int(path.size()), wide.data(), units);
    return wide;
}

}  // namespace firma
