// SPDX-License-Identifier: MIT
// Casts that are on their way at one time, in one thread.
#pragma once

#include <cstddef>
#include <cstdint>

#include "firma/function_ref.h"
#include "firma/hit.h"
#include "firma/queries.h"
#include "world/movers.h"

namespace firma {

/// Fills a hit that says nothing yet with what a cast says.
using PutHit = FunctionRef<void(Hit& hit)>;
/// Takes the answer of cast k.
using AnswerFirst = void(std::size_t k, PutHit put);
using AnswerAny = void(std::size_t k, Status status);

/// Some casts, all of one kind.
struct AskedCasts {
    std::size_t first = 0, count = 0;
    bool spheres = false;  ///< or particles
    FunctionRef<Asked(std::size_t k)> ask;
    std::uint32_t places = 0;  ///< how many are on their way at one time, at most 8; 0: as many as pay
};

/// Makes casts as cast() does, each as if it were alone; but while one waits for memory, or for one result after
/// another, the processor has others to go on with. Where lanes are not in use, one after the other.
/// @param answer  called once for each, in any order
/// Takes 150 KB; where they are not to be had, the casts are made one after the other.
void cast_together(const World& world, const AskedCasts& casts, FunctionRef<AnswerFirst> answer,
                   const CastOptions& options);
/// The same as cast_any() does.
void cast_any_together(const World& world, const AskedCasts& casts, FunctionRef<AnswerAny> answer,
                       const CastOptions& options);

}  // namespace firma
