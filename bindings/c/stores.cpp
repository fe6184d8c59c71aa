// SPDX-License-Identifier: MIT
// Histories.
#include <limits>
#include <string>

#include "bindings/c/calls.h"
#include "bindings/c/objects.h"
#include "bindings/c/store_object.h"

namespace firma::c {
namespace {

/// Goes where `step` says, undo() or redo(), and gives the world gone to. Its handle is made first, known to nobody:
/// what may find no memory comes before what changes the store.
template <class Step>
firma_code give_gone_to(WorldStore& store, Step step, firma_world* out, const char* none, const char* function) {
    auto object = std::make_unique<WorldObject>(store.current());
    World& shown = object->world;
    firma_world made{};
    if (const firma_code code = give(std::move(object), &made, function)) return code;
    std::optional<World> gone_to = (store.*step)();
    if (!gone_to) {
        remove_object(made.id, WorldObject::kKind);
        return fail(FIRMA_ERROR_INVALID, function, none);
    }
    shown = *std::move(gone_to);
    *out = made;
    return FIRMA_OK;
}

firma_code give_current(const WorldStore& store, firma_world* out, const char* function) {
    return give(std::make_unique<WorldObject>(store.current()), out, function);
}

}  // namespace
}  // namespace firma::c

using namespace firma;
using namespace firma::c;

firma_code firma_store_open(firma_world first, uint64_t max_bytes, firma_store* store) {
    return guarded(__func__, [&, function = __func__] {
        if (!store) return bad_call(function, kNull);
        const WorldObject* object = find<WorldObject>(first.id, function);
        if (!object) return FIRMA_ERROR_BAD_HANDLE;
        constexpr std::uint64_t kMost = std::numeric_limits<std::size_t>::max();
        WorldStoreOptions options;
        options.history_bytes = std::size_t(max_bytes < kMost ? max_bytes : kMost);
        return give(std::make_unique<StoreObject>(object->world, options), store, function);
    });
}

firma_code firma_store_current(firma_store store, firma_world* world) {
    return guarded(__func__, [&, function = __func__] {
        if (!world) return bad_call(function, kNull);
        const StoreObject* object = find<StoreObject>(store.id, function);
        return object ? give_current(object->store, world, function) : FIRMA_ERROR_BAD_HANDLE;
    });
}

firma_code firma_store_publish(firma_store store, firma_world before, firma_world after) {
    return guarded(__func__, [&, function = __func__] {
        StoreObject* object = find<StoreObject>(store.id, function);
        const WorldObject* first = object ? find<WorldObject>(before.id, function) : nullptr;
        const WorldObject* second = first ? find<WorldObject>(after.id, function) : nullptr;
        if (!second) return FIRMA_ERROR_BAD_HANDLE;
        switch (object->store.publish(first->world, second->world)) {
            case PublishStatus::kDone:
            case PublishStatus::kSame:
                return FIRMA_OK;
            case PublishStatus::kStale:
                return fail(FIRMA_ERROR_INVALID, function,
                            "it was not made from the current version: do the edit again on that");
            case PublishStatus::kNotNewer:
                return fail(FIRMA_ERROR_INVALID, function, "its version does not exceed that of the world before");
        }
        return FIRMA_ERROR_INTERNAL;
    });
}

firma_code firma_store_undo(firma_store store, firma_world* world) {
    return guarded(__func__, [&, function = __func__] {
        if (!world) return bad_call(function, kNull);
        StoreObject* object = find<StoreObject>(store.id, function);
        if (!object) return FIRMA_ERROR_BAD_HANDLE;
        return give_gone_to(object->store, &WorldStore::undo, world, "no version before the current one is held",
                            function);
    });
}

firma_code firma_store_redo(firma_store store, firma_world* world) {
    return guarded(__func__, [&, function = __func__] {
        if (!world) return bad_call(function, kNull);
        StoreObject* object = find<StoreObject>(store.id, function);
        if (!object) return FIRMA_ERROR_BAD_HANDLE;
        return give_gone_to(object->store, &WorldStore::redo, world, "no version was undone", function);
    });
}

firma_code firma_store_at(firma_store store, uint64_t version, firma_world* world) {
    return guarded(__func__, [&, function = __func__] {
        if (!world) return bad_call(function, kNull);
        const StoreObject* object = find<StoreObject>(store.id, function);
        if (!object) return FIRMA_ERROR_BAD_HANDLE;
        const std::optional<World> kept = object->store.at(version);
        if (!kept) return fail(FIRMA_ERROR_INVALID, function, "version " + std::to_string(version) + " is not held");
        return give(std::make_unique<WorldObject>(*kept), world, function);
    });
}

firma_code firma_store_get_facts(firma_store store, firma_store_facts* out) {
    return guarded(__func__, [&, function = __func__] {
        if (!out) return bad_call(function, kNull);
        if (!sized(out)) return bad_call(function, kWrongSize);
        firma_store_facts facts{};
        const StoreObject* object = find<StoreObject>(store.id, function);
        if (!object) return FIRMA_ERROR_BAD_HANDLE;
        const StoreHistory history = object->store.history();
        facts.oldest = history.oldest;
        facts.current = history.current;
        facts.newest = history.newest;
        facts.versions = history.versions;
        facts.bytes = history.bytes;
        facts.waiting = history.waiting;
        put_sized(facts, out);
        return FIRMA_OK;
    });
}

firma_code firma_store_collect(firma_store store, uint64_t* waiting) {
    return guarded(__func__, [&, function = __func__] {
        StoreObject* object = find<StoreObject>(store.id, function);
        if (!object) return FIRMA_ERROR_BAD_HANDLE;
        const std::size_t left = object->store.collect();
        if (waiting) *waiting = left;
        return FIRMA_OK;
    });
}

firma_code firma_store_release(firma_store store) {
    return release<StoreObject>(store.id, __func__);
}
