// SPDX-License-Identifier: MIT
// Commands as bytes.
//
// The first byte: kind (3 bits), and of a door whether it opens (bit 3). Then the number less the one before; of a
// group how many parts instead, each after its length. A door: its portal. A carve or fill: a byte with the cutter's
// form (4 bits: a shape, or a number in the log, or the cutter itself) and the pose's (4 bits), the cutter, the pose,
// options.
#include "log/command_bytes.h"

#include <algorithm>
#include <utility>

#include "log/carve_option_bytes.h"
#include "log/cutter_bytes.h"
#include "log/pose_bytes.h"

namespace firma {
namespace {

constexpr unsigned kOpens = 8;
constexpr unsigned kCutterBits = 15, kPoseShift = 4;
constexpr unsigned kShapes = 5;  ///< forms below are shapes with their seeds
constexpr unsigned kNumberedCutter = 14, kCutterItself = 15;
constexpr std::uint8_t kCommandVersion = 1;

std::optional<Error> judge_number(std::uint32_t number, std::uint32_t before) {
    if (number > kMaxEditNumber)
        return Error{ErrorCode::kTooLarge, "",
                     "an edit cannot have the number " + std::to_string(number) + "; the last one is " +
                         std::to_string(kMaxEditNumber)};
    if (number <= before)
        return Error{ErrorCode::kInvalid, "",
                     "edit " + std::to_string(number) + " does not come after edit " + std::to_string(before)};
    return {};
}

std::optional<Error> judge_cut(const EditCommand& command) {
    if (const auto* crater = std::get_if<CraterSeed>(&command.cutter)) {
        if (unsigned(crater->shape) >= kShapes) return Error{ErrorCode::kInvalid, "", "a shape that is none"};
    } else if (!std::get<Cutter>(command.cutter).valid()) {
        return Error{ErrorCode::kInvalid, "", "an empty cutter"};
    }
    const Pose& pose = command.pose;
    if (!is_finite(pose.position) || !is_finite(pose.scale) ||
        !std::all_of(pose.rotation.begin(), pose.rotation.end(), [](double part) { return is_finite(part); }))
        return Error{ErrorCode::kOutOfRange, "", "the pose is not finite"};
    if (command.options.chunks) return judge_chunk_options(*command.options.chunks);
    return {};
}

std::optional<Error> judge_part(const EditCommand& command, std::uint32_t before) {
    if (auto error = judge_number(command.number, before)) return error;
    switch (command.kind) {
        case EditKind::kCarve:
        case EditKind::kFill:
            return judge_cut(command);
        case EditKind::kDoor:
            if (!command.portal.valid()) return Error{ErrorCode::kInvalid, "", "a door of no portal"};
            return {};
        case EditKind::kGroup:
            break;
    }
    return Error{ErrorCode::kInvalid, "", command.kind == EditKind::kGroup ? "a group in a group" : "no kind of edit"};
}

void put_crater_or_cutter(ByteWriter& out, const EditCommand& command, CutterNumbers* cutters) {
    if (const auto* crater = std::get_if<CraterSeed>(&command.cutter)) {
        const PoseForm form = form_of(command.pose, crater->seed);
        out.u8(std::uint8_t(unsigned(crater->shape) | unsigned(form.bits()) << kPoseShift));
        out.u64(crater->seed);
        return put_pose(out, command.pose, form);
    }
    const Cutter& cutter = std::get<Cutter>(command.cutter);
    const PoseForm form = form_of(command.pose, {});
    out.u8(std::uint8_t((cutters ? kNumberedCutter : kCutterItself) | unsigned(form.bits()) << kPoseShift));
    if (cutters) {
        put_whole(out, cutters->number(cutter));
    } else {
        ByteWriter whole;
        put_cutter(whole, cutter);
        put_whole(out, whole.size());
        put_bytes(out, whole.bytes());
    }
    put_pose(out, command.pose, form);
}

void take_cut(ByteReader& in, EditCommand& command, const std::vector<Cutter>* cutters) {
    const std::size_t where = in.place();
    const unsigned forms = in.u8(), form = forms & kCutterBits;
    std::optional<std::uint64_t> seed;
    if (form < kShapes) {
        seed = in.u64();
        command.cutter = CraterSeed{CutterShape(form), *seed};
    } else if (form == kNumberedCutter && cutters) {
        const std::uint64_t number = in.whole();
        if (number < cutters->size())
            command.cutter = (*cutters)[std::size_t(number)];
        else
            in.fail_at(where, ErrorCode::kMalformed, "a cutter that is not there");
    } else if (form == kCutterItself && !cutters) {
        ByteReader whole = in.part(in.whole());
        command.cutter = take_cutter(whole);
        if (!whole.ok()) in.fail(*whole.error());
    } else {
        in.fail_at(where, ErrorCode::kUnsupported, "a form of cutter that this Firma does not know");
    }
    command.pose = take_pose(in, PoseForm::of_bits(forms >> kPoseShift), seed);
    command.options = take_options(in);
}

std::uint32_t take_number(ByteReader& in, std::uint32_t before) {
    const std::size_t where = in.place();
    const std::uint64_t more = in.whole();
    if (in.ok() && (more == 0 || more > kMaxEditNumber || before + more > kMaxEditNumber))
        in.fail_at(where, ErrorCode::kMalformed, "its number is not above the one before, or beyond the last");
    return in.ok() ? before + std::uint32_t(more) : 0;
}

EditCommand take_part(ByteReader& in, std::uint32_t before, const std::vector<Cutter>* cutters, bool in_group);

void take_group(ByteReader& in, EditCommand& group, std::uint32_t before, const std::vector<Cutter>* cutters) {
    const std::uint64_t count = in.whole();
    if (in.ok() && (count == 0 || count > in.left())) in.fail("a group with no parts, or more than bytes follow");
    for (std::uint64_t k = 0; in.ok() && k < count; ++k) {
        ByteReader part = in.part(in.whole());
        if (!in.ok()) break;
        group.parts.push_back(take_part(part, before, cutters, true));
        if (!part.ok()) in.fail(*part.error());
        before = group.parts.back().number;
    }
}

EditCommand take_part(ByteReader& in, std::uint32_t before, const std::vector<Cutter>* cutters, bool in_group) {
    EditCommand command;
    const unsigned head = in.u8(), kind = head & 7, rest = head >> 3;
    command.kind = EditKind(kind);
    if (in.ok() && kind > unsigned(EditKind::kGroup)) in.fail(ErrorCode::kUnsupported, "no kind of edit that is known");
    if (in.ok() && rest > (command.kind == EditKind::kDoor ? 1u : 0u)) in.fail("flags that mean nothing");
    if (in.ok() && in_group && command.kind == EditKind::kGroup) in.fail("a group in a group");
    if (!in.ok()) return command;
    if (command.kind == EditKind::kGroup) {
        take_group(in, command, before, cutters);
    } else {
        command.number = take_number(in, before);
        if (command.kind == EditKind::kDoor) {
            command.open = (head & kOpens) != 0;
            const std::uint64_t portal = in.whole();
            if (in.ok() && portal >= PortalId().value) in.fail("a portal that is none");
            command.portal = {std::uint32_t(portal)};
        } else {
            take_cut(in, command, cutters);
        }
    }
    if (in.ok() && !in.at_end()) in.fail("bytes behind a command");
    return command;
}

}  // namespace

std::uint32_t last_number(const EditCommand& command) {
    if (command.kind != EditKind::kGroup) return command.number;
    return command.parts.empty() ? 0 : command.parts.back().number;
}

std::optional<Error> judge_command(const EditCommand& command, std::uint32_t before) {
    if (command.kind != EditKind::kGroup) return judge_part(command, before);
    if (command.parts.empty()) return Error{ErrorCode::kInvalid, "", "a group without parts"};
    for (std::size_t k = 0; k < command.parts.size(); ++k) {
        if (auto error = judge_part(command.parts[k], before)) {
            error->place = "part " + std::to_string(k);
            return error;
        }
        before = command.parts[k].number;
    }
    return {};
}

void put_command(ByteWriter& out, const EditCommand& command, std::uint32_t before, CutterNumbers* cutters) {
    const bool opens = command.kind == EditKind::kDoor && command.open;
    out.u8(std::uint8_t(unsigned(command.kind) | (opens ? kOpens : 0)));
    if (command.kind == EditKind::kGroup) {
        put_whole(out, command.parts.size());
        for (const EditCommand& part : command.parts) {
            ByteWriter bytes;
            put_command(bytes, part, before, cutters);
            put_whole(out, bytes.size());
            put_bytes(out, bytes.bytes());
            before = part.number;
        }
        return;
    }
    put_whole(out, command.number - before);
    if (command.kind == EditKind::kDoor) return put_whole(out, command.portal.value);
    put_crater_or_cutter(out, command, cutters);
    put_options(out, command.options);
}

EditCommand take_command(ByteReader& in, std::uint32_t before, const std::vector<Cutter>* cutters) {
    return take_part(in, before, cutters, false);
}

Result<std::vector<std::byte>> pack_command(const EditCommand& command) {
    if (std::optional<Error> error = judge_command(command, 0)) return *error;
    ByteWriter out;
    out.u8(kCommandVersion);
    put_command(out, command, 0, nullptr);
    return out.bytes();
}

Result<EditCommand> unpack_command(std::span<const std::byte> bytes, std::string name) {
    ByteReader in(bytes, name);
    const unsigned version = in.u8();
    if (in.ok() && version != kCommandVersion)
        in.fail_at(0, ErrorCode::kUnsupported,
                   "it is of version " + std::to_string(version) + " of commands; this Firma reads version 1");
    EditCommand command = take_command(in, 0, nullptr);
    if (!in.ok()) return *in.error();
    return command;
}

EditCommand quantised(EditCommand command) {
    for (EditCommand& part : command.parts) part = quantised(std::move(part));
    const auto* crater = std::get_if<CraterSeed>(&command.cutter);
    const bool by_seed = crater && form_of(command.pose, crater->seed).turn == PoseForm::Turn::kOfSeed;
    const Quaternion turn = command.pose.rotation;
    command.pose = quantised(command.pose);
    if (by_seed) command.pose.rotation = turn;
    if (command.options.from)
        if (const std::optional<GridPoint> grid = snap(*command.options.from)) command.options.from = to_metres(*grid);
    return command;
}

EditCommand crater_command(std::uint32_t number, const CraterSeed& crater, const Vec3& position, double radius,
                           CarveOptions options) {
    EditCommand command;
    command.number = number;
    command.cutter = crater;
    command.pose = {position, random_turn(crater.seed), radius};
    command.options = std::move(options);
    return quantised(std::move(command));
}

}  // namespace firma
