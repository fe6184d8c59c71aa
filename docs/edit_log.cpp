// SPDX-License-Identifier: MIT
// The program of docs/edit_log.md: a server and a client, a command that is lost, a repair, a player who joins late.
#include <cstdio>

#include "firma/firma.h"

int main() {
    const firma::Result<firma::Level> read = firma::read_level("levels/first.obj");
    if (!read) return std::puts(read.error().text().c_str()), 1;
    const firma::World level = firma::make_world(read.value()).value();
    firma::World server = level, client = level;

    // The server numbers the shots, applies each, and sends it. The client hears all but one.
    firma::EditLog log(level);
    std::size_t sent = 0;
    for (int k = 0; k < 20; ++k) {
        const firma::EditCommand shot = firma::crater_command(
            log.next_number(), {firma::CutterShape::kRocky, 1000u + k}, {25.0 + k, 29, 0}, 1.2, {.material = "soot"});
        const std::vector<std::byte> bytes = firma::pack_command(shot).value();
        sent += bytes.size();
        server = apply(server, shot).world;
        if (log.append(shot)) return 1;
        if (k == 7) continue;
        const firma::Result<firma::EditCommand> heard = firma::unpack_command(bytes, "server");
        if (heard) client = apply(client, heard.value()).world;
    }
    log.add_checkpoint(server);
    std::printf("a shot took %zu bytes; the worlds are %s\n", sent / 20,
                hash_world(client) == hash_world(server) ? "the same" : "not the same");

    // Hashes of regions say where; the client lists the faces that it has there, the server answers with a patch.
    const std::vector<firma::Region> where = firma::differing_regions(hash_regions(client), hash_regions(server));
    const std::vector<std::byte> list = firma::list_faces(client, where);
    const firma::Result<std::vector<std::byte>> patch = firma::make_patch(server, list, "client");
    if (!patch) return std::puts(patch.error().text().c_str()), 1;
    const firma::Result<firma::World> repaired = firma::apply_patch(client, patch.value(), "server");
    if (!repaired) return std::puts(repaired.error().text().c_str()), 1;
    std::printf("%zu region(s) differed; a list of %zu bytes and a patch of %zu: %s\n", where.size(), list.size(),
                patch.value().size(),
                hash_world(repaired.value()) == hash_world(server) ? "the same again" : "not the same");

    // Who joins late has the level, and gets the log.
    const std::vector<std::byte> bytes = firma::pack_log(log);
    const firma::Result<firma::EditLog> got = firma::unpack_log(bytes, "server's log");
    if (!got) return std::puts(got.error().text().c_str()), 1;
    const firma::ReplayResult joined = firma::replay(level, got.value());
    if (!joined.ok()) return std::puts(joined.error->text().c_str()), 1;
    std::printf("a log of %zu bytes: %zu shots, %s\n", bytes.size(), joined.done,
                hash_world(joined.world) == hash_world(server) ? "the same world" : "another world");
}
