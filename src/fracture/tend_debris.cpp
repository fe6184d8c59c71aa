// SPDX-License-Identifier: MIT
// Debris grows old: what lies about too long goes, or becomes ground; what is too much goes.
#include <algorithm>
#include <utility>

#include "base/sort.h"
#include "firma/debris.h"
#include "firma/queries.h"

namespace firma {
namespace {

class Tending {
public:
    Tending(const World& world, Bodies& bodies, Debris& debris, const DebrisRules& rules)
        : bodies_(bodies), debris_(debris), rules_(rules) {
        report_.world = world;
    }

    void age(double seconds) {
        if (!is_finite(seconds) || seconds < 0) seconds = 0;
        for (const BodyId id : all()) {
            DebrisPiece& piece = *debris_.find(bodies_, id);
            piece.age += seconds;
            piece.asleep_for = bodies_.find(id)->asleep ? piece.asleep_for + seconds : 0;
        }
        for (const BodyId id : all())
            if (debris_.find(bodies_, id)->age > rules_.max_age) go(id);
    }

    void settle_sleepers() {
        std::vector<BodyId> sleepers;
        for (const BodyId id : all())
            if (debris_.find(bodies_, id)->asleep_for > rules_.max_asleep) sleepers.push_back(id);
        sort_range(sleepers, [&](BodyId a, BodyId b) { return is_less(a, b); });
        for (const BodyId id : sleepers) {
            DebrisPiece& piece = *debris_.find(bodies_, id);
            if (!rules_.to_ground || mass_properties(piece.solid, 1).volume < rules_.min_to_ground)
                go(id);
            else if (!piece.never_ground)
                settle(id, piece);
        }
    }

    void keep_budget() {
        std::vector<BodyId> left = all();
        sort_range(left, [&](BodyId a, BodyId b) {
            const bool a_sleeps = bodies_.find(a)->asleep, b_sleeps = bodies_.find(b)->asleep;
            return a_sleeps != b_sleeps ? a_sleeps : is_less(a, b);
        });
        std::size_t count = left.size(), spheres = 0;
        for (const BodyId id : left) spheres += spheres_of(id);
        for (const BodyId id : left) {
            if (count <= rules_.max_bodies && spheres <= rules_.max_spheres) return;
            spheres -= spheres_of(id);
            --count;
            go(id);
        }
    }

    DebrisReport report() { return std::move(report_); }

private:
    std::vector<BodyId> all() const {
        std::vector<BodyId> ids;
        for (std::uint32_t slot = 0; slot < debris_.slots.size(); ++slot) {
            const BodyId id{slot, debris_.slots[slot].use};
            if (debris_.find(bodies_, id)) ids.push_back(id);
        }
        return ids;
    }

    bool is_less(BodyId a, BodyId b) const {
        const double mass_a = bodies_.find(a)->shape.mass(), mass_b = bodies_.find(b)->shape.mass();
        return mass_a != mass_b ? mass_a < mass_b : a.slot < b.slot;
    }

    std::size_t spheres_of(BodyId id) const { return bodies_.find(id)->shape.spheres().size(); }

    void go(BodyId id) {
        remove_debris(bodies_, debris_, id);
        report_.removed.push_back(id);
    }

    void settle(BodyId id, DebrisPiece& piece) {
        if (report_.to_ground.size() >= rules_.max_to_ground || is_in_the_way(id, piece)) {
            ++report_.waiting;
            return;
        }
        const auto refuse = [&] {
            piece.never_ground = true;
            ++report_.refused;
        };
        Result<RestingSolid> resting = resting_solid(piece.solid, pose_of(*bodies_.find(id)), "debris");
        if (!resting) return refuse();
        CarveOptions options;
        options.material = matter(report_.world, piece.matter).inside;
        if (rules_.first_edit > 0) options.edit = rules_.first_edit + std::uint32_t(report_.fills.size());
        const RestingSolid& rest = resting.value();
        const CarveResult filled = fill(report_.world, rest.cutter, rest.pose, options);
        if (filled.status == CarveStatus::kRefused) return refuse();
        if (filled.status == CarveStatus::kNothing) return go(id);  // there is ground already
        report_.world = filled.world;
        report_.edits.push_back(filled.report);
        report_.fills.push_back(std::move(resting).value());
        report_.fill_options.push_back(std::move(options));
        report_.to_ground.push_back(id);
        remove_debris(bodies_, debris_, id);
    }

    /// Whether anything that is to stay clear, or another body, would be in the new ground.
    bool is_in_the_way(BodyId id, const DebrisPiece& piece) const {
        const Pose pose = pose_of(*bodies_.find(id));
        const TurnMatrix turn = matrix_of(pose.rotation);
        const Box box = piece.solid.bounds();
        const Vec3 middle = (box.low + box.high) * 0.5;
        const double reach = length(box.high - box.low) * 0.5;
        std::optional<World> own;  // made where anything is near
        const auto meets = [&](const Vec3& centre, double radius, double overlap) {
            const Vec3 at = turn.back(centre - pose.position);
            if (!(length(at - middle) < reach + radius)) return false;
            if (!own) own = make_world(piece.solid).value();
            if (locate(piece.solid, at) == Where::kSolid) return true;
            const NearFace near = closest(*own, at, radius);
            return near && radius - near.distance > overlap;
        };
        for (const Sphere& sphere : rules_.keep_clear)
            if (meets(sphere.centre, sphere.radius, 0)) return true;
        for (std::uint32_t slot = 0; slot < bodies_.slots.size(); ++slot) {
            const Body& body = bodies_.slots[slot];
            if (slot == id.slot || !body.shape.valid()) continue;
            if (!(length(body.position - (pose.position + turn * middle)) < reach + body.shape.reach())) continue;
            const Pose at = pose_of(body);
            const TurnMatrix its_turn = matrix_of(at.rotation);
            for (const Sphere& sphere : body.shape.spheres())
                if (meets(at.position + its_turn * sphere.centre, sphere.radius, rules_.max_overlap)) return true;
        }
        return false;
    }

    Bodies& bodies_;
    Debris& debris_;
    const DebrisRules& rules_;
    DebrisReport report_;
};

}  // namespace

DebrisReport tend_debris(const World& world, Bodies& bodies, Debris& debris, double seconds, const DebrisRules& rules) {
    Tending tending(world, bodies, debris, rules);
    tending.age(seconds);
    tending.settle_sleepers();
    tending.keep_budget();
    return tending.report();
}

}  // namespace firma
