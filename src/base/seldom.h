// SPDX-License-Identifier: MIT
// FIRMA_SELDOM: before a function that few calls reach, in a source that is compiled for speed. In the module for
// browsers, which has to be small, it is compiled for size; elsewhere that says nothing.
#pragma once

#if defined(__wasm__)
#define FIRMA_SELDOM [[gnu::noinline, clang::minsize]]
#else
#define FIRMA_SELDOM
#endif
