// SPDX-License-Identifier: MIT
// From hostile bytes to a log.
#include <algorithm>
#include <utility>
#include <vector>

#include "firma/edit_log.h"
#include "log/command_bytes.h"
#include "log/cutter_bytes.h"
#include "log/log_records.h"
#include "save/crc32c.h"

namespace firma {

class LogReader {
public:
    LogReader(std::span<const std::byte> bytes, const std::string& name) : bytes_(bytes), in_(bytes, name) {}

    Result<EditLog> read() {
        if (read_head()) read_records();
        if (!in_.ok()) return *in_.error();
        return std::move(log_);
    }

private:
    bool read_head() {
        if (!is_edit_log(bytes_)) return in_.fail("it does not begin as a log of edits does");
        in_.bytes(kLogMagic.size());
        const std::size_t where = in_.place();
        const std::uint32_t version = in_.u32();
        if (in_.ok() && version != kEditLogVersion)
            return in_.fail_at(
                where, ErrorCode::kUnsupported,
                "it is of version " + std::to_string(version) + " of the format; this Firma reads version 1");
        log_.level_hash_ = in_.u64();
        log_.rules_hash_ = in_.u64();
        log_.level_edits_ = log_.last_number_ = in_.u32();
        return in_.ok() && check_sum();
    }

    /// Before anything is made of what may be damaged.
    bool check_sum() {
        if (bytes_.size() < kLogHeadBytes + 5) return in_.fail("it ends before its checksum");
        const std::size_t at = bytes_.size() - 4;
        if (crc32c(bytes_.first(at)) == read_u32(bytes_.data() + at)) return true;
        return in_.fail_at(at, ErrorCode::kMalformed, "it is damaged: wrong checksum");
    }

    void read_records() {
        while (in_.ok()) {
            const std::size_t where = in_.place();
            const std::uint8_t type = in_.u8();
            if (!in_.ok()) return;
            if (type == std::uint8_t(LogRecord::kEnd)) {
                if (in_.left() != 4) in_.fail_at(where, ErrorCode::kMalformed, "an end that is not at the end");
                return;
            }
            ByteReader content = in_.part(in_.whole());
            if (!in_.ok()) return;
            read_record(type, content, where);
            if (!content.ok()) in_.fail(*content.error());
        }
    }

    void read_record(std::uint8_t type, ByteReader& content, std::size_t where) {
        switch (LogRecord(type)) {
            case LogRecord::kCutter:
                cutters_.push_back(take_cutter(content));
                return;
            case LogRecord::kCommand: {
                EditCommand command = take_command(content, log_.last_number_, &cutters_);
                if (!content.ok()) return;
                if (std::optional<Error> error = log_.append(std::move(command)))
                    in_.fail_at(where, error->code, error->text());
                return;
            }
            case LogRecord::kCheckpoint: {
                const std::size_t commands = log_.commands_.size();
                if (!log_.checkpoints_.empty() && log_.checkpoints_.back().commands == commands) {
                    in_.fail_at(where, ErrorCode::kMalformed, "a second checkpoint in one place");
                    return;
                }
                log_.checkpoints_.push_back({commands, content.u64()});
                if (content.ok() && !content.at_end()) content.fail("bytes behind a checkpoint");
                return;
            }
            case LogRecord::kPatch:
                read_patch(content, where);
                return;
            case LogRecord::kEnd:
                break;
        }
        if (!(type & kOptionalRecord))
            in_.fail_at(where, ErrorCode::kUnsupported,
                        "a record of kind " + std::to_string(type) + ", which this Firma does not know");
    }

    /// What it holds is judged when it is applied.
    void read_patch(ByteReader& content, std::size_t where) {
        if (where != kLogHeadBytes) {
            in_.fail_at(where, ErrorCode::kMalformed, "a patch that is not first of all");
            return;
        }
        const std::uint64_t edits = content.whole();
        if (content.ok() && (edits > kMaxEditNumber || edits + log_.level_edits_ > kMaxEditNumber))
            content.fail("it stands for edits beyond the last");
        const std::span<const std::byte> patch = content.bytes(content.left());
        if (content.ok() && patch.empty()) content.fail("a patch without content");
        if (!content.ok()) return;
        log_.patch_.assign(patch.begin(), patch.end());
        log_.patched_number_ = log_.last_number_ = log_.level_edits_ + std::uint32_t(edits);
    }

    const std::span<const std::byte> bytes_;
    ByteReader in_;
    EditLog log_;
    std::vector<Cutter> cutters_;
};

Result<EditLog> unpack_log(std::span<const std::byte> bytes, std::string name) {
    return LogReader(bytes, name).read();
}

bool is_edit_log(std::span<const std::byte> bytes) {
    return bytes.size() >= kLogMagic.size() &&
           std::equal(kLogMagic.begin(), kLogMagic.end(), bytes.begin(),
                      [](unsigned char a, std::byte b) { return std::byte(a) == b; });
}

}  // namespace firma
