// SPDX-License-Identifier: MIT
// Judges a cut by all that must hold after every edit: edges, faces, volume, tree, leaks, slices, the world before.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "carve/place_cutter.h"
#include "firma/carve.h"
#include "scenes/cut_families.h"
#include "scenes/rng.h"

namespace firma::reference {

/// What judging came to. Adds up.
struct CutTally {
    std::uint64_t cuts = 0, done = 0, nothing = 0, refused = 0;
    std::uint64_t unplaceable = 0;  ///< refused for the cutter: no area on the grid, crossing itself, out of the world
    std::uint64_t blamed = 0;       ///< refused, and the library is to blame: degenerate position, a contradiction
    std::uint64_t sliced = 0;       ///< made again in slices
    std::uint64_t commuted = 0;     ///< pairs of disjoint cuts made in both orders
    std::uint64_t reseamed = 0;     ///< of those, with the same solid but its large faces divided otherwise
    std::uint64_t replayed = 0;     ///< made once more, a whole case from its level, and the last world was the same
    std::uint64_t points = 0, rays = 0, casts = 0;
    std::uint64_t protected_points = 0;  ///< of points: in the cutter, and in what may not be carved
    std::uint64_t room_casts = 0;        ///< of worlds with rooms: casts by room against casts of all faces ...
    std::uint64_t crossings = 0;         ///< ... of which so many went through portals
    std::uint64_t ways = 0;              ///< of worlds with rooms: pairs of points in the air
    std::uint64_t holed = 0;             ///< cuts that made a portal
    std::uint64_t shared_edges = 0;      ///< edges that more than two facets use, over all cuts
    // Of cuts in contact.
    std::uint64_t again = 0;           ///< made again where they were
    std::uint64_t reversed = 0;        ///< followed by the opposite one, and made again
    std::uint64_t grown = 0;           ///< of those, of more exact faces than before
    std::uint64_t history_points = 0;  ///< that lie where the level and all cutters put them
    double carve_seconds = 0;
    struct Refusals {
        std::uint64_t count = 0;
        std::string first;  ///< the cut that met it first
    };
    std::map<std::string, Refusals> refusals;  ///< by reason, numbers left out
    std::map<std::string, Refusals> kinds;     ///< of failures, likewise
    std::uint64_t failed = 0;                  ///< cuts with at least one failure
    std::vector<std::string> failures;         ///< the first few

    /// Of the cuts refused, how many had a cutter that can be placed.
    std::uint64_t refused_in_place() const { return refused - unplaceable; }

    void add(const CutTally& other);
    /// @param where  what it takes to see it again
    void fail(const std::string& where, const std::string& what);
};

struct JudgeOptions {
    int casts = 40, rays = 24, points = 8;
    double slices = 0.25;  ///< share of cuts made again in slices
    bool volume = true;
    std::size_t most_cuts = ~std::size_t(0);  ///< of a case
    bool contact = false;                     ///< judged by judge_contact.h too, and no cut may be refused
    int history_points = 24;                  ///< of a cut in contact
    double back = 0.5;                        ///< share of cuts in contact made back and forth
};

/// Makes a cut and judges it.
/// @param world  before; replaced by the world after
/// @param where  for failures: what it takes to see the cut again
/// @return how it ended
CarveResult judge_cut(World& world, const scenes::CutOrder& order, scenes::Rng& rng, const std::string& where,
                      CutTally& tally, const JudgeOptions& options = {});

/// Cuts one after another, and neighbouring ones that are disjoint in both orders; then all of them again from another
/// world, which must end in the same bits.
/// @param world  made of a level
/// @param again  made of the same level anew: in memory laid out otherwise
/// @param name   for failures: what it takes to see the cuts again
CutTally judge_cuts(World world, World again, std::span<const scenes::CutOrder> cuts, const std::string& name,
                    std::uint64_t seed, const JudgeOptions& options = {});

/// The same for a case of a family.
CutTally judge_case(const scenes::CutFamily& family, std::uint64_t seed, std::uint64_t index, const Level& ours,
                    const JudgeOptions& options = {});

/// From now on the library's asserts of contradictions do not end the program: the judge tells of them, with what it
/// takes to see them again.
void report_contradictions();
/// The same for as long as this lives: for a test among others.
struct ContradictionsReported {
    ContradictionsReported() { report_contradictions(); }
    ~ContradictionsReported();
};

CarveResult make_cut(const World& world, const scenes::CutOrder& order);

/// A cutter as an edit had it at last: shrunk by rules; nothing when it cannot be placed.
std::optional<PlacedCutter> placed_cutter(const scenes::CutOrder& order, const CarveReport& report);

/// The first directed edge of the solid's facets, of all rooms, that is not used as often the other way; empty when all
/// are.
std::string open_edge(const World& world, std::uint64_t* shared_edges = nullptr);

}  // namespace firma::reference
