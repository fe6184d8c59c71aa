// SPDX-License-Identifier: MIT
// A scene of bench_scale with its casts and Firma's answers, for who runs elsewhere: bench/node/bench_scale.mjs.
#pragma once

#include <span>
#include <string>

#include "scale/work.h"

namespace firma::bench {

/// Two files: SCENE_TRIANGLES.json says what is in SCENE_TRIANGLES.bin, which holds, in this machine's order of bytes,
/// positions (float, three a vertex), corners (uint32, three a triangle), and for each kind its casts (float: start,
/// radius, path) and then their fractions (double).
class SceneDump {
public:
    SceneDump(const ScaleScene& scene, std::size_t casts);

    void add(const KindOfCast& kind, std::span<const FloatCast> casts, std::span<const double> fractions);
    /// Ends the program when a file cannot be written.
    void write(const std::string& folder) const;

private:
    const ScaleScene& scene_;
    std::string kinds_, bytes_;
    std::size_t casts_;
};

}  // namespace firma::bench
