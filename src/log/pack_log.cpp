// SPDX-License-Identifier: MIT
// From a log to its bytes.
#include <map>
#include <utility>
#include <vector>

#include "base/flat_map.h"
#include "firma/edit_log.h"
#include "log/command_bytes.h"
#include "log/cutter_bytes.h"
#include "log/log_records.h"
#include "save/crc32c.h"

namespace firma {
namespace {

void put_record(ByteWriter& out, LogRecord type, const ByteWriter& content) {
    out.u8(std::uint8_t(type));
    put_whole(out, content.size());
    put_bytes(out, content.bytes());
}

/// Writes each cutter where it is first asked for. Equal ones are one, whichever handles there are to them.
class CutterRecords final : public CutterNumbers {
public:
    explicit CutterRecords(ByteWriter& out) : out_(out) {}

    std::uint32_t number(const Cutter& cutter) override {
        std::uint32_t& known = number_of_.at(reinterpret_cast<std::uintptr_t>(cutter.data().get()));
        if (known != FlatMap::kNone) return known;
        ByteWriter content;
        put_cutter(content, cutter);
        const auto [found, is_new] =
            number_of_bytes_.try_emplace(content.bytes(), std::uint32_t(number_of_bytes_.size()));
        if (is_new) put_record(out_, LogRecord::kCutter, content);
        return known = found->second;
    }

private:
    ByteWriter& out_;
    FlatMap number_of_;  ///< by address
    std::map<std::vector<std::byte>, std::uint32_t> number_of_bytes_;
};

}  // namespace

std::vector<std::byte> pack_log(const EditLog& log) {
    ByteWriter out;
    for (const unsigned char byte : kLogMagic) out.u8(byte);
    out.u32(kEditLogVersion);
    out.u64(log.level_hash());
    out.u64(log.rules_hash());
    out.u32(log.level_edits());
    CutterRecords cutters(out);
    std::uint32_t last = log.level_edits();
    if (!log.patch().empty()) {
        ByteWriter content;
        put_whole(content, log.patched_number() - last);
        put_bytes(content, log.patch());
        put_record(out, LogRecord::kPatch, content);
        last = log.patched_number();
    }
    auto checkpoint = log.checkpoints().begin();
    const auto put_checkpoints = [&](std::size_t commands) {
        for (; checkpoint != log.checkpoints().end() && checkpoint->commands == commands; ++checkpoint) {
            ByteWriter content;
            content.u64(checkpoint->hash);
            put_record(out, LogRecord::kCheckpoint, content);
        }
    };
    put_checkpoints(0);
    for (std::size_t k = 0; k < log.commands().size(); ++k) {
        const EditCommand& command = log.commands()[k];
        ByteWriter content;
        put_command(content, command, last, &cutters);
        put_record(out, LogRecord::kCommand, content);
        last = last_number(command);
        put_checkpoints(k + 1);
    }
    out.u8(std::uint8_t(LogRecord::kEnd));
    out.u32(crc32c(out.bytes()));
    return out.bytes();
}

}  // namespace firma
