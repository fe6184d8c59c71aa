// SPDX-License-Identifier: MIT
// What a body is made of: how much of it is of which matter, exactly. The pieces of the level are cut out of it one
// after the other, in the order in which they win; what is left at the end is in none of them.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "carve/cut_job.h"
#include "solid/matter_pieces.h"
#include "solid/moment_sum.h"

namespace firma {

/// The matter of all that lies in a box, where it is of one, filled in or not; nothing where it may be of several.
/// @param box  surface steps, rounded by a step at most
std::optional<std::uint32_t> only_matter_in(const MatterPieces& pieces, const GridBox& box);

/// Works in pieces of some ten microseconds, but for what cuts begin with.
class MatterShares {
public:
    struct Share {
        std::uint32_t matter = 0;
        Moments moments;  ///< about the apex
    };

    /// @param solid     where it lay in the world; encloses volume
    /// @param box       around it, surface steps, rounded by a step at most
    /// @param apex      near it
    /// @param pieces    lives as long as this, as `rules`, which may be null
    /// @param solid_of  a piece as a solid; nothing for one without volume
    MatterShares(Solid solid, const GridBox& box, const InputPoint& apex, const MatterPieces& pieces,
                 const CarveRules* rules, std::function<std::optional<Solid>(const MatterPiece&)> solid_of);

    /// Does one piece of work; false once there is none left.
    bool step();

    // Once step() said false:
    /// Ascending by matter, each once. A piece that cannot be cut out, see carve(), counts as what comes after it.
    const std::vector<Share>& shares() const { return shares_; }
    /// Of all of it.
    const Moments& total() const { return total_; }

private:
    void list_pieces(const GridBox& box, const CarveRules* rules, const SolidPatch& patch);
    void start(const MatterPiece& piece);
    void take_share();
    void settle();
    void add(std::uint32_t matter, const Moments& moments);
    /// Whether a closed mesh holds all of the whole body (true) or none of it (false); nothing where it holds some.
    std::optional<bool> holds_all(const Solid& mesh) const;

    const Solid whole_;
    const InputPoint apex_;
    const MatterPieces& pieces_;
    const std::function<std::optional<Solid>(const MatterPiece&)> solid_of_;
    std::vector<std::uint32_t> order_;  ///< pieces to be cut out
    std::uint32_t last_ = 0;            ///< the matter of what is left then
    std::size_t next_ = 0;              ///< in order_
    Solid left_;
    std::optional<std::uint32_t> taken_;  ///< the matter of what was cut out of it since `moments_left_`
    Moments total_, moments_left_;
    std::unique_ptr<CutJob> job_;  ///< with order_[next_]
    std::vector<Share> shares_;
};

}  // namespace firma
