// SPDX-License-Identifier: MIT
// What every function of the C API does around its work: handles looked up, errors kept, exceptions stopped.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <exception>
#include <memory>
#include <new>
#include <stdexcept>
#include <string_view>
#include <utility>

#include "bindings/c/handles.h"
#include "firma/firma_c.h"
#include "firma/result.h"

namespace firma::c {

/// Keeps the message for firma_error_message() and returns the code. Never fails, takes no memory.
firma_code fail(firma_code code, std::string_view place, std::string_view reason) noexcept;
firma_code fail(const Error& error) noexcept;
inline firma_code bad_call(std::string_view function, std::string_view reason) noexcept {
    return fail(FIRMA_ERROR_BAD_CALL, function, reason);
}

/// Runs the work of a function; whatever it throws becomes a code.
template <class Work>
firma_code guarded(const char* function, Work&& work) noexcept {
#if defined(__cpp_exceptions)
    try {
        return work();
    } catch (const std::bad_alloc&) {
        return fail(FIRMA_ERROR_NO_MEMORY, function, "not enough memory");
    } catch (const std::length_error&) {
        return fail(FIRMA_ERROR_NO_MEMORY, function, "not enough memory");
    } catch (const std::exception& error) {
        return fail(FIRMA_ERROR_INTERNAL, function, error.what());
    } catch (...) {
        return fail(FIRMA_ERROR_INTERNAL, function, "something went wrong that has no name");
    }
#else
    static_cast<void>(function);
    return work();
#endif
}

/// The object of a handle; each T names its kind as T::kKind and its noun as T::kNoun.
template <class T>
T* find(std::uint64_t id, const char* function) noexcept {
    if (Object* object = find_object(id, T::kKind)) return static_cast<T*>(object);
    char reason[80] = "";
    std::size_t length = 0;
    const auto put = [&](const char* text) {
        while (*text && length + 1 < sizeof reason) reason[length++] = *text++;
    };
    put(id == 0 ? "no " : "not a ");
    put(T::kNoun);
    put(id == 0 ? " (a handle of 0)" : " that is held: released already, or never made");
    fail(FIRMA_ERROR_BAD_HANDLE, function, {reason, length});
    return nullptr;
}

/// Puts an object into the table and its handle into `out`.
template <class T, class Handle>
firma_code give(std::unique_ptr<T> object, Handle* out, const char* function) noexcept {
    const std::uint64_t id = add_object(std::move(object), T::kKind);
    if (id == 0) return fail(FIRMA_ERROR_NO_MEMORY, function, "too many handles are held");
    out->id = id;
    return FIRMA_OK;
}

template <class T>
firma_code release(std::uint64_t id, const char* function) noexcept {
    if (id == 0) return FIRMA_OK;
    const std::unique_ptr<Object> object = remove_object(id, T::kKind);
    if (object) return FIRMA_OK;
    find<T>(id, function);  // says why not
    return FIRMA_ERROR_BAD_HANDLE;
}

/// Whether a struct from outside may be one that this header, or one before it, describes.
template <class T>
bool sized(const T* given) noexcept {
    return given->size >= 8 && given->size <= sizeof(T) && given->size % alignof(T) == 0;
}

/// Copies what the caller's struct has; what it is too short for stays in `out`. Once it is sized().
template <class T>
void take_sized(const T* given, T& out) noexcept {
    std::memcpy(&out, given, given->size);
}

/// Fills what the caller's struct has room for. Once it is sized().
template <class T>
void put_sized(T made, T* out) noexcept {
    made.size = out->size;
    std::memcpy(out, &made, out->size);
}

inline constexpr const char* kWrongSize =
    "the struct's `size` is not set, or is larger than this version's: it was compiled with a newer header";
inline constexpr const char* kNull = "a pointer is null that may not be";

}  // namespace firma::c
