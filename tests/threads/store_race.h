// SPDX-License-Identifier: MIT
// Readers and an editor at one store: what each reader was answered, and what its version answers alone.
#pragma once

#include <algorithm>
#include <atomic>
#include <bit>
#include <cstdint>
#include <thread>
#include <vector>

#include "base/hasher.h"
#include "firma/queries.h"
#include "firma/rooms.h"
#include "firma/versions.h"
#include "tests/store/cratered.h"

namespace firma::test {

/// An answer as a reader got it.
struct StoreRecord {
    std::uint64_t version = 0;
    std::uint64_t question = 0;
    std::uint64_t answer = 0;
};

/// A hash of everything in the answer to question number so-and-so: a cast, now and then another kind.
inline std::uint64_t answer_of(const World& world, std::uint64_t question) {
    scenes::Rng rng(question * 0x9E3779B97F4A7C15ull + 1);
    Vec3 centre;
    for (std::uint32_t k = 0; k < 3; ++k) {
        const double room = k == 2 ? 0 : 13.5 * rng.below(2);
        centre[int(k)] = room + rng.uniform(0.5, k == 2 ? 5.5 : 11.5);
    }
    const double radius = rng.chance(0.3) ? 0 : rng.uniform(0.1, 0.4);
    const Vec3 path = rng.direction() * 20;
    Hasher hasher;
    if (question % 32 == 7) {
        std::vector<Overlap> near;
        overlap(world, {centre, 1.5}, near);
        for (const NearFace& face : near) hasher.add(std::uint64_t(face.face.id.value));
    } else if (question % 32 == 15) {
        if (const NearFace near = closest(world, centre)) hasher.add(std::bit_cast<std::uint64_t>(near.distance));
    } else if (question % 32 == 23) {
        hasher.add(std::uint64_t(cast_any(world, {centre, radius}, path)));
    } else {
        const Hit hit = cast(world, {centre, radius}, path);
        hasher.add(std::uint64_t(hit.status) * 2 + hit.touched());
        hasher.add(std::uint64_t(hit.face.id.value) << 32 | room_of(world, hit).value);
        hasher.add(std::bit_cast<std::uint64_t>(hit.fraction));
        hasher.add(std::bit_cast<std::uint64_t>(hit.point.x + 2 * hit.point.y + 3 * hit.point.z));
    }
    return hasher.value();
}

struct StoreRace {
    std::vector<StoreRecord> records;  ///< of all readers
    StoreHistory history;              ///< at the end
    std::uint64_t wrong = 0;           ///< answers other than their version's alone
    std::uint64_t versions_read = 0;   ///< how many different ones were asked
    std::size_t most_waiting = 0;      ///< dropped versions that readers held
};

/// Two readers ask for as long as one editor makes so many craters and drops history; then the same craters are made
/// again without threads or store, and each version is asked what the readers asked it.
inline StoreRace run_store_race(int cuts, std::uint64_t seed) {
    constexpr int kReaders = 2, kQuestionsAJob = 24;
    constexpr std::size_t kHistoryBytes = 500'000;  // some dozen craters
    StoreRace race;
    std::vector<StoreRecord> records[kReaders];
    {
        WorldStore store(building(), {kHistoryBytes});
        std::atomic<bool> done = false;
        std::atomic<int> ready = 0;
        std::vector<std::thread> readers;
        for (int k = 0; k < kReaders; ++k)
            readers.emplace_back([&, k] {
                std::uint64_t question = std::uint64_t(k) << 40 | seed << 44;
                bool last = false;
                for (std::uint64_t job = 0; !last; ++job) {
                    last = done;  // and one job more, of the last version
                    World world = store.current();
                    if (!last && job % 8 == 5) world = store.at(store.history().oldest).value_or(world);
                    for (int q = 0; q < kQuestionsAJob; ++q, ++question)
                        records[k].push_back({world.version(), question, answer_of(world, question)});
                    if (job == 0) ++ready;
                }
            });
        while (ready < kReaders) std::this_thread::yield();
        CraterMaker maker(seed);
        for (int cut = 0; cut < cuts; ++cut) {
            const World before = store.current();
            if (store.publish(before, maker.next(before)) != PublishStatus::kDone) ++race.wrong;
            race.most_waiting = std::max(race.most_waiting, store.history().waiting);
            if (cut % 16 == 9 && store.undo() && !store.redo()) ++race.wrong;
        }
        done = true;
        for (std::thread& reader : readers) reader.join();
        if (store.collect() != 0) ++race.wrong;  // nobody holds anything any more
        race.history = store.history();
    }
    for (const auto& some : records) race.records.insert(race.records.end(), some.begin(), some.end());
    std::sort(race.records.begin(), race.records.end(), [](const StoreRecord& a, const StoreRecord& b) {
        return a.version != b.version ? a.version < b.version : a.question < b.question;
    });
    CraterMaker maker(seed);
    World world = building();
    auto next = race.records.begin();
    for (int cut = 0;; ++cut) {
        race.versions_read += next != race.records.end() && next->version == world.version();
        for (; next != race.records.end() && next->version == world.version(); ++next)
            race.wrong += answer_of(world, next->question) != next->answer;
        if (cut == cuts) break;
        world = maker.next(world);
    }
    race.wrong += std::uint64_t(race.records.end() - next);  // of versions that there never were
    return race;
}

}  // namespace firma::test
