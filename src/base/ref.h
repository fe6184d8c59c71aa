// SPDX-License-Identifier: MIT
// A shared handle to something immutable that counts its own users: what blocks and rooms are held by.
#pragma once

#include <atomic>
#include <cstdint>
#include <utility>

namespace firma {

/// Base of what a Ref can hold.
class RefCounted {
public:
    RefCounted() = default;
    RefCounted(const RefCounted&) = delete;
    RefCounted& operator=(const RefCounted&) = delete;

    void take() const { users_.fetch_add(1, std::memory_order_relaxed); }
    /// True for the last user, who then deletes.
    bool drop() const { return users_.fetch_sub(1, std::memory_order_acq_rel) == 1; }

protected:
    ~RefCounted() = default;

private:
    mutable std::atomic<std::uint32_t> users_{0};
};

/// Copying takes, destroying drops. Casts never copy one: they pass references.
template <class T>
class Ref {
public:
    Ref() = default;
    explicit Ref(T* object) : object_(object) {
        if (object_) object_->take();
    }
    Ref(const Ref& other) : Ref(other.object_) {}
    Ref(Ref&& other) noexcept : object_(std::exchange(other.object_, nullptr)) {}
    Ref& operator=(Ref other) noexcept {
        std::swap(object_, other.object_);
        return *this;
    }
    ~Ref() {
        if (object_ && object_->drop()) delete object_;
    }

    T* get() const { return object_; }
    T& operator*() const { return *object_; }
    T* operator->() const { return object_; }
    explicit operator bool() const { return object_ != nullptr; }

private:
    T* object_ = nullptr;
};

}  // namespace firma
