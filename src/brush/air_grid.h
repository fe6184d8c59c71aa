// SPDX-License-Identifier: MIT
// The air of a level of brushes, sampled: cells in layers between the planes of walls, and which neighbours are in
// sight of each other. For finding where it is narrow, never for geometry.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "firma/brush_level.h"

namespace firma {

/// Layers of cells across each axis; where walls stand square to the axes and are no thinner than the thinnest layer,
/// each lies within one wall, one opening, one room. Outermost are layers beyond all brushes, of air.
///
/// A way from a cell's centre to the next one's is free where no wall, however thin, stands in between. So what is
/// joined by free ways is joined in the level; but narrow gaps beside the centres are not seen.
class AirGrid {
public:
    /// @param max_cells  layers are as many as these allow: of a sixteenth of a metre at least, half a metre at most,
    ///                    or wider
    /// @return nothing where no brush is solid, or the brushes are too many and too large to be looked at
    static std::optional<AirGrid> make(const BrushLevel& level, std::size_t max_cells);

    std::size_t cells() const { return flags_.size(); }
    int layers(int axis) const { return int(layers_[axis].centres.size()); }
    /// On the input grid, ascending.
    double centre(int axis, int layer) const { return layers_[axis].centres[std::size_t(layer)]; }
    /// Where a layer begins, and the one before ends.
    double border(int axis, int layer) const { return layers_[axis].borders[std::size_t(layer)]; }
    double width(int axis, int layer) const { return border(axis, layer + 1) - border(axis, layer); }
    std::size_t stride(int axis) const { return strides_[axis]; }
    int layer_of(std::size_t cell, int axis) const { return int(cell / strides_[axis]) % layers(axis); }
    bool is_outermost(std::size_t cell) const;
    /// The cell around a point; nothing beyond all layers.
    std::optional<std::size_t> cell_at(const Vec3& point) const;

    bool is_air(std::size_t cell) const { return flags_[cell] & kAir; }
    /// Whether the way to the next cell along an axis is free.
    bool is_free(std::size_t cell, int axis) const { return flags_[cell] & kWay << axis; }
    /// Whether that way leads through a portal.
    bool is_cut(std::size_t cell, int axis) const { return flags_[cell] & kCut << axis; }
    void cut(std::size_t cell, int axis) { flags_[cell] = std::uint8_t(flags_[cell] | kCut << axis); }

private:
    static constexpr unsigned kAir = 1, kWay = 2, kCut = 16;

    struct Layers {
        std::vector<double> borders, centres;
    };
    struct Body;
    struct Line;

    void set_layers(const std::vector<Body>& bodies, double thinnest);
    double lines_through(const std::vector<Body>& bodies) const;
    void enter(const Body& body);
    void enter(const Body& body, const Line& line);
    void close_ways();

    Layers layers_[3];
    std::size_t strides_[3] = {1, 1, 1};
    std::vector<std::uint8_t> flags_;
};

}  // namespace firma
