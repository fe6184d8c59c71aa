// SPDX-License-Identifier: MIT
// The program of docs/lockstep.md: two peers over a network that loses, doubles and reorders; a world that differs.
#include <algorithm>
#include <array>
#include <cstdio>
#include <map>
#include <optional>
#include <random>
#include <span>
#include <string>
#include <vector>

#include "firma/firma.h"

using firma::EditCommand, firma::World;
using Bytes = std::vector<std::byte>;

constexpr int kTicks = 300;
constexpr std::size_t kDelay = 4;              // ticks from a key to what it does, for everybody
constexpr std::size_t kKept = 2 * kDelay + 1;  // ticks whose worlds are kept: so far may peers be apart
constexpr std::size_t kMaxCommands = 4;        // of a player in a tick
constexpr std::size_t kMaxBytes = 64;          // of a command

// What a player says of a tick: what to do in it; and a hash of its world, kDelay ticks before.
struct Turn {
    std::uint64_t hash = 0;
    std::vector<Bytes> commands;
};
// All turns that the other may not have yet, and the first of its own that is missing.
struct Packet {
    std::uint64_t wanted = 0, first = 0;
    std::vector<Turn> turns;
};

void put(Bytes& bytes, std::uint64_t value, int count) {
    for (int k = 0; k < count; ++k) bytes.push_back(std::byte(value >> (8 * k)));
}

Bytes pack(const Packet& packet) {
    Bytes bytes;
    put(bytes, packet.wanted, 4);
    put(bytes, packet.first, 4);
    put(bytes, packet.turns.size(), 1);
    for (const Turn& turn : packet.turns) {
        put(bytes, turn.hash, 8);
        put(bytes, turn.commands.size(), 1);
        for (const Bytes& command : turn.commands) {
            put(bytes, command.size(), 1);
            bytes.insert(bytes.end(), command.begin(), command.end());
        }
    }
    return bytes;
}

// Nothing for what is cut short, too long, or more than a player may say.
std::optional<Packet> unpack(std::span<const std::byte> bytes) {
    bool whole = true;
    const auto take = [&](std::size_t count) {
        whole = whole && count <= bytes.size();
        const auto taken = bytes.first(whole ? count : 0);
        bytes = bytes.subspan(taken.size());
        return taken;
    };
    const auto number = [&](std::size_t count, std::uint64_t limit) {
        std::uint64_t value = 0;
        const auto taken = take(count);
        for (std::size_t k = 0; k < taken.size(); ++k) value |= std::uint64_t(taken[k]) << (8 * k);
        whole = whole && value <= limit;
        return whole ? value : 0;
    };
    Packet packet{number(4, ~0u), number(4, ~0u), {}};
    packet.turns.resize(number(1, 2 * kKept));
    for (Turn& turn : packet.turns) {
        turn.hash = number(8, ~std::uint64_t(0));
        turn.commands.resize(number(1, kMaxCommands));
        for (Bytes& command : turn.commands) {
            const auto taken = take(number(1, kMaxBytes));
            command.assign(taken.begin(), taken.end());
        }
    }
    if (!whole || !bytes.empty()) return std::nullopt;
    return packet;
}

// What this game lets players do: doors, and craters of up to two metres.
bool allowed(const EditCommand& command) {
    if (command.kind == firma::EditKind::kDoor) return true;
    return command.kind == firma::EditKind::kCarve && command.pose.scale <= 2 &&
           std::holds_alternative<firma::CraterSeed>(command.cutter);
}

class Peer {
public:
    Peer(int me, const World& level) : me_(me) {
        states_[0].world = level;
        for (std::vector<Turn>& turns : turns_) turns.resize(kDelay);  // in the first ticks nobody does anything
    }

    std::size_t done() const { return done_; }
    std::size_t compared() const { return compared_; }
    const World& world(std::size_t done) const { return states_.at(done).world; }

    Bytes packet() const {
        const std::vector<Turn>& own = turns_[me_];
        return pack({turns_[1 - me_].size(), acked_, {own.begin() + std::ptrdiff_t(acked_), own.end()}});
    }

    void hear(const Bytes& bytes) {
        std::optional<Packet> packet = unpack(bytes);
        if (!packet) return;
        acked_ = std::max(acked_, std::min(std::size_t(packet->wanted), turns_[me_].size()));
        std::vector<Turn>& theirs = turns_[1 - me_];
        for (std::size_t k = 0; k < packet->turns.size(); ++k)
            if (packet->first + k == theirs.size() && theirs.size() < done_ + kKept)
                theirs.push_back(std::move(packet->turns[k]));
    }

    // Compares hashes of the ticks that both have done. @return after how many ticks they differ, one at a time
    std::optional<std::size_t> difference() {
        const std::vector<Turn>& theirs = turns_[1 - me_];
        while (compared_ < done_ && compared_ + kDelay < theirs.size()) {
            const std::uint64_t hash = theirs[compared_ + kDelay].hash;
            if (hash != hash_world(world(++compared_))) return compared_;
        }
        return std::nullopt;
    }

    // Whether it is known what both do in the next tick.
    bool ready() const { return done_ < turns_[1 - me_].size(); }

    // Does it; then says what the player wants, for kDelay ticks later.
    void step(const std::vector<Bytes>& commands, bool spoiled = false) {
        State state = after(states_.at(done_), done_);
        if (spoiled) state.world = states_.at(done_).world;
        turns_[me_].push_back({hash_world(state.world), commands});
        states_[++done_] = std::move(state);
        states_.erase(states_.begin(), states_.lower_bound(done_ < kKept ? 0 : done_ - kKept));
    }

    // Takes another world for the one after some ticks, and does again what was done since.
    void go_on_from(std::size_t done, const World& world) {
        states_.at(done).world = world;
        for (; done < done_; ++done) states_[done + 1] = after(states_.at(done), done);
    }

    int refused = 0, loose = 0;

private:
    struct State {
        World world;
        std::uint32_t number = 0;  // of the last command
    };

    // Both do the same: commands of player 0, then of player 1; what is no command, or not allowed, is left out.
    State after(State state, std::size_t tick) {
        for (const std::vector<Turn>& turns : turns_)
            for (const Bytes& bytes : turns[tick].commands) {
                firma::Result<EditCommand> command = firma::unpack_command(bytes, "tick " + std::to_string(tick));
                ++state.number;
                if (!command || !allowed(command.value())) {
                    ++refused;
                    if (me_ == 0) std::puts(command ? "not allowed" : command.error().text().c_str());
                    continue;
                }
                EditCommand numbered = command.value();
                numbered.number = state.number;
                const firma::CommandResult result = apply(state.world, numbered);
                for (const firma::CarveResult& edit : result.edits) loose += int(edit.chunks.size());
                state.world = result.world;
            }
        return state;
    }

    int me_;
    std::size_t done_ = 0, compared_ = 0, acked_ = kDelay;
    std::map<std::size_t, State> states_;     // after so many ticks
    std::array<std::vector<Turn>, 2> turns_;  // of both players, by tick. A game drops old ones, or keeps an EditLog
};

// What is sent arrives after 1 to 6 frames, twice, cut short, or not at all.
class Network {
public:
    void send(int frame, int to, Bytes packet) {
        ++sent;
        bytes += packet.size();
        if (random_() % 10 < 3) return void(++lost);
        if (random_() % 10 == 0 && ++doubled) way_[{to, frame + 1 + int(random_() % 6)}].push_back(packet);
        if (random_() % 20 == 0 && ++cut) packet.resize(random_() % packet.size());
        way_[{to, frame + 1 + int(random_() % 6)}].push_back(std::move(packet));
    }
    std::vector<Bytes> receive(int frame, int to) { return std::move(way_[{to, frame}]); }

    int sent = 0, lost = 0, doubled = 0, cut = 0;
    std::size_t bytes = 0;

private:
    std::mt19937_64 random_{5};
    std::map<std::pair<int, int>, std::vector<Bytes>> way_;
};

// Player 1's world differs after some ticks, and player 0 is right. By a connection that loses nothing go: hashes of
// regions, the regions that differ, what player 1 has there, a patch.
bool repair(Peer& guest, const Peer& host, std::size_t done) {
    const World &wrong = guest.world(done), &right = host.world(done);
    const std::vector<firma::Region> regions = firma::differing_regions(hash_regions(wrong), hash_regions(right));
    const Bytes list = list_faces(wrong, regions);
    const firma::Result<Bytes> patch = make_patch(right, list, "list");
    if (!patch) return std::puts(patch.error().text().c_str()), false;
    const firma::Result<World> mended = apply_patch(wrong, patch.value(), "patch");
    if (!mended) return std::puts(mended.error().text().c_str()), false;
    const auto kilobytes = [](const Bytes& bytes) { return bytes.size() / 10'000 * 10 + 10; };
    std::printf("after %zu ticks %zu region(s) differ: a list of less than %zu KB, a patch of less than %zu KB\n", done,
                regions.size(), kilobytes(list), kilobytes(patch.value()));
    std::printf("then %zu ticks are done again\n", guest.done() - done);
    guest.go_on_from(done, mended.value());
    return true;
}

// What a player does in a tick: shoots about, and player 0 opens and closes a door.
class Player {
public:
    Player(int me, firma::PortalId door) : me_(me), door_(door), random_(std::uint64_t(me) + 1) {}

    std::vector<Bytes> commands(const World& world, std::size_t tick) {
        std::vector<Bytes> said;
        // Numbers are given by who does a command.
        if (me_ == 0 && tick % 40 == 20)
            said.push_back(pack_command(firma::door_command(1, door_, tick % 80 == 60)).value());
        if (tick % 3 == 0) {
            const firma::Ray ray{{10, 4.0 + 5 * me_, 1.5}, {20 * unit(), 20 * unit(), 10 + 10 * unit()}};
            const firma::Hit hit = cast(world, ray);
            firma::CarveOptions options;
            options.chunks.emplace();  // what comes loose leaves
            const EditCommand crater =
                firma::crater_command(1, {firma::CutterShape::kRocky, random_()}, hit.point, 0.7, options);
            if (hit) said.push_back(pack_command(crater).value());
        }
        if (me_ == 1 && tick == 200) {  // to do harm: no command, one that is not allowed, no bytes, too few
            EditCommand huge = firma::crater_command(1, {}, {10, 7, 0}, 40);
            said = {Bytes(20, std::byte(0xFF)), pack_command(huge).value(), Bytes()};
            said.push_back(pack_command(firma::crater_command(1, {}, {10, 7, 0}, 1)).value());
            said.back().pop_back();
        }
        return said;
    }

private:
    double unit() { return double(random_() >> 11) * 0x1p-52 - 1; }  // -1 to 1

    int me_;
    firma::PortalId door_;
    std::mt19937_64 random_;
};

int main() {
    const firma::Result<World> level = firma::read_world("levels/depot.map");
    if (!level) return std::puts(level.error().text().c_str()), 1;
    const firma::PortalId door = find_portal(level.value(), "hall_dock_north").value();
    std::array<Peer, 2> peers{Peer(0, level.value()), Peer(1, level.value())};
    std::array<Player, 2> players{Player(0, door), Player(1, door)};
    Network network;
    std::array<int, 2> waited{}, differed{};
    int frame = 0;
    for (; std::min(peers[0].compared(), peers[1].compared()) < kTicks; ++frame)
        for (int me = 0; me < 2; ++me) {
            Peer& peer = peers[me];
            for (const Bytes& packet : network.receive(frame, me)) peer.hear(packet);
            while (const std::optional<std::size_t> done = peer.difference()) {
                ++differed[me];
                if (me == 1 && !repair(peer, peers[0], *done)) return 1;
            }
            const std::size_t tick = peer.done();
            if (tick < kTicks && peer.ready())  // in tick 100 player 1's machine forgets what was done
                peer.step(players[me].commands(peer.world(tick), tick), me == 1 && tick == 100);
            else if (tick < kTicks)
                ++waited[me];
            network.send(frame, 1 - me, peer.packet());
        }

    std::printf("%d ticks in %d frames; %d packets of %zu bytes, %d lost, %d doubled, %d cut short\n", kTicks, frame,
                network.sent, network.bytes / std::size_t(network.sent), network.lost, network.doubled, network.cut);
    for (int me = 0; me < 2; ++me)
        std::printf("player %d: %zu hashes compared, %d differed; %d commands refused; waited in %d frames\n", me,
                    peers[me].compared(), differed[me], peers[me].refused, waited[me]);
    const World &a = peers[0].world(kTicks), &b = peers[1].world(kTicks);
    std::printf("%d pieces came loose; %s\n", peers[0].loose,
                hash_world(a) == hash_world(b) ? "one world" : "two worlds");
    std::puts(check_world(b) || check_solid(b) ? "not sound" : "sound");
}
