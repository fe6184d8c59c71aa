// SPDX-License-Identifier: MIT
// Pieces of a batch: in a good order, over the threads that a caller has, until someone says stop.
#pragma once

#include "firma/batch.h"
#include "world/cast_order.h"

namespace firma {

/// What a batch is made of. Both may be called by several threads at a time, for different k.
struct ManyCasts {
    std::size_t count = 0;
    bool fits = true;  ///< as many answers as casts, and all else of one length
    FunctionRef<CastWay(std::size_t k)> way;
    /// Makes a cast and puts its answer; without options puts kInvalid.
    FunctionRef<void(std::size_t k, const CastOptions* options)> answer;
    /// Lets the processor fetch what a cast reads and where its answer goes.
    FunctionRef<void(std::size_t k)> fetch;
};

ManyResult run_many(const World& world, const ManyCasts& casts, const ManyOptions& options);

}  // namespace firma
