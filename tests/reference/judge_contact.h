// SPDX-License-Identifier: MIT
// Judges what must hold of a cut beyond judge_cut(), whatever touches: no face lies on another, the same cut again does
// nothing, the opposite cut and the cut again give an equal solid, the order of two carvings or two fillings does not
// count, and points lie where the level and all cutters so far put them.
#pragma once

#include <string>

#include "tests/reference/cut_history.h"
#include "tests/reference/judge_cut.h"

namespace firma::reference {

class ContactJudge {
public:
    /// @param level  before any cut
    ContactJudge(const World& level, const JudgeOptions& options) : history_(level), options_(options) {}

    /// Judges the next cut.
    /// @return whether all holds
    bool judge(const World& before, const scenes::CutOrder& order, const CarveResult& result, scenes::Rng& rng,
               const std::string& where, CutTally& tally);

    /// What went wrong once is told once: from here on points lie where this world has them.
    void start_again(const World& world) { history_ = CutHistory(world); }

private:
    CutHistory history_;
    const JudgeOptions options_;
};

}  // namespace firma::reference
