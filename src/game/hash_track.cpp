// SPDX-License-Identifier: MIT
// Hashes of a game tick by tick, as bytes.
//
// A tick: u64, the whole game's; for each GameItem its count, how many hashes are listed, and these: how many others
// lie between it and the one listed before, and the hash in 32 bits. Those that the tick before did not have are
// listed.
#include <algorithm>

#include "firma/recording.h"
#include "log/byte_reader.h"

namespace firma {
namespace {

constexpr std::size_t kListedBytes = 5;  // at least

void put_changes(ByteWriter& out, const std::vector<std::uint32_t>& before, const std::vector<std::uint32_t>& now) {
    std::vector<std::size_t> changed;
    for (std::size_t k = 0; k < now.size(); ++k)
        if (k >= before.size() || before[k] != now[k]) changed.push_back(k);
    put_whole(out, now.size());
    put_whole(out, changed.size());
    std::size_t next = 0;
    for (const std::size_t k : changed) {
        put_whole(out, k - next);
        out.u32(now[k]);
        next = k + 1;
    }
}

void take_changes(ByteReader& in, std::vector<std::uint32_t>& hashes) {
    const std::uint64_t count = in.whole(), listed = in.whole();
    if (!in.ok()) return;
    const std::uint64_t added = count > hashes.size() ? count - hashes.size() : 0;
    if (listed > in.left() / kListedBytes || listed > count || added > listed) {
        in.fail("hashes that are not listed, or more than bytes follow");
        return;
    }
    const std::size_t old = hashes.size();
    hashes.resize(std::size_t(count));
    std::uint64_t next = 0, new_ones = 0;
    for (std::uint64_t k = 0; k < listed; ++k) {
        const std::uint64_t gap = in.whole();
        const std::uint32_t hash = in.u32();
        if (!in.ok()) return;
        if (gap >= count - next) {
            in.fail("a hash of what is not there");
            return;
        }
        next += gap;
        new_ones += next >= old;
        hashes[std::size_t(next++)] = hash;
        if (next == count && k + 1 < listed) {
            in.fail("more hashes than things");
            return;
        }
    }
    if (new_ones != added) in.fail("a hash of something new that is not listed");
}

void take_tick(ByteReader& in, GameHashes& hashes) {
    hashes.whole = in.u64();
    for (std::vector<std::uint32_t>& items : hashes.items) take_changes(in, items);
}

}  // namespace

void HashTrack::append(const GameHashes& hashes) {
    ByteWriter out;
    out.u64(hashes.whole);
    for (std::size_t kind = 0; kind < kGameItems; ++kind) put_changes(out, last_.items[kind], hashes.items[kind]);
    bytes_.insert(bytes_.end(), out.bytes().begin(), out.bytes().end());
    last_ = hashes;
    ++count_;
}

const GameHashes& HashTrack::Reader::next() {
    const std::string name = "hashes";
    ByteReader in(std::span(track_->bytes_).subspan(at_), name);
    take_tick(in, now_);
    at_ = in.ok() ? at_ + in.place() : track_->bytes_.size();
    return now_;
}

Result<HashTrack> HashTrack::from_bytes(std::span<const std::byte> bytes, const std::string& name) {
    HashTrack track;
    ByteReader in(bytes, name);
    while (in.ok() && !in.at_end()) {
        take_tick(in, track.last_);
        ++track.count_;
    }
    if (!in.ok()) return *in.error();
    track.bytes_.assign(bytes.begin(), bytes.end());
    return track;
}

}  // namespace firma
