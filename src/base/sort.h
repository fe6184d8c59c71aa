// SPDX-License-Identifier: MIT
// Sorting, where no two elements are equal that anyone could tell apart: results are then the same by any method.
//
// Natively that is std::sort. In the module it is a heap sort of some three hundred bytes, as libc++'s sort is ten
// times that for every type and order, and was a fifth of the module. Source: J. W. J. Williams, Algorithm 232:
// Heapsort, 1964; R. W. Floyd, Algorithm 245: Treesort 3, 1964.
#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>
#include <numeric>
#include <span>
#include <utility>
#include <vector>

namespace firma {

/// The element at `at` goes down a heap of `count`, whose rest is one already.
template <class T, class Less>
void sift_down(T* heap, std::size_t at, std::size_t count, const Less& less) {
    T moving = std::move(heap[at]);
    for (std::size_t below = 2 * at + 1; below < count; below = 2 * at + 1) {
        if (below + 1 < count && less(heap[below], heap[below + 1])) ++below;
        if (!less(moving, heap[below])) break;
        heap[at] = std::move(heap[below]);
        at = below;
    }
    heap[at] = std::move(moving);
}

template <class T, class Less>
void heap_sort(std::span<T> all, const Less& less) {
    for (std::size_t k = all.size() / 2; k-- > 0;) sift_down(all.data(), k, all.size(), less);
    for (std::size_t end = all.size(); end-- > 1;) {
        std::swap(all[0], all[end]);
        sift_down(all.data(), 0, end, less);
    }
}

/// @param range  contiguous
/// @param less   an order in which equal elements are alike in all that matters
template <class Range, class Less = std::less<>>
void sort_range(Range&& range, const Less& less = {}) {
#if defined(__wasm__)
    heap_sort(std::span(range), less);
#else
    std::sort(range.begin(), range.end(), less);
#endif
}

/// Equal elements stay in the order that they had.
template <class T, class Less = std::less<>>
void sort_stably(std::vector<T>& all, const Less& less = {}) {
    std::vector<std::size_t> order(all.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    sort_range(order,
               [&](std::size_t a, std::size_t b) { return less(all[a], all[b]) || (a < b && !less(all[b], all[a])); });
    std::vector<T> sorted;
    sorted.reserve(all.size());
    for (const std::size_t k : order) sorted.push_back(std::move(all[k]));
    all = std::move(sorted);
}

/// Each element once, in order.
template <class T>
void sort_once(std::vector<T>& all) {
    sort_range(all);
    all.erase(std::unique(all.begin(), all.end()), all.end());
}

}  // namespace firma
