// SPDX-License-Identifier: MIT
// How much of a long loop one step does.
#pragma once

#include <algorithm>
#include <cstddef>

namespace firma {

/// Counts down units of work: turns of a loop, more for a turn that does more.
class WorkSlice {
public:
    explicit WorkSlice(std::size_t units) : left_(units) {}

    void take(std::size_t units = 1) { left_ -= std::min(left_, units); }
    bool used_up() const { return left_ == 0; }

private:
    std::size_t left_;
};

/// Goes on with a loop over 0 .. count: calls `function(index)` from `next` on, a unit each, until the slice is used
/// up.
/// @return whether the loop is at its end; then `next` is 0 again, for the loop after it
template <class Index, class Function>
bool go_on(Index& next, std::size_t count, WorkSlice& slice, const Function& function) {
    for (; next < count; ++next) {
        if (slice.used_up()) return false;
        slice.take();
        function(next);
    }
    next = 0;
    return true;
}

}  // namespace firma
