// SPDX-License-Identifier: MIT
// What a straight path goes through.
#include "firma/pierce.h"

#include <algorithm>
#include <tuple>

#include "base/sort.h"
#include "body/matters_along.h"
#include "body/path_crossings.h"
#include "firma/rooms.h"
#include "geometry/exact_predicates.h"
#include "world/put_hit.h"
#include "world/touch_takers.h"

namespace firma {

struct PierceScratch::Data {
    std::vector<PathCrossing> crossings, far;
    std::vector<SolidStretch> stretches;
    MatterScratch matters;
};

PierceScratch::PierceScratch() = default;
PierceScratch::PierceScratch(const PierceScratch&) {}
PierceScratch::PierceScratch(PierceScratch&&) noexcept = default;
PierceScratch& PierceScratch::operator=(const PierceScratch&) {
    return *this;
}
PierceScratch& PierceScratch::operator=(PierceScratch&&) noexcept = default;
PierceScratch::~PierceScratch() = default;

PierceScratch::Data& PierceScratch::data() {
    if (!data_) data_ = std::make_unique<Data>();
    return *data_;
}

namespace {

/// Is told of all that the path meets, from either side.
class PathTouches : public TellAny {
public:
    /// @param panes  null: of no use
    PathTouches(const World& world, const Sweep& sweep, const PierceOptions& options,
                std::vector<PathCrossing>& crossings, std::vector<PierceSpan>* panes)
        : TellAny(tell<PathTouches>(sweep.end)),
          world_(world),
          sweep_(sweep),
          options_(options),
          crossings_(crossings),
          panes_(panes) {}

    bool operator()(const SweepContact& found) {
        if (!found.block)
            add_portal(found);
        else if (found.whole)
            add_face(found, LaneShape(*found.whole, found.lane).polygon);
        else
            add_face(found, FaceShape(*found.block, found.face()).polygon);
        return false;
    }

private:
    void add_face(const SweepContact& found, const PolygonShape& polygon) {
        const FaceRecord& face = found.face();
        const int facing = found.through_plane ? (found.away ? 1 : -1) : exact_facing(sweep_.direction, polygon);
        if (!face.solid) return add_pane(found, polygon, facing);
        if (facing == 0) return;  // along it
        PathCrossing crossing;
        crossing.beside = lines_through(sweep_, polygon, facing);
        if (!crossing.beside) return;
        crossing.t = found.contact.t;
        crossing.turn = -facing;
        crossing.face = name_of(found);
        const FaceOwner* owner = found.block->owner_of(face);
        crossing.normal = owner ? owner->normal : polygon.unit_normal();
        crossing.material = face.material;
        crossing.mask = face.mask;
        crossings_.push_back(crossing);
    }

    void add_pane(const SweepContact& found, const PolygonShape& polygon, int facing) {
        const FaceRecord& face = found.face();
        if (!panes_ || !(face.mask & options_.mask)) return;
        if (facing >= 0 && !face.two_sided && options_.sides == Sides::kFront) return;
        const FaceOwner* owner = found.block->owner_of(face);
        const Vec3 normal = owner ? owner->normal : polygon.unit_normal();
        PierceSpan& pane = put_pane(found, facing > 0 ? -normal : normal, face.material);
        pane.in.face = pane.out.face = name_of(found);
    }

    void add_portal(const SweepContact& found) {
        const Portal& portal = world_.data().cells.portal(found.portal);
        if (!panes_ || !(portal.mask & options_.mask)) return;
        const PolygonShape& polygon = portal.polygons()[found.slot].shape;
        const Vec3 normal = polygon.unit_normal();
        const bool away = exact_facing(sweep_.direction, polygon) > 0;
        put_pane(found, away ? -normal : normal, portal.material).portal = {found.portal};
    }

    PierceSpan& put_pane(const SweepContact& found, const Vec3& normal, std::uint32_t material) {
        PierceSpan& pane = panes_->emplace_back();
        pane.pane = true;
        pane.in.fraction = sweep_.fraction(found.contact.t);
        pane.in.point = sweep_.at(found.contact.t);
        pane.in.normal = normal;
        pane.in.material = material;
        pane.out = pane.in;
        return pane;
    }

    const World& world_;
    const Sweep& sweep_;
    const PierceOptions& options_;
    std::vector<PathCrossing>& crossings_;
    std::vector<PierceSpan>* panes_;
};

/// All rooms at once.
void meet_along(const World& world, const Sweep& sweep, PathTouches& found) {
    CastOptions all;
    all.sides = Sides::kBoth;
    TellAny& told = found;
    WorldSweep<TellAny, SphereMover> on_its_way(world.data(), sweep, SphereMover{}, all, told);
    while (const Node* index = on_its_way.next()) on_its_way.look_into(*index);
}

/// Which lines beside the path start in the solid.
unsigned start_in_world(const World& world, const Sweep& sweep, const PierceOptions& options,
                        std::vector<PathCrossing>& crossings) {
    constexpr unsigned kBoth = kLineOneWay | kLineOtherWay;
    const Where where = options.start == Where::kAir || options.start == Where::kSolid
                            ? options.start
                            : locate(world, sweep.start).where;
    if (where == Where::kAir) return 0;
    if (where == Where::kSolid) return kBoth;
    crossings.clear();
    const Sweep far = far_on(sweep);
    PathTouches touches(world, far, options, crossings, nullptr);
    meet_along(world, far, touches);
    return starts_inside(crossings, world.solid().rock_outside());
}

class Piercer {
public:
    Piercer(const World& world, const Sweep& sweep, const PierceOptions& options, Piercing& found)
        : world_(world), sweep_(sweep), options_(options), found_(found), scratch_(found.scratch.data()) {}

    Status pierce() {
        scratch_.crossings.clear();
        PathTouches touches(world_, sweep_, options_, scratch_.crossings, options_.panes ? &found_.spans : nullptr);
        meet_along(world_, sweep_, touches);
        find_stretches(
            sweep_, scratch_.crossings, [&] { return start_in_world(world_, sweep_, options_, scratch_.far); },
            scratch_.stretches);
        for (const SolidStretch& stretch : scratch_.stretches) add(stretch);
        sort_range(found_.spans, [](const PierceSpan& a, const PierceSpan& b) {
            return std::tuple(a.in.fraction, !a.pane, a.in.face.id, a.portal) <
                   std::tuple(b.in.fraction, !b.pane, b.in.face.id, b.portal);
        });
        if (options_.matters) add_matters();
        if (found_.spans.empty()) return Status::kMiss;
        const bool inside =
            std::any_of(found_.spans.begin(), found_.spans.end(), [](const auto& it) { return it.starts_inside; });
        return inside ? Status::kInitialOverlap : Status::kHit;
    }

private:
    PierceEnd end_at(double t, std::uint32_t crossing) const {
        PierceEnd end;
        end.fraction = sweep_.fraction(t);
        end.point = sweep_.at(t);
        if (crossing == SolidStretch::kOpen) return end;
        const PathCrossing& it = scratch_.crossings[crossing];
        end.normal = it.normal;
        end.face = it.face;
        end.material = it.material;
        return end;
    }

    bool is_told(const SolidStretch& stretch) const {
        const std::uint32_t by = stretch.in != SolidStretch::kOpen ? stretch.in : stretch.out;
        return by == SolidStretch::kOpen || (scratch_.crossings[by].mask & options_.mask);
    }

    void add(const SolidStretch& stretch) {
        if (!is_told(stretch)) return;
        PierceSpan& span = found_.spans.emplace_back();
        span.in = end_at(stretch.from, stretch.in);
        span.out = end_at(stretch.to, stretch.out);
        span.thickness = (stretch.to - stretch.from) * sweep_.direction_length;
        span.starts_inside = stretch.in == SolidStretch::kOpen;
        span.ends_inside = stretch.out == SolidStretch::kOpen;
        found_.thickness += span.thickness;
    }

    void add_matters() {
        const WorldData& data = world_.data();
        for (PierceSpan& span : found_.spans) {
            if (span.pane) continue;
            span.first_matter = std::uint32_t(found_.matters.size());
            add_matters_along(data.matters.get(), data.rules.get(), sweep_, span.in.fraction * sweep_.end,
                              span.out.fraction * sweep_.end, scratch_.matters, found_.matters);
            span.matter_count = std::uint32_t(found_.matters.size()) - span.first_matter;
        }
    }

    const World& world_;
    const Sweep& sweep_;
    const PierceOptions& options_;
    Piercing& found_;
    PierceScratch::Data& scratch_;
};

}  // namespace

Status pierce(const World& world, const Ray& ray, Piercing& found, const PierceOptions& options) {
    found.spans.clear();
    found.matters.clear();
    found.thickness = 0;
    Sweep sweep;
    const Status ready = make_sweep({ray.start, 0}, ray.path, sweep);
    if (ready != Status::kHit) return ready;
    return Piercer(world, sweep, options, found).pierce();
}

}  // namespace firma
