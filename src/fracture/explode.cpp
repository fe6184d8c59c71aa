// SPDX-License-Identifier: MIT
// A blast in one call: crater, loose pieces, debris that breaks, pushes.
#include <algorithm>
#include <utility>

#include "base/random.h"
#include "body/rolling.h"
#include "fracture/piece_of_chunk.h"
#include "fracture/piece_spheres.h"

namespace firma {
namespace {

class Explosion {
public:
    Explosion(const Scene& scene, Bodies& bodies, Debris& debris, const Blast& blast, const BlastOptions& options)
        : before_blast_(scene), bodies_(bodies), debris_(debris), blast_(blast), options_(options) {
        options_.max_spheres = std::clamp<std::size_t>(options_.max_spheres, 1, kMaxSpheres);
        for (std::uint32_t slot = 0; slot < debris.slots.size(); ++slot)
            if (debris.find(bodies, {slot, debris.slots[slot].use})) before_.push_back({slot, debris.slots[slot].use});
    }

    void carve_world(const Cutter& crater, const Pose& pose) {
        const World& world = before_blast_.world;
        if (crater.valid()) {
            result_.carve = carve(world, crater, pose, options_.carve);
        } else {
            result_.carve.status = CarveStatus::kNothing;
            result_.carve.world = world;
        }
        for (const Chunk& chunk : result_.carve.chunks) {
            const std::optional<BodyId> id = add_chunk(chunk);
            if (!id)
                ++result_.unfit;
            else if (!is_near(*id) || !break_body(*id, result_.loose))
                result_.loose.push_back(*id);
        }
    }

    /// Of what was there before.
    void break_debris() {
        for (const BodyId id : before_)
            if (is_near(id) && is_seen(id) && debris_.find(bodies_, id)->broken < options_.max_broken)
                break_body(id, result_.pieces);
    }

    BlastResult finish() {
        result_.push = blast_push(after_blast(), bodies_, blast_, options_.push);
        return std::move(result_);
    }

private:
    std::optional<BodyId> add_chunk(const Chunk& chunk) {
        const SphereFit fit = piece_spheres(chunk.solid, options_.max_spheres);
        const Result<BodyShape> shape = make_body_shape(fit.spheres, chunk.mass);
        if (!shape) return std::nullopt;
        Pose pose;
        pose.position = chunk.origin;
        Body body = body_at(shape.value(), pose);
        body.rolling = rolling_of(fit, body.rolling);
        return add_debris(bodies_, debris_, std::move(body), piece_of_chunk(chunk));
    }

    std::vector<Sphere> spheres_of(BodyId id) const {
        const Body& body = *bodies_.find(id);
        const Pose pose = pose_of(body);
        const TurnMatrix turn = matrix_of(pose.rotation);
        std::vector<Sphere> spheres;
        for (const Sphere& sphere : body.shape.spheres())
            spheres.push_back({pose.position + turn * sphere.centre, sphere.radius});
        return spheres;
    }

    bool is_near(BodyId id) const {
        const Body& body = *bodies_.find(id);
        if (!(length(body.position - blast_.at) < options_.break_radius + body.shape.reach())) return false;
        for (const Sphere& sphere : spheres_of(id))
            if (length(sphere.centre - blast_.at) < options_.break_radius + sphere.radius) return true;
        return false;
    }

    Scene after_blast() const {
        return {result_.carve.world, before_blast_.parts, before_blast_.from, before_blast_.to};
    }

    bool is_seen(BodyId id) const { return exposure(after_blast(), blast_.at, spheres_of(id), options_.push.mask) > 0; }

    /// @return false where it stays whole
    bool break_body(BodyId id, std::vector<BodyId>& to) {
        const DebrisPiece& piece = *debris_.find(bodies_, id);
        const World& world = result_.carve.world;
        ShatterOptions options;
        options.max_spheres = options_.max_spheres;
        options.world = &world;
        options.fracture.impact = blast_.at;
        options.fracture.max_pieces = options_.max_pieces;
        options.fracture.min_volume = options_.min_volume;
        options.fracture.seed = mix_bits(options_.seed + tried_++);
        options.fracture.material = crack_material(world, piece.matter).value_or(0);
        const FracturePattern pattern = fracture_pattern(matter(world, piece.matter));
        const Result<Shattered> broken = shatter(bodies_, debris_, id, pattern, options);
        if (!broken || broken.value().cracks == 0) return false;
        ++result_.broken;
        result_.dust += broken.value().dust;
        result_.dust_mass += broken.value().dust_mass;
        const std::vector<BodyId>& pieces = broken.value().pieces;
        to.insert(to.end(), pieces.begin(), pieces.end());
        return true;
    }

    const Scene before_blast_;
    Bodies& bodies_;
    Debris& debris_;
    const Blast& blast_;
    BlastOptions options_;
    std::vector<BodyId> before_;
    std::uint64_t tried_ = 0;
    BlastResult result_;
};

}  // namespace

BlastResult explode(const Scene& scene, Bodies& bodies, Debris& debris, const Blast& blast, const Cutter& crater,
                    const Pose& pose, const BlastOptions& options) {
    Explosion explosion(scene, bodies, debris, blast, options);
    explosion.carve_world(crater, pose);
    explosion.break_debris();
    return explosion.finish();
}

}  // namespace firma
