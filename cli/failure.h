// SPDX-License-Identifier: MIT
// What ends the program with code 2: a bad call or bad input, as a place and a reason.
#pragma once

#include <stdexcept>
#include <string>
#include <utility>

#include "firma/result.h"

namespace firma::cli {

/// Thrown by anything in the command line, caught in main(), printed as "firma: place: reason".
class Failure : public std::runtime_error {
public:
    Failure(const std::string& place, const std::string& reason)
        : std::runtime_error(place.empty() ? reason : place + ": " + reason) {}
    explicit Failure(const Error& error) : std::runtime_error(error.text()) {}
};

/// The value of a result, or its error as a Failure.
template <class T>
T take(Result<T> result) {
    if (!result) throw Failure(result.error());
    return std::move(result).value();
}

}  // namespace firma::cli
