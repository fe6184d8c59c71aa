// SPDX-License-Identifier: MIT
// The rooms that a cast has been to, and those that wait. In worlds of up to some thousand rooms all of it is on the
// stack; for more of them each thread keeps memory, which grows at its first such casts and is then used again.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace firma {

/// A room that was reached only by meeting a closed portal lies `behind` it: of its faces, those at the portal's rim
/// may be met at the same time, and the lowest id counts; but the sweep did not pass into it.
struct WaitingRoom {
    double reached;
    std::uint32_t room;
    std::uint32_t portal : 31;  ///< that it is reached through first
    std::uint32_t behind : 1;
};
/// In place of a portal: there the sweep begins.
inline constexpr std::uint32_t kNoPortalPassed = (1u << 31) - 1;

class RoomsOnTheWay {
public:
    RoomsOnTheWay() = default;
    RoomsOnTheWay(const RoomsOnTheWay&) = delete;
    RoomsOnTheWay& operator=(const RoomsOnTheWay&) = delete;
    ~RoomsOnTheWay() {
        if (has_memory_) of_thread() = std::move(memory_);
    }

    void start(std::size_t rooms) {
        const std::size_t words = (rooms + 63) / 64;
        if (words <= kWords) {
            looked_into_ = few_looked_into_;
            passed_ = few_passed_;
        } else {
            Memory& memory = take_memory();
            if (memory.marks.size() < 2 * words) memory.marks.resize(2 * words);
            looked_into_ = memory.marks.data();
            passed_ = looked_into_ + words;
        }
        if (words == 1) {  // of most levels; not worth two calls
            looked_into_[0] = passed_[0] = 0;
        } else {
            std::fill_n(looked_into_, words, 0);
            std::fill_n(passed_, words, 0);
        }
        count_ = 0;
        waiting_ = few_waiting_.data();
        room_for_ = few_waiting_.size();
    }

    bool looked_into(std::uint32_t room) const { return has(looked_into_, room); }
    bool passed(std::uint32_t room) const { return has(passed_, room); }
    void mark_looked_into(std::uint32_t room) { mark(looked_into_, room); }
    void mark_passed(std::uint32_t room) { mark(passed_, room); }

    bool any() const { return count_ > 0; }
    /// The one reached first; of several passed into before behind, then the lowest.
    WaitingRoom take_first() {
        std::size_t first = 0;
        for (std::size_t k = 1; k < count_; ++k) {
            const WaitingRoom &a = waiting_[k], &b = waiting_[first];
            if (a.reached != b.reached ? a.reached < b.reached : a.behind != b.behind ? b.behind : a.room < b.room)
                first = k;
        }
        const WaitingRoom taken = waiting_[first];
        waiting_[first] = waiting_[--count_];
        return taken;
    }

    /// Once each, by the earliest way; of several, through the lowest portal.
    void wait(const WaitingRoom& more) {
        for (std::size_t k = 0; k < count_; ++k)
            if (waiting_[k].room == more.room && waiting_[k].behind == more.behind) {
                const WaitingRoom& known = waiting_[k];
                if (more.reached < known.reached || (more.reached == known.reached && more.portal < known.portal))
                    waiting_[k] = more;
                return;
            }
        if (count_ == room_for_) make_room();
        waiting_[count_++] = more;
    }

private:
    static constexpr std::size_t kWords = 64;     ///< marks of 4,096 rooms
    static constexpr std::size_t kWaiting = 256;  ///< rooms at a time

    struct Memory {
        std::vector<std::uint64_t> marks;
        std::vector<WaitingRoom> waiting;
    };
    static Memory& of_thread() {
        thread_local Memory memory;
        return memory;
    }

    /// The thread's, until this ends: a cast that a visitor asks meanwhile has memory of its own.
    Memory& take_memory() {
        if (!has_memory_) memory_ = std::exchange(of_thread(), {});
        has_memory_ = true;
        return memory_;
    }

    static void mark(std::uint64_t* marks, std::uint32_t room) { marks[room / 64] |= std::uint64_t(1) << room % 64; }
    static bool has(const std::uint64_t* marks, std::uint32_t room) { return marks[room / 64] >> room % 64 & 1; }

    void make_room() {
        std::vector<WaitingRoom>& memory = take_memory().waiting;
        if (memory.size() < 2 * room_for_) memory.resize(2 * room_for_);
        if (waiting_ == few_waiting_.data()) std::copy_n(waiting_, count_, memory.begin());
        waiting_ = memory.data();
        room_for_ = memory.size();
    }

    std::uint64_t* looked_into_ = nullptr;
    std::uint64_t* passed_ = nullptr;
    WaitingRoom* waiting_ = nullptr;
    std::size_t count_ = 0, room_for_ = 0;
    Memory memory_;
    bool has_memory_ = false;
    std::uint64_t few_looked_into_[kWords], few_passed_[kWords];  // these are written before they are read
    std::array<WaitingRoom, kWaiting> few_waiting_;
};

}  // namespace firma
