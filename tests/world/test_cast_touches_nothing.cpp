// SPDX-License-Identifier: MIT
// Casts write nothing of the world and allocate nothing. A test program of its own: everything that a world is made of
// lies in memory that is read-only while casts run, so a reference count touched, a mark left, a handle copied ends the
// program at once; and operator new counts.
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/mman.h>
#include <unistd.h>

#include <atomic>
#include <bit>
#include <cstdio>
#include <cstdlib>
#include <new>
#include <vector>

#include "firma/capsule.h"
#include "firma/hull.h"
#include "firma/memory.h"
#include "firma/queries.h"
#include "firma/rooms.h"
#include "scenes/divided_building.h"
#include "tests/store/cratered.h"
#include "world/world_data.h"

namespace {

/// Addresses for all that is ever taken from it; nothing is used again.
class Arena {
public:
    void* take(std::size_t bytes) {
        void* start = base();
        const std::size_t at = used_.fetch_add((bytes + 63) / 64 * 64);
        if (!start || at + bytes > kSize) return nullptr;
        return static_cast<std::byte*>(start) + at;
    }
    bool holds(const void* address) {
        const auto at = reinterpret_cast<std::uintptr_t>(address), from = reinterpret_cast<std::uintptr_t>(base());
        return at >= from && at < from + kSize;
    }
    bool protect(bool read_only) {
        return mprotect(base(), kSize, read_only ? PROT_READ : PROT_READ | PROT_WRITE) == 0;
    }

private:
    static constexpr std::size_t kSize = std::size_t(1) << 31;  // of addresses; memory comes as it is written

    void* base() {
        if (!base_) {
            void* mapped =
                mmap(nullptr, kSize, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
            if (mapped != MAP_FAILED) base_ = mapped;
        }
        return base_;
    }

    void* base_ = nullptr;
    std::atomic<std::size_t> used_ = 0;
};

constinit Arena pool_arena;    // blocks, rooms, exact faces
constinit Arena handle_arena;  // what operator new serves while a world is made: its WorldData and count of handles
constinit bool into_arena = false;
constinit std::size_t allocations = 0;

void* allocate(std::size_t bytes) {
    ++allocations;
    void* memory = into_arena ? handle_arena.take(bytes) : std::malloc(bytes ? bytes : 1);
    if (!memory) throw std::bad_alloc();
    return memory;
}

void release(void* memory) {
    if (memory && !handle_arena.holds(memory)) std::free(memory);
}

constexpr int kWritten = 66;

/// A write to read-only memory, by its address; anything else as ever.
void on_fault(int, siginfo_t* fault, void*) {
    if (pool_arena.holds(fault->si_addr) || handle_arena.holds(fault->si_addr)) {
        constexpr char kSaid[] = "a write to the world\n";
        [[maybe_unused]] const auto written = write(STDERR_FILENO, kSaid, sizeof kSaid - 1);
        _exit(kWritten);
    }
    signal(SIGSEGV, SIG_DFL);
}

}  // namespace

void* operator new(std::size_t bytes) {
    return allocate(bytes);
}
void* operator new[](std::size_t bytes) {
    return allocate(bytes);
}
void operator delete(void* memory) noexcept {
    release(memory);
}
void operator delete[](void* memory) noexcept {
    release(memory);
}
void operator delete(void* memory, std::size_t) noexcept {
    release(memory);
}
void operator delete[](void* memory, std::size_t) noexcept {
    release(memory);
}

namespace firma {
namespace {

constexpr int kCraters = 100;

World make_it() {
    const bool set = set_memory_source({[](std::size_t bytes, std::size_t, void*) { return pool_arena.take(bytes); },
                                        [](void*, std::size_t, std::size_t, void*) {}, nullptr});
    EXPECT_TRUE(set);
    into_arena = true;
    World world = test::building(12);
    into_arena = false;
    test::CraterMaker maker(4);
    for (int k = 0; k < kCraters; ++k) {
        into_arena = k + 1 == kCraters;  // the scratch of one cut is enough
        world = maker.next(world);
    }
    into_arena = false;
    struct sigaction action{};
    action.sa_sigaction = on_fault;
    action.sa_flags = SA_SIGINFO;
    sigaction(SIGSEGV, &action, nullptr);
    return world;
}

/// A building with a hundred craters. Never ends: its memory is read-only from time to time.
const World& the_world() {
    static const World& world = *new World(make_it());
    return world;
}

/// While it lives nothing of the world can be written.
class ReadOnly {
public:
    ReadOnly() { set(true); }
    ~ReadOnly() { set(false); }

private:
    static void set(bool read_only) {
        if (!pool_arena.protect(read_only) || !handle_arena.protect(read_only)) std::abort();
    }
};

struct Question {
    Sphere sphere;
    Vec3 path;
};

std::vector<Question> questions(std::size_t count) {
    scenes::Rng rng(6);
    std::vector<Question> all(count);
    for (Question& it : all) {
        for (int k = 0; k < 3; ++k) {
            const double room = k == 2 ? 0 : 13.5 * rng.below(2);
            it.sphere.centre[k] = room + rng.uniform(-1, k == 2 ? 7 : 13);
        }
        it.sphere.radius = rng.chance(0.3) ? 0 : rng.uniform(0.05, 0.5);
        const Vec3 direction = rng.direction();
        it.path = direction * rng.uniform(0.1, 20);
    }
    return all;
}

struct Asked {
    std::size_t touched = 0, any = 0, all = 0, near = 0, nearest = 0, edges = 0, hulls = 0, capsules = 0;
};

const Hull the_box = make_box({0.3, 0.2, 0.1}, {Vec3{0.6, 0.8, 0}, Vec3{-0.8, 0.6, 0}, Vec3{0, 0, 1}}).value();

/// @param hits, found  keep their memory from call to call
Asked ask(const World& world, const std::vector<Question>& all, std::vector<Hit>& hits, std::vector<Overlap>& found) {
    Asked asked;
    for (std::size_t k = 0; k < all.size(); ++k) {
        const Question& it = all[k];
        const Hit hit = cast(world, it.sphere, it.path);
        asked.touched += hit.touched();
        if (hit.feature == Feature::kEdge && hit.touched())
            asked.edges += other_face(world, hit.face, hit.feature_index).valid();
        const Status any = cast_any(world, it.sphere, it.path);
        asked.any += any == Status::kHit || any == Status::kInitialOverlap;
        asked.hulls += cast(world, the_box, it.sphere.centre, it.path).touched();
        asked.capsules += cast(world, make_capsule(it.sphere.centre, {0.6, 0, 0.8}, 0.3, 0.2), it.path).touched();
        if (k % 8 != 0) continue;
        cast_all(world, it.sphere, it.path, hits);
        asked.all += hits.size();
        overlap(world, {it.sphere.centre, 1}, found);
        asked.near += found.size();
        asked.nearest += closest(world, it.sphere.centre, 2).found();
        asked.nearest += locate(world.solid(), it.sphere.centre) == Where::kSolid;
    }
    return asked;
}

TEST(CastTouchesNothing, AllOfTheWorldIsInMemoryThatIsWatched) {
    const WorldData& data = the_world().data();
    EXPECT_TRUE(handle_arena.holds(&data));
    EXPECT_TRUE(handle_arena.holds(&data.solid.data()));
    std::size_t blocks = 0, owners = 0, outside = 0;
    std::vector<const Node*> waiting;
    data.room_faces.for_each([&](std::uint32_t, const Ref<const RoomFaces>& room) {
        EXPECT_TRUE(pool_arena.holds(room.get()));
        waiting.push_back(room->tree.get());
    });
    while (!waiting.empty()) {
        const Node& node = *waiting.back();
        waiting.pop_back();
        outside += !pool_arena.holds(&node) || !pool_arena.holds(node.wide.data());
        for (const Ref<const Node>& child : node.children) waiting.push_back(child.get());
        if (!node.is_leaf()) continue;
        const Block& block = block_of(node);
        ++blocks;
        outside += !pool_arena.holds(&block) || !pool_arena.holds(block.faces.data());
        outside += !pool_arena.holds(block.lanes.data());
        for (const Ref<const FaceOwner>& owner : block.owners) outside += !pool_arena.holds(owner.get());
        owners += block.owners.size();
    }
    EXPECT_EQ(outside, 0u);
    EXPECT_GT(blocks, 100u);
    EXPECT_GT(owners, 1000u) << "faces that cuts made";
}

TEST(CastTouchesNothing, AHundredThousandCastsWriteNothingAndAllocateNothing) {
    const World& world = the_world();
    const std::vector<Question> all = questions(100'000);
    std::vector<Hit> hits;
    std::vector<Overlap> found;
    const Asked before = ask(world, all, hits, found);  // the lists get their memory
    const long handles = world.handles();
    const std::uint64_t hash = hash_world(world);
    Asked asked;
    std::size_t allocated = 0;
    {
        const ReadOnly guard;
        const std::size_t start = allocations;
        asked = ask(world, all, hits, found);
        allocated = allocations - start;
    }
    EXPECT_EQ(allocated, 0u);
    EXPECT_EQ(world.handles(), handles);
    EXPECT_EQ(handles, 1);
    EXPECT_EQ(hash_world(world), hash);
    EXPECT_EQ(asked.touched, before.touched);
    EXPECT_GT(asked.touched, 30'000u);
    EXPECT_LT(asked.touched, all.size());
    EXPECT_EQ(asked.any, asked.touched);
    EXPECT_GT(asked.edges, 100u) << "these look for the face across";
    EXPECT_GT(asked.all, 10'000u);
    EXPECT_GT(asked.near, 10'000u);
    EXPECT_GT(asked.nearest, 5'000u);
    EXPECT_GT(asked.hulls, 1'000u);
    EXPECT_GT(asked.capsules, 1'000u);
}

/// Some hundred rooms with craters, a third of their doors closed. Never ends either.
const World& the_rooms() {
    static const World& world = *new World([] {
        the_world();  // sets the sources of memory
        into_arena = true;
        World made =
            assemble_world(
                scenes::DividedBuilding({.rooms_x = 6, .rooms_y = 6, .rooms_z = 2, .closed = 0.3, .seed = 9}).parts())
                .value();
        for (int k = 0; k < 10; ++k) {
            Pose pose;
            pose.position = {2 + 2.5 * k, 2 + 2.0 * k, 1};
            pose.scale = 0.7;
            made = carve(made, make_crater(CutterShape::kRocky, std::uint64_t(k)), pose).world;
        }
        into_arena = false;
        return made;
    }());
    return world;
}

Asked ask_by_room(const World& world, const std::vector<Question>& all, std::vector<Hit>& hits,
                  std::vector<Overlap>& found) {
    Asked asked;
    std::array<RoomId, 40> passed;
    for (const Question& it : all) {
        const Location where = locate(world, it.sphere.centre);
        const bool in_room = where.where == Where::kAir;
        RoomTrail trail{passed};
        const CastOptions by_room{.room = in_room ? where.room : kAnyRoom, .trail = &trail};
        const Hit hit = cast(world, it.sphere, it.path, by_room);
        asked.touched += hit.touched();
        asked.edges += trail.count > 2;
        asked.any += cast(world, it.sphere, it.path, {.room = kLocateRoom}).touched();
        asked.any += cast(world, it.sphere, it.path).status == Status::kInvalid;
        asked.any += cast_any(world, it.sphere, it.path, by_room) == Status::kInvalid;
        cast_all(world, it.sphere, it.path, hits, by_room);
        asked.all += hits.size();
        overlap(world, {it.sphere.centre, 1}, found, {.room = by_room.room});
        asked.near += found.size();
        asked.nearest += closest(world, it.sphere.centre, 2, {.room = by_room.room}).found();
    }
    return asked;
}

TEST(CastTouchesNothing, NorDoThoseFromRoomToRoom) {
    const World& world = the_rooms();
    EXPECT_GT(world.room_count(), 16u);
    EXPECT_TRUE(world.data().cells.any_closed());
    EXPECT_TRUE(pool_arena.holds(&world.data().cells.portal(0)));
    EXPECT_TRUE(pool_arena.holds(world.data().cells.portal_index().get()));
    std::vector<Question> all = questions(10'000);
    for (Question& it : all) it.sphere.centre = it.sphere.centre * 1.2 + Vec3{1, 1, 1};
    std::vector<Hit> hits;
    std::vector<Overlap> found;
    const Asked before = ask_by_room(world, all, hits, found);
    const long handles = world.handles();
    Asked asked;
    std::size_t allocated = 0;
    {
        const ReadOnly guard;
        const std::size_t start = allocations;
        asked = ask_by_room(world, all, hits, found);
        allocated = allocations - start;
    }
    EXPECT_EQ(allocated, 0u);
    EXPECT_EQ(world.handles(), handles);
    EXPECT_EQ(asked.touched, before.touched);
    EXPECT_EQ(asked.all, before.all);
    EXPECT_GT(asked.touched, 3'000u);
    EXPECT_EQ(asked.any, asked.touched);
    EXPECT_GT(asked.edges, 100u) << "these pass through portals";
    EXPECT_GT(asked.near, 3'000u);
}

// That the above can fail: each of these is what a careless cast might do.

TEST(CastTouchesNothingDeathTest, ACopiedReferenceIsCaught) {
    const RoomFaces& room = the_world().data().faces_of(0);
    const auto copy_block = [&] {
        const ReadOnly guard;
        const Ref<const Node> copy(room.tree);
        std::fprintf(stderr, "%u faces\n", copy->facets_below);
    };
    EXPECT_EXIT(copy_block(), testing::ExitedWithCode(kWritten), "a write to the world");
    const auto copy_room = [&] {
        const ReadOnly guard;
        const Ref<const RoomFaces> copy(*the_world().data().room_faces.find(0));
        std::fprintf(stderr, "%u faces\n", copy->tree->facets_below);
    };
    EXPECT_EXIT(copy_room(), testing::ExitedWithCode(kWritten), "a write to the world");
}

TEST(CastTouchesNothingDeathTest, ACopiedHandleIsCaught) {
    const World& world = the_world();
    const auto copy_world = [&] {
        const ReadOnly guard;
        const World copy = world;
        std::fprintf(stderr, "%zu faces\n", copy.face_count());
    };
    EXPECT_EXIT(copy_world(), testing::ExitedWithCode(kWritten), "a write to the world");
}

TEST(CastTouchesNothingDeathTest, AMarkLeftInAFaceIsCaught) {
    const Node* node = the_world().data().faces_of(0).tree.get();
    while (!node->is_leaf()) node = node->children[0].get();
    const Block* block = &block_of(*node);
    const auto mark = [&] {
        const ReadOnly guard;
        const_cast<FaceRecord&>(block->faces[0]).mask ^= 1;
    };
    EXPECT_EXIT(mark(), testing::ExitedWithCode(kWritten), "a write to the world");
}

TEST(CastTouchesNothing, AllocationsAreCounted) {
    const std::size_t before = allocations;
    const std::vector<int> some(100);
    EXPECT_EQ(allocations, before + 1) << some.size();
}

}  // namespace
}  // namespace firma
