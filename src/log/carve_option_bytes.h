// SPDX-License-Identifier: MIT
// CarveOptions as bytes: a field for each that is not what it is by default. Here a new option gets its field.
#pragma once

#include <optional>

#include "firma/carve.h"
#include "log/byte_reader.h"

namespace firma {

/// Why a command cannot carry them.
std::optional<Error> judge_chunk_options(const ChunkOptions& options);

/// Fields: key * 2 + 1 (who does not know it cannot carve the same), length, content; keys ascend.
void put_options(ByteWriter& out, const CarveOptions& options);
/// All that is left of `in`. Fields that are unknown and not required are passed over.
CarveOptions take_options(ByteReader& in);

}  // namespace firma
