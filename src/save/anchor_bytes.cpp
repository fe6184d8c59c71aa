// SPDX-License-Identifier: MIT
// What holds pieces, in bytes and out of them: lists that are searched by halves must ascend.
#include "save/anchor_bytes.h"

#include <tuple>

#include "save/little_endian.h"
#include "save/sections.h"

namespace firma {

void put_anchors(ByteWriter& out, const Anchors& anchors) {
    const auto add = [&](std::uint32_t kind, std::uint32_t edit, std::uint32_t value) {
        for (const std::uint32_t number : {kind, edit, value}) out.u32(number);
    };
    for (const std::uint32_t material : anchors.materials) add(kMaterialHolds, 0, material);
    for (const std::uint32_t source : anchors.sources) add(kSourceHolds, 0, source);
    for (const std::uint32_t edit : anchors.edits) add(kEditHolds, 0, edit);
    for (const std::uint64_t key : anchors.hanging) add(kHangingHolds, std::uint32_t(key >> 32), std::uint32_t(key));
}

std::shared_ptr<const Anchors> unpack_anchors(Sections& sections, Damage& damage) {
    if (!sections.has(kAnchorsSection)) return nullptr;
    const Entries section = sections.entries(kAnchorsSection, kAnchorBytes);
    auto anchors = std::make_shared<Anchors>();
    std::vector<std::uint32_t>* const lists[] = {&anchors->materials, &anchors->sources, &anchors->edits};
    std::tuple<std::uint32_t, std::uint32_t, std::uint32_t> last;
    for (std::size_t k = 0; k < section.count(); ++k) {
        const std::byte* at = section.at(k);
        const std::uint32_t kind = read_u32(at), edit = read_u32(at + 4), value = read_u32(at + 8);
        if (kind > kHangingHolds || (kind != kHangingHolds && edit != 0)) {
            damage.report(section.type(), k, "has flags that mean nothing");
            return nullptr;
        }
        const std::tuple entry(kind, edit, value);
        if (k > 0 && !(last < entry)) {
            damage.report(section.type(), k, "is out of order");
            return nullptr;
        }
        last = entry;
        if (kind == kHangingHolds)
            anchors->hanging.push_back(std::uint64_t(edit) << 32 | value);
        else
            lists[kind]->push_back(value);
    }
    return anchors;
}

}  // namespace firma
