// SPDX-License-Identifier: MIT
// Publishing, history and the end of versions, among threads.
//
// Three locks, always taken in this order. `writer`: whoever changes the store has it from beginning to end, so that
// writers take turns; measuring and freeing happen under it alone. `history`: while versions are moved in or out of the
// row, or one is copied from it. `current`: while the current handle is copied or swapped, and nothing else.
#include "firma/versions.h"

#include <algorithm>
#include <functional>
#include <utility>
#include <vector>

#include "base/lock.h"
#include "base/sort.h"
#include "store/bytes_alone.h"
#include "store/history.h"

namespace firma {

struct WorldStore::State {
    State(World first, std::size_t bytes) : history(first), current(std::move(first)), history_bytes(bytes) {}

    /// For writers: `history` says which version is current.
    void show_current() {
        World shown = history.current();
        const std::lock_guard<Lock> guard(current_lock);
        std::swap(current, shown);
        // The handle before lives on in `history` or `dropped`, so this is not its version's end.
    }

    /// For writers, before anything changes: whatever the history lets go of then needs no more memory.
    void make_room_for_dropped() {
        const std::size_t most = dropped.size() + history.size() + 1;
        if (dropped.capacity() < most) dropped.reserve(2 * most);
    }

    /// For writers holding the history's lock.
    void keep_within_bytes() {
        while (history.bytes() > history_bytes && history.can_undo()) dropped.push_back(history.take_oldest());
        while (history.bytes() > history_bytes && history.can_redo()) dropped.push_back(history.take_newest());
    }

    /// For writers. A dropped version with one handle has the one in `dropped`: nobody can get another from it.
    std::size_t collect() {
        // A version that was dropped, published once more and dropped again is here twice. Order shows nowhere.
        const auto address = [](const World& a) { return &a.data(); };
        sort_range(dropped, [&](const World& a, const World& b) {
            return std::less<const WorldData*>()(address(a), address(b));
        });
        const auto same = [&](const World& a, const World& b) { return address(a) == address(b); };
        dropped.erase(std::unique(dropped.begin(), dropped.end(), same), dropped.end());
        std::erase_if(dropped, [](const World& version) { return version.handles() == 1; });
        const std::lock_guard<Lock> guard(history_lock);
        return waiting = dropped.size();
    }

    Lock writer_lock;
    std::vector<World> dropped;  // from the history, perhaps still held by readers

    Lock history_lock;
    History history;
    std::size_t waiting = 0;  // what `dropped` held after the last collection

    Lock current_lock;
    World current;

    std::size_t history_bytes;
};

WorldStore::WorldStore(World first, const WorldStoreOptions& options)
    : state_(std::make_unique<State>(std::move(first), options.history_bytes)) {}
WorldStore::~WorldStore() = default;

World WorldStore::current() const {
    const std::lock_guard<Lock> guard(state_->current_lock);
    return state_->current;
}

std::optional<World> WorldStore::at(std::uint64_t version) const {
    const std::lock_guard<Lock> guard(state_->history_lock);
    return state_->history.find(version);
}

StoreHistory WorldStore::history() const {
    const std::lock_guard<Lock> guard(state_->history_lock);
    const History& history = state_->history;
    return {history.oldest().version(),
            history.current().version(),
            history.newest().version(),
            history.size(),
            history.bytes(),
            state_->waiting};
}

PublishStatus WorldStore::publish(const World& before, World after) {
    const std::lock_guard<Lock> turn(state_->writer_lock);
    const World& current = state_->history.current();  // changed by writers only
    if (&before.data() != &current.data()) return PublishStatus::kStale;
    if (&after.data() == &current.data()) return PublishStatus::kSame;
    if (after.version() <= current.version()) return PublishStatus::kNotNewer;
    const std::size_t lost = bytes_alone(current, after);
    state_->make_room_for_dropped();
    {
        const std::lock_guard<Lock> guard(state_->history_lock);
        state_->history.push(std::move(after), lost, state_->dropped);
        state_->keep_within_bytes();
    }
    state_->show_current();
    state_->collect();
    return PublishStatus::kDone;
}

std::optional<World> WorldStore::undo() {
    const std::lock_guard<Lock> turn(state_->writer_lock);
    if (!state_->history.can_undo()) return {};
    {
        const std::lock_guard<Lock> guard(state_->history_lock);
        state_->history.undo();
    }
    state_->show_current();
    state_->collect();
    return state_->history.current();
}

std::optional<World> WorldStore::redo() {
    const std::lock_guard<Lock> turn(state_->writer_lock);
    if (!state_->history.can_redo()) return {};
    {
        const std::lock_guard<Lock> guard(state_->history_lock);
        state_->history.redo();
    }
    state_->show_current();
    state_->collect();
    return state_->history.current();
}

void WorldStore::set_history_bytes(std::size_t bytes) {
    const std::lock_guard<Lock> turn(state_->writer_lock);
    state_->make_room_for_dropped();
    {
        const std::lock_guard<Lock> guard(state_->history_lock);
        state_->history_bytes = bytes;
        state_->keep_within_bytes();
    }
    state_->collect();
}

void WorldStore::reset(World first) {
    const std::lock_guard<Lock> turn(state_->writer_lock);
    state_->make_room_for_dropped();
    {
        History anew(std::move(first));
        {
            const std::lock_guard<Lock> guard(state_->history_lock);
            std::swap(state_->history, anew);
        }
        state_->show_current();
        while (anew.can_undo()) state_->dropped.push_back(anew.take_oldest());
        while (anew.can_redo()) state_->dropped.push_back(anew.take_newest());
        state_->dropped.push_back(anew.current());
    }
    state_->collect();
}

std::size_t WorldStore::collect() {
    const std::lock_guard<Lock> turn(state_->writer_lock);
    return state_->collect();
}

}  // namespace firma
