// SPDX-License-Identifier: MIT
// Where a failed assertion goes.
#include "base/assert.h"

#include <cstdio>
#include <cstdlib>

namespace firma {
namespace {

void print_and_abort(const char* condition, const char* advice, const char* file, int line) {
#if defined(__wasm__)  // no terminal to print to
    static_cast<void>(condition), static_cast<void>(advice), static_cast<void>(file), static_cast<void>(line);
#else
    std::fprintf(stderr, "%s:%d: firma: %s: it must hold that %s\n", file, line, advice, condition);
#endif
    std::abort();
}

AssertHandler current_handler = print_and_abort;

}  // namespace

void set_assert_handler(AssertHandler handler) {
    current_handler = handler ? handler : print_and_abort;
}

void report_assertion(const char* condition, const char* advice, const char* file, int line) {
    current_handler(condition, advice, file, line);
}

}  // namespace firma
