// SPDX-License-Identifier: MIT
// What the C and C++ libraries would ask the host for, answered here, so that the module needs two things of it: the
// time, for edits in slices and for reports, and what its visitors answer.
//
// A failed allocation or assertion ends in a trap: JavaScript sees an exception, and the module must not be used again.
#include <cstdarg>
#include <cstddef>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <new>

#include "bindings/wasm/print_number.h"
#include "firma/firma_c.h"

extern "C" {
/// Microseconds since whenever.
__attribute__((import_module("firma"), import_name("now"))) double firma_host_now();
/// Shows an answer to the question under way; returns what the visitor answers.
__attribute__((import_module("firma"), import_name("visit"))) double firma_host_visit(const void* answer);
}

namespace {

void* take(std::size_t bytes) {
    void* memory = std::malloc(bytes ? bytes : 1);
    if (!memory) __builtin_trap();
    return memory;
}

}  // namespace

void* operator new(std::size_t bytes) {
    return take(bytes);
}
void* operator new[](std::size_t bytes) {
    return take(bytes);
}
void* operator new(std::size_t bytes, const std::nothrow_t&) noexcept {
    return std::malloc(bytes ? bytes : 1);
}
void* operator new(std::size_t bytes, std::align_val_t alignment) {
    void* memory = std::aligned_alloc(
        std::size_t(alignment), (bytes + std::size_t(alignment) - 1) / std::size_t(alignment) * std::size_t(alignment));
    if (!memory) __builtin_trap();
    return memory;
}
void operator delete(void* memory) noexcept {
    std::free(memory);
}
void operator delete[](void* memory) noexcept {
    std::free(memory);
}
void operator delete(void* memory, std::size_t) noexcept {
    std::free(memory);
}
void operator delete[](void* memory, std::size_t) noexcept {
    std::free(memory);
}
void operator delete(void* memory, std::align_val_t) noexcept {
    std::free(memory);
}
void operator delete(void* memory, std::size_t, std::align_val_t) noexcept {
    std::free(memory);
}

// Instead of printing to a terminal that is not there.
_LIBCPP_BEGIN_NAMESPACE_STD
[[noreturn]] void __libcpp_verbose_abort(const char*, ...) {
    __builtin_trap();
}
_LIBCPP_END_NAMESPACE_STD

extern "C" {

firma_code firma_wasm_cast_mover_each(firma_world world, const firma_mover* mover, const double* path,
                                      const firma_cast_options* options, uint32_t* status) {
    return firma_cast_mover_each(
        world, mover, path, options, [](const firma_hit* hit, void*) { return firma_host_visit(hit); }, nullptr,
        status);
}

firma_code firma_wasm_overlap_mover_each(firma_world world, const firma_mover* mover, const firma_near_options* options,
                                         uint32_t* found) {
    return firma_overlap_mover_each(
        world, mover, options, [](const firma_near* near, void*) { return uint32_t(firma_host_visit(near) != 0); },
        nullptr, found);
}

firma_code firma_wasm_each_face(firma_world world, const firma_face_filter* filter, uint32_t* completed) {
    struct Shown {
        const firma_face* face;
        const double* corners;
    };
    const auto show = [](const firma_face* face, const double* corners, void*) {
        const Shown shown{face, corners};
        return uint32_t(firma_host_visit(&shown) != 0);
    };
    return firma_world_each_face(world, filter, show, nullptr, completed);
}

/// The rule that asks the visitor: where firma_fly_options.rule is to point.
firma_shot_rule firma_wasm_shot_rule() {
    struct Shown {
        const firma_shot_impact* impact;
        firma_shot_terms* terms;
        uint32_t matter;
    };
    return [](const firma_shot_impact* impact, uint32_t matter, firma_shot_terms* terms, void*) {
        const Shown shown{impact, terms, matter};
        firma_host_visit(&shown);
    };
}

int clock_gettime(clockid_t, timespec* time) {
    const double us = firma_host_now();
    time->tv_sec = time_t(us / 1e6);
    time->tv_nsec = long((us - double(time->tv_sec) * 1e6) * 1e3);
    return 0;
}

/// wasi-libc's way to files and terminals, of which there are none here: EBADF.
int __imported_wasi_snapshot_preview1_fd_write(int, int, int, int) {
    return 8;
}
int __imported_wasi_snapshot_preview1_fd_seek(int, long long, int, int) {
    return 8;
}
int __imported_wasi_snapshot_preview1_fd_close(int) {
    return 8;
}

/// Only std::to_string(double) calls it, with "%f", and number_text() with "%.*g": print_number.h.
int snprintf(char* out, std::size_t size, const char* format, ...) {
    std::va_list list;
    va_start(list, format);
    const bool fixed = format[1] == 'f';
    const int digits = fixed ? 6 : va_arg(list, int);
    const double value = va_arg(list, double);
    va_end(list);
    char text[firma::kLongestNumber];
    const std::size_t length = std::size_t(firma::print_number(value, digits, fixed, text));
    if (size > 0) {
        const std::size_t kept = length < size ? length : size - 1;
        std::memcpy(out, text, kept);
        out[kept] = '\0';
    }
    return int(length);
}

/// Nobody calls it; without it std::to_wstring would bring in all of stdio.
int swprintf(wchar_t*, std::size_t, const wchar_t*, ...) {
    return -1;
}

/// What a thread keeps is given back when it ends; there is one, and it never does.
int __cxa_thread_atexit(void (*)(void*), void*, void*) {
    return 0;
}

/// Memory for arguments and answers: 16-byte aligned; null for none.
void* firma_wasm_take(std::size_t bytes) {
    return std::malloc(bytes ? bytes : 1);
}
void firma_wasm_give_back(void* memory) {
    std::free(memory);
}
}
