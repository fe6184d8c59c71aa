// SPDX-License-Identifier: MIT
// Firma, castable only: the exact part of a level is measured by itself (bench_scale.cpp).
#include "firma/memory.h"
#include "firma/queries.h"
#include "scale/scale_peer.h"

namespace firma::bench {
namespace {

class FirmaScalePeer final : public ScalePeer {
public:
    std::string describe() const override {
        return "this checkout; make_world(), cast(), Sides::kBoth, default options, whole hits (point, normals, ids); "
               "castable only";
    }
    bool has(CastShape) const override { return true; }
    void prepare(const ScaleScene& scene) override { level_ = castable_only(scene.level); }
    void build(const ScaleScene&) override { world_ = make_world(level_).value(); }
    std::size_t own_bytes() const override { return memory_used(world_); }

    void cast(CastShape, std::span<const FloatCast> casts, double* fractions) override {
        const CastOptions options{.sides = Sides::kBoth};
        for (std::size_t k = 0; k < casts.size(); ++k) {
            const FloatCast& c = casts[k];
            const Sphere sphere{{c.start[0], c.start[1], c.start[2]}, c.radius};
            const Hit hit = firma::cast(world_, sphere, {c.path[0], c.path[1], c.path[2]}, options);
            fractions[k] = hit.touched() ? hit.fraction : kScaleMiss;
        }
    }

private:
    Level level_;
    World world_;
};

}  // namespace

std::unique_ptr<ScalePeer> make_firma_peer() {
    return std::make_unique<FirmaScalePeer>();
}

}  // namespace firma::bench
