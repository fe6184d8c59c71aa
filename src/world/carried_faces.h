// SPDX-License-Identifier: MIT
// What is castable only and goes with loose pieces: what stands on them, lies on them or is around them, and is held by
// nothing else.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "base/flat_map.h"
#include "carve/cut_job.h"
#include "solid/face_store.h"

namespace firma {

/// Works in pieces of some ten microseconds. Faces that hang together by corners are one body. It goes, whole, where a
/// face of it touches a facet of a piece, and none of it touches solid that stays. Faces touch where their boxes do.
/// A body that is held costs the faces until the first that is; one that goes, all of them.
class CarriedFaces {
public:
    /// What is given is kept alive by the caller.
    /// @param open    the faces that are castable only
    /// @param solid   before the cut
    /// @param change  what the cut makes of it, pieces gone
    /// @param may_go  all others are part of no body
    CarriedFaces(const FaceStore& open, const Solid& solid, const SolidChange& change, std::span<const CutPiece> pieces,
                 std::function<bool(const FaceRecord&)> may_go);

    /// Does one piece of work; false once there is none left.
    bool step();
    /// Once step() said false: each once.
    const std::vector<FacetPlace>& faces() const { return faces_; }

private:
    void add_seeds(const GridBox& box);
    bool is_held(const FacetPlace& face);
    void look_at(const FacetPlace& face);
    void end_body(bool held);

    const FaceStore& open_;
    const Solid& solid_;
    const SolidChange& change_;
    const std::function<bool(const FaceRecord&)> may_go_;
    FlatMap removed_;    ///< ids of the solid's facets that go
    GridBox added_box_;  ///< around those that come
    std::vector<FacetPlace> seeds_;
    std::size_t next_seed_ = 0;
    FlatMap body_of_;                      ///< of a face, by id
    std::vector<std::uint8_t> held_;       ///< of a body
    std::vector<FacetPlace> body_, near_;  ///< at hand
    std::size_t next_face_ = 0;
    std::vector<FacetPlace> faces_;
};

}  // namespace firma
