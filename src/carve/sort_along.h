// SPDX-License-Identifier: MIT
// Sorts points along a line by an order that may leave some undecided.
#pragma once

#include <algorithm>
#include <utility>

namespace firma {

/// Mostly there are two to four: those are inserted one by one. Many are sorted by a heap, which stays within its range
/// whatever the order says.
///
/// @param before  1 when its first comes before its second, -1 after, 0 when that is not decided
/// @return false when neighbours, once sorted, are not decided
template <class Iterator, class Before>
bool sort_along(Iterator begin, Iterator end, const Before& before) {
    if (end - begin > 16) {
        const auto less = [&](const auto& a, const auto& b) { return before(a, b) > 0; };
        std::make_heap(begin, end, less);
        std::sort_heap(begin, end, less);
        for (Iterator k = begin; k + 1 < end; ++k)
            if (before(*k, *(k + 1)) <= 0) return false;
        return true;
    }
    for (Iterator k = begin; k < end; ++k)
        for (Iterator j = k; j > begin; --j) {
            const int sign = before(*(j - 1), *j);
            if (sign == 0) return false;
            if (sign > 0) break;
            std::swap(*(j - 1), *j);
        }
    return true;
}

}  // namespace firma
