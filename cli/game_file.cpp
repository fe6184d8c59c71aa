// SPDX-License-Identifier: MIT
// Saved games as files, and what the verbs tell of a game.
#include "cli/game_file.h"

#include <fmt/format.h>

#include "cli/csv_reader.h"
#include "cli/edit_log_file.h"
#include "cli/failure.h"
#include "cli/numbers.h"

namespace firma::cli {

namespace {

struct GameCount {
    std::size_t bodies = 0, asleep = 0, debris = 0, projectiles = 0;
};

GameCount count_game(const GameState& game) {
    GameCount counts;
    for (const Body& body : game.bodies.slots) {
        counts.bodies += body.shape.valid();
        counts.asleep += body.shape.valid() && body.asleep;
    }
    for (const DebrisPiece& piece : game.debris.slots) counts.debris += piece.solid.face_count() > 0;
    for (const GameShots& shots : game.shots) counts.projectiles += shots.projectiles.size();
    return counts;
}

}  // namespace

std::optional<GameState> read_saved_game(const std::string& path) {
    const std::string text = read_file(path);
    const std::span<const std::byte> bytes = std::as_bytes(std::span(text));
    if (!is_game_file(bytes)) return std::nullopt;
    return take(unpack_game(bytes, path));
}

void write_bytes(std::span<const std::byte> bytes, AtomicFile& file) {
    file.write({reinterpret_cast<const char*>(bytes.data()), bytes.size()});
}

Json game_json(const GameState& game) {
    const GameCount counts = count_game(game);
    Json json;
    json["tick"] = game.tick;
    json["seconds"] = double(game.tick) / game.rate;
    json["explosions"] = game.explosions;
    json["edits"] = game.log.commands().size();
    json["players"] = Json::array();
    for (const GamePlayer& player : game.players)
        json["players"].push_back({{"position", player.player.position},
                                   {"velocity", player.player.velocity},
                                   {"on_ground", player.player.on_ground},
                                   {"stuck", player.player.stuck}});
    json["parts"] = game.parts.size();
    json["projectiles"] = counts.projectiles;
    json["bodies"] = counts.bodies;
    json["asleep"] = counts.asleep;
    json["debris"] = counts.debris;
    return json;
}

std::string game_text(const GameState& game) {
    const GameCount counts = count_game(game);
    return fmt::format("tick {}: {} ({} asleep, {} of them debris), {}, {}, {}; hash {}", game.tick,
                       counted(counts.bodies, "body", "bodies"), counts.asleep, counts.debris,
                       counted(counts.projectiles, "projectile"), counted(game.players.size(), "player"),
                       counted(game.parts.size(), "part"), hash_digits(hash_game(game)));
}

}  // namespace firma::cli
