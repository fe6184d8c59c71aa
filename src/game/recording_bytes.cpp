// SPDX-License-Identifier: MIT
// Recordings as bytes, and back.
#include <utility>
#include <vector>

#include "firma/recording.h"
#include "game/event_bytes.h"
#include "game/game_sections.h"
#include "game/number_bytes.h"

namespace firma {
namespace {

constexpr SectionType kSectionsOfRecordings[] = {kRecordingSection, kRecordedStartSection, kRecordedEventsSection,
                                                 kRecordedHashesSection, kRecordedEndSection};

class RecordingReader {
public:
    RecordingReader(std::span<const std::byte> bytes, const std::string& name) : bytes_(bytes), name_(name) {}

    Result<Recording> read() {
        Result<std::vector<Section>> sections = read_container(bytes_, name_);
        if (!sections) return sections.error();
        sections_ = std::move(sections).value();
        if (const auto error = find_all()) return *error;
        if (const auto error = take_head()) return *error;
        if (const auto error = take_game(kRecordedStartSection, recording_.start)) return *error;
        if (const auto error = take_game(kRecordedEndSection, recording_.end)) return *error;
        if (recording_.level_hash != recording_.start.log.level_hash())
            return fault(kRecordingSection, "the level is another than that of the game that it begins with");
        if (const auto error = take_event_list()) return *error;
        Result<HashTrack> track =
            HashTrack::from_bytes(bytes_of(kRecordedHashesSection), place(kRecordedHashesSection));
        if (!track) return track.error();
        recording_.hashes = std::move(track).value();
        if (recording_.hashes.size() != recording_.end.tick - recording_.start.tick)
            return fault(kRecordedHashesSection, "has not as many ticks as lie between the first and the last game");
        return std::move(recording_);
    }

private:
    std::string place(SectionType type) const { return name_ + ": section " + section_name(type); }
    Error fault(SectionType type, std::string reason, ErrorCode code = ErrorCode::kMalformed) const {
        return {code, place(type), std::move(reason)};
    }

    std::optional<Error> find_all() const {
        if (!names_section(bytes_, kRecordingSection)) return Error{ErrorCode::kMalformed, name_, "it is no recording"};
        for (const SectionType type : kSectionsOfRecordings)
            if (!names_section(bytes_, type)) return fault(type, "is missing");
        for (const Section& section : sections_) {
            bool known = !section.required();
            for (const SectionType type : kSectionsOfRecordings) known = known || section.type == type;
            if (!known)
                return fault(section.type, "is needed to understand the file, and this Firma does not know it",
                             ErrorCode::kUnsupported);
        }
        return std::nullopt;
    }

    /// Of one that find_all() found.
    std::span<const std::byte> bytes_of(SectionType type) const {
        for (const Section& section : sections_)
            if (section.type == type) return section.bytes;
        return {};
    }

    std::optional<Error> take_head() {
        const std::string where = place(kRecordingSection);
        ByteReader in(bytes_of(kRecordingSection), where);
        const std::uint32_t version = in.u32();
        if (in.ok() && version != kRecordingVersion)
            in.fail_at(0, ErrorCode::kUnsupported,
                       "it is of version " + std::to_string(version) + " of recordings; this Firma reads version 1");
        recording_.level_hash = in.u64();
        recording_.level = in.text();
        if (in.ok() && !in.at_end()) in.fail("bytes behind the name of the level");
        return in.error();
    }

    std::optional<Error> take_game(SectionType type, GameState& game) {
        Result<GameState> read = unpack_game(bytes_of(type), place(type));
        if (!read) return read.error();
        game = std::move(read).value();
        return std::nullopt;
    }

    std::optional<Error> take_event_list() {
        const std::string where = place(kRecordedEventsSection);
        ByteReader in(bytes_of(kRecordedEventsSection), where);
        recording_.events = take_events(in);
        if (in.ok() && !in.at_end()) in.fail("bytes behind the last event");
        if (!in.ok()) return in.error();
        if (auto error = judge_events(recording_.start, recording_.events))
            return fault(kRecordedEventsSection, error->text());
        return std::nullopt;
    }

    const std::span<const std::byte> bytes_;
    const std::string& name_;
    std::vector<Section> sections_;
    Recording recording_;
};

}  // namespace

Result<std::vector<std::byte>> pack_recording(const Recording& recording) {
    if (auto error = judge_events(recording.start, recording.events)) return *error;
    ByteWriter head, start, events, hashes, end;
    head.u32(kRecordingVersion);
    head.u64(recording.level_hash);
    put_text(head, recording.level);
    for (const auto& [game, out] : {std::pair(&recording.start, &start), std::pair(&recording.end, &end)}) {
        const Result<std::vector<std::byte>> packed = pack_game(*game);
        if (!packed) return packed.error();
        put_bytes(*out, packed.value());
    }
    put_events(events, recording.events);
    put_bytes(hashes, recording.hashes.bytes());
    std::vector<NewSection> sections;
    sections.push_back({kRecordingSection, kRequiredSection, std::move(head)});
    sections.push_back({kRecordedStartSection, kRequiredSection, std::move(start)});
    sections.push_back({kRecordedEventsSection, kRequiredSection, std::move(events)});
    sections.push_back({kRecordedHashesSection, kRequiredSection, std::move(hashes)});
    sections.push_back({kRecordedEndSection, kRequiredSection, std::move(end)});
    return write_container(sections);
}

Result<Recording> unpack_recording(std::span<const std::byte> bytes, std::string name) {
    return RecordingReader(bytes, name).read();
}

bool is_recording(std::span<const std::byte> bytes) {
    return names_section(bytes, kRecordingSection);
}

}  // namespace firma
