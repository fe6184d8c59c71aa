// SPDX-License-Identifier: MIT
// Many casts at once: of rays, spheres, capsules and hulls, from arrays of structures or from columns of numbers, on
// the threads that a caller has.
//
// Each answer is that of the single cast, to the bit, whatever the order, the threads, and what else is in the batch.
#pragma once

#include <cstddef>
#include <span>

#include "firma/capsule.h"
#include "firma/export.h"
#include "firma/hull.h"
#include "firma/queries.h"

namespace firma {

/// Casts of rays or spheres as columns of numbers: cast k goes from x[k], y[k], z[k] along path_x[k], path_y[k],
/// path_z[k], in metres.
struct CastColumns {
    std::span<const double> x, y, z;
    std::span<const double> path_x, path_y, path_z;
    std::span<const double> radius{};  ///< empty: all are particles
};

struct CapsuleInput {
    Capsule capsule{};
    Vec3 path{};
};

struct HullInput {
    const Hull* hull = nullptr;  ///< many inputs may share one; null: kInvalid
    Vec3 at{};
    Vec3 path{};
};

/// Answers as columns: those that are wanted as long as there are casts, the others empty. What they say is in hit.h.
struct HitColumns {
    std::span<Status> status{};
    std::span<double> fraction{}, safe_fraction{};
    std::span<double> normal_x{}, normal_y{}, normal_z{};
    std::span<FaceRef> face{};
    std::span<std::uint32_t> material{};
};

struct ManyOptions {
    CastOptions cast{};            ///< of all; its trail is left as it is
    const Tasks* tasks = nullptr;  ///< null: this thread does it all
    /// Told after each piece of work, by whichever thread did it, one at a time, of how many casts are done; it returns
    /// whether to go on. Null: nobody is told. Must not throw, or cast many itself.
    bool (*progress)(std::size_t done, std::size_t count, void* user) = nullptr;
    void* user = nullptr;  ///< handed to progress
};

enum class ManyResult {
    kDone,       ///< all answers are there
    kCancelled,  ///< progress said so: answers of casts that were not made are kInvalid, at their starts
    kRefused,    ///< spans of different lengths, or Tasks::run returned before all its work had: all are kInvalid
};

/// The first touch of each, as cast() says it.
/// @param hits  as many as casts
/// Several are on their way at one time in each thread, so that the processor has something to do while one waits for
/// memory: over millions of faces it costs 0.5 to 0.7 of its casts one by one, over fewer than a hundred thousand as
/// much (docs/performance.md). 256 of them are a piece of work. Each piece allocates 150 KB and returns it at its end,
/// so each thread at work holds as much; beside it some bytes a piece, and once where tasks are given and there are
/// several pieces.
[[nodiscard]] FIRMA_EXPORT ManyResult cast_many(const World& world, std::span<const CastInput> casts,
                                                std::span<Hit> hits, const ManyOptions& options = {});
[[nodiscard]] FIRMA_EXPORT ManyResult cast_many(const World& world, std::span<const CapsuleInput> casts,
                                                std::span<Hit> hits, const ManyOptions& options = {});
[[nodiscard]] FIRMA_EXPORT ManyResult cast_many(const World& world, std::span<const HullInput> casts,
                                                std::span<Hit> hits, const ManyOptions& options = {});
/// By columns; `hits` as much of the answers as is wanted.
[[nodiscard]] FIRMA_EXPORT ManyResult cast_many(const World& world, const CastColumns& casts, const HitColumns& hits,
                                                const ManyOptions& options = {});

/// Whether each touches anything, as cast_any() says it: the least that can be asked.
[[nodiscard]] FIRMA_EXPORT ManyResult cast_many_any(const World& world, std::span<const CastInput> casts,
                                                    std::span<Status> statuses, const ManyOptions& options = {});
[[nodiscard]] FIRMA_EXPORT ManyResult cast_many_any(const World& world, std::span<const CapsuleInput> casts,
                                                    std::span<Status> statuses, const ManyOptions& options = {});
[[nodiscard]] FIRMA_EXPORT ManyResult cast_many_any(const World& world, std::span<const HullInput> casts,
                                                    std::span<Status> statuses, const ManyOptions& options = {});
[[nodiscard]] FIRMA_EXPORT ManyResult cast_many_any(const World& world, const CastColumns& casts,
                                                    std::span<Status> statuses, const ManyOptions& options = {});

}  // namespace firma
