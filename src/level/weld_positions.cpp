// SPDX-License-Identifier: MIT
// Finds vertices that are at the same position: sorted by a hash, then by the numbers themselves.
#include "level/weld_positions.h"

#include "base/sort.h"

namespace firma {
namespace {

/// Only spreads positions; nothing depends on it being without collisions, not even the time.
std::uint64_t hash_of(const std::array<ExactNumber, 3>& position) {
    std::uint64_t hash = 0;
    for (const ExactNumber& number : position) {
        hash = (hash ^ std::uint64_t(number.mantissa)) * 0x9E3779B97F4A7C15ull;
        hash ^= hash >> 29;
        hash =
            (hash ^ (std::uint64_t(std::uint32_t(number.exponent)) << 32 | number.long_digits)) * 0xBF58476D1CE4E5B9ull;
        hash ^= hash >> 32;
    }
    return hash;
}

struct Key {
    std::uint64_t hash;
    std::uint32_t vertex;
};

std::vector<Key> sorted_keys(const ExactMesh& mesh) {
    std::vector<bool> used(mesh.exact.size());
    for (const std::uint32_t vertex : mesh.corners) used[vertex] = true;
    std::vector<Key> keys;
    for (std::uint32_t vertex = 0; vertex < mesh.exact.size(); ++vertex)
        if (used[vertex]) keys.push_back({hash_of(mesh.exact[vertex]), vertex});
    sort_range(keys, [&](const Key& a, const Key& b) {
        if (a.hash != b.hash) return a.hash < b.hash;
        const auto order = mesh.exact[a.vertex] <=> mesh.exact[b.vertex];
        return order != 0 ? order < 0 : a.vertex < b.vertex;
    });
    return keys;
}

}  // namespace

WeldedPositions weld_positions(const ExactMesh& mesh) {
    constexpr std::uint32_t kUnused = WeldedPositions::kUnused;
    std::vector<std::uint32_t> first(mesh.exact.size(), kUnused);  // the first vertex at the same position
    const std::vector<Key> keys = sorted_keys(mesh);
    for (std::size_t k = 0; k < keys.size(); ++k) {
        const std::uint32_t vertex = keys[k].vertex;
        const bool same =
            k > 0 && keys[k].hash == keys[k - 1].hash && mesh.exact[vertex] == mesh.exact[keys[k - 1].vertex];
        first[vertex] = same ? first[keys[k - 1].vertex] : vertex;
    }

    WeldedPositions welded;
    welded.of_vertex.assign(mesh.exact.size(), kUnused);
    for (std::uint32_t vertex = 0; vertex < mesh.exact.size(); ++vertex) {
        if (first[vertex] == kUnused) continue;
        if (first[vertex] == vertex) {
            welded.of_vertex[vertex] = std::uint32_t(welded.vertex.size());
            welded.vertex.push_back(vertex);
        } else {
            welded.of_vertex[vertex] = welded.of_vertex[first[vertex]];
        }
    }
    welded.of_corner.reserve(mesh.corners.size());
    for (const std::uint32_t vertex : mesh.corners) welded.of_corner.push_back(welded.of_vertex[vertex]);
    return welded;
}

}  // namespace firma
