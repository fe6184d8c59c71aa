// SPDX-License-Identifier: MIT
// Who is told of what a cast touches.
#pragma once

#include "world/sweep_world.h"

namespace firma {

/// Is told of touches, whoever asks: one traversal serves all of them. A touch costs a call through a pointer.
struct TellAny {
    static constexpr bool kEarliestOnly = false;
    double latest;
    bool (*take)(TellAny& self, const SweepContact& contact);

    bool operator()(const SweepContact& contact) { return take(*this, contact); }
};

/// `Found` as TellAny, which it then is.
template <class Found>
TellAny tell(double latest) {
    return {latest, [](TellAny& self, const SweepContact& contact) { return static_cast<Found&>(self)(contact); }};
}

/// Keeps the earliest touch; of several at one time the lowest id.
struct KeepFirst : TellAny {
    static constexpr bool kEarliestOnly = true;
    SweepContact best;

    explicit KeepFirst(double end) : TellAny(tell<KeepFirst>(end)) {}

    /// Whether a face that is met counts more than what there is.
    bool is_earlier(double t, const FaceRecord& face) const {
        if (!best.contact.touched() || t < best.contact.t) return true;
        return t == best.contact.t && (!best.block || face.id < best.face().id);
    }
    void keep(const SweepContact& touch) {
        best = touch;
        latest = touch.contact.t;
    }
    bool operator()(const SweepContact& other) {
        const bool sooner = !best.contact.touched() || other.contact.t < best.contact.t ||
                            (other.contact.t == best.contact.t && other.comes_before(best));
        if (sooner) keep(other);
        return false;
    }
};

struct StopAtAny : TellAny {
    Status status = Status::kMiss;

    explicit StopAtAny(double end) : TellAny(tell<StopAtAny>(end)) {}
    bool operator()(const SweepContact& contact) {
        status = contact.contact.status;
        return true;
    }
};

}  // namespace firma
