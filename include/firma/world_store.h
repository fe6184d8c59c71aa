// SPDX-License-Identifier: MIT
// A place for the newest version of a world: readers take it while an editor works on the next, and old versions are
// kept for as long as their bytes allow.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>

#include "firma/export.h"
#include "firma/world.h"

namespace firma {

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
class WorldStore {
public:
    FIRMA_EXPORT explicit WorldStore(World first, const WorldStoreOptions& options = {});
    FIRMA_EXPORT ~WorldStore();
    WorldStore(const WorldStore&) = delete;
    WorldStore& operator=(const WorldStore&) = delete;

    /// The version that was published last, or that undo() or redo() went to.
    FIRMA_EXPORT World current() const;
    /// A version of the history, undone ones included; nothing when it is not kept (any more). Numbers name versions of
    /// one line: when some were undone and others published instead, their numbers are used again.
    FIRMA_EXPORT std::optional<World> at(std::uint64_t version) const;
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
    FIRMA_EXPORT PublishStatus publish(const World& before, World after);

    /// Goes back to the version before, or forward to the one that was undone.
    /// @return the version gone to, whatever other threads do meanwhile; nothing when there is none
    FIRMA_EXPORT std::optional<World> undo();
    FIRMA_EXPORT std::optional<World> redo();

    /// Drops versions, the oldest first, then of the undone ones the newest, until StoreHistory::bytes is at most so
    /// many; from then on publish() keeps it so. The current version always stays: with 0 only it does,
    /// and there is no undo.
    FIRMA_EXPORT void set_history_bytes(std::size_t bytes);

    /// Begins anew with another world, of any version; everything else is dropped.
    FIRMA_EXPORT void reset(World first);

    /// Frees dropped versions that no reader holds any more: for when nothing is published for a while.
    /// @return how many are still held
    FIRMA_EXPORT std::size_t collect();

private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace firma
