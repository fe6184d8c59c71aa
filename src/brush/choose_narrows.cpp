// SPDX-License-Identifier: MIT
// Cells become rooms, and rooms become larger ones.
#include "brush/choose_narrows.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <numeric>
#include <queue>
#include <tuple>

namespace firma {
namespace {

constexpr std::uint32_t kNoRoom = ~0u;
constexpr std::uint32_t kMostBetweenRooms = 12;  ///< between two rooms: what has more is a fence, or a window with bars
constexpr double kShare = 0.75;                  ///< of a narrow that divides rooms, at least
constexpr int kMostChoices = 8;
constexpr double kEndless = 1e18;  ///< cubic metres: a room that reaches beyond the level

class RoomJoiner {
public:
    RoomJoiner(const AirGrid& grid, const DivideOptions& options)
        : grid_(grid), options_(options), room_of_(grid.cells(), kNoRoom) {
        for (std::size_t cell = 0; cell < grid.cells(); ++cell)
            if (grid.is_air(cell) && room_of_[cell] == kNoRoom) add_room(cell);
        openings_.resize(volumes_.size());
        part_of_.resize(volumes_.size());
        std::iota(part_of_.begin(), part_of_.end(), 0u);
    }

    /// @param number  the narrow's own: more than those before
    void add_openings(const Narrow& narrow, std::uint32_t number) {
        for_each_way(narrow, [&](std::uint32_t a, std::uint32_t b, double area) {
            if (a == b) return;
            for (Opening* opening : {&openings_[a][b], &openings_[b][a]}) {
                opening->area += area;
                if (opening->narrows.empty() || opening->narrows.back() != number) opening->narrows.push_back(number);
            }
        });
    }

    /// The widest openings first. Rooms only grow, and so openings become narrower by the way: an offer that was made
    /// before is made again, when its turn comes. One that becomes wider, as two become one, is made at once.
    void join_rooms() {
        for (std::uint32_t a = 0; a < openings_.size(); ++a)
            for (const auto& [b, opening] : openings_[a])
                if (a < b) offers_.push(offer(a, b, opening));
        while (!offers_.empty()) {
            const Offer best = offers_.top();
            offers_.pop();
            const std::uint32_t a = room(best.a), b = room(best.b);
            if (a == b) continue;
            const Opening& opening = openings_[a][b];
            const Offer now = offer(a, b, opening);
            if (now.width() < best.width()) offers_.push(now);
            if (now.width() != best.width()) continue;
            const bool fence = opening.narrows.size() > kMostBetweenRooms;
            if (now.small < options_.min_room_volume || now.is_wide(options_.narrow) || fence) join(a, b);
        }
    }

    /// How much of a narrow has two rooms on its sides, 0 .. 1.
    double share_that_divides(const Narrow& narrow) {
        double divided = 0, all = 0;
        for_each_way(narrow, [&](std::uint32_t a, std::uint32_t b, double area) {
            all += area;
            divided += a == b ? 0 : area;
        });
        return all > 0 ? divided / all : 0;
    }

private:
    /// All that leads from one room to another.
    struct Opening {
        double area = 0;                     ///< square metres
        std::vector<std::uint32_t> narrows;  ///< by number
    };

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
            if (room_of_[cell] != kNoRoom) return;
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

    /// Calls `function(room, room beyond, area)` for each way out of a narrow.
    template <class Function>
    void for_each_way(const Narrow& narrow, const Function& function) {
        const int u = (narrow.axis + 1) % 3, v = (narrow.axis + 2) % 3;
        for (const std::uint32_t cell : narrow.ways) {
            const std::uint32_t a = room(room_of_[cell]);
            const std::uint32_t b = room(room_of_[cell + grid_.stride(narrow.axis)]);
            function(a, b, grid_.width(u, grid_.layer_of(cell, u)) * grid_.width(v, grid_.layer_of(cell, v)));
        }
    }

    Offer offer(std::uint32_t a, std::uint32_t b, const Opening& opening) const {
        return {opening.area, std::min(volumes_[a], volumes_[b]), std::min(a, b), std::max(a, b)};
    }

    /// What a room is part of by now.
    std::uint32_t room(std::uint32_t k) {
        while (part_of_[k] != k) k = part_of_[k] = part_of_[part_of_[k]];
        return k;
    }

    /// The one with fewer openings becomes part of the other.
    void join(std::uint32_t stays, std::uint32_t goes) {
        if (openings_[stays].size() < openings_[goes].size()) std::swap(stays, goes);
        part_of_[goes] = stays;
        volumes_[stays] = std::min(volumes_[stays] + volumes_[goes], kEndless);
        openings_[stays].erase(goes);
        openings_[goes].erase(stays);
        for (const auto& [other, opening] : openings_[goes]) {
            openings_[other].erase(goes);
            Opening& sum = openings_[stays][other];
            sum.area += opening.area;
            unite(sum.narrows, opening.narrows);
            openings_[other][stays] = sum;
            offers_.push(offer(stays, other, sum));
        }
        openings_[goes].clear();
    }

    /// A narrow may lead from one room to two that become one.
    void unite(std::vector<std::uint32_t>& narrows, const std::vector<std::uint32_t>& more) {
        united_.clear();
        std::set_union(narrows.begin(), narrows.end(), more.begin(), more.end(), std::back_inserter(united_));
        narrows = united_;
    }

    const AirGrid& grid_;
    const DivideOptions& options_;
    std::vector<std::uint32_t> room_of_;                      ///< a cell each; kNoRoom in the solid
    std::vector<double> volumes_;                             ///< of rooms, cubic metres
    std::vector<std::map<std::uint32_t, Opening>> openings_;  ///< of rooms, to others
    std::vector<std::uint32_t> part_of_;
    std::priority_queue<Offer> offers_;
    std::vector<std::uint32_t> waiting_, united_;
};

}  // namespace

std::vector<std::uint32_t> choose_narrows(const AirGrid& grid, std::span<const Narrow> narrows,
                                          std::vector<bool> without, const DivideOptions& options) {
    for (int round = 0;; ++round) {
        AirGrid cut = grid;
        std::vector<std::uint32_t> tried, chosen;
        for (std::uint32_t k = 0; k < narrows.size(); ++k) {
            const Narrow& narrow = narrows[k];
            const auto is_cut = [&](std::uint32_t cell) { return cut.is_cut(cell, narrow.axis); };
            if (without[k] || std::any_of(narrow.ways.begin(), narrow.ways.end(), is_cut)) continue;
            for (const std::uint32_t cell : narrow.ways) cut.cut(cell, narrow.axis);
            tried.push_back(k);
        }
        RoomJoiner joiner(cut, options);
        for (const std::uint32_t k : tried) joiner.add_openings(narrows[k], k);
        joiner.join_rooms();
        bool again = false;
        for (const std::uint32_t k : tried) {
            const double share = joiner.share_that_divides(narrows[k]);
            if (share > 0) chosen.push_back(k);
            if (share > 0 && share < kShare) again = without[k] = true;
        }
        if (!again || round + 1 == kMostChoices) return chosen;
    }
}

}  // namespace firma
