// SPDX-License-Identifier: MIT
// Edit logs and their replays.
#include <memory>
#include <span>
#include <utility>

#include "bindings/c/convert.h"
#include "bindings/c/objects.h"
#include "firma/edit_log.h"

using namespace firma;
using namespace firma::c;

firma_code firma_log_begin(firma_world level, firma_log* log) {
    return guarded(__func__, [&, function = __func__] {
        if (!log) return bad_call(function, kNull);
        const WorldObject* object = find<WorldObject>(level.id, function);
        if (!object) return FIRMA_ERROR_BAD_HANDLE;
        return give(std::make_unique<LogObject>(EditLog(object->world)), log, function);
    });
}

firma_code firma_log_append(firma_log log, firma_command command) {
    return guarded(__func__, [&, function = __func__] {
        LogObject* object = find<LogObject>(log.id, function);
        const CommandObject* edit = object ? find<CommandObject>(command.id, function) : nullptr;
        if (!edit) return FIRMA_ERROR_BAD_HANDLE;
        const std::optional<Error> error = object->log.append(edit->command);
        return error ? fail(*error) : FIRMA_OK;
    });
}

firma_code firma_log_checkpoint(firma_log log, firma_world world) {
    return guarded(__func__, [&, function = __func__] {
        LogObject* object = find<LogObject>(log.id, function);
        const WorldObject* now = object ? find<WorldObject>(world.id, function) : nullptr;
        if (!now) return FIRMA_ERROR_BAD_HANDLE;
        object->log.add_checkpoint(now->world);
        return FIRMA_OK;
    });
}

firma_code firma_log_get_facts(firma_log log, firma_log_facts* out) {
    return guarded(__func__, [&, function = __func__] {
        if (!out) return bad_call(function, kNull);
        if (!sized(out)) return bad_call(function, kWrongSize);
        const LogObject* object = find<LogObject>(log.id, function);
        if (!object) return FIRMA_ERROR_BAD_HANDLE;
        const EditLog& held = object->log;
        firma_log_facts facts{};
        facts.level_edits = held.level_edits();
        facts.level_hash = held.level_hash();
        facts.rules_hash = held.rules_hash();
        facts.command_count = held.commands().size();
        facts.checkpoint_count = held.checkpoints().size();
        facts.patch_bytes = held.patch().size();
        facts.last_number = held.last_number();
        facts.patched_number = held.patched_number();
        put_sized(facts, out);
        return FIRMA_OK;
    });
}

firma_code firma_log_command(firma_log log, size_t index, firma_command* command) {
    return guarded(__func__, [&, function = __func__] {
        if (!command) return bad_call(function, kNull);
        const LogObject* object = find<LogObject>(log.id, function);
        if (!object) return FIRMA_ERROR_BAD_HANDLE;
        if (index >= object->log.commands().size())
            return fail(FIRMA_ERROR_OUT_OF_RANGE, function, "the log has no such command");
        return give(std::make_unique<CommandObject>(object->log.commands()[index]), command, function);
    });
}

firma_code firma_log_pack(firma_log log, firma_bytes* bytes) {
    return guarded(__func__, [&, function = __func__] {
        if (!bytes) return bad_call(function, kNull);
        const LogObject* object = find<LogObject>(log.id, function);
        if (!object) return FIRMA_ERROR_BAD_HANDLE;
        return give_bytes(pack_log(object->log), bytes, function);
    });
}

firma_code firma_log_unpack(const void* data, size_t length, const char* name, firma_log* log) {
    return guarded(__func__, [&, function = __func__] {
        if (!log || (!data && length)) return bad_call(function, kNull);
        Result<EditLog> read = unpack_log(bytes_of(data, length), name_or(name, "log"));
        if (!read) return fail(read.error());
        return give(std::make_unique<LogObject>(std::move(read).value()), log, function);
    });
}

firma_code firma_log_compact(firma_log log, firma_world level, uint32_t number, firma_log* out) {
    return guarded(__func__, [&, function = __func__] {
        if (!out) return bad_call(function, kNull);
        const LogObject* object = find<LogObject>(log.id, function);
        const WorldObject* first = object ? find<WorldObject>(level.id, function) : nullptr;
        if (!first) return FIRMA_ERROR_BAD_HANDLE;
        Result<EditLog> made = compacted(first->world, object->log, number);
        if (!made) return fail(made.error());
        return give(std::make_unique<LogObject>(std::move(made).value()), out, function);
    });
}

firma_code firma_log_release(firma_log log) {
    return release<LogObject>(log.id, __func__);
}

firma_code firma_replay_start(firma_world level, firma_log log, uint32_t last_number, firma_replay* replay) {
    return guarded(__func__, [&, function = __func__] {
        if (!replay) return bad_call(function, kNull);
        const WorldObject* first = find<WorldObject>(level.id, function);
        const LogObject* object = first ? find<LogObject>(log.id, function) : nullptr;
        if (!object) return FIRMA_ERROR_BAD_HANDLE;
        const ReplayOptions options{last_number};
        return give(std::make_unique<ReplayObject>(LogReplay(first->world, object->log, options)), replay, function);
    });
}

firma_code firma_replay_run(firma_replay replay, double microseconds, uint32_t* finished) {
    return guarded(__func__, [&, function = __func__] {
        if (!finished) return bad_call(function, kNull);
        ReplayObject* object = find<ReplayObject>(replay.id, function);
        if (!object) return FIRMA_ERROR_BAD_HANDLE;
        if (!(microseconds >= 0)) return fail(FIRMA_ERROR_INVALID, function, "the time is negative, or no number");
        *finished = object->replay.run(microseconds);
        return FIRMA_OK;
    });
}

firma_code firma_replay_get_facts(firma_replay replay, firma_replay_facts* out) {
    return guarded(__func__, [&, function = __func__] {
        if (!out) return bad_call(function, kNull);
        if (!sized(out)) return bad_call(function, kWrongSize);
        ReplayObject* object = find<ReplayObject>(replay.id, function);
        if (!object) return FIRMA_ERROR_BAD_HANDLE;
        const ReplayResult result = object->replay.result();
        // Once: what was given stays where it is.
        if (result.error && object->error.empty()) object->error = result.error->text();
        firma_replay_facts facts{};
        facts.finished = object->replay.finished();
        facts.commands_behind = object->replay.commands_behind();
        facts.commands_in_all = object->replay.commands_in_all();
        facts.applied = result.commands;
        facts.done = result.done;
        facts.nothing = result.nothing;
        facts.refused = result.refused;
        facts.checkpoints = result.checkpoints;
        facts.error = object->error.c_str();
        put_sized(facts, out);
        return FIRMA_OK;
    });
}

firma_code firma_replay_result(firma_replay replay, firma_world* world) {
    return guarded(__func__, [&, function = __func__] {
        if (!world) return bad_call(function, kNull);
        const ReplayObject* object = find<ReplayObject>(replay.id, function);
        if (!object) return FIRMA_ERROR_BAD_HANDLE;
        ReplayResult result = object->replay.result();
        if (result.error) return fail(*result.error);
        return give(std::make_unique<WorldObject>(std::move(result.world)), world, function);
    });
}

firma_code firma_replay_release(firma_replay replay) {
    return release<ReplayObject>(replay.id, __func__);
}
