// SPDX-License-Identifier: MIT
// Ways out: by overlaps, then by trying places around.
#include "player/way_out.h"

#include <cmath>

#include "firma/rooms.h"
#include "firma/turn.h"

namespace firma {
namespace {

constexpr int kMaxWaysOut = 16;
/// Metres: the first ring of places; each is half as far again as the last.
constexpr double kFirstRing = 0.1;
constexpr double kRingGrowth = 1.5;
/// Rings of many places, evenly as far as it may be moved: 32 and 6 k^2 on the k-th, 2,630 in all, so that places far
/// out lie hardly farther apart than those near.
constexpr int kDenseRings = 10, kDenseFirst = 32, kDenseMore = 6;
constexpr int kMaxWaysFromPlace = 4;
constexpr double kGoldenAngle = 2.399963229728653;  // radians: places on a spiral turned by that lie evenly on a ring

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
    WayOut(const World& world, const PostureIn& posture, const Vec3& feet, RoomId room, double reach, double offset)
        : world_(world), posture_(posture), feet_(feet), reach_(reach), offset_(offset) {
        const std::optional<RoomInfo> was = room_info(world, room);
        may_be_outside_ = world.room_count() < 2 || (was && was->exterior);
    }

    /// By the ways of what it overlaps alone.
    std::optional<Vec3> shortest() const {
        const Vec3 there = out_of_overlaps(feet_, kMaxWaysOut);
        if (length(there - feet_) <= reach_ && may_be(there)) return there;
        return std::nullopt;
    }

    /// The nearest of 26 places on the first ring that has a free one.
    std::optional<Vec3> on_rings(const Vec3& up) const {
        for (double ring = kFirstRing; ring <= reach_; ring *= kRingGrowth) {
            Nearest nearest{feet_};
            each_way(up, [&](const Vec3& way) {
                const Vec3 place = feet_ + way * (ring / length(way));
                if (may_be(place)) add_from(place, nearest);
                return false;
            });
            if (nearest.found) return nearest.found;
        }
        return std::nullopt;
    }

    /// The same of many more, and of places near these where the ways of what is overlapped there lead to.
    std::optional<Vec3> on_dense_rings() const {
        for (int ring = 1; ring <= kDenseRings; ++ring) {
            Nearest nearest{feet_};
            const int count = kDenseFirst + kDenseMore * ring * ring;
            for (int k = 0; k < count; ++k) {
                const double height = 1 - (2 * k + 1.0) / count, wide = std::sqrt(1 - height * height);
                const SineCosine turn = sine_cosine(kGoldenAngle * k);
                const Vec3 way{turn.cosine * wide, turn.sine * wide, height};
                const Vec3 place = feet_ + way * (reach_ * ring / kDenseRings);
                if (posture_.where(place).where != Where::kAir) continue;
                const Vec3 there = out_of_overlaps(place, kMaxWaysFromPlace);
                if (length(there - feet_) <= reach_ && may_be(there)) add_from(there, nearest);
            }
            if (nearest.found) return nearest.found;
        }
        return std::nullopt;
    }

private:
    struct Nearest {
        Vec3 feet;
        std::optional<Vec3> found{};
        double far = 0;
        void add(const Vec3& there) {
            const double away = length(there - feet);
            if (found && !(away < far)) return;
            found = there;
            far = away;
        }
    };

    bool may_be(const Vec3& feet) const {
        const Location at = posture_.where(feet);
        if (at.where != Where::kAir || posture_.overlaps(feet) || posture_.part_around(feet) != kNoPart) return false;
        return may_be_outside_ || !room_info(world_, at.room)->exterior;
    }

    Vec3 out_of_overlaps(Vec3 at, int most) const {
        for (int k = 0; k < most; ++k) {
            const PartOverlap overlap = posture_.deepest(at);
            if (!overlap.found()) break;
            at += overlap.direction * (overlap.depth + offset_);
        }
        return at;
    }

    /// From a free place back toward where it was, as far as nothing is met.
    void add_from(const Vec3& place, Nearest& nearest) const {
        const Hit back = posture_.sweep(place, feet_ - place);
        const Vec3 there = place + (feet_ - place) * back.safe_fraction;
        if (may_be(there)) nearest.add(there);
    }

    const World& world_;
    const PostureIn& posture_;
    const Vec3 feet_;
    const double reach_, offset_;
    bool may_be_outside_;
};

}  // namespace

bool is_free(const PostureIn& posture, const Vec3& feet) {
    return posture.where(feet).where == Where::kAir && !posture.overlaps(feet) && posture.part_around(feet) == kNoPart;
}

std::optional<Vec3> way_out(const World& world, const PostureIn& posture, const PlayerShapeData& shape,
                            const Vec3& feet, RoomId room, double reach, double offset, bool thorough) {
    const WayOut out(world, posture, feet, room, reach, offset);
    std::optional<Vec3> found = out.shortest();
    if (!found) found = out.on_rings(shape.up);
    if (!found && thorough) found = out.on_dense_rings();
    return found;
}

}  // namespace firma
