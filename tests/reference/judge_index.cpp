// SPDX-License-Identifier: MIT
// Judges that an index is free.
#include "tests/reference/judge_index.h"

#include <array>

#include "firma/save.h"
#include "firma/solid.h"
#include "firma/versions.h"
#include "tests/reference/judge_cut.h"
#include "tests/reference/world_facets.h"

namespace firma::reference {
namespace {

constexpr std::size_t kCutsAFile = 16, kMostFailures = 8;

const std::array<TreeOptions, 3> kKinds{TreeOptions{}, TreeOptions{.split = Split::kSurfaceArea},
                                        TreeOptions{.max_depth = 0, .faces_per_leaf = 64}};

std::vector<std::uint32_t> ids_of(const World& world) {
    std::vector<std::uint32_t> ids;
    for (const FacetPlace& facet : all_facets(world)) ids.push_back(facet.record().id.value);
    return ids;
}

/// What must not depend on an index.
struct Answers {
    std::uint64_t world = 0, solid = 0;
    std::vector<RegionHash> regions, solid_regions;
    std::vector<std::uint32_t> ids;
    std::vector<std::byte> bytes;  ///< only now and then

    Answers(const World& of, bool packs)
        : world(hash_world(of)),
          solid(hash_solid(of)),
          regions(hash_regions(of)),
          solid_regions(hash_regions(of.solid())),
          ids(ids_of(of)) {
        if (packs) bytes = pack_world(of, {.index = false});
    }
};

/// Empty when nothing differs.
std::string difference(const Answers& one, const Answers& two) {
    if (one.world != two.world) return "hash_world";
    if (one.solid != two.solid) return "hash_solid";
    if (one.regions != two.regions) return "hash_regions";
    if (one.solid_regions != two.solid_regions) return "hash_regions of the solid";
    if (one.ids != two.ids) return "ids";
    if (one.bytes != two.bytes) return "bytes of pack_world";
    return "";
}

bool same_ending(const CarveResult& one, const CarveResult& two) {
    const CarveReport &a = one.report, &b = two.report;
    return one.status == two.status && one.error.text() == two.error.text() && one.reproduction == two.reproduction &&
           a.candidate_faces == b.candidate_faces && a.faces_cut == b.faces_cut && a.faces_removed == b.faces_removed &&
           a.faces_added == b.faces_added && a.faces_castable_only == b.faces_castable_only && a.retries == b.retries &&
           a.scale == b.scale && a.volume == b.volume;
}

class IndexJudge {
public:
    explicit IndexJudge(const std::function<World(const TreeOptions&)>& make) {
        for (const TreeOptions& kind : kKinds) worlds_.push_back(make(kind));
        worlds_.push_back(worlds_[0]);
    }

    void cut(const scenes::CutOrder& order, bool packs) {
        std::vector<CarveResult> results;
        for (const World& world : worlds_) results.push_back(make_cut(world, order));
        std::string wrong;
        std::vector<std::pair<std::size_t, std::size_t>> differences;
        for (std::size_t k = 0; k < worlds_.size(); ++k) {
            const WorldDiff diff = diff_worlds(worlds_[k], results[k].world);
            differences.emplace_back(diff.removed.size(), diff.added.size());
            worlds_[k] = results[k].world;
            if (!same_ending(results[k], results[0])) wrong = "how it ended, kind " + std::to_string(k);
        }
        const Answers first(worlds_[0], packs);
        for (std::size_t k = 1; k < worlds_.size() && wrong.empty(); ++k) {
            wrong = difference(first, Answers(worlds_[k], packs));
            if (wrong.empty() && differences[k] != differences[0]) wrong = "diff_worlds";
            if (!wrong.empty()) wrong += ", kind " + std::to_string(k);
        }
        const std::uint64_t number = tally_.cuts++;
        tally_.done += results[0].status == CarveStatus::kDone;
        tally_.nothing += results[0].status == CarveStatus::kNothing;
        tally_.refused += results[0].status == CarveStatus::kRefused;
        tally_.packed += packs ? worlds_.size() : 0;
        if (!wrong.empty()) fail("cut " + std::to_string(number) + ": " + wrong);
        worlds_.back() = rebuild_index(worlds_.back(), kKinds[++tally_.rebuilds % kKinds.size()]);
    }

    IndexTally finish() {
        for (const World& world : worlds_) {
            if (const std::optional<WorldFault> fault = check_world(world)) fail("check_world: " + fault->what);
            if (const std::optional<SolidFault> fault = check_solid(world)) fail("check_solid: " + fault->what);
        }
        return std::move(tally_);
    }

private:
    void fail(const std::string& text) {
        ++tally_.failed;
        if (tally_.failures.size() < kMostFailures) tally_.failures.push_back(text);
    }

    std::vector<World> worlds_;  ///< one a kind, then the one with its index built anew
    IndexTally tally_;
};

}  // namespace

IndexTally judge_index(const std::function<World(const TreeOptions&)>& make, std::span<const scenes::CutOrder> cuts) {
    IndexJudge judge(make);
    for (std::size_t k = 0; k < cuts.size(); ++k)
        judge.cut(cuts[k], k % kCutsAFile == kCutsAFile - 1 || k + 1 == cuts.size());
    return judge.finish();
}

std::vector<scenes::CutOrder> cuts_of_our_level(const Level& ours, std::uint64_t seed, std::size_t count) {
    std::vector<scenes::CutOrder> cuts;
    for (std::uint64_t index = 0; cuts.size() < count; ++index)
        for (const scenes::CutFamily& family : scenes::cut_families()) {
            if (!family.name.starts_with("our_level_")) continue;
            for (scenes::CutOrder& order : scenes::make_cut_case(family, seed, index, ours).cuts)
                cuts.push_back(std::move(order));
        }
    cuts.resize(count);
    for (std::size_t k = 7; k < count; k += 8) cuts[k].kind = CarveKind::kFill;
    return cuts;
}

}  // namespace firma::reference
