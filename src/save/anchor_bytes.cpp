// SPDX-License-Identifier: MIT
// What holds pieces, in bytes and out of them: lists that are searched by halves must ascend.
#include "save/anchor_bytes.h"

#include <tuple>

#include "save/little_endian.h"
#include "save/sections.h"

namespace firma {
namespace {

bool unpack_volumes(const std::vector<std::int32_t>& coordinates, std::vector<GridBox>& volumes) {
    if (coordinates.size() % 6 != 0) return false;
    for (std::size_t k = 0; k < coordinates.size(); k += 6) {
        GridBox& box = volumes.emplace_back();
        for (int axis = 0; axis < 3; ++axis) {
            box.low[axis] = coordinates[k + std::size_t(axis)];
            box.high[axis] = coordinates[k + 3 + std::size_t(axis)];
            if (box.low[axis] > box.high[axis]) return false;
        }
    }
    return true;
}

}  // namespace

void put_anchors(ByteWriter& out, const Anchors& anchors) {
    const auto add = [&](std::uint32_t kind, std::uint32_t edit, std::uint32_t value) {
        for (const std::uint32_t number : {kind, edit, value}) out.u32(number);
    };
    for (const std::uint32_t material : anchors.materials) add(kMaterialHolds, 0, material);
    for (const std::uint32_t source : anchors.sources) add(kSourceHolds, 0, source);
    for (const std::uint32_t edit : anchors.edits) add(kEditHolds, 0, edit);
    for (const std::uint64_t key : anchors.hanging) add(kHangingHolds, std::uint32_t(key >> 32), std::uint32_t(key));
    std::uint32_t number = 0;  // of a coordinate
    for (const GridBox& volume : anchors.volumes)
        for (const GridPoint& corner : {volume.low, volume.high})
            for (int axis = 0; axis < 3; ++axis) add(kVolumeHolds, number++, std::uint32_t(corner[axis]));
}

std::shared_ptr<const Anchors> unpack_anchors(Sections& sections, Damage& damage) {
    if (!sections.has(kAnchorsSection)) return nullptr;
    const Entries section = sections.entries(kAnchorsSection, kAnchorBytes);
    auto anchors = std::make_shared<Anchors>();
    std::vector<std::uint32_t>* const lists[] = {&anchors->materials, &anchors->sources, &anchors->edits};
    std::tuple<std::uint32_t, std::uint32_t, std::uint32_t> last;
    std::vector<std::int32_t> coordinates;  // of volumes
    for (std::size_t k = 0; k < section.count(); ++k) {
        const std::byte* at = section.at(k);
        const std::uint32_t kind = read_u32(at), edit = read_u32(at + 4), value = read_u32(at + 8);
        if (kind > kVolumeHolds || (kind < kHangingHolds && edit != 0)) {
            damage.report(section.type(), k, "has flags that mean nothing");
            return nullptr;
        }
        const std::tuple entry(kind, edit, value);
        if (k > 0 && !(last < entry)) {
            damage.report(section.type(), k, "is out of order");
            return nullptr;
        }
        last = entry;
        if (kind == kVolumeHolds) {
            if (edit != coordinates.size()) {
                damage.report(section.type(), k, "is out of order");
                return nullptr;
            }
            coordinates.push_back(std::int32_t(value));
        } else if (kind == kHangingHolds)
            anchors->hanging.push_back(std::uint64_t(edit) << 32 | value);
        else
            lists[kind]->push_back(value);
    }
    if (!unpack_volumes(coordinates, anchors->volumes)) {
        damage.report(section.type(), "a volume that holds is no box");
        return nullptr;
    }
    return anchors;
}

}  // namespace firma
