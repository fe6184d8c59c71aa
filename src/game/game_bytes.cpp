// SPDX-License-Identifier: MIT
// A game as the bytes of a .firma file, and back.
#include <algorithm>
#include <utility>
#include <vector>

#include "firma/game.h"
#include "firma/save.h"
#include "game/body_bytes.h"
#include "game/fault_of_game.h"
#include "game/game_sections.h"
#include "game/number_bytes.h"
#include "game/part_bytes.h"
#include "game/player_bytes.h"
#include "game/shot_bytes.h"

namespace firma {
namespace {

constexpr std::size_t kLeastPartBytes = 300, kLeastPlayerBytes = 250, kLeastShotsBytes = 117;

void put_rules(ByteWriter& out, const GameRules& rules) {
    const StepOptions& bodies = rules.bodies;
    put_vec(out, bodies.gravity);
    put_whole(out, std::uint64_t(bodies.substeps_a_second));
    put_whole(out, std::uint64_t(bodies.max_bounces));
    put_numbers(out, {bodies.contact_friction, bodies.contact_offset, bodies.sleep_speed, bodies.sleep_after});
    const DebrisRules& debris = rules.debris;
    for (const std::size_t count : {debris.max_bodies, debris.max_spheres, debris.max_to_ground}) put_whole(out, count);
    put_numbers(out, {debris.max_age, debris.max_asleep, debris.min_to_ground, debris.max_overlap});
    put_flags(out, {debris.to_ground, rules.chunks.has_value()});
    if (rules.chunks) put_numbers(out, {rules.chunks->min_volume, rules.chunks->density});
    out.f64(rules.max_blast_speed);
    out.u64(rules.seed);
}

GameRules take_rules(ByteReader& in) {
    GameRules rules;
    StepOptions& bodies = rules.bodies;
    bodies.gravity = take_vec(in);
    bodies.substeps_a_second = int(std::min<std::uint64_t>(in.whole(), 1u << 30));  // judged with all else
    bodies.max_bounces = int(std::min<std::uint64_t>(in.whole(), 1u << 30));
    take_numbers(in, {&bodies.contact_friction, &bodies.contact_offset, &bodies.sleep_speed});
    bodies.sleep_after = take_length_of_time(in);
    DebrisRules& debris = rules.debris;
    for (std::size_t* count : {&debris.max_bodies, &debris.max_spheres, &debris.max_to_ground})
        *count = std::size_t(in.whole());
    debris.max_age = take_length_of_time(in);
    debris.max_asleep = take_length_of_time(in);
    take_numbers(in, {&debris.min_to_ground, &debris.max_overlap});
    bool has_chunks = false;
    take_flags(in, {&debris.to_ground, &has_chunks});
    rules.chunks.reset();
    if (has_chunks) {
        rules.chunks.emplace();
        take_numbers(in, {&rules.chunks->min_volume, &rules.chunks->density});
    }
    rules.max_blast_speed = take_length_of_time(in);
    rules.seed = in.u64();
    return rules;
}

/// Lists with their count before them.
template <class Entry, class Put>
ByteWriter list_of(const std::vector<Entry>& entries, const Put& put) {
    ByteWriter out;
    put_whole(out, entries.size());
    for (const Entry& entry : entries) put(out, entry);
    return out;
}

ByteWriter copy_of(std::span<const std::byte> bytes) {
    ByteWriter out;
    put_bytes(out, bytes);
    return out;
}

std::vector<NewSection> sections_of_game(const GameState& game) {
    std::vector<NewSection> sections;
    const auto add = [&](SectionType type, ByteWriter content) { sections.push_back({type, 0, std::move(content)}); };
    ByteWriter head, parts, bodies, debris;
    head.u32(kGameFileVersion);
    head.u64(game.tick);
    put_whole(head, game.rate);
    put_whole(head, game.explosions);
    put_rules(head, game.rules);
    put_whole(parts, game.parts.size());
    for (std::size_t k = 0; k < game.parts.size(); ++k) put_part(parts, game.parts[k], game.drives[k]);
    put_bodies(bodies, game.bodies);
    put_debris(debris, game.debris);
    add(kGameSection, std::move(head));
    add(kGameLogSection, copy_of(pack_log(game.log)));
    add(kGamePartsSection, std::move(parts));
    add(kGamePlayersSection, list_of(game.players, put_player));
    add(kGameShotsSection, list_of(game.shots, put_shots));
    add(kGameBodiesSection, std::move(bodies));
    add(kGameDebrisSection, std::move(debris));
    return sections;
}

class GameReader {
public:
    GameReader(std::span<const std::byte> bytes, const std::string& name) : bytes_(bytes), name_(name) {}

    Result<GameState> read() {
        Result<std::vector<Section>> sections = read_container(bytes_, name_);
        if (!sections) return sections.error();
        sections_ = std::move(sections).value();
        if (!names_section(bytes_, kGameSection))
            return Error{ErrorCode::kMalformed, name_, "it holds a world and no game"};
        Result<World> world = unpack_world(bytes_, name_);
        if (!world) return world.error();
        game_.world = std::move(world).value();
        take(kGameSection, [&](ByteReader& in) { take_head(in); });
        take(kGamePartsSection, [&](ByteReader& in) { take_parts(in); });
        take(kGamePlayersSection,
             [&](ByteReader& in) { take_list(in, kLeastPlayerBytes, game_.players, take_player); });
        take(kGameShotsSection, [&](ByteReader& in) { take_list(in, kLeastShotsBytes, game_.shots, take_shots); });
        take(kGameBodiesSection, [&](ByteReader& in) { game_.bodies = take_bodies(in); });
        take(kGameDebrisSection, [&](ByteReader& in) { game_.debris = take_debris(in); });
        if (!error_) read_log();
        if (error_) return *error_;
        if (const auto fault = fault_of_game(game_))
            return Error{ErrorCode::kMalformed, name_ + (fault->place.empty() ? "" : ": ") + fault->place,
                         "the game is broken: " + fault->reason};
        return std::move(game_);
    }

private:
    /// Null where it is missing, which is an error.
    const Section* find(SectionType type) {
        for (const Section& section : sections_)
            if (section.type == type) return &section;
        error_ = Error{ErrorCode::kMalformed, name_ + ": section " + section_name(type), "is missing"};
        return nullptr;
    }

    template <class Take>
    void take(SectionType type, const Take& take_content) {
        const Section* section = error_ ? nullptr : find(type);
        if (!section) return;
        const std::string place = name_ + ": section " + section_name(type);
        ByteReader in(section->bytes, place);
        take_content(in);
        if (in.ok() && !in.at_end()) in.fail("bytes behind the last entry");
        if (!in.ok()) error_ = in.error();
    }

    template <class Entry, class TakeEntry>
    static void take_list(ByteReader& in, std::size_t least_bytes, std::vector<Entry>& entries, const TakeEntry& one) {
        const std::size_t count = take_count(in, least_bytes);
        for (std::size_t k = 0; k < count && in.ok(); ++k) entries.push_back(one(in));
    }

    void take_head(ByteReader& in) {
        const std::uint32_t version = in.u32();
        if (in.ok() && version != kGameFileVersion) {
            in.fail_at(0, ErrorCode::kUnsupported,
                       "it is of version " + std::to_string(version) + " of games; this Firma reads version " +
                           std::to_string(kGameFileVersion));
            return;
        }
        game_.tick = in.u64();
        game_.rate = take_u32_whole(in);
        game_.explosions = in.whole();
        game_.rules = take_rules(in);
    }

    void take_parts(ByteReader& in) {
        const std::size_t count = take_count(in, kLeastPartBytes);
        for (std::size_t k = 0; k < count && in.ok(); ++k)
            take_part(in, game_.parts.emplace_back(), game_.drives.emplace_back());
    }

    void read_log() {
        const Section* section = find(kGameLogSection);
        if (!section) return;
        Result<EditLog> log = unpack_log(section->bytes, name_ + ": section " + section_name(kGameLogSection));
        if (log)
            game_.log = std::move(log).value();
        else
            error_ = log.error();
    }

    const std::span<const std::byte> bytes_;
    const std::string& name_;
    std::vector<Section> sections_;
    std::optional<Error> error_;
    GameState game_;
};

}  // namespace

bool names_section(std::span<const std::byte> bytes, SectionType type) {
    if (!is_firma_file(bytes) || bytes.size() < kHeadBytes) return false;
    const std::size_t count =
        std::min<std::size_t>(read_u32(bytes.data() + 12), (bytes.size() - kHeadBytes) / kTableEntryBytes);
    for (std::size_t k = 0; k < count; ++k)
        if (read_u32(bytes.data() + kHeadBytes + k * kTableEntryBytes) == type) return true;
    return false;
}

bool is_game_file(std::span<const std::byte> bytes) {
    return names_section(bytes, kGameSection);
}

Result<std::vector<std::byte>> pack_game(const GameState& game) {
    if (auto fault = fault_of_game(game)) return *fault;
    // The world's own sections first, as they are.
    const std::vector<std::byte> world = pack_world(game.world);
    const Result<std::vector<Section>> of_world = read_container(world, "world");
    std::vector<NewSection> sections;
    for (const Section& section : of_world.value())
        sections.push_back({section.type, section.flags, copy_of(section.bytes)});
    for (NewSection& section : sections_of_game(game)) sections.push_back(std::move(section));
    return write_container(sections, version_of_container(world));
}

Result<GameState> unpack_game(std::span<const std::byte> bytes, std::string name) {
    return GameReader(bytes, name).read();
}

}  // namespace firma
