// SPDX-License-Identifier: MIT
// What differs between two worlds, as bytes: for peers who find that theirs are not the same, and for players who join
// late. docs/edit_log.md tells how.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "firma/export.h"
#include "firma/result.h"
#include "firma/solid.h"
#include "firma/world.h"

namespace firma {

/// The regions whose hashes differ, ascending: those that only one list has, too. Costs both lists, sorted.
[[nodiscard]] FIRMA_EXPORT std::vector<Region> differing_regions(std::span<const RegionHash> a,
                                                                 std::span<const RegionHash> b);

/// What a world has in some regions, as bytes for another peer: the id and hash of each face, 12 bytes a face; a hash
/// of its rooms and portals. Regions beyond the world have none. Costs the faces there, sorted.
[[nodiscard]] FIRMA_EXPORT std::vector<std::byte> list_faces(const World& world, std::span<const Region> regions);

/// The patch that makes this world out of the one that a list was made of: which of the faces listed go, and those of
/// these regions that come, with their exact form; rooms and portals, where they differ; counters and names of
/// materials; what holds loose pieces (with_anchors()). Rules, textures, the contact offset and options of trees are
/// not in it.
/// @param list  of list_faces(), by whomever: taken as hostile
/// @param name  of the list, for messages
/// @return kMalformed, with the section and entry, for bytes that are no list
/// Costs the faces of the regions, and those around the ones that differ.
[[nodiscard]] FIRMA_EXPORT Result<std::vector<std::byte>> make_patch(const World& world,
                                                                     std::span<const std::byte> list, std::string name);
/// The same from a world at hand, whose ids, rules and textures it shares: in the regions where they differ.
[[nodiscard]] FIRMA_EXPORT std::vector<std::byte> make_patch(const World& from, const World& to);

/// The world that a patch makes, which is taken as hostile: of damage, of faces that do not close with those around
/// them, and of any world whose hash_world() is not the one that the patch says, nothing is published.
/// @param world  the one that the patch was made for
/// @return kInvalid for another world; else errors as unpack_world()
/// Shares what the patch leaves as it is. What is exchanged is judged, and its border with what stays; the world is
/// taken as sound: then the one made is, too (check_world(), check_solid()). Costs the patch, and of faces that stay
/// those near; a comparison of ids with theirs where numbers went back, and all of them where rooms that stay became
/// part of others.
[[nodiscard]] FIRMA_EXPORT Result<World> apply_patch(const World& world, std::span<const std::byte> patch,
                                                     std::string name);

}  // namespace firma
