// SPDX-License-Identifier: MIT
// Which ids new faces get. An edit without a number of its own takes the next ones of the world's counter, below 2^31.
// One that was given its number has ids above, 1024 for each number, whatever edits were made before it: so worlds that
// lack different earlier edits still agree on them.
#pragma once

#include <algorithm>
#include <cstdint>

namespace firma {

/// Ids from here on follow from numbers of edits.
inline constexpr std::uint32_t kFirstNumberedFace = std::uint32_t(1) << 31;
/// Faces of one edit beyond so many take their ids from the world's counter.
inline constexpr std::uint32_t kIdsAnEdit = 1024;
/// The highest number that an edit can be given: its ids end below the one that says "no face".
inline constexpr std::uint32_t kLastEditNumber = (std::uint32_t(1) << 21) - 1;

/// The first id of the faces of an edit that was given a number, 1 to kLastEditNumber.
inline std::uint32_t first_id_of_edit(std::uint32_t number) {
    return kFirstNumberedFace + (number - 1) * kIdsAnEdit;
}

/// Whether an id was given before, by these counters.
inline bool was_given(std::uint32_t id, std::uint32_t next_face, std::uint32_t edits) {
    if (id < next_face) return true;
    return id >= kFirstNumberedFace && (id - kFirstNumberedFace) / kIdsAnEdit < edits;
}

/// Takes the ids of one edit's faces, in order.
class FaceIds {
public:
    /// @param number  of the edit, 0: it was given none
    FaceIds(std::uint32_t next_face, std::uint32_t number)
        : counter_(next_face),
          numbered_(number > 0 ? first_id_of_edit(number) : 0),
          numbered_left_(number > 0 ? kIdsAnEdit : 0) {}

    /// Whether there are so many.
    bool has(std::size_t count) const {
        const std::size_t counted = count - std::min<std::size_t>(count, numbered_left_);
        return counter_ <= kFirstNumberedFace && counted <= kFirstNumberedFace - counter_;
    }
    std::uint32_t take() {
        if (numbered_left_ == 0) return counter_++;
        --numbered_left_;
        return numbered_++;
    }
    /// The counter after those taken.
    std::uint32_t next_face() const { return counter_; }

private:
    std::uint32_t counter_, numbered_, numbered_left_;
};

}  // namespace firma
