// SPDX-License-Identifier: MIT
// The slow, obviously right oracle of the casts: what the contract demands of a cast among polygons, over all faces,
// exactly.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "firma/hit.h"
#include "firma/polygon.h"
#include "tests/reference/exact_polygon.h"
#include "tests/reference/surely_apart.h"

namespace firma::reference {

struct Cast {
    Sphere sphere;
    Vec3 path;
    Sides sides = Sides::kFront;
};

/// What a cast must answer.
struct Expected {
    Status status = Status::kMiss;
    Root at;                           ///< the fraction, exactly
    std::vector<std::uint32_t> faces;  ///< all that are met at that fraction
    Feature feature = Feature::kFace;  ///< where the first of them is met: the lowest that holds the point
    std::uint32_t feature_index = 0;

    bool touched() const { return status == Status::kHit || status == Status::kInitialOverlap; }
    /// Rounded down.
    std::string fraction_text(int digits = 25) const { return decimals(at, digits); }
};

/// How one face by itself is met.
enum class Meeting : std::uint8_t {
    kNot,  ///< never within the radius, or not to be met from this side
    kHit,
    kInitialOverlap,
    kIgnored,  ///< touched or overlapped from the start, and not getting deeper
};

struct Face {
    ExactPolygon exact;
    Hull hull;
    bool two_sided = false;
};

class ExactOracle {
public:
    /// @param polygons   as cast_polygon() takes them
    /// @param two_sided  a flag a polygon, or empty
    explicit ExactOracle(const std::vector<std::vector<Vec3>>& polygons, const std::vector<bool>& two_sided = {});

    /// Over all faces.
    Expected expect(const Cast& cast) const;
    /// Over one.
    Expected expect(const Cast& cast, std::uint32_t face) const;
    /// Whether closed ball and closed polygon share a point.
    bool overlaps(const Sphere& sphere, std::uint32_t face) const;

    const std::vector<Face>& faces() const { return faces_; }
    /// Whether this side may be met at all: path . normal < 0, or both sides.
    bool considers(const Cast& cast, std::uint32_t face, const SeenPolygon& seen) const;

private:
    Expected expect_among(const Cast& cast, std::uint32_t first, std::uint32_t last) const;

    std::vector<Face> faces_;
};

/// Whether the contract calls the numbers of a cast valid: finite, at most 2^200, radius not negative.
bool is_valid(const Cast& cast);

}  // namespace firma::reference
