// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#if defined(__SANITIZE_ADDRESS__)
#define FIRMA_SANITIZED 1
#elif defined(__has_feature)
#if __has_feature(address_sanitizer)
#define FIRMA_SANITIZED 1
#endif
#endif

namespace firma::test {

/// How many of a sample a test looks at. Under the sanitizers, where all takes ten times as long, and on Windows, which
/// wine runs, a fifth: what they look for is in every part, and all of it is looked at without them in the same run.
constexpr int sample(int count) {
#if defined(FIRMA_SANITIZED) || defined(_WIN32)
    return count / 5;
#else
    return count;
#endif
}

/// Every fifth of these where sample() gives a fifth, the first among them.
template <typename T>
std::vector<T> sampled(std::vector<T> all) {
    const std::size_t step = std::size_t(5 / sample(5));
    std::vector<T> some;
    for (std::size_t k = 0; k < all.size(); k += step) some.push_back(std::move(all[k]));
    return some;
}

}  // namespace firma::test
