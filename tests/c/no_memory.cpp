// SPDX-License-Identifier: MIT
// The C API when memory runs out, at every allocation of a call in turn: the code says so, nothing has changed, nothing
// has leaked. A program of its own, as operator new fails on demand.
#include <gtest/gtest.h>

#include "firma/firma_c.h"
#include "tests/failing_new.h"

namespace {

/// Calls with memory for so many allocations; whether that was too few.
template <class Call>
bool runs_out(long allocations, firma_code& code, const Call& call) {
    return firma::tests::runs_out(allocations, [&] { code = call(); });
}

firma_world make_room() {
    const double positions[] = {0, 0, 0, 8, 0, 0, 8, 8, 0, 0, 8, 0, 0, 0, 4, 8, 0, 4, 8, 8, 4, 0, 8, 4};
    const uint32_t corners[] = {0, 1, 2, 3, 4, 7, 6, 5, 0, 4, 5, 1, 1, 5, 6, 2, 2, 6, 7, 3, 3, 7, 4, 0};
    const uint32_t counts[] = {4, 4, 4, 4, 4, 4};
    firma_mesh mesh{};
    mesh.size = sizeof mesh;
    mesh.positions = positions;
    mesh.vertex_count = 8;
    mesh.corners = corners;
    mesh.corner_counts = counts;
    mesh.face_count = 6;
    firma_world world{};
    EXPECT_EQ(firma_world_from_mesh(&mesh, "room", nullptr, &world), FIRMA_OK);
    return world;
}

uint64_t hash_of(firma_world world) {
    uint64_t hash = 0;
    EXPECT_EQ(firma_world_hash(world, &hash), FIRMA_OK);
    return hash;
}

class NoMemory : public testing::Test {
protected:
    NoMemory() { EXPECT_EQ(firma_cutter_crater(FIRMA_ROCKY, 1, &cutter), FIRMA_OK); }
    ~NoMemory() override {
        EXPECT_EQ(firma_world_release(room), FIRMA_OK);
        EXPECT_EQ(firma_cutter_release(cutter), FIRMA_OK);
        EXPECT_EQ(firma_live_handles(), 0u);
    }

    firma_world cut(firma_world from, double x) {
        const firma_pose there{{x, 4, 0}, {0, 0, 0, 1}, 1};
        firma_world after{};
        EXPECT_EQ(firma_carve(from, cutter, &there, nullptr, &after, nullptr), FIRMA_OK);
        return after;
    }

    const firma_world room = make_room();
    firma_cutter cutter{};
    const firma_pose pose{{4, 4, 0}, {0, 0, 0, 1}, 1};
};

TEST_F(NoMemory, CarveChangesNothing) {
    const firma_world whole = cut(room, 4);
    const uint64_t before = hash_of(room), after = hash_of(whole);
    const size_t held = firma_live_handles();
    long allocations = 0;
    for (;; ++allocations) {
        firma_world made{77};
        firma_code code;
        const auto carve = [&] { return firma_carve(room, cutter, &pose, nullptr, &made, nullptr); };
        if (!runs_out(allocations, code, carve)) {
            EXPECT_EQ(code, FIRMA_OK);
            EXPECT_EQ(hash_of(made), after);
            firma_world_release(made);
            break;
        }
        ASSERT_EQ(code, FIRMA_ERROR_NO_MEMORY) << allocations;
        ASSERT_EQ(made.id, 77u);
        ASSERT_EQ(firma_live_handles(), held);
    }
    EXPECT_GT(allocations, 100);
    EXPECT_EQ(hash_of(room), before);
    EXPECT_EQ(firma_world_check(room), FIRMA_OK);
    firma_world_release(whole);
}

TEST_F(NoMemory, AJobIsOver) {
    long allocations = 0;
    for (;; ++allocations) {
        firma_job job{};
        ASSERT_EQ(firma_job_start(room, cutter, &pose, nullptr, &job), FIRMA_OK);
        uint32_t finished = 0;
        const auto run = [&] {
            firma_code code = FIRMA_OK;
            while (code == FIRMA_OK && !finished) code = firma_job_run(job, 0, &finished);
            return code;
        };
        firma_code code;
        const bool out = runs_out(allocations, code, run);
        if (out) {
            ASSERT_EQ(code, FIRMA_ERROR_NO_MEMORY) << allocations;
            firma_world made{77};
            ASSERT_EQ(firma_job_run(job, 0, &finished), FIRMA_ERROR_NO_MEMORY) << allocations;
            ASSERT_EQ(firma_job_result(job, &made, nullptr), FIRMA_ERROR_NO_MEMORY) << allocations;
            ASSERT_EQ(made.id, 77u);
            ASSERT_EQ(finished, 0u);
        }
        ASSERT_EQ(firma_job_release(job), FIRMA_OK);
        if (!out) break;
    }
    EXPECT_GT(allocations, 100);
}

/// A bar from wall to wall whose one end is cut: cutting the other, its middle comes loose.
class ChunksWithoutMemory : public NoMemory {
protected:
    ChunksWithoutMemory() {
        firma_world bridge{};
        const firma_carve_options fill{sizeof fill, 1, nullptr, 0, 0, {}, 0, 0, 0, 0};
        for (const double x : {0.0, 2.0, 4.0, 6.0, 8.0}) put(x, fill, bridge);
        put(1, asking, bridge);
        cut_bridge = bridge;
    }
    ~ChunksWithoutMemory() override { firma_world_release(cut_bridge); }

    /// A cube of 2 m around (x, 4, 2.1), added or taken away.
    void put(double x, const firma_carve_options& options, firma_world& now) {
        firma_cutter box{};
        firma_world after{};
        EXPECT_EQ(firma_cutter_crater(FIRMA_BOX, 0, &box), FIRMA_OK);
        const firma_pose there{{x, 4, 2.1}, {0, 0, 0, 1}, options.fill ? 1.0 : 1.1};
        EXPECT_EQ(firma_carve(now.id ? now : room, box, &there, &options, &after, nullptr), FIRMA_OK);
        firma_world_release(now);
        firma_cutter_release(box);
        now = after;
    }

    const firma_carve_options asking{sizeof asking, 0, nullptr, 0, 0, {}, 1, 0, 0, 0};
    firma_world cut_bridge{};
};

/// Neither the world, nor the edit that goes on, nor the list of chunks is left half made.
TEST_F(ChunksWithoutMemory, AnEditChangesNothing) {
    firma_cutter box{};
    EXPECT_EQ(firma_cutter_crater(FIRMA_BOX, 0, &box), FIRMA_OK);
    const firma_pose there{{7, 4, 2.1}, {0, 0, 0, 1}, 1.1};
    firma_edit edit{};
    ASSERT_EQ(firma_edit_begin(cut_bridge, &edit), FIRMA_OK);
    const size_t held = firma_live_handles();
    long allocations = 0;
    for (;; ++allocations) {
        firma_carve_report report{};
        report.size = sizeof report;
        firma_code code;
        const auto carve = [&] { return firma_edit_carve(edit, box, &there, &asking, &report); };
        if (!runs_out(allocations, code, carve)) {
            EXPECT_EQ(code, FIRMA_OK);
            EXPECT_EQ(report.chunks, 1u);
            EXPECT_EQ(firma_live_handles(), held + 1);
            EXPECT_EQ(firma_chunks_release(report.loose), FIRMA_OK);
            break;
        }
        ASSERT_EQ(code, FIRMA_ERROR_NO_MEMORY) << allocations;
        ASSERT_EQ(firma_live_handles(), held) << allocations;
        firma_world now{};
        ASSERT_EQ(firma_edit_finish(edit, &now), FIRMA_OK);
        ASSERT_EQ(hash_of(now), hash_of(cut_bridge)) << allocations;
        firma_world_release(now);
    }
    EXPECT_GT(allocations, 100);
    firma_edit_release(edit);
    firma_cutter_release(box);
}

/// A store whose current version stands between one before and one undone, and what it says of itself.
class StoreWithoutMemory : public NoMemory {
protected:
    StoreWithoutMemory() {
        EXPECT_EQ(firma_store_open(room, 1 << 24, &store), FIRMA_OK);
        EXPECT_EQ(firma_store_publish(store, room, first), FIRMA_OK);
        EXPECT_EQ(firma_store_publish(store, first, second), FIRMA_OK);
        firma_world back{};
        EXPECT_EQ(firma_store_undo(store, &back), FIRMA_OK);
        EXPECT_EQ(hash_of(back), hash_of(first));
        firma_world_release(back);
    }
    ~StoreWithoutMemory() override {
        for (const firma_world world : {first, second, other}) firma_world_release(world);
        EXPECT_EQ(firma_store_release(store), FIRMA_OK);
    }

    void expect_unchanged(const firma_store_facts& before, long allocations) {
        firma_store_facts after{};
        after.size = sizeof after;
        ASSERT_EQ(firma_store_get_facts(store, &after), FIRMA_OK);
        ASSERT_EQ(after.current, before.current) << allocations;
        ASSERT_EQ(after.newest, before.newest) << allocations;
        ASSERT_EQ(after.versions, before.versions) << allocations;
        ASSERT_EQ(after.bytes, before.bytes) << allocations;
        firma_world current{};
        ASSERT_EQ(firma_store_current(store, &current), FIRMA_OK);
        ASSERT_EQ(hash_of(current), hash_of(first)) << allocations;
        firma_world_release(current);
    }

    firma_store store{};
    const firma_world first = cut(room, 3), second = cut(first, 5), other = cut(first, 6);
};

TEST_F(StoreWithoutMemory, PublishChangesNothing) {
    firma_store_facts before{};
    before.size = sizeof before;
    ASSERT_EQ(firma_store_get_facts(store, &before), FIRMA_OK);
    for (long allocations = 0;; ++allocations) {
        firma_code code;
        if (!runs_out(allocations, code, [&] { return firma_store_publish(store, first, other); })) {
            EXPECT_EQ(code, FIRMA_OK);
            EXPECT_GT(allocations, 3);
            break;
        }
        ASSERT_EQ(code, FIRMA_ERROR_NO_MEMORY);
        ASSERT_NO_FATAL_FAILURE(expect_unchanged(before, allocations));
    }
}

TEST_F(StoreWithoutMemory, UndoAndRedoChangeNothing) {
    firma_store_facts before{};
    before.size = sizeof before;
    ASSERT_EQ(firma_store_get_facts(store, &before), FIRMA_OK);
    for (const auto step : {firma_store_undo, firma_store_redo}) {
        firma_code code;
        firma_world world{77};
        ASSERT_TRUE(runs_out(0, code, [&] { return step(store, &world); }));
        EXPECT_EQ(code, FIRMA_ERROR_NO_MEMORY);
        EXPECT_EQ(world.id, 77u);
        expect_unchanged(before, 0);
    }
}

}  // namespace
