// SPDX-License-Identifier: MIT
// Records ten seconds of a fight in the depot, or replays such a recording and says whether it is the same.
//
//   same_games record OUT.firmarec
//   same_games replay IN.firmarec
#include <cstdio>
#include <fstream>
#include <iterator>
#include <string>

#include "tests/game/depot_fight.h"

namespace {

constexpr std::uint64_t kTicks = 600;

int record(const char* path) {
    using namespace firma;
    const Result<Recording> recorded = record_game(test::depot_game(), test::depot_events(), kTicks, "depot.map");
    if (!recorded) return std::fprintf(stderr, "%s\n", recorded.error().text().c_str()), 1;
    const std::vector<std::byte> bytes = pack_recording(recorded.value()).value();
    std::ofstream file(path, std::ios::binary);
    file.write(reinterpret_cast<const char*>(bytes.data()), std::streamsize(bytes.size()));
    if (!file.flush()) return std::fprintf(stderr, "%s: cannot be written\n", path), 1;
    std::printf("recorded=%zu bytes=%zu\n", std::size_t(recorded.value().hashes.size()), bytes.size());
    return 0;
}

int replay(const char* path) {
    using namespace firma;
    std::ifstream file(path, std::ios::binary);
    const std::string text{std::istreambuf_iterator<char>(file), {}};
    const Result<Recording> read = unpack_recording(std::as_bytes(std::span(text)), path);
    if (!read) return std::fprintf(stderr, "%s\n", read.error().text().c_str()), 1;
    const GameReplay replay = replay_game(read.value());
    if (replay.error) std::fprintf(stderr, "%s\n", replay.error->text().c_str());
    if (replay.difference) std::fprintf(stderr, "%s\n", replay.difference->text().c_str());
    const GameState& end = replay.game;
    std::size_t bodies = 0;
    for (const Body& body : end.bodies.slots) bodies += body.shape.valid();
    std::printf("same=%zu explosions=%zu bodies=%zu hash=%016llx\n", std::size_t(replay.ticks),
                std::size_t(end.explosions), bodies, static_cast<unsigned long long>(hash_game(end)));
    return replay.ok() ? 0 : 1;
}

}  // namespace

int main(int count, char** words) {
    const std::string what = count == 3 ? words[1] : "";
    if (what == "record") return record(words[2]);
    if (what == "replay") return replay(words[2]);
    return std::fputs("usage: same_games record|replay FILE.firmarec\n", stderr), 2;
}
