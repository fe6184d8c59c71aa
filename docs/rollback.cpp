// SPDX-License-Identifier: MIT
// The program of docs/rollback.md: a server that judges late shots in past worlds, clients that guess and go back.
#include <array>
#include <cmath>
#include <cstdio>
#include <deque>
#include <map>
#include <optional>
#include <random>
#include <vector>

#include "firma/firma.h"

using firma::EditCommand, firma::Hit, firma::Vec3, firma::World;
using Bytes = std::vector<std::byte>;

constexpr int kKept = 16;           // ticks whose worlds the server keeps
constexpr int kLatency[] = {5, 2};  // ticks from each player to the server, and back
constexpr int kServer = -1;         // in place of a player

// What a client sends when its player fires.
struct Shot {
    int player;
    int seen;            // the last tick that the client had heard of
    std::uint64_t hash;  // hash_world() of what it showed
    firma::Ray ray;
    std::uint64_t seed;  // of the crater
};
// What the server sends to all: of each tick, what became of the shots that arrived. No bytes: nothing.
struct Verdict {
    int player;
    Bytes command;
};
struct News {
    int tick;
    std::vector<Verdict> verdicts;
};

std::uint32_t next_number(const World& world) {
    return world.solid().edits() + 1;
}
World apply_as_next(const World& world, EditCommand& command) {
    command.number = next_number(world);
    return apply(world, command).world;
}

// What a shot does in a world: for its client at once, for the server when it arrives.
std::optional<EditCommand> crater_of(const World& world, const Shot& shot) {
    const Hit hit = cast(world, shot.ray);
    if (!hit || hit.portal.valid()) return std::nullopt;  // nothing was met, or a closed door
    return firma::crater_command(next_number(world), {firma::CutterShape::kRocky, shot.seed}, hit.point, 0.6);
}

void tell(const World& world, const Shot& shot) {
    const Hit hit = cast(world, shot.ray);
    const std::string met = hit.portal.valid() ? "the closed door" : world.material_name(hit.material);
    std::printf(" %s after %.2f m", met.c_str(), length(hit.point - shot.ray.start));
}

class Server {
public:
    explicit Server(const World& level) : past_{level}, now_(level) {}

    Verdict judge(const Shot& shot) {
        const std::optional<World> seen = seen_by(shot);
        if (!seen) return {shot.player, {}};
        ++judged;
        exact += hash_world(*seen) == shot.hash;
        if (tick_ < 40) {
            std::printf("tick %d, a shot of tick %d: meets", tick_, shot.seen);
            tell(*seen, shot);
            std::printf("; in the newest world");
            tell(now_, shot);
            std::printf("\n");
        }
        std::optional<EditCommand> crater = crater_of(*seen, shot);
        if (!crater) return {shot.player, {}};
        now_ = apply_as_next(now_, *crater);  // the next of all, whichever tick it was aimed in
        made_.push_back({tick_, shot.player, *crater});
        return {shot.player, pack_command(*crater).value()};
    }

    Verdict close(firma::PortalId door) {
        const EditCommand command = firma::door_command(next_number(now_), door, false);
        now_ = apply(now_, command).world;
        return {kServer, pack_command(command).value()};
    }

    // Keeps the world as it is now.
    void end_tick() {
        past_.push_back(now_);
        if (past_.size() > kKept) past_.erase(past_.begin());
        while (!made_.empty() && made_.front().tick <= tick_ - kKept) made_.pop_front();
        ++tick_;
    }

    const World& now() const { return now_; }
    const std::vector<World>& past() const { return past_; }

    int judged = 0, exact = 0;

private:
    struct Made {
        int tick, player;
        EditCommand command;
    };

    // The world of the tick that the client had heard of, and in it what its player had shot since: what the client
    // showed, to the bit. Nothing for a tick that is not kept or not over.
    std::optional<World> seen_by(const Shot& shot) const {
        const int oldest = tick_ - int(past_.size());
        if (shot.seen < oldest || shot.seen >= tick_) return std::nullopt;
        World world = past_[std::size_t(shot.seen - oldest)];
        for (Made made : made_)
            if (made.player == shot.player && made.tick > shot.seen) world = apply_as_next(world, made.command);
        return world;
    }

    int tick_ = 1;
    std::vector<World> past_;  // after the ticks before this one
    std::deque<Made> made_;    // craters of as many ticks
    World now_;
};

class Client {
public:
    Client(int player, const World& level) : player_(player), confirmed_(level), shown_(level) {}

    // Shows at once what should come of a shot.
    Shot fire(const firma::Ray& ray, std::uint64_t seed) {
        const Shot shot{player_, seen_, hash_world(shown_), ray, seed};
        guesses_.push_back({crater_of(shown_, shot), {}, {}});
        show(guesses_.back());
        return shot;
    }

    // @return false for what is no command: nothing has changed then, and the client had better leave
    bool hear(const News& news) {
        World world = confirmed_;
        std::ptrdiff_t own = 0;
        bool right = true;  // all was as guessed, so far
        for (const Verdict& verdict : news.verdicts) {
            const bool mine = verdict.player == player_ && own < std::ssize(guesses_);
            const Guess* guess = mine ? &guesses_[std::size_t(own++)] : nullptr;
            right = right && guess && guess->bytes == verdict.command;
            if (right) {
                world = guess->after;
            } else if (!verdict.command.empty()) {
                const firma::Result<EditCommand> command = firma::unpack_command(verdict.command, "server");
                if (!command) return std::puts(command.error().text().c_str()), false;
                world = apply(world, command.value()).world;
            }
        }
        seen_ = news.tick;
        confirmed_ = std::move(world);
        right_guesses += right ? int(own) : 0;
        went_back += !right && !guesses_.empty();
        guesses_.erase(guesses_.begin(), guesses_.begin() + own);
        if (right) return true;
        shown_ = confirmed_;  // back to what is known, and on from there
        for (Guess& guess : guesses_) show(guess);
        return true;
    }

    const World& shown() const { return shown_; }

    int right_guesses = 0, went_back = 0;

private:
    struct Guess {
        std::optional<EditCommand> command;
        Bytes bytes;
        World after;
    };

    void show(Guess& guess) {
        if (guess.command) {
            shown_ = apply_as_next(shown_, *guess.command);
            guess.bytes = pack_command(*guess.command).value();
        }
        guess.after = shown_;
    }

    int player_, seen_ = 0;
    World confirmed_, shown_;    // what the server said, and what is guessed on top of it
    std::deque<Guess> guesses_;  // of the shots that the server has not answered
};

int main() {
    const firma::Result<World> level = firma::read_world("levels/depot.map");
    if (!level) return std::puts(level.error().text().c_str()), 1;
    const firma::PortalId door = find_portal(level.value(), "hall_dock_north").value();
    Server server(level.value());
    std::array<Client, 2> clients{Client(0, level.value()), Client(1, level.value())};
    std::multimap<int, Shot> shots;  // on their way, by the tick in which they arrive
    std::array<std::map<int, News>, 2> news;
    std::mt19937_64 random(16);
    const auto unit = [&random] { return double(random() >> 11) * 0x1p-52 - 1; };  // -1 to 1

    for (int tick = 1; tick <= 300; ++tick) {
        for (std::size_t k = 0; k < 2; ++k) {
            const auto heard = news[k].find(tick);
            if (heard != news[k].end() && !clients[k].hear(heard->second)) return 1;
            const auto fire = [&](const firma::Ray& ray) {
                const Shot shot = clients[k].fire(ray, random());
                shots.emplace(tick + kLatency[k], shot);
            };
            if (tick == 9 && k == 0) fire({{20, 10, 1.5}, {16, 0, -2}});  // through a doorway; the door closes
            if (tick == 24 && k == 0) fire({{3, 18, 1.5}, {12, 0, 0}});   // at a thin wall
            if (tick == 26 && k == 1) fire({{3, 18, 1.5}, {12, 0, 0}});   // at the same, and is heard first
            if (tick >= 40 && tick < 280 && tick % (5 - int(k)) == 0)     // both at a thick one
                fire({{8.0 + 4 * double(k), 7, 1.5}, {2 * unit(), 10, 2 * unit()}});
        }
        News said{tick, {}};
        for (auto [one, end] = shots.equal_range(tick); one != end; ++one)
            said.verdicts.push_back(server.judge(one->second));
        if (tick == 12) said.verdicts.push_back(server.close(door));
        server.end_tick();
        for (std::size_t k = 0; k < 2; ++k) news[k].emplace(tick + kLatency[k], said);
        if (tick == 279) {
            const std::size_t all = memory_used(server.past()), newest = memory_used(server.now());
            std::printf("%d ticks are kept, at less than %zu KB each\n", kKept,
                        (all - newest) / kKept / 10'000 * 10 + 10);
        }
    }

    std::printf("%d shots, %d judged in the very world that their player saw\n", server.judged, server.exact);
    for (const Client& client : clients)
        std::printf("%d guesses right, went back %d times; %s\n", client.right_guesses, client.went_back,
                    hash_world(client.shown()) == hash_world(server.now()) ? "the server's world" : "another world");

    // What is broken or absurd changes nothing.
    const std::uint64_t hash = hash_world(server.now());
    const firma::Ray no_ray{{14, 7, 1.5}, {std::nan(""), 0, 0}};
    for (const Shot& shot : {Shot{0, 299, 0, no_ray, 1}, Shot{0, -5, 0, {}, 1}, Shot{0, 999, 0, {}, 1}})
        if (!server.judge(shot).command.empty()) return 1;
    Bytes cut_short = pack_command(firma::crater_command(1000, {}, {14, 7, 0}, 0.6)).value();
    cut_short.pop_back();
    if (clients[0].hear({301, {{kServer, cut_short}}})) return 1;
    std::puts(hash_world(server.now()) == hash && hash_world(clients[0].shown()) == hash ? "nothing is harmed"
                                                                                         : "harmed");
}
