// SPDX-License-Identifier: MIT
// Where a failed assertion goes.
#include "base/assert.h"

#include <cstdio>
#include <cstdlib>

namespace firma {
namespace {

void print_and_abort(const char* condition, const char* advice, const char* file, int line) {
    std::fprintf(stderr, "%s:%d: firma: %s: it must hold that %s\n", file, line, advice, condition);
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
