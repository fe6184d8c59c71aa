// SPDX-License-Identifier: MIT
// Cells become rooms, and rooms become larger ones.
#include "brush/choose_narrows.h"

#include <algorithm>
#include <map>
#include <queue>
#include <tuple>

#include "base/disjoint_sets.h"

namespace firma {
namespace {

constexpr std::uint32_t kNone = ~0u;
constexpr double kEndless = 1e18;  ///< cubic metres: a room that reaches beyond the level

class RoomJoiner {
public:
    RoomJoiner(const AirGrid& grid, const DivideOptions& options)
        : grid_(grid), options_(options), room_of_(grid.cells(), kNone) {
        for (std::size_t cell = 0; cell < grid.cells(); ++cell)
            if (grid.is_air(cell) && room_of_[cell] == kNone) add_room(cell);
        openings_.resize(volumes_.size());
        joined_ = DisjointSets(volumes_.size());
    }

    void add_openings(const Narrow& narrow) {
        for_each_pair(narrow, [&](std::uint32_t a, std::uint32_t b, double area) {
            openings_[a][b] += area;
            openings_[b][a] += area;
        });
    }

    void join_rooms() {
        for (std::uint32_t a = 0; a < openings_.size(); ++a)
            for (const auto& [b, area] : openings_[a])
                if (a < b) offer(a, b, area);
        while (!offers_.empty()) {
            const Offer best = offers_.top();
            offers_.pop();
            const double small = std::min(volumes_[best.a], volumes_[best.b]);
            const bool stale = joined_.find(best.a) != best.a || joined_.find(best.b) != best.b ||
                               small != best.small || openings_[best.a][best.b] != best.area;
            if (stale || (small >= options_.smallest_room && !best.is_wide(options_.narrow))) continue;
            join(best.a, best.b);
        }
    }

    bool divides(const Narrow& narrow) {
        bool divides = false;
        for_each_pair(narrow, [&](std::uint32_t a, std::uint32_t b, double) { divides |= a != b; });
        return divides;
    }

private:
    /// To join two rooms. Equal ones are told apart by their numbers.
    struct Offer {
        double area, small;  ///< of the opening, of the smaller room
        std::uint32_t a, b;

        /// Of a cube of volume V a wall has the area V^(2/3).
        double width() const { return area * area * area / (small * small); }
        bool is_wide(double narrow) const { return width() > narrow * narrow * narrow; }
        bool operator<(const Offer& other) const {
            const double mine = width(), others = other.width();
            return std::tie(mine, other.a, other.b) < std::tie(others, a, b);
        }
    };

    double volume_of(std::size_t cell) const {
        if (grid_.is_outermost(cell)) return kEndless;
        double volume = 1;
        for (int axis = 0; axis < 3; ++axis) volume *= grid_.width(axis, grid_.layer_of(cell, axis));
        return volume;
    }

    void add_room(std::size_t seed) {
        const auto number = std::uint32_t(volumes_.size());
        double volume = 0;
        room_of_[seed] = number;
        waiting_.assign(1, std::uint32_t(seed));
        const auto reach = [&](std::size_t cell) {
            if (room_of_[cell] != kNone) return;
            room_of_[cell] = number;
            waiting_.push_back(std::uint32_t(cell));
        };
        const auto leads_on = [&](std::size_t cell, int axis) {
            return grid_.is_free(cell, axis) && !grid_.is_cut(cell, axis);
        };
        while (!waiting_.empty()) {
            const std::size_t cell = waiting_.back();
            waiting_.pop_back();
            volume += volume_of(cell);
            for (int axis = 0; axis < 3; ++axis) {
                const std::size_t stride = grid_.stride(axis);
                if (leads_on(cell, axis)) reach(cell + stride);
                if (cell >= stride && leads_on(cell - stride, axis)) reach(cell - stride);
            }
        }
        volumes_.push_back(std::min(volume, kEndless));
    }

    /// The rooms on both sides of each way out of a narrow, where they are two.
    template <class Function>
    void for_each_pair(const Narrow& narrow, const Function& function) {
        const int u = (narrow.axis + 1) % 3, v = (narrow.axis + 2) % 3;
        for (const std::uint32_t cell : narrow.ways) {
            const std::uint32_t a = joined_.find(room_of_[cell]);
            const std::uint32_t b = joined_.find(room_of_[cell + grid_.stride(narrow.axis)]);
            if (a == b) continue;
            function(a, b, grid_.width(u, grid_.layer_of(cell, u)) * grid_.width(v, grid_.layer_of(cell, v)));
        }
    }

    void offer(std::uint32_t a, std::uint32_t b, double area) {
        offers_.push({area, std::min(volumes_[a], volumes_[b]), std::min(a, b), std::max(a, b)});
    }

    void join(std::uint32_t a, std::uint32_t b) {
        joined_.join(a, b);
        const std::uint32_t stays = joined_.find(a), goes = stays == a ? b : a;
        volumes_[stays] = std::min(volumes_[stays] + volumes_[goes], kEndless);
        openings_[stays].erase(goes);
        openings_[goes].erase(stays);
        for (const auto& [other, area] : openings_[goes]) {
            openings_[other].erase(goes);
            openings_[stays][other] += area;
            openings_[other][stays] = openings_[stays][other];
        }
        openings_[goes].clear();
        for (const auto& [other, area] : openings_[stays]) offer(stays, other, area);
    }

    const AirGrid& grid_;
    const DivideOptions& options_;
    std::vector<std::uint32_t> room_of_;                     ///< a cell each; kNone in the solid
    std::vector<double> volumes_;                            ///< of rooms, cubic metres
    std::vector<std::map<std::uint32_t, double>> openings_;  ///< to other rooms, square metres
    DisjointSets joined_{0};
    std::priority_queue<Offer> offers_;
    std::vector<std::uint32_t> waiting_;
};

}  // namespace

std::vector<std::uint32_t> choose_narrows(AirGrid& grid, std::span<const Narrow> narrows,
                                          const DivideOptions& options) {
    std::vector<std::uint32_t> tried, chosen;
    for (std::uint32_t k = 0; k < narrows.size(); ++k) {
        const Narrow& narrow = narrows[k];
        const auto is_cut = [&](std::uint32_t cell) { return grid.is_cut(cell, narrow.axis); };
        if (std::any_of(narrow.ways.begin(), narrow.ways.end(), is_cut)) continue;
        for (const std::uint32_t cell : narrow.ways) grid.cut(cell, narrow.axis);
        tried.push_back(k);
    }
    RoomJoiner joiner(grid, options);
    for (const std::uint32_t k : tried) joiner.add_openings(narrows[k]);
    joiner.join_rooms();
    for (const std::uint32_t k : tried)
        if (joiner.divides(narrows[k])) chosen.push_back(k);
    return chosen;
}

}  // namespace firma
