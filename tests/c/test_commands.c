/* SPDX-License-Identifier: MIT */
/* Commands: what they say, as bytes and back, applied at once and in slices. */
#include <math.h>

#include "tests/c/check.h"

static const firma_pose kInFloor = {{4.1, 4.2, 0.3}, {0.1, 0.2, 0.3, 0.9}, 1.3};

static firma_command crater_command(uint32_t number, uint64_t seed) {
    const firma_carve_options options = {.size = sizeof options, .material = "dirt", .has_from = 1, .from = {4, 4, 2}};
    firma_cutter crater = {0};
    firma_command exact = {0}, command = {0};
    firma_pose pose = kInFloor;
    firma_random_turn(seed, pose.rotation);
    CHECK_OK(firma_cutter_crater(FIRMA_ROCKY, seed, &crater));
    CHECK_OK(firma_command_edit(number, crater, &pose, &options, &exact));
    CHECK_OK(firma_command_quantise(exact, &command));
    CHECK_OK(firma_command_release(exact));
    CHECK_OK(firma_cutter_release(crater));
    return command;
}

static size_t packed_size(firma_command command) {
    firma_bytes bytes = {0};
    const void* data = NULL;
    size_t length = 0;
    CHECK_OK(firma_command_pack(command, &bytes));
    CHECK_OK(firma_bytes_get_view(bytes, &data, &length));
    CHECK_OK(firma_bytes_release(bytes));
    return length;
}

/* The same command, read from its bytes. */
static firma_command read_back(firma_command command) {
    firma_bytes bytes = {0};
    firma_command read = {0};
    const void* data = NULL;
    size_t length = 0;
    CHECK_OK(firma_command_pack(command, &bytes));
    CHECK_OK(firma_bytes_get_view(bytes, &data, &length));
    CHECK_OK(firma_command_unpack(data, length, "sent", &read));
    /* Without its end it is refused, or another command: one without its last options. */
    for (size_t shorter = 0; shorter < length; ++shorter) {
        firma_command part = {0};
        const firma_code code = firma_command_unpack(data, shorter, "sent", &part);
        CHECK(code == FIRMA_ERROR_MALFORMED || (code == FIRMA_OK && packed_size(part) == shorter));
        CHECK_OK(firma_command_release(part));
    }
    CHECK_OK(firma_bytes_release(bytes));
    return read;
}

static void test_pose(void) {
    firma_pose once, twice;
    CHECK_OK(firma_pose_quantise(&kInFloor, &once));
    CHECK_OK(firma_pose_quantise(&once, &twice));
    CHECK(memcmp(&once, &twice, sizeof once) == 0);
    for (int axis = 0; axis < 3; ++axis) {
        CHECK(fabs(once.position[axis] - kInFloor.position[axis]) <= 1.0 / 8192);
        CHECK(once.position[axis] * 4096 == floor(once.position[axis] * 4096));
    }
    CHECK_FAILS(firma_pose_quantise(NULL, &once), FIRMA_ERROR_BAD_CALL, "null");
}

static void test_view(firma_command command) {
    const firma_command read = read_back(command);
    firma_command_view view = {.size = sizeof view};
    CHECK(packed_size(command) < 64);
    CHECK_OK(firma_command_get_view(read, &view));
    CHECK(view.kind == FIRMA_EDIT_CARVE && view.number == 3 && view.last_number == 3 && view.part_count == 0);
    CHECK(view.shape == FIRMA_ROCKY && view.seed == 77 && view.portal == FIRMA_NO_PORTAL);
    CHECK(strcmp(view.material, "dirt") == 0 && view.has_from == 1 && view.from[2] == 2 && view.chunks == 0);
    CHECK(fabs(view.pose.scale - 1.3) <= 1.0 / 8192);
    view.size = 4;
    CHECK_FAILS(firma_command_get_view(read, &view), FIRMA_ERROR_BAD_CALL, "size");
    CHECK_OK(firma_command_release(read));
}

/* At once, in slices, and as the carve that it says. */
static void test_apply(firma_world room, firma_command command) {
    firma_carve_report report = {.size = sizeof report};
    firma_world applied = {0}, other = {0};
    firma_command_view view = {.size = sizeof view};
    firma_cutter crater = {0};
    firma_job job = {0};
    uint32_t finished = 0;
    CHECK_OK(firma_command_apply(room, command, &applied, &report));
    CHECK(report.status == FIRMA_CARVE_DONE && report.volume > 0.5 && report.faces_added > 10 && report.scale == 1);
    CHECK_OK(firma_command_start(room, command, &job));
    CHECK_FAILS(firma_job_result(job, &other, NULL), FIRMA_ERROR_BAD_CALL, "not finished");
    while (!finished) CHECK_OK(firma_job_run(job, 0, &finished));
    CHECK_OK(firma_job_result(job, &other, &report));
    CHECK(report.status == FIRMA_CARVE_DONE && hash_of(other) == hash_of(applied));
    CHECK_OK(firma_job_release(job));
    CHECK_OK(firma_world_release(other));
    CHECK_OK(firma_command_get_view(command, &view));
    CHECK_OK(firma_cutter_crater(view.shape, view.seed, &crater));
    const firma_carve_options options = {
        .size = sizeof options, .material = "dirt", .has_from = 1, .from = {4, 4, 2}, .edit = 3};
    CHECK_OK(firma_carve(room, crater, &view.pose, &options, &other, NULL));
    CHECK(hash_of(other) == hash_of(applied));
    CHECK_OK(firma_cutter_release(crater));
    CHECK_OK(firma_world_release(other));
    CHECK_OK(firma_command_apply(applied, command, &other, &report)); /* its number was used */
    CHECK(report.status == FIRMA_CARVE_REFUSED && hash_of(other) == hash_of(applied));
    CHECK(strlen(firma_error_message()) > 0);
    CHECK_OK(firma_world_release(other));
    CHECK_OK(firma_world_release(applied));
}

static void test_groups(firma_world room, firma_command first) {
    const firma_command second = crater_command(4, 5);
    const firma_command parts[] = {first, second}, backwards[] = {second, first};
    firma_command group = {0}, part = {0}, none = {0};
    firma_command_view view = {.size = sizeof view};
    firma_carve_report report = {.size = sizeof report}, one = {.size = sizeof one};
    firma_world after = {0}, half = {0}, whole = {0};
    CHECK_OK(firma_command_group(parts, 2, &group));
    CHECK_OK(firma_command_get_view(group, &view));
    CHECK(view.kind == FIRMA_EDIT_GROUP && view.number == 0 && view.last_number == 4 && view.part_count == 2);
    CHECK_OK(firma_command_part(group, 1, &part));
    CHECK_OK(firma_command_get_view(part, &view));
    CHECK(view.number == 4 && view.seed == 5);
    CHECK_OK(firma_command_release(part));
    CHECK_FAILS(firma_command_part(group, 2, &part), FIRMA_ERROR_OUT_OF_RANGE, "no such part");
    const firma_command read = read_back(group);
    CHECK_OK(firma_command_apply(room, read, &after, &report));
    CHECK_OK(firma_command_apply(room, first, &half, &one));
    const double volume = one.volume;
    CHECK_OK(firma_command_apply(half, second, &whole, &one));
    CHECK(report.status == FIRMA_CARVE_DONE && fabs(report.volume - volume - one.volume) < 1e-9);
    firma_world_facts facts = {.size = sizeof facts};
    CHECK_OK(firma_world_get_facts(after, &facts));
    CHECK(facts.version == 1 && facts.edits == 4);
    CHECK_FAILS(firma_command_group(backwards, 2, &none), FIRMA_ERROR_INVALID, "part 1");
    CHECK_FAILS(firma_command_group(&group, 1, &none), FIRMA_ERROR_INVALID, "is a group");
    CHECK_FAILS(firma_command_group(parts, 0, &none), FIRMA_ERROR_INVALID, "at least one");
    CHECK_OK(firma_command_release(read));
    CHECK_OK(firma_command_release(group));
    CHECK_OK(firma_command_release(second));
    CHECK_OK(firma_world_release(whole));
    CHECK_OK(firma_world_release(half));
    CHECK_OK(firma_world_release(after));
}

static void test_doors(firma_world room) {
    firma_command door = {0};
    firma_command_view view = {.size = sizeof view};
    firma_carve_report report = {.size = sizeof report};
    firma_world after = {0};
    CHECK_FAILS(firma_command_door(1, 0, 2, &door), FIRMA_ERROR_INVALID, "open");
    CHECK_OK(firma_command_door(1, 6, 1, &door));
    const firma_command read = read_back(door);
    CHECK_OK(firma_command_get_view(read, &view));
    CHECK(view.kind == FIRMA_EDIT_DOOR && view.portal == 6 && view.open == 1 && view.shape == FIRMA_NO_SHAPE);
    CHECK_OK(firma_command_apply(room, read, &after, &report)); /* a room without portals */
    CHECK(report.status == FIRMA_CARVE_REFUSED && hash_of(after) == hash_of(room));
    CHECK_OK(firma_world_release(after));
    CHECK_OK(firma_command_release(read));
    CHECK_OK(firma_command_release(door));
}

static void test_refused(firma_world room, firma_command command) {
    firma_cutter box = make_box(0, 0, 0, 1, 1, 1);
    firma_command odd = {0};
    firma_bytes bytes = {0};
    firma_world after = {0};
    CHECK_OK(firma_command_edit(0, box, &kInFloor, NULL, &odd));
    CHECK_FAILS(firma_command_pack(odd, &bytes), FIRMA_ERROR_INVALID, "");
    CHECK_OK(firma_command_release(odd));
    CHECK_OK(firma_command_edit(1u << 21, box, &kInFloor, NULL, &odd));
    CHECK_FAILS(firma_command_pack(odd, &bytes), FIRMA_ERROR_TOO_LARGE, "");
    CHECK_OK(firma_command_release(odd));
    CHECK_OK(firma_command_edit(1, box, &kInFloor, NULL, &odd));
    const firma_command read = read_back(odd); /* a mesh, stored whole */
    firma_command_view view = {.size = sizeof view};
    CHECK_OK(firma_command_get_view(read, &view));
    CHECK(view.shape == FIRMA_NO_SHAPE && memcmp(&view.pose, &kInFloor, sizeof kInFloor) == 0);
    CHECK_OK(firma_command_release(read));
    CHECK_OK(firma_command_release(odd));
    CHECK_FAILS(firma_command_edit(1, box, NULL, NULL, &odd), FIRMA_ERROR_BAD_CALL, "null");
    CHECK_FAILS(firma_command_unpack(NULL, 4, NULL, &odd), FIRMA_ERROR_BAD_CALL, "null");
    CHECK_FAILS(firma_command_apply(room, odd, &after, NULL), FIRMA_ERROR_BAD_HANDLE, "command");
    CHECK_FAILS(firma_command_apply(after, command, &after, NULL), FIRMA_ERROR_BAD_HANDLE, "world");
    CHECK_OK(firma_cutter_release(box));
}

void test_commands(void) {
    const firma_world room = make_room();
    const firma_command command = crater_command(3, 77);
    test_pose();
    test_view(command);
    test_apply(room, command);
    test_groups(room, command);
    test_doors(room);
    test_refused(room, command);
    CHECK_OK(firma_command_release(command));
    CHECK_OK(firma_world_release(room));
}
