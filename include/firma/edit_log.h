// SPDX-License-Identifier: MIT
// Edits as bytes: commands that say what an edit does, and logs of them. A level and its log give the same world, to
// the bit, on every machine: for lockstep, replays, and players who join late. docs/edit_log.md tells how.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "firma/carve.h"
#include "firma/cutter.h"
#include "firma/export.h"
#include "firma/hit.h"
#include "firma/result.h"
#include "firma/vec.h"
#include "firma/world.h"

namespace firma {

enum class EditKind : std::uint8_t {
    kCarve,  ///< takes a cutter away
    kFill,   ///< adds one
    kDoor,   ///< opens or closes a portal
    kGroup,  ///< several of these as one version
};

/// A cutter that its kind and seed say: make_crater(shape, seed).
struct CraterSeed {
    CutterShape shape = CutterShape::kRocky;
    std::uint64_t seed = 0;
    friend bool operator==(const CraterSeed&, const CraterSeed&) = default;
};

/// What one edit does: a value, made by who shoots, applied by everybody. It says nothing that depends on a world.
struct EditCommand {
    /// Of the edit: 1 to kMaxEditNumber, above that of every command before it. Gaps do no harm. The ids of new faces
    /// follow from it (CarveOptions::edit). Of a group it is not used: its parts have numbers of their own.
    std::uint32_t number = 0;
    EditKind kind = EditKind::kCarve;

    // kCarve, kFill
    std::variant<CraterSeed, Cutter> cutter;
    Pose pose;
    CarveOptions options;  ///< `edit` is not used: `number` is

    // kDoor
    PortalId portal;
    bool open = true;

    // kGroup
    std::vector<EditCommand> parts;  ///< at least one, none of them a group
};

/// The number of a command's edit; of a group that of its last part, 0 without any.
[[nodiscard]] FIRMA_EXPORT std::uint32_t last_number(const EditCommand& command);

/// A pose that takes few bytes: its position on the input grid (1/4096 m, halves to even), its turn in four parts of
/// 16 bits, its scale in steps of 1/4096 unless it is less than half of one. Doing it again changes nothing. What is
/// not finite, and a turn of zero, stays; so do a position and a scale of 2^14 and beyond, which no cut takes.
/// Off by at most 1/8192 m, 1/16,000 of a radian and 1/8192 of a metre a unit of the cutter.
/// Costs the same for every pose; never allocates.
[[nodiscard]] FIRMA_EXPORT Pose quantised(const Pose& pose);

/// The same command with its poses quantised, and CarveOptions::from put on the input grid; but for turns that are
/// those of the crater's seed (random_turn()), which take no bytes. Who shoots does this before anybody applies the
/// command, himself included: then all cut alike.
[[nodiscard]] FIRMA_EXPORT EditCommand quantised(EditCommand command);

/// A crater as a quantised command: at a position (metres), as large as `radius` (metres) scales its shape, turned by
/// its seed. Costs what it copies of the options.
[[nodiscard]] FIRMA_EXPORT EditCommand crater_command(std::uint32_t number, const CraterSeed& crater,
                                                      const Vec3& position, double radius, CarveOptions options = {});

/// A portal opened or closed, as a command. Costs nothing worth counting; never allocates.
[[nodiscard]] inline EditCommand door_command(std::uint32_t number, PortalId portal, bool open) {
    EditCommand command;
    command.number = number;
    command.kind = EditKind::kDoor;
    command.portal = portal;
    command.open = open;
    return command;
}

/// A command as bytes. A crater by seed with a quantised pose takes about 25 bytes and the name of its material; poses
/// that are not quantised are stored whole, cutters that are meshes by their vertices and triangles, cutters that are
/// solids as .firma files. What comes back is the same to the bit. docs/edit_log.md has the layout.
/// @return kInvalid, naming the part of a group, for numbers that do not ascend, a group without parts or in a group,
///         an empty cutter or one that is no crater; kOutOfRange for a pose that is not finite; kTooLarge for a number
///         above kMaxEditNumber
/// Costs the bytes.
[[nodiscard]] FIRMA_EXPORT Result<std::vector<std::byte>> pack_command(const EditCommand& command);

/// The command of such bytes, which are taken as hostile: every count is compared with the bytes that are left before
/// memory is taken, numbers must be finite, meshes are judged by make_cutter(), solids by unpack_world().
/// @param name  for messages
/// @return kMalformed with the byte where it was found ("name: byte 12"); kUnsupported for another version, or a part
///         that is marked as required and unknown
[[nodiscard]] FIRMA_EXPORT Result<EditCommand> unpack_command(std::span<const std::byte> bytes, std::string name);

/// What came of a command.
struct [[nodiscard]] CommandResult {
    /// kDone when any of its parts did something, kRefused when none did and one was refused.
    CarveStatus status = CarveStatus::kRefused;
    World world;                     ///< after it; the one before unless kDone
    Error error;                     ///< of the first part refused, if any; "part 2: " before its place, of a group
    std::vector<CarveResult> edits;  ///< of each part that carves or fills, in order

    bool done() const { return status == CarveStatus::kDone; }
};

/// A command in slices, as CarveJob: the same bits as in one go; a group's parts come one after the other.
class CommandJob {
public:
    /// Makes the crater of a seed; all else is left to run().
    FIRMA_EXPORT CommandJob(World world, EditCommand command);
    FIRMA_EXPORT ~CommandJob();
    /// Leaves a job behind that is finished and refused.
    FIRMA_EXPORT CommandJob(CommandJob&&) noexcept;
    FIRMA_EXPORT CommandJob& operator=(CommandJob&&) noexcept;

    /// As CarveJob::run(): memory that runs out leaves it as std::bad_alloc, and the job is finished and refused.
    FIRMA_EXPORT bool run(double microseconds);
    FIRMA_EXPORT bool finished() const;
    /// Only once finished() (FIRMA_ASSERT), else a refusal.
    FIRMA_EXPORT CommandResult result() const;

private:
    struct State;
    std::unique_ptr<State> state_;
};

/// Applies a command. It is refused, and the world stays, where it carves or fills and its number is not above that of
/// the last edit (Solid::edits()), for a portal that is not there, and as carve(). Of doors the number is not looked
/// at: whoever receives them puts them in order. Costs what its edits cost.
FIRMA_EXPORT CommandResult apply(const World& world, const EditCommand& command);

/// What pack_log() writes and unpack_log() reads; logs of older versions stay readable.
inline constexpr std::uint32_t kEditLogVersion = 1;

/// What a world's hash is after some commands of a log.
struct LogCheckpoint {
    std::size_t commands = 0;  ///< so many of them
    std::uint64_t hash = 0;    ///< hash_world()
    friend bool operator==(const LogCheckpoint&, const LogCheckpoint&) = default;
};

/// Commands in order, and the world that they begin from, by its hashes. A copy copies all; cutters are shared.
class EditLog {
public:
    /// Begins from no world.
    EditLog() = default;
    /// Begins from this one. Costs what hash_world() costs, and its rules.
    FIRMA_EXPORT explicit EditLog(const World& level);

    /// hash_world() of the world it begins from.
    std::uint64_t level_hash() const { return level_hash_; }
    /// Of the same world's rules for carving, and of what holds its loose pieces (with_anchors()), where that was said:
    /// hash_world() sees neither.
    std::uint64_t rules_hash() const { return rules_hash_; }
    const std::vector<EditCommand>& commands() const { return commands_; }
    const std::vector<LogCheckpoint>& checkpoints() const { return checkpoints_; }

    /// Of a log whose beginning was compacted: the patch (world_patch.h) that stands for it, to be applied to the world
    /// it begins from before any command; else empty.
    const std::vector<std::byte>& patch() const { return patch_; }
    /// The number of the last edit that the patch stands for; 0 without one.
    std::uint32_t patched_number() const { return patched_number_; }
    /// Solid::edits() of the world it begins from: numbers of commands are above it.
    std::uint32_t level_edits() const { return level_edits_; }
    /// The number of the last command's edit; level_edits() without any.
    std::uint32_t last_number() const { return last_number_; }
    /// What the next command's number may be at least.
    std::uint32_t next_number() const { return last_number_ + 1; }

    /// Puts a command at the end. @return why it cannot: as pack_command(), or a number that is not above the last one
    [[nodiscard]] FIRMA_EXPORT std::optional<Error> append(EditCommand command);
    /// Says what the world's hash is after the commands so far; replay() compares it.
    FIRMA_EXPORT void add_checkpoint(const World& world);

private:
    friend class LogReader;
    friend Result<EditLog> compacted(const World& level, const EditLog& log, std::uint32_t number);
    std::uint64_t level_hash_ = 0, rules_hash_ = 0;
    std::uint32_t level_edits_ = 0, last_number_ = 0, patched_number_ = 0;
    std::vector<std::byte> patch_;
    std::vector<EditCommand> commands_;
    std::vector<LogCheckpoint> checkpoints_;
};

/// A log as bytes: each cutter that is no crater once, however often commands name it. docs/edit_log.md has the layout.
/// Costs the bytes.
[[nodiscard]] FIRMA_EXPORT std::vector<std::byte> pack_log(const EditLog& log);

/// The log of such bytes, which are taken as hostile, as by unpack_command(); a checksum over all of them finds
/// accidents first. Costs the bytes, and judging meshes and solids.
/// @return errors as unpack_command(), each with its byte; kMalformed also for numbers that do not ascend
[[nodiscard]] FIRMA_EXPORT Result<EditLog> unpack_log(std::span<const std::byte> bytes, std::string name);

/// Whether bytes begin as those of a log do, of whatever version. Reads the first few bytes only.
[[nodiscard]] FIRMA_EXPORT bool is_edit_log(std::span<const std::byte> bytes);

struct ReplayOptions {
    /// Commands with higher numbers are left out.
    std::uint32_t last_number = std::numeric_limits<std::uint32_t>::max();
};

/// What a replay came to.
struct [[nodiscard]] ReplayResult {
    World world;               ///< after the commands that were applied
    std::size_t commands = 0;  ///< so many of them
    std::size_t done = 0, nothing = 0, refused = 0;
    std::size_t checkpoints = 0;  ///< that were compared and hold
    /// Why it ended early: the log begins from another world, is under other rules, or was compacted beyond the last
    /// number asked for (kInvalid); a checkpoint does not hold, naming the command, from 0, or the patch does not
    /// (kMalformed and others); memory ran out (kNoMemory).
    std::optional<Error> error;

    bool ok() const { return !error; }
};

/// A log applied to the level it begins from, in slices: the same bits as in one go.
class LogReplay {
public:
    /// Compares the level's hashes with the log's; all else is left to run(), which applies a patch in one piece.
    FIRMA_EXPORT LogReplay(World level, EditLog log, const ReplayOptions& options = {});
    FIRMA_EXPORT ~LogReplay();
    /// Leaves a replay behind that is finished, with an error.
    FIRMA_EXPORT LogReplay(LogReplay&&) noexcept;
    FIRMA_EXPORT LogReplay& operator=(LogReplay&&) noexcept;

    /// Goes on for about this long, as CarveJob::run(), one command after the other.
    /// @return true once it is finished
    FIRMA_EXPORT bool run(double microseconds);
    FIRMA_EXPORT bool finished() const;
    /// How many commands are behind it, and how many there are in all.
    FIRMA_EXPORT std::size_t commands_behind() const;
    FIRMA_EXPORT std::size_t commands_in_all() const;
    /// What came of it so far. Costs a copy of the handles.
    FIRMA_EXPORT ReplayResult result() const;

private:
    struct State;
    std::unique_ptr<State> state_;
};

/// The same log with a patch in place of its commands up to a number: for players who join late, as applying it takes
/// less time than many commands do, though it may take more bytes. What comes of it is the same to the bit, ids
/// included.
/// @param level   the world it begins from
/// @param number  commands with higher ones stay, with the checkpoints after them
/// @return the log; kInvalid where the log cannot be replayed on the level; kMalformed where a checkpoint does not
/// hold;
///         kInvalid where the number is below that of a patch that it has already
/// Costs replay(), make_patch() and apply_patch(), by which the patch is tried.
[[nodiscard]] FIRMA_EXPORT Result<EditLog> compacted(const World& level, const EditLog& log, std::uint32_t number);

/// The same in one go.
FIRMA_EXPORT ReplayResult replay(const World& level, const EditLog& log, const ReplayOptions& options = {});

}  // namespace firma
