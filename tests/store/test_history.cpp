// SPDX-License-Identifier: MIT
// The row of versions and its sums, against sums made anew from all of it.
#include "store/history.h"

#include <gtest/gtest.h>

#include <vector>

#include "scenes/rng.h"
#include "world/world_data.h"

namespace firma {
namespace {

World empty_world(std::uint64_t version) {
    auto data = std::make_shared<WorldData>();
    data->version = version;
    return World(data);
}

/// The same by the book.
struct Plain {
    struct Entry {
        std::uint64_t version;
        std::size_t lost;
    };
    std::vector<Entry> entries;
    std::size_t at = 0;

    std::size_t bytes() const {
        std::size_t sum = 0;
        for (std::size_t k = 1; k < entries.size(); ++k) sum += entries[k].lost;
        return sum;
    }
};

void expect_equal(const History& history, const Plain& plain) {
    ASSERT_EQ(history.size(), plain.entries.size());
    EXPECT_EQ(history.oldest().version(), plain.entries.front().version);
    EXPECT_EQ(history.current().version(), plain.entries[plain.at].version);
    EXPECT_EQ(history.newest().version(), plain.entries.back().version);
    EXPECT_EQ(history.can_undo(), plain.at > 0);
    EXPECT_EQ(history.can_redo(), plain.at + 1 < plain.entries.size());
    EXPECT_EQ(history.bytes(), plain.bytes());
    for (const Plain::Entry& entry : plain.entries) {
        ASSERT_TRUE(history.find(entry.version));
        EXPECT_EQ(history.find(entry.version)->version(), entry.version);
    }
    EXPECT_FALSE(history.find(plain.entries.front().version - 1));
    EXPECT_FALSE(history.find(plain.entries.back().version + 1));
}

TEST(History, SumsStayTrue) {
    scenes::Rng rng(3);
    History history(empty_world(100));
    Plain plain{{{100, 0}}, 0};
    for (int k = 0; k < 3000; ++k) {
        const std::uint32_t what = rng.below(6);
        if (what <= 1) {
            const std::size_t lost = rng.below(1000);
            std::vector<World> undone;
            undone.reserve(history.size());
            const std::uint64_t version = history.current().version() + 1 + rng.below(2);
            history.push(empty_world(version), lost, undone);
            for (const World& world : undone) {
                EXPECT_EQ(world.version(), plain.entries.back().version);
                plain.entries.pop_back();
            }
            EXPECT_EQ(plain.entries.size(), plain.at + 1);
            plain.entries.push_back({version, lost});
            ++plain.at;
        } else if (what == 2 && history.can_undo()) {
            history.undo();
            --plain.at;
        } else if (what == 3 && history.can_redo()) {
            history.redo();
            ++plain.at;
        } else if (what == 4 && history.can_undo() && rng.chance(0.4)) {
            EXPECT_EQ(history.take_oldest().version(), plain.entries.front().version);
            plain.entries.erase(plain.entries.begin());
            --plain.at;
        } else if (what == 5 && history.can_redo() && rng.chance(0.4)) {
            EXPECT_EQ(history.take_newest().version(), plain.entries.back().version);
            plain.entries.pop_back();
        }
        expect_equal(history, plain);
        if (HasFailure()) return;
    }
    EXPECT_GT(plain.entries.size(), 3u);
}

}  // namespace
}  // namespace firma
