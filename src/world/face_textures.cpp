// SPDX-License-Identifier: MIT
// Which texture projection each face of a level's file has.
#include "world/face_textures.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/sort.h"

namespace firma {
namespace {

bool by_source(const FaceTextures::Entry& a, const FaceTextures::Entry& b) {
    return a.source < b.source;
}

Vec3 middle_of(std::span<const Vec3> corners) {
    Vec3 sum;
    for (const Vec3& corner : corners) sum = sum + corner;
    return sum * (1 / double(corners.size()));
}

}  // namespace

FaceTextures::FaceTextures(std::vector<TextureProjection> projections, std::vector<Entry> entries,
                           std::vector<GridPoint> corners)
    : projections_(std::move(projections)), entries_(std::move(entries)), corners_(std::move(corners)) {}

const TextureProjection* FaceTextures::find(std::uint32_t source, std::span<const Vec3> face) const {
    const auto [first, end] = std::equal_range(entries_.begin(), entries_.end(), Entry{.source = source}, by_source);
    if (first == end) return nullptr;
    auto nearest = first;
    if (end - first > 1) {
        const Vec3 point = middle_of(face);
        double least = INFINITY;
        for (auto entry = first; entry != end; ++entry) {
            const double away = distance(*entry, point, least);
            if (away >= least) continue;
            least = away;
            nearest = entry;
        }
    }
    return &projections_[nearest->projection];
}

/// How far a point is from a piece: from its plane, or from one of its sides, whichever is farther. That is no more
/// than the distance, and next to nothing for points of the piece alone.
/// @param enough  what is at least as far need not be told exactly
double FaceTextures::distance(const Entry& entry, const Vec3& point, double enough) const {
    const std::span<const GridPoint> outline = std::span(corners_).subspan(entry.first_corner, entry.corner_count);
    const Vec3 origin = to_metres(outline[0]);
    Vec3 normal;  // Newell's: twice the area long
    for (std::size_t k = 2; k < outline.size(); ++k)
        normal = normal + cross(to_metres(outline[k - 1]) - origin, to_metres(outline[k]) - origin);
    const double area = length(normal);
    if (!(area > 0)) return enough;
    normal = normal * (1 / area);
    double farthest = std::fabs(dot(point - origin, normal));
    for (std::size_t k = 0; k < outline.size() && farthest < enough; ++k) {
        const Vec3 from = to_metres(outline[k]), along = to_metres(outline[k + 1 < outline.size() ? k + 1 : 0]) - from;
        const Vec3 outward = cross(along, normal);
        const double size = length(outward);
        if (size > 0) farthest = std::max(farthest, dot(point - from, outward) / size);
    }
    return farthest;
}

std::size_t FaceTextures::bytes() const {
    return sizeof *this + projections_.capacity() * sizeof(TextureProjection) + entries_.capacity() * sizeof(Entry) +
           corners_.capacity() * sizeof(GridPoint);
}

std::uint32_t FaceTextureBuilder::add_projections(std::span<const TextureProjection> projections) {
    const auto first = std::uint32_t(projections_.size());
    projections_.insert(projections_.end(), projections.begin(), projections.end());
    return first;
}

void FaceTextureBuilder::add(std::uint32_t source, std::uint32_t projection, std::span<const GridPoint> outline) {
    entries_.push_back({source, projection, std::uint32_t(corners_.size()), std::uint32_t(outline.size())});
    corners_.insert(corners_.end(), outline.begin(), outline.end());
}

std::shared_ptr<const FaceTextures> FaceTextureBuilder::take() {
    if (entries_.empty()) return nullptr;
    sort_range(entries_, [](const FaceTextures::Entry& a, const FaceTextures::Entry& b) {
        return a.source != b.source ? a.source < b.source : a.first_corner < b.first_corner;
    });
    std::vector<FaceTextures::Entry> kept;
    std::vector<GridPoint> corners;
    for (std::size_t first = 0, end = 0; first < entries_.size(); first = end) {
        bool alike = true;
        for (end = first + 1; end < entries_.size() && entries_[end].source == entries_[first].source; ++end)
            alike = alike && entries_[end].projection == entries_[first].projection;
        if (alike) {
            kept.push_back({entries_[first].source, entries_[first].projection, 0, 0});
            continue;
        }
        for (std::size_t k = first; k < end; ++k) {
            const FaceTextures::Entry& from = entries_[k];
            kept.push_back({from.source, from.projection, std::uint32_t(corners.size()), from.corner_count});
            const auto outline = corners_.begin() + std::ptrdiff_t(from.first_corner);
            corners.insert(corners.end(), outline, outline + std::ptrdiff_t(from.corner_count));
        }
    }
    kept.shrink_to_fit();
    corners.shrink_to_fit();
    return std::make_shared<const FaceTextures>(std::move(projections_), std::move(kept), std::move(corners));
}

}  // namespace firma
