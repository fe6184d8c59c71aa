// SPDX-License-Identifier: MIT
// A map from small numbers to values whose copies share all they have in common: setting one value copies a few pages
// of 32, however many values there are.
// Source: P. Bagwell, Ideal Hash Trees, 2001, without the hashing: pages follow the digits of a key to base 32.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>

#include "base/pool.h"
#include "base/ref.h"

namespace firma {

/// Copies are cheap, and what is done to one shows in no other.
template <class Value>
class PersistentMap {
public:
    std::size_t size() const { return size_; }
    bool empty() const { return size_ == 0; }

    /// Null when there is none. Good while this map stays as it is.
    const Value* find(std::uint32_t key) const {
        if (height_ == 1 && key < kItems && root_) return leaf(root_.get()).find(key);
        if (!holds_digits_of(key)) return nullptr;
        const Page* page = root_.get();
        for (int level = height_ - 1; page && level > 0; --level) page = inner(page).pages[digit(key, level)].get();
        return page ? leaf(page).find(digit(key, 0)) : nullptr;
    }
    /// For keys that are there.
    const Value& operator[](std::uint32_t key) const { return *find(key); }

    void set(std::uint32_t key, Value value) {
        while (!holds_digits_of(key)) grow();
        root_ = with_value(root_.get(), height_ - 1, key, std::move(value));
    }

    /// Calls `function(key, value)` in order of the keys.
    template <class Function>
    void for_each(const Function& function) const {
        if (root_) each(*root_, height_ - 1, 0, function);
    }

    /// Calls `function(key, mine, its)` for the keys in pages that two maps do not share, in order; null where a map
    /// has no value. Costs what was set in one and not in the other.
    template <class Function>
    void for_each_unshared(const PersistentMap& other, const Function& function) const {
        PersistentMap a = *this, b = other;
        while (a.height_ < b.height_) a.grow();
        while (b.height_ < a.height_) b.grow();
        unshared(a.root_.get(), b.root_.get(), a.height_ - 1, 0, function);
    }

    /// Memory of the pages for which `is_new(page)` says true; pages below others are not asked about.
    template <class IsNew>
    std::size_t bytes(const IsNew& is_new) const {
        return root_ ? bytes_below(*root_, height_ - 1, is_new) : 0;
    }

    /// Memory of the pages that another map does not have in the same place. Costs what was set in one of the two.
    std::size_t bytes_unshared(const PersistentMap& other) const {
        PersistentMap a = *this, b = other;
        while (a.height_ < b.height_) a.grow();
        while (b.height_ < a.height_) b.grow();
        return unshared_bytes(a.root_.get(), b.root_.get(), a.height_ - 1);
    }

private:
    static constexpr std::uint32_t kItems = 32;

    struct Page : RefCounted, Pooled {
        virtual ~Page() = default;
    };
    struct Inner final : Page {
        std::array<Ref<const Page>, kItems> pages;
    };
    struct Leaf final : Page {
        std::uint32_t has = 0;  ///< a bit for each value that is there
        std::array<Value, kItems> values{};
        const Value* find(std::uint32_t at) const { return has >> at & 1 ? &values[at] : nullptr; }
    };

    static const Inner& inner(const Page* page) { return static_cast<const Inner&>(*page); }
    static const Leaf& leaf(const Page* page) { return static_cast<const Leaf&>(*page); }
    static std::uint32_t digit(std::uint32_t key, int level) { return key >> 5 * level & (kItems - 1); }

    /// Six digits hold 30 bits, the seventh the rest.
    bool holds_digits_of(std::uint32_t key) const { return height_ > 0 && (height_ >= 7 || key >> 5 * height_ == 0); }

    void grow() {
        if (root_) {
            Ref<Inner> above(new Inner);
            above->pages[0] = std::move(root_);
            root_ = Ref<const Page>(above.get());
        }
        ++height_;
    }

    Ref<const Page> with_value(const Page* page, int level, std::uint32_t key, Value value) {
        if (level == 0) {
            Ref<Leaf> made(new Leaf);
            if (page) {
                made->has = leaf(page).has;
                made->values = leaf(page).values;
            }
            const std::uint32_t at = digit(key, 0);
            size_ += !(made->has >> at & 1);
            made->has |= 1u << at;
            made->values[at] = std::move(value);
            return Ref<const Page>(made.get());
        }
        Ref<Inner> made(new Inner);
        if (page) made->pages = inner(page).pages;
        Ref<const Page>& below = made->pages[digit(key, level)];
        below = with_value(below.get(), level - 1, key, std::move(value));
        return Ref<const Page>(made.get());
    }

    template <class Function>
    static void each(const Page& page, int level, std::uint32_t first, const Function& function) {
        for (std::uint32_t k = 0; k < kItems; ++k) {
            const std::uint32_t at = first << 5 | k;
            if (level == 0) {
                if (const Value* value = leaf(&page).find(k)) function(at, *value);
            } else if (const Page* below = inner(&page).pages[k].get()) {
                each(*below, level - 1, at, function);
            }
        }
    }

    template <class Function>
    static void unshared(const Page* a, const Page* b, int level, std::uint32_t first, const Function& function) {
        if (a == b) return;
        for (std::uint32_t k = 0; k < kItems; ++k) {
            const std::uint32_t at = first << 5 | k;
            if (level > 0) {
                unshared(a ? inner(a).pages[k].get() : nullptr, b ? inner(b).pages[k].get() : nullptr, level - 1, at,
                         function);
                continue;
            }
            const Value* mine = a ? leaf(a).find(k) : nullptr;
            const Value* its = b ? leaf(b).find(k) : nullptr;
            if (mine || its) function(at, mine, its);
        }
    }

    static std::size_t unshared_bytes(const Page* a, const Page* b, int level) {
        if (!a || a == b) return 0;
        if (level == 0) return pool_size(sizeof(Leaf));
        std::size_t sum = pool_size(sizeof(Inner));
        for (std::uint32_t k = 0; k < kItems; ++k)
            sum += unshared_bytes(inner(a).pages[k].get(), b ? inner(b).pages[k].get() : nullptr, level - 1);
        return sum;
    }

    template <class IsNew>
    static std::size_t bytes_below(const Page& page, int level, const IsNew& is_new) {
        if (!is_new(&page)) return 0;
        if (level == 0) return pool_size(sizeof(Leaf));
        std::size_t sum = pool_size(sizeof(Inner));
        for (const Ref<const Page>& below : inner(&page).pages)
            if (below) sum += bytes_below(*below, level - 1, is_new);
        return sum;
    }

    Ref<const Page> root_;
    int height_ = 0;  ///< pages on the way to a value
    std::size_t size_ = 0;
};

}  // namespace firma
