// SPDX-License-Identifier: MIT
// Games recorded and replayed; games and recordings as bytes and in files.
#include <memory>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "bindings/c/convert.h"
#include "bindings/c/game_object.h"
#include "bindings/c/objects.h"
#if !defined(__wasm__)
#include <span>
#include <system_error>

#include "base/file_aside.h"
#include "level/read_file.h"
#endif

namespace firma::c {
namespace {

static_assert(FIRMA_EVENT_PART + 1 == std::variant_size_v<decltype(GameEvent::what)>);

class EventTeller {
public:
    explicit EventTeller(firma_game_event& out) : out_(out) {}

    void operator()(const EditEvent& event) const {
        const EditCommand& command = event.command;
        if (command.kind == EditKind::kCarve || command.kind == EditKind::kFill)
            put(command.pose.position, out_.position);
    }
    void operator()(const BlastEvent& event) const { put(event.at, out_.position); }
    void operator()(const FireEvent& event) const {
        out_.index = event.weapon;
        put(event.position, out_.position);
        put(event.velocity, out_.velocity);
    }
    void operator()(const BodyEvent& event) const {
        put(event.body.position, out_.position);
        put(event.body.velocity, out_.velocity);
    }
    void operator()(const PlayerEvent& event) const {
        put(event.player.player.position, out_.position);
        put(event.player.player.velocity, out_.velocity);
    }
    void operator()(const WishEvent& event) const {
        out_.index = event.player;
        put(event.wish.velocity, out_.velocity);
    }
    void operator()(const PartEvent& event) const { out_.index = event.part; }

private:
    firma_game_event& out_;
};

firma_code give_recording(Recording made, firma_recording* out, const char* function) {
    return give(std::make_unique<RecordingObject>(std::move(made)), out, function);
}

firma_code give_packed(Result<std::vector<std::byte>> packed, firma_bytes* out, const char* function) {
    if (!packed) return fail_in(function, packed.error());
    return give_bytes(std::move(packed), out, function);
}

firma_code give_unpacked(Result<GameState> read, firma_game* out, const char* function) {
    if (!read) return fail_in(function, read.error());
    return give_game(std::move(read).value(), out, function);
}
firma_code give_unpacked(Result<Recording> read, firma_recording* out, const char* function) {
    if (!read) return fail_in(function, read.error());
    return give_recording(std::move(read).value(), out, function);
}

#if defined(__wasm__)

firma_code save_packed(const Result<std::vector<std::byte>>&, const char*, const char* function) {
    return fail(FIRMA_ERROR_UNSUPPORTED, function, "there are no files here: pack it");
}
template <class Unpack, class Handle>
firma_code load_file(const char*, const Unpack&, Handle*, const char* function) {
    return fail(FIRMA_ERROR_UNSUPPORTED, function, "there are no files here: unpack it");
}

#else

firma_code save_packed(const Result<std::vector<std::byte>>& packed, const char* path, const char* function) {
    if (!packed) return fail_in(function, packed.error());
    if (!*path) return fail(FIRMA_ERROR_INVALID, function, "a file needs a name");
    const int reason = write_whole_file(path, [&](FileAside& file) { return file.write(packed.value()); });
    if (reason == 0) return FIRMA_OK;
    return fail({ErrorCode::kCannotWrite, path, "cannot be written: " + std::generic_category().message(reason)});
}
template <class Unpack, class Handle>
firma_code load_file(const char* path, const Unpack& unpack, Handle* out, const char* function) {
    const Result<std::string> text = read_file(path);
    if (!text) return fail(text.error());
    return give_unpacked(unpack(std::as_bytes(std::span(text.value())), path), out, function);
}

#endif

}  // namespace
}  // namespace firma::c

using namespace firma;
using namespace firma::c;

firma_code firma_game_pack(firma_game game, firma_bytes* bytes) {
    return guarded(__func__, [&, function = __func__] {
        if (!bytes) return bad_call(function, kNull);
        firma_code code = FIRMA_OK;
        const GameObject* const object = find_game(game, code, function);
        return object ? give_packed(pack_game(object->game()), bytes, function) : code;
    });
}

firma_code firma_game_unpack(const void* data, size_t length, const char* name, firma_game* game) {
    return guarded(__func__, [&, function = __func__] {
        if (!game || (!data && length)) return bad_call(function, kNull);
        return give_unpacked(unpack_game(bytes_of(data, length), name_or(name, "game")), game, function);
    });
}

firma_code firma_game_save(firma_game game, const char* path) {
    return guarded(__func__, [&, function = __func__] {
        if (!path) return bad_call(function, kNull);
        firma_code code = FIRMA_OK;
        const GameObject* const object = find_game(game, code, function);
        return object ? save_packed(pack_game(object->game()), path, function) : code;
    });
}

firma_code firma_game_load(const char* path, firma_game* game) {
    return guarded(__func__, [&, function = __func__] {
        if (!path || !game) return bad_call(function, kNull);
        return load_file(path, unpack_game, game, function);
    });
}

firma_code firma_game_bytes_kind(const void* data, size_t length, uint32_t* kind) {
    return guarded(__func__, [&, function = __func__] {
        if (!kind || (!data && length)) return bad_call(function, kNull);
        *kind = is_recording(bytes_of(data, length))   ? FIRMA_BYTES_RECORDING
                : is_game_file(bytes_of(data, length)) ? FIRMA_BYTES_GAME
                                                       : FIRMA_BYTES_OTHER;
        return FIRMA_OK;
    });
}

firma_code firma_game_record(firma_game game, const char* level) {
    return guarded(__func__, [&, function = __func__] {
        firma_code code = FIRMA_OK;
        GameObject* const object = find_played(game, code, function);
        if (!object) return code;
        if (object->recording) return bad_call(function, "the game is being recorded already");
        Recording begun{text_of(level), object->own.log.level_hash(), object->own, {}, {}, {}};
        object->recording = std::move(begun);
        return FIRMA_OK;
    });
}

firma_code firma_game_recording(firma_game game, firma_recording* recording) {
    return guarded(__func__, [&, function = __func__] {
        if (!recording) return bad_call(function, kNull);
        firma_code code = FIRMA_OK;
        const GameObject* const object = find_game(game, code, function);
        if (!object) return code;
        if (!object->recording) return bad_call(function, "the game is not being recorded: firma_game_record()");
        const std::vector<GameEvent>& events = object->recording->events;
        if (!events.empty() && events.back().tick >= object->own.tick)
            return bad_call(function, "something has happened since the last tick: step the game first");
        Recording made = *object->recording;
        made.end = object->own;
        return give_recording(std::move(made), recording, function);
    });
}

firma_code firma_recording_replay(firma_recording recording, firma_game* game) {
    return guarded(__func__, [&, function = __func__] {
        if (!game) return bad_call(function, kNull);
        const RecordingObject* const object = find<RecordingObject>(recording.id, function);
        if (!object) return FIRMA_ERROR_BAD_HANDLE;
        auto made = std::make_unique<GameObject>();
        made->played = object->recording;
        made->replay = std::make_unique<GameReplayJob>(*made->played);
        return give(std::move(made), game, function);
    });
}

firma_code firma_game_get_replay(firma_game game, firma_game_replay* out) {
    return guarded(__func__, [&, function = __func__] {
        if (!out) return bad_call(function, kNull);
        if (!sized(out)) return bad_call(function, kWrongSize);
        firma_code code = FIRMA_OK;
        GameObject* const object = find_game(game, code, function);
        if (!object) return code;
        if (!object->replay) return bad_call(function, "the game is no replay");
        const GameReplay& result = object->replay->result();
        // Once: what was given stays where it is.
        if (object->text.empty() && result.difference) object->text = result.difference->text();
        if (object->text.empty() && result.error) object->text = result.error->text();
        firma_game_replay told{};
        told.finished = object->replay->finished();
        told.ticks = result.ticks;
        told.ticks_in_all = object->played->hashes.size();
        told.differs = result.difference.has_value();
        if (result.difference) {
            told.at_end = result.difference->at_end;
            told.tick = result.difference->tick;
            told.hash = result.difference->hash;
            told.recorded = result.difference->recorded;
        }
        told.text = object->text.c_str();
        put_sized(told, out);
        return FIRMA_OK;
    });
}

firma_code firma_recording_get_facts(firma_recording recording, firma_recording_facts* out) {
    return guarded(__func__, [&, function = __func__] {
        if (!out) return bad_call(function, kNull);
        if (!sized(out)) return bad_call(function, kWrongSize);
        const RecordingObject* const object = find<RecordingObject>(recording.id, function);
        if (!object) return FIRMA_ERROR_BAD_HANDLE;
        const Recording& held = *object->recording;
        firma_recording_facts facts{};
        facts.rate = held.start.rate;
        facts.first_tick = held.start.tick;
        facts.ticks = held.hashes.size();
        facts.events = held.events.size();
        facts.level_hash = held.level_hash;
        facts.level = held.level.c_str();
        put_sized(facts, out);
        return FIRMA_OK;
    });
}

firma_code firma_recording_game(firma_recording recording, uint32_t at_end, firma_game* game) {
    return guarded(__func__, [&, function = __func__] {
        if (!game) return bad_call(function, kNull);
        if (at_end > 1) return fail(FIRMA_ERROR_INVALID, function, "at_end must be 0 or 1");
        const RecordingObject* const object = find<RecordingObject>(recording.id, function);
        if (!object) return FIRMA_ERROR_BAD_HANDLE;
        return give_game(at_end ? object->recording->end : object->recording->start, game, function);
    });
}

firma_code firma_recording_event(firma_recording recording, size_t index, firma_game_event* event) {
    return guarded(__func__, [&, function = __func__] {
        if (!event) return bad_call(function, kNull);
        if (!sized(event)) return bad_call(function, kWrongSize);
        const RecordingObject* const object = find<RecordingObject>(recording.id, function);
        if (!object) return FIRMA_ERROR_BAD_HANDLE;
        const std::vector<GameEvent>& events = object->recording->events;
        if (index >= events.size())
            return fail(FIRMA_ERROR_OUT_OF_RANGE, function, "there is no event " + std::to_string(index));
        firma_game_event told{};
        told.kind = std::uint32_t(events[index].what.index());
        told.tick = events[index].tick;
        std::visit(EventTeller(told), events[index].what);
        put_sized(told, event);
        return FIRMA_OK;
    });
}

firma_code firma_recording_pack(firma_recording recording, firma_bytes* bytes) {
    return guarded(__func__, [&, function = __func__] {
        if (!bytes) return bad_call(function, kNull);
        const RecordingObject* const object = find<RecordingObject>(recording.id, function);
        if (!object) return FIRMA_ERROR_BAD_HANDLE;
        return give_packed(pack_recording(*object->recording), bytes, function);
    });
}

firma_code firma_recording_unpack(const void* data, size_t length, const char* name, firma_recording* recording) {
    return guarded(__func__, [&, function = __func__] {
        if (!recording || (!data && length)) return bad_call(function, kNull);
        return give_unpacked(unpack_recording(bytes_of(data, length), name_or(name, "recording")), recording, function);
    });
}

firma_code firma_recording_save(firma_recording recording, const char* path) {
    return guarded(__func__, [&, function = __func__] {
        if (!path) return bad_call(function, kNull);
        const RecordingObject* const object = find<RecordingObject>(recording.id, function);
        if (!object) return FIRMA_ERROR_BAD_HANDLE;
        return save_packed(pack_recording(*object->recording), path, function);
    });
}

firma_code firma_recording_load(const char* path, firma_recording* recording) {
    return guarded(__func__, [&, function = __func__] {
        if (!path || !recording) return bad_call(function, kNull);
        return load_file(path, unpack_recording, recording, function);
    });
}

firma_code firma_recording_release(firma_recording recording) {
    return release<RecordingObject>(recording.id, __func__);
}
