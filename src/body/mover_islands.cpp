// SPDX-License-Identifier: MIT
// Islands of movers.
#include "body/mover_islands.h"

#include <algorithm>

#include "base/disjoint_sets.h"

namespace firma {
namespace {

/// Puts elements in order of their island, each by a number that islands were given in order.
template <class T, class IslandOf>
std::vector<std::uint32_t> places_by_island(const std::vector<T>& all, std::size_t islands, const IslandOf& island_of) {
    std::vector<std::uint32_t> starts(islands + 1), places(all.size());
    for (const T& one : all) ++starts[island_of(one) + 1];
    for (std::size_t k = 0; k < islands; ++k) starts[k + 1] += starts[k];
    for (std::size_t k = 0; k < all.size(); ++k) places[k] = starts[island_of(all[k])]++;
    return places;
}

template <class T>
void put_in_places(std::vector<T>& all, const std::vector<std::uint32_t>& places) {
    std::vector<T> moved(all.size());
    for (std::size_t k = 0; k < all.size(); ++k) moved[places[k]] = std::move(all[k]);
    all = std::move(moved);
}

}  // namespace

std::vector<MoverIsland> part_into_islands(std::vector<Mover>& movers, std::vector<NearContact>& contacts) {
    DisjointSets sets(movers.size());
    for (const NearContact& contact : contacts)
        if (contact.b != kFixed) sets.join(contact.a, contact.b);
    // Numbers of islands, in the order of their first movers.
    std::vector<std::uint32_t> number_of_root(movers.size(), ~0u), island_of(movers.size());
    std::vector<MoverIsland> islands;
    for (std::uint32_t k = 0; k < movers.size(); ++k) {
        std::uint32_t& number = number_of_root[sets.find(k)];
        if (number == ~0u) {
            number = std::uint32_t(islands.size());
            islands.emplace_back();
        }
        island_of[k] = number;
        ++islands[number].movers;
    }
    for (const NearContact& contact : contacts) {
        MoverIsland& island = islands[island_of[contact.a]];
        ++island.contacts;
        if (contact.b == kFixed) continue;
        const double a = movers[contact.a].inverse_mass, b = movers[contact.b].inverse_mass;
        island.mass_ratio = std::max(island.mass_ratio, a > b ? a / b : b / a);
    }
    for (std::size_t k = 1; k < islands.size(); ++k) {
        islands[k].first_mover = islands[k - 1].first_mover + islands[k - 1].movers;
        islands[k].first_contact = islands[k - 1].first_contact + islands[k - 1].contacts;
    }
    const std::vector<std::uint32_t> contact_places =
        places_by_island(contacts, islands.size(), [&](const NearContact& contact) { return island_of[contact.a]; });
    std::vector<std::uint32_t> order(movers.size());
    for (std::uint32_t k = 0; k < movers.size(); ++k) order[k] = k;
    const std::vector<std::uint32_t> mover_places =
        places_by_island(order, islands.size(), [&](std::uint32_t k) { return island_of[k]; });
    put_in_places(contacts, contact_places);
    put_in_places(movers, mover_places);
    for (NearContact& contact : contacts) {
        contact.a = mover_places[contact.a];
        if (contact.b != kFixed) contact.b = mover_places[contact.b];
    }
    return islands;
}

}  // namespace firma
