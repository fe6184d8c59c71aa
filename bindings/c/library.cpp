// SPDX-License-Identifier: MIT
// Version, errors, hooks.
#include <cstddef>
#include <mutex>
#include <new>

#include "base/lock.h"
#include "bindings/c/convert.h"
#include "firma/memory.h"

namespace firma::c {
namespace {

constexpr std::size_t kLongestMessage = 2047;
thread_local char message[kLongestMessage + 1];

struct BatchHook {
    Lock lock;
    Tasks tasks{};
};

BatchHook& batch_hook() {
    alignas(BatchHook) static std::byte place[sizeof(BatchHook)];  // never destroyed, never without memory
    static auto& only = *new (place) BatchHook;
    return only;
}

void set_batch_tasks(const firma_tasks& tasks) {
    const std::lock_guard<Lock> guard(batch_hook().lock);
    batch_hook().tasks = {tasks.run, tasks.user};
}

}  // namespace

Tasks batch_tasks() {
    const std::lock_guard<Lock> guard(batch_hook().lock);
    return batch_hook().tasks;
}

firma_code fail(firma_code code, std::string_view place, std::string_view reason) noexcept {
    std::size_t length = 0;
    const auto put = [&](std::string_view text) {
        for (const char c : text) {
            if (length == kLongestMessage) return;
            message[length++] = c == '\0' ? ' ' : c;
        }
    };
    put(place);
    if (!place.empty()) put(": ");
    put(reason);
    message[length] = '\0';
    return code;
}

firma_code fail(const Error& error) noexcept {
    const auto code = [&] {
        switch (error.code) {
            case ErrorCode::kCannotRead:
                return FIRMA_ERROR_CANNOT_READ;
            case ErrorCode::kMalformed:
                return FIRMA_ERROR_MALFORMED;
            case ErrorCode::kOutOfRange:
                return FIRMA_ERROR_OUT_OF_RANGE;
            case ErrorCode::kTooLarge:
                return FIRMA_ERROR_TOO_LARGE;
            case ErrorCode::kUnsupported:
                return FIRMA_ERROR_UNSUPPORTED;
            case ErrorCode::kInvalid:
                return FIRMA_ERROR_INVALID;
            case ErrorCode::kCannotWrite:
                return FIRMA_ERROR_CANNOT_WRITE;
            case ErrorCode::kNoMemory:
                return FIRMA_ERROR_NO_MEMORY;
            case ErrorCode::kCancelled:  // nothing that C asks for is
                break;
        }
        return FIRMA_ERROR_INTERNAL;
    };
    return fail(code(), error.place, error.reason);
}

}  // namespace firma::c

using namespace firma;
using namespace firma::c;

uint32_t firma_version(void) {
    return FIRMA_VERSION_MAJOR << 16 | FIRMA_VERSION_MINOR << 8 | FIRMA_VERSION_PATCH;
}

const char* firma_error_message(void) {
    return message;
}

firma_code firma_set_allocator(const firma_allocator* allocator) {
    if (!allocator) return bad_call(__func__, kNull);
    if (!sized(allocator)) return bad_call(__func__, kWrongSize);
    firma_allocator given{};
    take_sized(allocator, given);
    if (!given.take || !given.give_back) return bad_call(__func__, "a function is missing");
    if (!set_memory_source({given.take, given.give_back, given.user}))
        return bad_call(__func__, "it is too late: worlds have taken memory already");
    return FIRMA_OK;
}

firma_code firma_set_tasks(const firma_tasks* tasks) {
    if (!tasks) {
        set_batch_tasks({});
        return FIRMA_OK;
    }
    if (!sized(tasks)) return bad_call(__func__, kWrongSize);
    firma_tasks given{};
    take_sized(tasks, given);
    if (!given.run) return bad_call(__func__, "the function `run` is missing");
    set_batch_tasks(given);
    return FIRMA_OK;
}

size_t firma_live_handles(void) {
    return count_objects();
}
