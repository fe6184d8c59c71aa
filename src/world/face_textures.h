// SPDX-License-Identifier: MIT
// Which texture projection each face of a level's file has: one table, made with the world and shared by all versions.
//
// Faces keep the number of the file's face that they were cut from (FaceInfo::source), so no edit touches the table. A
// face of the file that was divided into pieces with maps of their own (a curve, a quad that is not flat) has several:
// they are told apart by where they lie.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "firma/grid.h"
#include "firma/texture.h"

namespace firma {

class FaceTextures {
public:
    /// Of one source, or of a piece of it.
    struct Entry {
        std::uint32_t source = 0;
        std::uint32_t projection = 0;  ///< index into projections()
        /// The piece's convex outline in corners(); of a source's only entry there is none.
        std::uint32_t first_corner = 0, corner_count = 0;
    };

    /// @param projections  each usable
    /// @param entries      by source, ascending; several of one source each have 3 to 64 corners
    FaceTextures(std::vector<TextureProjection> projections, std::vector<Entry> entries,
                 std::vector<GridPoint> corners);

    const std::vector<TextureProjection>& projections() const { return projections_; }
    const std::vector<Entry>& entries() const { return entries_; }
    const std::vector<GridPoint>& corners() const { return corners_; }

    /// That of a face, or of a part of it; null where its file says nothing. Takes as long as a search among the
    /// entries, and a look at each piece of the source where it has several.
    const TextureProjection* find(std::uint32_t source, std::span<const Vec3> face) const;

    std::size_t bytes() const;

private:
    double distance(const Entry& entry, const Vec3& point, double enough) const;

    std::vector<TextureProjection> projections_;
    std::vector<Entry> entries_;
    std::vector<GridPoint> corners_;
};

/// Gathers a table while a world is made.
class FaceTextureBuilder {
public:
    /// @param projections  of a level
    /// @return what to add to the level's numbers of projections
    std::uint32_t add_projections(std::span<const TextureProjection> projections);
    void add(std::uint32_t source, std::uint32_t projection, std::span<const GridPoint> outline = {});

    /// Null when nothing was added. Of a source whose pieces have one projection, one entry stays.
    std::shared_ptr<const FaceTextures> take();

private:
    std::vector<TextureProjection> projections_;
    std::vector<FaceTextures::Entry> entries_;
    std::vector<GridPoint> corners_;
};

}  // namespace firma
