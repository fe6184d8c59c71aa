// SPDX-License-Identifier: MIT
// Sections of the air layer by layer, and how their areas change along an axis.
#include "brush/find_narrows.h"

#include <algorithm>
#include <tuple>

namespace firma {
namespace {

/// The air widens where a section has so many times the area, at most so far away; its next layer's must be so much
/// more already, so that of a straight passage only the end counts.
constexpr double kWider = 1.5, kAtOnce = 1.05;
constexpr double kReach = 0.75;         ///< metres
constexpr double kIntoWall = 0.015625;  ///< metres: how deep portals reach into thin walls
constexpr std::uint32_t kNoSection = ~0u;

/// Cells of one layer that free ways within it join.
struct Section {
    std::uint32_t seed = 0;  ///< its first cell
    int layer = 0;
    double area = 0;
    int low[2] = {0, 0}, high[2] = {0, 0};
    bool open = false;                                 ///< it reaches the outermost layers
    std::uint32_t next[2] = {kNoSection, kNoSection};  ///< the largest one that it leads to, backward and onward
};

class NarrowFinder {
public:
    NarrowFinder(const AirGrid& grid, const std::vector<bool>& inside, int axis)
        : grid_(grid), inside_(inside), axis_(axis), across_{(axis + 1) % 3, (axis + 2) % 3} {}

    void find(std::vector<Narrow>& narrows) {
        section_of_.assign(grid_.cells(), kNoSection);
        for (int layer = 0; layer < grid_.layers(axis_); ++layer) add_layer(layer);
        for (std::size_t cell = 0; cell < grid_.cells(); ++cell)
            if (grid_.is_free(cell, axis_)) join(section_of_[cell], section_of_[cell + grid_.stride(axis_)]);
        for (const Section& section : sections_) {
            if (section.open || (!inside_.empty() && !inside_[section.seed])) continue;
            for (const bool onward : {true, false})
                if (widens(section, onward) && fills_rectangle(section)) narrows.push_back(make(section, onward));
        }
    }

private:
    int layer_across(std::size_t cell, int k) const { return grid_.layer_of(cell, across_[k]); }
    std::size_t layer_size(int k) const { return std::size_t(grid_.layers(across_[k])); }

    void add_layer(int layer) {
        const std::size_t base = std::size_t(layer) * grid_.stride(axis_);
        for (std::size_t j = 0; j < layer_size(1); ++j)
            for (std::size_t i = 0; i < layer_size(0); ++i) {
                const std::size_t cell = base + i * grid_.stride(across_[0]) + j * grid_.stride(across_[1]);
                if (grid_.is_air(cell) && section_of_[cell] == kNoSection) add_section(cell, layer);
            }
    }

    void add_section(std::size_t seed, int layer) {
        const auto number = std::uint32_t(sections_.size());
        Section section;
        section.seed = std::uint32_t(seed);
        section.layer = layer;
        for (int k = 0; k < 2; ++k) section.low[k] = section.high[k] = layer_across(seed, k);
        waiting_.assign(1, section.seed);
        section_of_[seed] = number;
        while (!waiting_.empty()) {
            const std::size_t cell = waiting_.back();
            waiting_.pop_back();
            double area = 1;
            for (int k = 0; k < 2; ++k) {
                const int at = layer_across(cell, k), stride_axis = across_[k];
                area *= grid_.width(stride_axis, at);
                section.low[k] = std::min(section.low[k], at);
                section.high[k] = std::max(section.high[k], at);
                section.open |= at == 0 || at + 1 == grid_.layers(stride_axis);
                const std::size_t stride = grid_.stride(stride_axis);
                if (grid_.is_free(cell, stride_axis)) reach(cell + stride, number);
                if (at > 0 && grid_.is_free(cell - stride, stride_axis)) reach(cell - stride, number);
            }
            section.area += area;
        }
        sections_.push_back(section);
    }

    void reach(std::size_t cell, std::uint32_t number) {
        if (section_of_[cell] != kNoSection) return;
        section_of_[cell] = number;
        waiting_.push_back(std::uint32_t(cell));
    }

    void join(std::uint32_t before, std::uint32_t after) {
        const auto offer = [&](std::uint32_t& next, std::uint32_t other) {
            if (next == kNoSection || sections_[other].area > sections_[next].area) next = other;
        };
        offer(sections_[before].next[1], after);
        offer(sections_[after].next[0], before);
    }

    bool widens(const Section& section, bool onward) const {
        std::uint32_t next = section.next[onward];
        if (next == kNoSection || sections_[next].area < kAtOnce * section.area) return false;
        const double from = grid_.centre(axis_, section.layer);
        for (;;) {
            if (sections_[next].area >= kWider * section.area) return true;
            next = sections_[next].next[onward];
            if (next == kNoSection) return false;
            const double way = grid_.centre(axis_, sections_[next].layer) - from;
            if (way > kReach || way < -kReach) return false;
        }
    }

    /// Calls `function(cell)` for all cells of its layer in the rectangle around a section.
    template <class Function>
    void for_each_around(const Section& section, const Function& function) const {
        const std::size_t base = std::size_t(section.layer) * grid_.stride(axis_);
        for (int j = section.low[1]; j <= section.high[1]; ++j)
            for (int i = section.low[0]; i <= section.high[0]; ++i)
                function(base + std::size_t(i) * grid_.stride(across_[0]) + std::size_t(j) * grid_.stride(across_[1]));
    }

    /// Whether there is no other air in the rectangle around it: a portal there would divide that as well.
    bool fills_rectangle(const Section& section) const {
        const std::uint32_t number = section_of_[section.seed];
        bool alone = true;
        for_each_around(section, [&](std::size_t cell) {
            alone &= section_of_[cell] == number || section_of_[cell] == kNoSection;
        });
        return alone;
    }

    /// To the centres of the next cells; but where one of them is air, behind a wall thinner than cells are, hardly
    /// into that wall.
    double reach_into_solid(Section section, int k, bool upward) const {
        const int across = across_[k], last = upward ? section.high[k] : section.low[k];
        const int next = upward ? last + 1 : last - 1;
        section.low[k] = section.high[k] = next;
        bool air = false;
        for_each_around(section, [&](std::size_t cell) { air |= grid_.is_air(cell); });
        if (!air) return grid_.centre(across, next);
        return upward ? grid_.border(across, next) + kIntoWall : grid_.border(across, last) - kIntoWall;
    }

    Narrow make(const Section& section, bool onward) const {
        Narrow narrow{axis_, section.layer, section.area, {}, {}, {}};
        for (int k = 0; k < 2; ++k) {
            narrow.low[k] = reach_into_solid(section, k, false);
            narrow.high[k] = reach_into_solid(section, k, true);
        }
        const std::uint32_t number = section_of_[section.seed];
        for_each_around(section, [&](std::size_t cell) {
            if (section_of_[cell] != number) return;
            if (!onward) cell -= grid_.stride(axis_);
            if (grid_.is_free(cell, axis_)) narrow.ways.push_back(std::uint32_t(cell));
        });
        return narrow;
    }

    const AirGrid& grid_;
    const std::vector<bool>& inside_;
    const int axis_;
    const int across_[2];
    std::vector<Section> sections_;
    std::vector<std::uint32_t> section_of_, waiting_;
};

}  // namespace

std::vector<Narrow> find_narrows(const AirGrid& grid, const std::vector<bool>& inside) {
    std::vector<Narrow> narrows;
    for (int axis = 0; axis < 3; ++axis) NarrowFinder(grid, inside, axis).find(narrows);
    std::sort(narrows.begin(), narrows.end(), [](const Narrow& a, const Narrow& b) {
        return std::tie(a.area, a.axis, a.layer, a.ways) < std::tie(b.area, b.axis, b.layer, b.ways);
    });
    return narrows;
}

}  // namespace firma
