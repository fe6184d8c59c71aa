// SPDX-License-Identifier: MIT
// A few corners in place: nothing is written but those that are there.
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <type_traits>

#include "firma/hull.h"

namespace firma {

/// Up to kMaxHullCorners, which is also the most that a face has.
class CornerList {
public:
    CornerList() = default;
    CornerList(const CornerList& other) { *this = other; }
    CornerList& operator=(const CornerList& other) {
        if (this == &other) return *this;
        count_ = 0;
        for (const Vec3& corner : other.all()) add(corner);
        return *this;
    }
    ~CornerList() = default;

    void add(const Vec3& corner) { std::construct_at(first() + count_++, corner); }
    std::size_t count() const { return count_; }
    std::span<const Vec3> all() const { return {first(), count_}; }
    const Vec3& operator[](std::size_t k) const { return first()[k]; }

private:
    static_assert(std::is_trivially_destructible_v<Vec3>);

    Vec3* first() { return reinterpret_cast<Vec3*>(bytes_); }
    const Vec3* first() const { return reinterpret_cast<const Vec3*>(bytes_); }

    std::size_t count_ = 0;
    alignas(Vec3) std::byte bytes_[kMaxHullCorners * sizeof(Vec3)];
};

}  // namespace firma
