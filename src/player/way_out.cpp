// SPDX-License-Identifier: MIT
// Ways out: by overlaps, then by trying places around.
#include "player/way_out.h"

#include <array>

#include "firma/rooms.h"

namespace firma {
namespace {

constexpr int kMaxWaysOut = 16;
/// Metres: the first ring of places; each is half as far again as the last.
constexpr double kFirstRing = 0.1;
constexpr double kRingGrowth = 1.5;

/// The 26 ways to the sides, edges and corners of a cube, up first, not unit.
template <class Visit>
bool each_way(const Vec3& up, const Visit& visit) {
    if (visit(up)) return true;
    for (int x = -1; x <= 1; ++x)
        for (int y = -1; y <= 1; ++y)
            for (int z = -1; z <= 1; ++z)
                if ((x || y || z) && visit(Vec3{double(x), double(y), double(z)})) return true;
    return false;
}

class WayOut {
public:
    WayOut(const World& world, const PostureIn& posture, RoomId room) : world_(world), posture_(posture) {
        const std::optional<RoomInfo> was = room_info(world, room);
        may_be_outside_ = world.room_count() < 2 || (was && was->exterior);
    }

    bool may_be(const Vec3& feet) const {
        const Location at = posture_.where(feet);
        if (at.where != Where::kAir || posture_.overlaps(feet) || posture_.part_around(feet) != kNoPart) return false;
        return may_be_outside_ || !room_info(world_, at.room)->exterior;
    }

private:
    const World& world_;
    const PostureIn& posture_;
    bool may_be_outside_;
};

}  // namespace

bool is_free(const PostureIn& posture, const Vec3& feet) {
    return posture.where(feet).where == Where::kAir && !posture.overlaps(feet) && posture.part_around(feet) == kNoPart;
}

std::optional<Vec3> way_out(const World& world, const PostureIn& posture, const PlayerShapeData& shape,
                            const Vec3& feet, RoomId room, double reach, double offset) {
    const WayOut out(world, posture, room);
    Vec3 at = feet;
    for (int k = 0; k < kMaxWaysOut; ++k) {
        const PartOverlap overlap = posture.deepest(at);
        if (!overlap.found()) break;
        at += overlap.direction * (overlap.depth + offset);
    }
    if (length(at - feet) <= reach && out.may_be(at)) return at;
    for (double ring = kFirstRing; ring <= reach; ring *= kRingGrowth) {
        std::optional<Vec3> best;
        double nearest = 0;
        each_way(shape.up, [&](const Vec3& way) {
            const Vec3 place = feet + way * (ring / length(way));
            if (!out.may_be(place)) return false;
            const Hit back = posture.sweep(place, feet - place);
            const Vec3 there = place + (feet - place) * back.safe_fraction;
            const double far = length(there - feet);
            if ((!best || far < nearest) && out.may_be(there)) {
                best = there;
                nearest = far;
            }
            return false;
        });
        if (best) return best;
    }
    return std::nullopt;
}

}  // namespace firma
