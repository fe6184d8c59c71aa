// SPDX-License-Identifier: MIT
// Portals made ready for casts, and listed by room.
#include "world/portal_set.h"

namespace firma {
namespace {

PortalPolygon make_polygon(std::span<const GridPoint> corners, std::span<const Vec3> metres) {
    PortalPolygon polygon{make_shape(metres), corners, {}};
    GridBox box;
    for (const GridPoint& corner : corners) box.add(corner);
    const Vec3 low = to_metres(box.low), high = to_metres(box.high);
    for (int axis = 0; axis < 3; ++axis) {
        polygon.box.low[axis] = low[axis];
        polygon.box.high[axis] = high[axis];
    }
    return polygon;
}

}  // namespace

PortalSet::PortalSet(std::span<const PortalPart> parts, std::size_t rooms) {
    for (const PortalPart& part : parts)
        for (const std::vector<GridPoint>& polygon : part.polygons)
            corners_.insert(corners_.end(), polygon.begin(), polygon.end());
    metres_.reserve(corners_.size());
    for (const GridPoint& corner : corners_) metres_.push_back(to_metres(corner));

    std::size_t at = 0;
    first_of_room_.assign(rooms + 1, 0);
    for (const PortalPart& part : parts) {
        Portal portal{part.rooms,
                      part.name,
                      part.material,
                      part.mask,
                      std::uint32_t(polygons_.size()),
                      std::uint32_t(part.polygons.size()),
                      {}};
        for (const std::vector<GridPoint>& polygon : part.polygons) {
            const std::span<const GridPoint> corners(corners_.data() + at, polygon.size());
            polygons_.push_back(make_polygon(corners, {metres_.data() + at, polygon.size()}));
            for (const GridPoint& corner : corners) portal.box.add(corner);
            at += polygon.size();
        }
        if (!portal.gone())
            for (const RoomId room : portal.rooms) ++first_of_room_[room.value + 1];
        portals_.push_back(std::move(portal));
    }
    for (std::size_t room = 0; room < rooms; ++room) first_of_room_[room + 1] += first_of_room_[room];
    of_rooms_.resize(first_of_room_[rooms]);
    std::vector<std::uint32_t> next(first_of_room_.begin(), first_of_room_.end() - 1);
    std::vector<GridBox> boxes;
    for (std::uint32_t k = 0; k < portals_.size(); ++k) {
        if (portals_[k].gone()) continue;
        for (const RoomId room : portals_[k].rooms) of_rooms_[next[room.value]++] = k;
        boxes.push_back(portals_[k].box);
        with_box_.push_back(k);
    }
    boxes_ = BoxTree(boxes);
}

PortalPart PortalSet::part(std::size_t index) const {
    const Portal& portal = portals_[index];
    PortalPart part;
    part.rooms = portal.rooms;
    part.name = portal.name;
    part.material = portal.material;
    part.mask = portal.mask;
    for (const PortalPolygon& polygon : polygons_of(portal))
        part.polygons.emplace_back(polygon.corners.begin(), polygon.corners.end());
    return part;
}

std::size_t PortalSet::bytes() const {
    std::size_t sum =
        sizeof *this + portals_.capacity() * sizeof(Portal) + polygons_.capacity() * sizeof(PortalPolygon) +
        corners_.capacity() * sizeof(GridPoint) + metres_.capacity() * sizeof(Vec3) +
        (first_of_room_.capacity() + of_rooms_.capacity() + with_box_.capacity()) * sizeof(std::uint32_t) +
        boxes_.bytes();
    const std::size_t inside = std::string().capacity();
    for (const Portal& portal : portals_)
        if (portal.name.capacity() > inside) sum += portal.name.capacity() + 1;
    return sum;
}

ClosedPortals::ClosedPortals(std::vector<std::uint8_t> flags) : is_closed(std::move(flags)) {
    for (std::uint32_t k = 0; k < is_closed.size(); ++k)
        if (is_closed[k]) all.push_back(k);
}

}  // namespace firma
