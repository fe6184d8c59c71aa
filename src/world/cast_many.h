// SPDX-License-Identifier: MIT
// Many casts: in pieces, over the threads that a caller has, until someone says stop.
#pragma once

#include "firma/batch.h"
#include "world/cast_together.h"

namespace firma {

/// What a batch is made of.
struct ManyCasts {
    std::size_t count = 0;
    bool fits = true;     ///< as many answers as casts, and all else of one length; else nothing is asked
    bool spheres = true;  ///< or particles, all of them
    /// May be called by several threads at a time, for different k.
    FunctionRef<Asked(std::size_t k)> ask;
};

/// Calls answer(k, put) for each k, from several threads where there are; put(hit) fills a hit that says nothing yet.
ManyResult run_many(const World& world, const ManyCasts& casts, FunctionRef<AnswerFirst> answer,
                    const ManyOptions& options);
/// Calls answer(k, status) likewise.
ManyResult run_many_any(const World& world, const ManyCasts& casts, FunctionRef<AnswerAny> answer,
                        const ManyOptions& options);

}  // namespace firma
