// SPDX-License-Identifier: MIT
// What came of an edit, as the caller gets it.
#pragma once

#include "bindings/c/objects.h"

namespace firma::c {

/// The world after an edit as a handle, unless `after` is null, and the report with the chunks as another. A refusal's
/// reason becomes the message. Fails without any handle made.
firma_code give_result(CarveResult result, firma_world* after, firma_carve_report* report, const char* function);

inline CarveResult carve_result(CarveResult result) {
    return result;
}
/// Of a command: the sums over its parts.
CarveResult carve_result(CommandResult result);

}  // namespace firma::c
