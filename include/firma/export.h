// SPDX-License-Identifier: MIT
// What makes a function leave the shared library, where all else is hidden.
#pragma once

/// Stands before each function of the public headers that is not inline; `tools/public_symbols.py --mark` puts it
/// there.
#ifdef _WIN32  // there the C++ library is static
#define FIRMA_EXPORT
#else
#define FIRMA_EXPORT [[gnu::visibility("default")]]
#endif
