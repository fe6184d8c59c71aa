// SPDX-License-Identifier: MIT
// Edits as bytes: commands made, packed, shown, applied.
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "bindings/c/convert.h"
#include "bindings/c/objects.h"
#include "bindings/c/orders.h"
#include "bindings/c/results.h"
#include "firma/edit_log.h"

namespace firma::c {
namespace {

firma_code give_command(EditCommand command, firma_command* out, const char* function) {
    return give(std::make_unique<CommandObject>(std::move(command)), out, function);
}

void put_edit(const EditCommand& command, firma_command_view& view) {
    const CarveOptions& options = command.options;
    if (const auto* crater = std::get_if<CraterSeed>(&command.cutter)) {
        view.shape = std::uint32_t(crater->shape);
        view.seed = crater->seed;
    }
    put_pose(command.pose, view.pose);
    view.material = options.material.c_str();
    view.has_from = options.from.has_value();
    if (options.from) put(*options.from, view.from);
    view.chunks = options.chunks.has_value();
    if (!options.chunks) return;
    view.min_chunk_volume = options.chunks->min_volume;
    view.density = options.chunks->density;
}

}  // namespace
}  // namespace firma::c

using namespace firma;
using namespace firma::c;

static_assert(FIRMA_EDIT_CARVE == int(EditKind::kCarve) && FIRMA_EDIT_FILL == int(EditKind::kFill) &&
              FIRMA_EDIT_DOOR == int(EditKind::kDoor) && FIRMA_EDIT_GROUP == int(EditKind::kGroup));

firma_code firma_pose_quantise(const firma_pose* pose, firma_pose* out) {
    return guarded(__func__, [&, function = __func__] {
        if (!pose || !out) return bad_call(function, kNull);
        put_pose(quantised(pose_of(*pose)), *out);
        return FIRMA_OK;
    });
}

firma_code firma_command_edit(uint32_t number, firma_cutter cutter, const firma_pose* pose,
                              const firma_carve_options* options, firma_command* command) {
    return guarded(__func__, [&, function = __func__] {
        if (!command) return bad_call(function, kNull);
        Order order;
        if (const firma_code code = read_order(cutter, pose, options, order, function)) return code;
        EditCommand made;
        made.number = number;
        made.kind = order.kind == CarveKind::kFill ? EditKind::kFill : EditKind::kCarve;
        if (order.cutter->seed)
            made.cutter = *order.cutter->seed;
        else
            made.cutter = order.cutter->cutter;
        made.pose = order.pose;
        made.options = std::move(order.options);
        made.options.edit = 0;
        return give_command(std::move(made), command, function);
    });
}

firma_code firma_command_door(uint32_t number, uint32_t portal, uint32_t open, firma_command* command) {
    return guarded(__func__, [&, function = __func__] {
        if (!command) return bad_call(function, kNull);
        if (open > 1) return fail(FIRMA_ERROR_INVALID, function, "open must be 0 or 1");
        EditCommand made;
        made.number = number;
        made.kind = EditKind::kDoor;
        made.portal = {portal};
        made.open = open == 1;
        return give_command(std::move(made), command, function);
    });
}

firma_code firma_command_group(const firma_command* parts, size_t count, firma_command* command) {
    return guarded(__func__, [&, function = __func__] {
        if (!command || (count && !parts)) return bad_call(function, kNull);
        if (count == 0) return fail(FIRMA_ERROR_INVALID, function, "a group has at least one part");
        EditCommand made;
        made.kind = EditKind::kGroup;
        for (std::size_t k = 0; k < count; ++k) {
            const CommandObject* part = find<CommandObject>(parts[k].id, function);
            if (!part) return FIRMA_ERROR_BAD_HANDLE;
            if (part->command.kind == EditKind::kGroup)
                return fail(FIRMA_ERROR_INVALID, function, "part " + std::to_string(k) + " is a group");
            if (k > 0 && part->command.number <= made.parts.back().number)
                return fail(FIRMA_ERROR_INVALID, function,
                            "the number of part " + std::to_string(k) + " is not above the one before");
            made.parts.push_back(part->command);
        }
        return give_command(std::move(made), command, function);
    });
}

firma_code firma_command_quantise(firma_command command, firma_command* out) {
    return guarded(__func__, [&, function = __func__] {
        if (!out) return bad_call(function, kNull);
        const CommandObject* object = find<CommandObject>(command.id, function);
        return object ? give_command(quantised(object->command), out, function) : FIRMA_ERROR_BAD_HANDLE;
    });
}

firma_code firma_command_pack(firma_command command, firma_bytes* bytes) {
    return guarded(__func__, [&, function = __func__] {
        if (!bytes) return bad_call(function, kNull);
        const CommandObject* object = find<CommandObject>(command.id, function);
        if (!object) return FIRMA_ERROR_BAD_HANDLE;
        return give_bytes(pack_command(object->command), bytes, function);
    });
}

firma_code firma_command_unpack(const void* data, size_t length, const char* name, firma_command* command) {
    return guarded(__func__, [&, function = __func__] {
        if (!command || (!data && length)) return bad_call(function, kNull);
        Result<EditCommand> read = unpack_command(bytes_of(data, length), name_or(name, "command"));
        if (!read) return fail(read.error());
        return give_command(std::move(read).value(), command, function);
    });
}

firma_code firma_command_get_view(firma_command command, firma_command_view* out) {
    return guarded(__func__, [&, function = __func__] {
        if (!out) return bad_call(function, kNull);
        if (!sized(out)) return bad_call(function, kWrongSize);
        const CommandObject* object = find<CommandObject>(command.id, function);
        if (!object) return FIRMA_ERROR_BAD_HANDLE;
        const EditCommand& made = object->command;
        firma_command_view view{};
        view.kind = std::uint32_t(made.kind);
        view.number = made.kind == EditKind::kGroup ? 0 : made.number;
        view.last_number = last_number(made);
        view.part_count = std::uint32_t(made.parts.size());
        view.portal = made.kind == EditKind::kDoor ? made.portal.value : FIRMA_NO_PORTAL;
        view.open = made.kind == EditKind::kDoor && made.open;
        view.shape = FIRMA_NO_SHAPE;
        view.material = "";
        if (made.kind == EditKind::kCarve || made.kind == EditKind::kFill) put_edit(made, view);
        put_sized(view, out);
        return FIRMA_OK;
    });
}

firma_code firma_command_part(firma_command command, size_t part, firma_command* out) {
    return guarded(__func__, [&, function = __func__] {
        if (!out) return bad_call(function, kNull);
        const CommandObject* object = find<CommandObject>(command.id, function);
        if (!object) return FIRMA_ERROR_BAD_HANDLE;
        if (part >= object->command.parts.size())
            return fail(FIRMA_ERROR_OUT_OF_RANGE, function, "the command has no such part");
        return give_command(object->command.parts[part], out, function);
    });
}

firma_code firma_command_release(firma_command command) {
    return release<CommandObject>(command.id, __func__);
}

firma_code firma_command_apply(firma_world world, firma_command command, firma_world* after,
                               firma_carve_report* report) {
    return guarded(__func__, [&, function = __func__] {
        if (!after) return bad_call(function, kNull);
        if (report && !sized(report)) return bad_call(function, kWrongSize);
        const WorldObject* object = find<WorldObject>(world.id, function);
        const CommandObject* edit = object ? find<CommandObject>(command.id, function) : nullptr;
        if (!edit) return FIRMA_ERROR_BAD_HANDLE;
        return give_result(carve_result(apply(object->world, edit->command)), after, report, function);
    });
}

firma_code firma_command_start(firma_world world, firma_command command, firma_job* job) {
    return guarded(__func__, [&, function = __func__] {
        if (!job) return bad_call(function, kNull);
        const WorldObject* object = find<WorldObject>(world.id, function);
        const CommandObject* edit = object ? find<CommandObject>(command.id, function) : nullptr;
        if (!edit) return FIRMA_ERROR_BAD_HANDLE;
        return give(std::make_unique<JobObject>(CommandJob(object->world, edit->command)), job, function);
    });
}
