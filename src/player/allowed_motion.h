// SPDX-License-Identifier: MIT
// The motions that lead into none of a few planes, and of these the nearest to a wanted one.
#pragma once

#include <array>
#include <cstddef>

#include "firma/vec.h"

namespace firma {

/// A cone: all d with normal . d >= 0 for each normal given.
class AllowedMotion {
public:
    /// One that is there already, or is one too many, is left out.
    void add(const Vec3& normal);
    /// The d of the cone that is nearest to `wanted`: `wanted` itself, or its part in one plane, along the line of two,
    /// or none. Which that is follows from trying all, so three planes of a corner hold as one does.
    Vec3 nearest(const Vec3& wanted) const;
    bool holds(const Vec3& normal) const;  ///< whether it was given, to rounding

private:
    bool allows(const Vec3& motion) const;

    static constexpr std::size_t kMaxPlanes = 24;
    std::array<Vec3, kMaxPlanes> normals_;
    std::size_t count_ = 0;
};

}  // namespace firma
