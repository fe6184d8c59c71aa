// SPDX-License-Identifier: MIT
// Where a line runs through a face.
#include "arrange/walk_line.h"

#include "base/assert.h"
#include "base/sort.h"

namespace firma {

std::uint32_t LineWalk::crossing(std::uint32_t edge, PlaneId across) {
    std::uint32_t& known = crossings_.at(std::uint64_t(edge) << 32 | (across & ~1u));
    if (known == FlatMap::kNone) {
        const OverlayEdge& it = overlay_.edges[edge];
        known = overlay_.tables.points.add(it.plane[0], it.plane[1], across);
        FIRMA_ASSERT(known != PointTable::kNone, "an edge that passes through a plane meets it");
    }
    return known;
}

bool LineWalk::start(std::uint32_t index, PlaneId across) {
    face_ = index;
    across_ = across;
    const OverlayFace& face = overlay_.faces[index];
    const auto sides = overlay_.sides(face);
    signs_.clear();
    bool front = false, back = false, on = false;
    for (const OverlaySide& side : sides) {
        const int sign = overlay_.tables.points.side(across, overlay_.from(side));
        (sign > 0 ? front : sign < 0 ? back : on) = true;
        signs_.push_back(std::int8_t(sign));
    }
    if (!on && !(front && back)) return false;

    events_.clear();
    std::size_t first = 0;
    for (const std::uint32_t end : overlay_.ends(face)) {
        for (std::size_t k = first; k < end; ++k) {
            const int here = signs_[k], there = signs_[k + 1 < end ? k + 1 : first];
            if (here == 0) {
                const int before = signs_[k > first ? k - 1 : end - 1];
                const auto toggle = [](int sign) { return std::uint8_t(sign > 0 ? kAbove : sign < 0 ? kBelow : 0); };
                events_.push_back({overlay_.from(sides[k]), kNoEdge, std::uint8_t(toggle(before) ^ toggle(there))});
            } else if (here * there < 0) {
                events_.push_back({crossing(sides[k].edge, across), sides[k].edge, kAbove | kBelow});
            }
        }
        first = end;
    }
    return true;
}

const std::vector<Interval>& LineWalk::finish(std::uint32_t line) {
    const LineTable& lines = overlay_.lines;
    sort_range(events_, [&](const Event& a, const Event& b) {
        return a.point != b.point ? lines.before(line, a.point, b.point) : a.edge < b.edge;
    });
    // Left of the line, seen from the front, lies below the other plane where the line runs along face x plane.
    const bool left_is_below = lines.runs_along(line, overlay_.faces[face_].plane, across_);
    intervals_.clear();
    std::uint8_t inside = 0;
    for (std::size_t k = 0; k < events_.size(); ++k) {
        const std::uint32_t point = events_[k].point;
        if (inside != 0) {
            const bool above = inside & kAbove, below = inside & kBelow;
            const bool left = left_is_below ? below : above, right = left_is_below ? above : below;
            intervals_.push_back(
                {events_[k - 1].point, point, std::uint8_t((left ? kCoversLeft : 0) | (right ? kCoversRight : 0))});
        }
        inside ^= events_[k].toggles;
        for (; k + 1 < events_.size() && events_[k + 1].point == point; ++k) inside ^= events_[k + 1].toggles;
    }
    return intervals_;
}

}  // namespace firma
