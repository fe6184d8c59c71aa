// SPDX-License-Identifier: MIT
// Which pieces of a solid a cut leaves loose, found from the faces that it made.
//
// Groups of these faces that come from one shell grow in turn, a face each, until one is left, or all that are left are
// held: what runs out of faces is a whole shell. One that encloses volume and that no anchor holds is loose. The one
// left over is looked at as well where what held the shell before the cut may be in another: then it grows on until it
// meets an anchor or is whole. So the cost follows the smaller pieces.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "carve/face_groups.h"
#include "firma/solid.h"

namespace firma {

/// A piece with the shells of its hollows.
struct LoosePiece {
    std::vector<std::uint32_t> made;  ///< faces that the cut made, by number of CutFaces
    std::vector<FacetPlace> faces;    ///< that the solid had before: a facet of each
    double volume = 0;                ///< cubic metres
    GridBox box;
};

class LooseSearch {
public:
    /// @param solid    before the cut
    /// @param cut      what it made of it; kept by the caller, as are the anchors
    LooseSearch(const Solid& solid, const CutFaces& cut, const Anchors& anchors);

    /// Does one piece of work, some ten microseconds, but for what a piece costs that is loose; false once there is
    /// none left.
    bool step();

    /// Once step() said false.
    std::vector<LoosePiece>& pieces() { return pieces_; }
    /// How many faces were looked for beyond those that the cut met.
    std::size_t searched() const { return groups_.searched(); }

private:
    enum class Phase : std::uint8_t { kGroup, kFlood, kRest, kTake, kEnd };

    Phase group();
    Phase next_family();
    Phase flood();
    Phase judge(const std::vector<std::uint32_t>& unfinished);
    Phase look_at_rest();
    Phase take_next();
    std::vector<std::uint32_t> lost_anchors() const;
    void judge_whole(std::uint32_t group);
    bool holds_a_volume(std::uint32_t group);
    bool cuts_a_volume() const;
    double volume_of(const std::vector<LiveFace>& faces);
    std::vector<std::uint32_t> hollows_of(std::uint32_t group);
    Solid solid_of_group(std::uint32_t group);
    bool lies_in(std::uint32_t group, const Solid& body);

    const Solid solid_;
    const CutFaces& cut_;
    const Anchors& anchors_;
    FaceGroups groups_;
    Phase phase_ = Phase::kGroup;

    std::vector<FaceGroups::Family> families_;
    std::size_t family_ = 0;
    std::vector<std::uint32_t> growing_;  ///< groups of the family at hand
    std::size_t turn_ = 0;
    std::size_t looks_ = 0;            ///< for a quick proof, at one of them after the other
    bool may_hold_elsewhere_ = false;  ///< what held the family may be in a group that is whole
    std::uint32_t rest_ = 0;
    struct Loose {
        std::uint32_t group;
        double volume;
    };
    std::vector<Loose> loose_;
    std::size_t next_ = 0;
    std::vector<LoosePiece> pieces_;
    std::vector<ExactPoint> corners_;
};

}  // namespace firma
