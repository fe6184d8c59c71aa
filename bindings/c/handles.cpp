// SPDX-License-Identifier: MIT
// A table of slots in blocks that never move, each with the number of times it was used.
#include "bindings/c/handles.h"

#include <array>
#include <atomic>
#include <new>
#include <utility>

#include "base/lock.h"

namespace firma::c {
namespace {

constexpr std::uint32_t kSlotsAtOnce = 1024;
constexpr std::uint32_t kBlocks = 4096;
constexpr std::uint32_t kNoSlot = ~0u;

/// `tag` is the use's number and the kind, 0 while the slot is free: a handle is good while its slot has its tag.
struct Slot {
    std::atomic<std::uint64_t> tag{0};
    Object* object = nullptr;
    std::uint32_t uses = 0;
    std::uint32_t next_free = kNoSlot;
};
using Slots = std::array<Slot, kSlotsAtOnce>;

struct Table {
    std::array<std::atomic<Slots*>, kBlocks> blocks{};
    Lock lock;  ///< of what follows
    std::uint32_t slots = 0;
    std::uint32_t first_free = kNoSlot;
    std::size_t held = 0;
};

/// Never destroyed, as handles may be released by whatever runs last; and never without memory.
Table& table() {
    alignas(Table) static std::byte place[sizeof(Table)];
    static auto& only = *new (place) Table;
    return only;
}

std::uint64_t tag_of(std::uint32_t uses, Kind kind) {
    return std::uint64_t(uses) << 8 | std::uint64_t(kind);
}

/// A handle is the number of the use, then that of the slot from 1.
Slot* slot_of(std::uint64_t id) {
    const auto index = std::uint32_t(id) - 1;
    if (index >= kSlotsAtOnce * kBlocks) return nullptr;
    Slots* some = table().blocks[index / kSlotsAtOnce].load(std::memory_order_acquire);
    return some ? &(*some)[index % kSlotsAtOnce] : nullptr;
}

/// With the lock held.
std::uint32_t free_slot(Table& all) {
    if (all.first_free != kNoSlot)
        return std::exchange(all.first_free, slot_of(std::uint64_t(all.first_free) + 1)->next_free);
    if (all.slots == kSlotsAtOnce * kBlocks) return kNoSlot;
    if (all.slots % kSlotsAtOnce == 0) {
        auto* some = new (std::nothrow) Slots;
        if (!some) return kNoSlot;
        all.blocks[all.slots / kSlotsAtOnce].store(some, std::memory_order_release);
    }
    return all.slots++;
}

}  // namespace

Object* find_object(std::uint64_t id, Kind kind) {
    const Slot* slot = slot_of(id);
    return slot && slot->tag.load(std::memory_order_acquire) == tag_of(std::uint32_t(id >> 32), kind) ? slot->object
                                                                                                      : nullptr;
}

std::uint64_t add_object(std::unique_ptr<Object> object, Kind kind) {
    Table& all = table();
    const std::lock_guard<Lock> guard(all.lock);
    const std::uint32_t index = free_slot(all);
    if (index == kNoSlot) return 0;
    Slot& slot = *slot_of(std::uint64_t(index) + 1);
    slot.object = object.release();
    ++slot.uses;
    slot.tag.store(tag_of(slot.uses, kind), std::memory_order_release);
    ++all.held;
    return std::uint64_t(slot.uses) << 32 | (index + 1);
}

std::unique_ptr<Object> remove_object(std::uint64_t id, Kind kind) {
    Table& all = table();
    const std::lock_guard<Lock> guard(all.lock);
    Slot* slot = slot_of(id);
    if (!slot || slot->tag.load(std::memory_order_relaxed) != tag_of(std::uint32_t(id >> 32), kind)) return nullptr;
    slot->tag.store(0, std::memory_order_release);
    --all.held;
    // A slot whose numbers are used up stays empty for good.
    if (slot->uses != ~0u) slot->next_free = std::exchange(all.first_free, std::uint32_t(id) - 1);
    return std::unique_ptr<Object>(std::exchange(slot->object, nullptr));
}

std::size_t count_objects() {
    Table& all = table();
    const std::lock_guard<Lock> guard(all.lock);
    return all.held;
}

}  // namespace firma::c
