// SPDX-License-Identifier: MIT
// Versions of a world: what changed from one to another, for meshes to draw, maps to walk, caches to drop; and a place
// for the newest, which readers take while an editor works on the next.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "firma/export.h"
#include "firma/hit.h"
#include "firma/vec.h"
#include "firma/world.h"

namespace firma {

/// A cell of a grid over space: from coordinate * size to (coordinate + 1) * size along each axis.
using Tile = std::array<std::int32_t, 3>;

/// Tiles of a smaller size are none.
inline constexpr double kMinTileSize = 1.0 / 16;  // metres
/// More of them are not listed.
inline constexpr std::size_t kMaxTiles = std::size_t(1) << 22;

struct WorldDiff {
    std::vector<FaceInfo> removed;  ///< faces of `before` only, in order of id, then room
    std::vector<FaceInfo> added;    ///< of `after` only, likewise; World::face() has their outlines

    // All ascending.
    std::vector<RoomId> rooms;  ///< that a face left or came to, that became part of another or ceased to be, or that
                                ///< only one of the worlds has
    std::vector<PortalId> opened, closed;   ///< doors, of portals in both worlds
    std::vector<PortalId> portals_removed;  ///< with polygons in `before` only
    std::vector<PortalId> portals_added;    ///< in `after` only
    std::vector<PortalId> portals_changed;  ///< in both, and yet not the same: other rooms (as edits joined some),
                                            ///< polygons or names

    Box bounds;                   ///< of all those faces and portals; empty when nothing changed
    std::vector<Tile> tiles;      ///< those that the box of such a face or portal touches, each once, in order
    bool too_many_tiles = false;  ///< there are more than kMaxTiles: `tiles` is empty; go by `bounds`

    bool empty() const {
        return removed.empty() && added.empty() && rooms.empty() && opened.empty() && closed.empty() &&
               portals_removed.empty() && portals_added.empty() && portals_changed.empty();
    }
};

/// Compares two worlds. A face is the same when it has the same id and is alike in everything but its room: what an
/// edit only put into another room, as it joined two, did not change. Rooms and portals are compared by their ids. What
/// the worlds share is not compared, so for versions a few edits apart the cost follows the edits: the blocks, the
/// rooms and the portals that they made anew, and where they joined rooms all portals of these. Worlds that share
/// nothing (read twice, or with an index built anew) cost all faces of both, in time and memory. Tiles cost one entry
/// for each tile in a changed face's box, and sorting them.
///
/// @param tile_size  metres, for `tiles`, at least kMinTileSize; anything smaller (0, say) or not finite is no error,
///                   and `tiles` stays empty.
///                   A long face slanted across many tiles counts for each in its box, so a size far below the faces'
///                   makes a long list; one of more than kMaxTiles is left out, and too_many_tiles is set.
[[nodiscard]] FIRMA_EXPORT WorldDiff diff_worlds(const World& before, const World& after, double tile_size = 0);

struct WorldStoreOptions {
    std::size_t history_bytes = std::size_t(64) << 20;  ///< see WorldStore::set_history_bytes
};

/// What became of a version that was to be published.
enum class PublishStatus : std::uint8_t {
    kDone,
    kSame,      ///< it is the current one (an edit that did nothing): nothing to do
    kStale,     ///< it was not made from the current version: somebody published, undid or redid meanwhile. Nothing
                ///< changed; do the edit again on current()
    kNotNewer,  ///< its number does not exceed that of the version it was made from. Nothing changed
};

/// What a store keeps.
struct StoreHistory {
    std::uint64_t oldest = 0, current = 0, newest = 0;  ///< versions
    std::size_t versions = 0;                           ///< how many are kept, the current one included
    /// Held beside the newest version, as memory_used() counts: that of all versions less that of the newest. So undo()
    /// and redo(), which let go of nothing, do not change it. Exact for a line of edits; too much, never too little,
    /// when worlds were published that were not made from the one before.
    std::size_t bytes = 0;
    std::size_t waiting = 0;  ///< dropped versions that readers still held when it was last looked
};

/// Several threads read while one edits. An editor takes current(), edits it for as long as it takes, and publishes the
/// result; readers take current() once for a job or a frame and ask that World.
///
/// Any thread may call anything. current() waits for nothing but the copying of one handle: no lock it takes is held
/// while an edit is computed, a version measured or freed. The functions that change the store take turns.
/// Versions dropped from the history are freed by the store, in the thread of an editor, and by no reader: a version
/// that a reader still holds waits, and is freed by the first call of publish(), undo(), redo(), set_history_bytes(),
/// reset() or collect() after the reader let go. (Handles that outlive the store free their versions themselves.)
/// Freeing a version costs what it alone holds. Each of these calls also sorts the versions that wait.
class WorldStore {
public:
    /// Costs a handle to the world, whatever its size.
    FIRMA_EXPORT explicit WorldStore(World first, const WorldStoreOptions& options = {});
    /// Lets go of all versions, and frees those that nobody else holds.
    FIRMA_EXPORT ~WorldStore();
    WorldStore(const WorldStore&) = delete;
    WorldStore& operator=(const WorldStore&) = delete;

    /// The version that was published last, or that undo() or redo() went to. Costs one handle; never allocates.
    [[nodiscard]] FIRMA_EXPORT World current() const;
    /// A version of the history, undone ones included; nothing when it is not kept. Numbers name versions of
    /// one line: when some were undone and others published instead, their numbers are used again.
    /// Costs a binary search among the versions kept; never allocates.
    [[nodiscard]] FIRMA_EXPORT std::optional<World> at(std::uint64_t version) const;
    /// What is kept. Kept up by the calls that change it: costs the same however much that is; never allocates.
    FIRMA_EXPORT StoreHistory history() const;

    /// Makes `after` the current version. Versions that were undone are dropped, and of the oldest so many that the
    /// history stays within its bytes.
    ///
    /// @param before  what `after` was made from: must be the current version itself, as current() gave it. So when
    ///                several threads edit, the first to publish wins, and the others are told (kStale) and lose
    ///                nothing but their work.
    /// @param after   of a greater version number. That it came from `before` by edits cannot be seen: another world
    ///                will do, and only counts and costs more.
    /// The cost follows what the two do not share, and what is dropped.
    [[nodiscard]] FIRMA_EXPORT PublishStatus publish(const World& before, World after);

    /// Goes back to the version before, or forward to the one that was undone.
    /// @return the version that is current then, whatever other threads do meanwhile; nothing when there is none
    /// Costs a few handles, whatever the two versions differ in, and freeing what waits and nobody holds any more.
    FIRMA_EXPORT std::optional<World> undo();
    FIRMA_EXPORT std::optional<World> redo();

    /// Drops versions, the oldest first, then of the undone ones the newest, until StoreHistory::bytes is at most so
    /// many; from then on publish() keeps it so. The current version always stays: with 0 only it does,
    /// and there is no undo. Costs what is dropped.
    FIRMA_EXPORT void set_history_bytes(std::size_t bytes);

    /// Begins anew with another world, of any version; everything else is dropped. Costs freeing it.
    FIRMA_EXPORT void reset(World first);

    /// Frees dropped versions that no reader holds any more: for when nothing is published for a while.
    /// @return how many are still held
    /// Costs a look at each version that waits, and what is freed.
    FIRMA_EXPORT std::size_t collect();

private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace firma
