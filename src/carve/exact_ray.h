// SPDX-License-Identifier: MIT
// A ray from an exact point, and whether it crosses a polygon of exact planes: what tells, without any tolerance, on
// which side of a boundary a point lies.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "geometry/exact_point.h"

namespace firma {

class ExactRay {
public:
    static constexpr int kWays = 12;

    /// Along the line in which two planes through the point meet: of a point of the grid in a direction of small
    /// numbers, of one of three planes along two of them.
    ExactRay(const ExactPoint& from, int way);
    ExactRay(const ExactRay&) = delete;
    ExactRay& operator=(const ExactRay&) = delete;

    /// Of length 1, but for rounding.
    const Vec3& direction() const { return direction_; }

    /// False only where the ray's line surely stays away from a face whose corners' approximate() lie in a box.
    bool may_meet(const Vec3& low, const Vec3& high) const;

    struct Edge {
        const ExactPoint* from = nullptr;
        const ExactPoint* to = nullptr;
        const Plane* across = nullptr;  ///< holds the edge, and is not parallel to the face
    };
    enum class Crossing : std::uint8_t {
        kNone,
        kCrosses,
        kUnsure,  ///< it meets an edge, or lies in the plane: another way may tell
        kOn,      ///< it begins on the face
    };
    /// @param loops  edges of all loops of the face, each loop closed
    /// @param until  what lies beyond is not met; input steps along the ray, in double: nothing may lie near it
    Crossing meet(const Plane& face, std::span<const Edge> loops, double until) const;

private:
    /// Whether a point of the face's plane lies in the face: 1 or 0; -1: on an edge.
    int encloses(const Plane& face, std::span<const Edge> loops, const ExactPoint& point) const;

    const ExactPoint from_;
    std::array<Plane, 3> own_;            ///< of a point of the grid
    std::array<const Plane*, 3> planes_;  ///< the ray runs along the first two
    int sign_ = 1;                        ///< as their normals' cross product, or against it
    Vec3 direction_;
};

/// How often a ray crosses the faces of a boundary, odd or even.
class CrossingCount {
public:
    /// @return whether others are still to be asked
    bool add(ExactRay::Crossing crossing) {
        odd_ ^= crossing == ExactRay::Crossing::kCrosses;
        unsure_ |= crossing == ExactRay::Crossing::kUnsure;
        on_ |= crossing == ExactRay::Crossing::kOn;
        return sure();
    }
    bool begins_on_one() const { return on_; }
    bool sure() const { return !unsure_ && !on_; }
    bool odd() const { return odd_; }

private:
    bool odd_ = false, unsure_ = false, on_ = false;
};

}  // namespace firma
