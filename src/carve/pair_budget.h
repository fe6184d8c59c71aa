// SPDX-License-Identifier: MIT
// How much of the work that may grow with the square of the input one edit is allowed.
#pragma once

#include <cstdint>

namespace firma {

/// One step of a cut looks at so many pairs, or a few more.
inline constexpr std::uint64_t kPairsACutStep = 32;

/// Counts pairs down: of triangles of a cutter, or of one and a face of the world. Some meshes (a fan of long
/// triangles) have boxes that all meet.
class PairBudget {
public:
    PairBudget() = default;
    explicit PairBudget(std::uint64_t most) : most_(most), left_(most) {}

    /// False, and spent() from then on, when fewer than so many are left.
    bool take(std::uint64_t count = 1) {
        spent_ = spent_ || count > left_;
        left_ = spent_ ? 0 : left_ - count;
        return !spent_;
    }
    bool spent() const { return spent_; }
    std::uint64_t taken() const { return most_ - left_; }
    std::uint64_t most() const { return most_; }

private:
    std::uint64_t most_ = ~std::uint64_t(0), left_ = ~std::uint64_t(0);
    bool spent_ = false;
};

}  // namespace firma
