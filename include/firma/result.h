// SPDX-License-Identifier: MIT
// What comes back when data from outside is bad: a code, a place and a sentence. Asking a Result costs a comparison.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <variant>

namespace firma {

enum class ErrorCode : std::uint8_t {
    kCannotRead,   ///< the file is missing or cannot be read
    kMalformed,    ///< the file breaks its format
    kOutOfRange,   ///< a number is not finite, or lies outside what Firma can hold
    kTooLarge,     ///< a count or size exceeds a limit, found before memory is taken
    kUnsupported,  ///< a format or version that Firma does not read
    kInvalid,      ///< a call with arguments that make no sense
    kCannotWrite,  ///< the file cannot be made or written: no folder, no permission, no room
    kNoMemory,     ///< an edit in slices was broken off when memory ran out: see CarveJob
    kCancelled,    ///< who was told of the progress said that it should not go on
};

/// Where and why. `place` is "file", "file:line" or "file: entry", whichever the format has.
struct Error {
    ErrorCode code = ErrorCode::kInvalid;
    std::string place;
    std::string reason;

    /// "place: reason", for people. Allocates the text.
    std::string text() const { return place.empty() ? reason : place + ": " + reason; }
};

/// Either a value or an Error: look which before you take the value.
template <class T>
class [[nodiscard]] Result {
public:
    Result(T value) : held_(std::move(value)) {}
    Result(Error error) : held_(std::move(error)) {}

    bool ok() const { return held_.index() == 0; }
    explicit operator bool() const { return ok(); }

    /// The value; asking a failed result for it is the caller's mistake and throws std::bad_variant_access.
    T& value() & { return std::get<0>(held_); }
    const T& value() const& { return std::get<0>(held_); }
    T&& value() && { return std::get<0>(std::move(held_)); }
    /// The Error; asking a result that is ok for it throws likewise.
    const Error& error() const { return std::get<1>(held_); }

private:
    std::variant<T, Error> held_;
};

}  // namespace firma
