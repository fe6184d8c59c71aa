// SPDX-License-Identifier: MIT
// The program of docs/snapshots.md: what-if, a store, a reader beside an editor, undo, and a file.
#include <atomic>
#include <cstdio>
#include <thread>

#include "firma/firma.h"

int main() {
    firma::Result<firma::Level> level = firma::read_level("levels/first.obj");
    if (!level) return std::puts(level.error().text().c_str()), 1;
    const firma::World first = firma::make_world(level.value()).value();
    const firma::Cutter crater = firma::make_crater(firma::CutterShape::kRocky, 1);
    const firma::Sphere ball{.centre = {35, 29, 2}, .radius = 0.25};
    const firma::Vec3 down{0, 0, -10};

    // What would this shot do? Do it, look, and forget it.
    const firma::World shot = firma::carve(first, crater, {.position = {35, 29, 0}, .scale = 1.6}).world;
    std::printf("a shot would make the ball fall %.2f m instead of %.2f\n", 10 * cast(shot, ball, down).fraction,
                10 * cast(first, ball, down).fraction);

    // A store for a game: readers take the newest world for a frame, an editor publishes the next.
    firma::WorldStore store(first, {.history_bytes = 8 << 20});
    std::atomic<bool> over = false;
    std::atomic<long> met = 0;
    std::thread reader([&] {
        while (!over) {
            const firma::World world = store.current();  // one handle for this frame
            for (int k = 0; k < 100; ++k) met += cast(world, ball, down).touched();
        }
    });
    for (int k = 0; k < 20; ++k) {
        const firma::World before = store.current();
        const firma::Pose pose{.position = {25.0 + k, 29, 0}, .rotation = firma::random_turn(k), .scale = 1.2};
        if (store.publish(before, firma::carve(before, crater, pose).world) != firma::PublishStatus::kDone) return 1;
    }
    over = true;
    reader.join();
    std::printf("version %d after twenty shots; ", int(store.current().version()));

    // Undo goes back to a version, redo forward again.
    for (int k = 0; k < 5; ++k) store.undo();
    std::printf("%d after five undone; ", int(store.current().version()));
    store.redo();
    const firma::World kept = store.current();
    std::printf("%d after one redone\n", int(kept.version()));

    // A file outlives the process: the same world, to the bit.
    const auto saved = firma::save_world(kept, "build/kept.firma");
    if (!saved) return std::puts(saved.error().text().c_str()), 1;
    const firma::Result<firma::World> back = firma::load_world("build/kept.firma");
    if (!back) return std::puts(back.error().text().c_str()), 1;
    std::puts(hash_world(back.value()) == hash_world(kept) ? "saved, and read back to the bit" : "not the same");
}
