// SPDX-License-Identifier: MIT
// Commands as bytes, within logs and by themselves; and which commands there can be.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "firma/edit_log.h"
#include "log/byte_reader.h"

namespace firma {

/// Cutters that no seed makes, each once.
class CutterNumbers {
public:
    virtual ~CutterNumbers() = default;
    virtual std::uint32_t number(const Cutter& cutter) = 0;
};

/// Why a command cannot be packed, or nothing.
/// @param before  its number must be above this one
std::optional<Error> judge_command(const EditCommand& command, std::uint32_t before);

/// A sound command.
/// @param before   its number is kept as the difference to this one
/// @param cutters  null: they stand within the command
void put_command(ByteWriter& out, const EditCommand& command, std::uint32_t before, CutterNumbers* cutters);

/// All that is left of `in`.
/// @param cutters  that numbers stand for; null: there are none
EditCommand take_command(ByteReader& in, std::uint32_t before, const std::vector<Cutter>* cutters);

}  // namespace firma
