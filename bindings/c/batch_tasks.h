// SPDX-License-Identifier: MIT
// The caller's hook that batches are spread over.
#pragma once

#include "firma/firma_c.h"
#include "firma/queries.h"

namespace firma::c {

/// `run` null: in the calling thread.
void set_batch_tasks(const firma_tasks& tasks);
Tasks batch_tasks();

}  // namespace firma::c
