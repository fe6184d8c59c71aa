// SPDX-License-Identifier: MIT
// Assertions: the caller's mistakes and our own, never bad data. On when FIRMA_ASSERTIONS is defined to 1.
#pragma once

namespace firma {

/// Called when an assertion fails; the default prints and aborts. Returning goes on, at the program's own risk.
using AssertHandler = void (*)(const char* condition, const char* advice, const char* file, int line);

/// Replaces the handler; null restores the default. Not for calling while other threads run Firma.
void set_assert_handler(AssertHandler handler);

void report_assertion(const char* condition, const char* advice, const char* file, int line);

}  // namespace firma

#if defined(FIRMA_ASSERTIONS) && FIRMA_ASSERTIONS
#define FIRMA_ASSERT(condition, advice) \
    ((condition) ? void() : ::firma::report_assertion(#condition, advice, __FILE__, __LINE__))
#else
#define FIRMA_ASSERT(condition, advice) void()
#endif
