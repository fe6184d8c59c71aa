// SPDX-License-Identifier: MIT
// Who is measured by bench_scale: each makes what it needs of the same triangles and answers casts with fractions.
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "scale/work.h"

namespace firma::bench {

/// For a fraction: nothing is met.
inline constexpr double kScaleMiss = 2;

class ScalePeer {
public:
    virtual ~ScalePeer() = default;

    /// Version, calls and settings, in a sentence.
    virtual std::string describe() const = 0;
    virtual bool has(CastShape shape) const = 0;
    /// Brings the triangles into the form that build() takes, where that is not arrays; not timed, not weighed.
    virtual void prepare(const ScaleScene&) {}
    /// Ready to cast. Arrays that must live on for it are copied, and count.
    virtual void build(const ScaleScene& scene) = 0;
    /// What it says itself that it holds, bytes; 0 where it does not tell.
    virtual std::size_t own_bytes() const { return 0; }
    /// @param fractions  as many as casts; of the whole path, kScaleMiss where nothing is met; both sides of faces
    /// count
    virtual void cast(CastShape shape, std::span<const FloatCast> casts, double* fractions) = 0;
};

struct PeerEntry {
    const char* name;
    std::unique_ptr<ScalePeer> (*make)();
    std::size_t max_triangles;  ///< that end in time; more with --full
    std::size_t max_in_full;
};

std::unique_ptr<ScalePeer> make_firma_peer();
std::unique_ptr<ScalePeer> make_embree_peer();
std::unique_ptr<ScalePeer> make_bullet_peer();
std::unique_ptr<ScalePeer> make_cgal_peer();
std::unique_ptr<ScalePeer> make_fcl_peer();

/// Those that were found when this was configured; Firma first.
std::span<const PeerEntry> scale_peers();
/// All that there are adapters for, found or not, in the order of tables.
std::span<const char* const> scale_peer_names();

}  // namespace firma::bench
