// SPDX-License-Identifier: MIT
// Makes libc++'s std::sort small: included before everything else, in the module only.
//
// libc++ sorts by some five thousand bytes for every type and order, which were a fifth of the module. What stands here
// is a better match for pointers than its own way of doing so (release 19: __algorithm/sort.h), and some four hundred
// bytes: insertion for few elements, which most sorts of a cut have, else heap sort. Sorts whose equal elements could
// be told apart are nowhere in this library, as results have to be the same with every standard library; so they are
// with this one. If a later libc++ does not look here, the module is as right as before, and larger. Source: J. W. J.
// Williams, Algorithm 232: Heapsort, 1964; R. W. Floyd, Algorithm 245: Treesort 3, 1964.
#pragma once

#include <__algorithm/comp.h>
#include <__config>
#include <cstddef>
#include <utility>

_LIBCPP_BEGIN_NAMESPACE_STD

template <class Policy, class T, class Less>
_LIBCPP_HIDE_FROM_ABI void __sort_dispatch(T* first, T* last, Less& less) {
    constexpr ptrdiff_t kFew = 24;
    const ptrdiff_t count = last - first;
    if (count <= kFew) {
        for (ptrdiff_t k = 1; k < count; ++k) {
            if (!less(first[k], first[k - 1])) continue;
            T moving = std::move(first[k]);
            ptrdiff_t at = k;
            do {
                first[at] = std::move(first[at - 1]);
            } while (--at > 0 && less(moving, first[at - 1]));
            first[at] = std::move(moving);
        }
        return;
    }
    ptrdiff_t heap = count / 2, end = count;  // first[heap], ..., first[end - 1] are a heap, what follows is sorted
    for (;;) {
        if (heap > 0) {
            --heap;
        } else if (--end > 0) {
            std::swap(first[0], first[end]);
        } else {
            return;
        }
        T moving = std::move(first[heap]);
        ptrdiff_t at = heap;
        for (ptrdiff_t below = 2 * at + 1; below < end; below = 2 * at + 1) {
            if (below + 1 < end && less(first[below], first[below + 1])) ++below;
            if (!less(moving, first[below])) break;
            first[at] = std::move(first[below]);
            at = below;
        }
        first[at] = std::move(moving);
    }
}

// libc++ has these compiled already, its way: three thousand bytes each.
template <class Policy>
_LIBCPP_HIDE_FROM_ABI void __sort_dispatch(unsigned* first, unsigned* last, __less<>& less) {
    std::__sort_dispatch<Policy, unsigned, __less<>>(first, last, less);
}
template <class Policy>
_LIBCPP_HIDE_FROM_ABI void __sort_dispatch(unsigned long long* first, unsigned long long* last, __less<>& less) {
    std::__sort_dispatch<Policy, unsigned long long, __less<>>(first, last, less);
}

_LIBCPP_END_NAMESPACE_STD
