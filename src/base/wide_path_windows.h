// SPDX-License-Identifier: MIT
// A name in UTF-8 as Windows takes it.
#pragma once

#include <string>

namespace firma {

/// In UTF-16; what is no UTF-8 becomes U+FFFD, which no file has in its name.
std::wstring wide_path(const std::string& path);

}  // namespace firma
