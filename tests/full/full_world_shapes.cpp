// SPDX-License-Identifier: MIT
// A million capsules, boxes and hulls cast through worlds by each of the lanes' kernels that this processor runs: the
// answers are those without lanes, to the bit, and of one cast in eight (in our level in 250) those of the pair
// function asked of every face, which the claims capsules_vs_twin and hulls_vs_twin judge.
//
//   full_world_shapes --count 1000000 --seed 1 [--show 3]
//
// The count is of casts by each kernel: in the scenes of the casts' families, and in our level.
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include "firma/level.h"
#include "firma/rooms.h"
#include "scenes/cast_families.h"
#include "tests/every_kernel.h"
#include "tests/full/options.h"
#include "tests/world/any_shape.h"
#include "tests/world/hit_bits.h"

namespace {

using namespace firma;

struct Tally {
    std::uint64_t casts = 0, touched = 0, wrong = 0, by_face = 0;

    void add(const Tally& other) {
        casts += other.casts;
        touched += other.touched;
        wrong += other.wrong;
        by_face += other.by_face;
    }
};

struct ShapeCast {
    AnyShape shape;
    Vec3 at, path;
    Sides sides;
};

std::vector<ShapeCast> casts_of(const scenes::CastScene& scene, std::uint64_t seed) {
    scenes::Rng rng(seed);
    std::vector<ShapeCast> casts;
    for (const scenes::CastQuery& query : scene.casts)
        for (const Sides sides : {Sides::kFront, Sides::kBoth}) {
            const double radius = query.sphere.radius, size = radius > 1e-6 && radius < 1e6 ? radius : 0.5;
            casts.push_back({AnyShape(rng, query.sphere.centre, size), query.sphere.centre, query.path, sides});
        }
    return casts;
}

/// Short and long ones, anywhere.
std::vector<ShapeCast> casts_in(const World& level, std::uint64_t seed) {
    scenes::Rng rng(seed);
    const Box bounds = level.bounds();
    std::vector<ShapeCast> casts;
    for (int k = 0; k < 500; ++k) {
        Vec3 at;
        for (int axis = 0; axis < 3; ++axis) at[axis] = rng.uniform(bounds.low[axis], bounds.high[axis]);
        const AnyShape shape(rng, at, rng.uniform(0.01, 1));
        casts.push_back({shape, at, rng.direction() * (rng.chance(0.5) ? rng.uniform(0.01, 2) : rng.uniform(2, 60)),
                         rng.chance(0.5) ? Sides::kFront : Sides::kBoth});
    }
    return casts;
}

/// Whether a cast through a world says what the pair function says of each of its faces.
bool is_earliest_of_all(const World& world, const ShapeCast& it, const Hit& hit) {
    PolygonHit best;
    FaceRef face;
    each_face(world, [&](const FaceView& view) {
        const PolygonHit one = it.shape.cast_at(view.corners, it.at, it.path, view.two_sided ? Sides::kBoth : it.sides);
        if (one &&
            (!best || one.fraction < best.fraction || (one.fraction == best.fraction && view.ref().id < face.id))) {
            best = one;
            face = view.ref();
        }
        return true;
    });
    if (!best) return !hit;
    return hit.status == best.status && hit.fraction == best.fraction && hit.face == face && hit.point == best.point &&
           hit.normal == best.normal;
}

/// @param each  of how many casts one is asked of every face
Tally judge(const World& world, const std::string& name, const std::vector<ShapeCast>& casts, std::size_t each,
            std::string& failure) {
    std::vector<std::pair<const char*, std::vector<std::vector<std::uint64_t>>>> all;
    std::vector<Hit> hits;
    test::with_every_kernel([&](const char* kernel) {
        auto& answers = all.emplace_back(kernel, std::vector<std::vector<std::uint64_t>>()).second;
        hits.clear();
        for (const ShapeCast& it : casts) {
            hits.push_back(it.shape.cast_through(world, it.at, it.path, it.sides));
            add_bits(answers.emplace_back(), hits.back());
        }
    });
    Tally tally;
    tally.casts = casts.size();
    const auto tell = [&](const char* who, std::size_t cast) {
        ++tally.wrong;
        char text[200];
        std::snprintf(text, sizeof text, "%s, cast %zu: %s", name.c_str(), cast, who);
        failure = text;
    };
    for (std::size_t k = 0; k < casts.size(); ++k) {
        tally.touched += bool(hits[k]);
        for (const auto& [kernel, answers] : all)
            if (answers[k] != all.back().second[k]) tell(kernel, k);
        if (k % each != 0 || hits[k].status == Status::kInvalid) continue;
        ++tally.by_face;
        if (!is_earliest_of_all(world, casts[k], hits[k])) tell("not the earliest of all faces", k);
    }
    return tally;
}

}  // namespace

int main(int count, char** words) {
    full::Options options;
    options.count = 1'000'000;
    if (!full::read_options(count, words, options, {})) {
        std::fprintf(stderr, "full_world_shapes [--count N] [--seed N] [--show N]\n");
        return 2;
    }
    std::string kernels;
    test::with_every_kernel([&](const char* kernel) {
        if (!kernels.empty()) kernels += '+';
        for (const char* letter = kernel; *letter; ++letter) kernels += *letter == ' ' ? '_' : *letter;
    });
    Tally total;
    std::size_t shown = 0;
    const auto take = [&](const World& world, const std::string& name, const std::vector<ShapeCast>& casts,
                          std::size_t each) {
        std::string failure;
        total.add(judge(world, name, casts, each, failure));
        if (!failure.empty() && shown++ < options.show) std::printf("failure %s\n", failure.c_str());
    };
    const World level = make_world(read_level(FIRMA_ROOT "/levels/first.obj").value()).value();
    for (std::uint64_t index = 0; total.casts < options.count; ++index) {
        const std::uint64_t seed = options.seed * 1'000'003 + index;
        const std::string scene_name = ", scene " + std::to_string(index);
        for (const scenes::CastFamily& family : scenes::cast_families()) {
            const scenes::CastScene scene = scenes::make_cast_scene(family, options.seed, index);
            take(make_world(scenes::level_of(scene.polygons, scene.two_sided)).value(),
                 std::string(family.name) + scene_name, casts_of(scene, seed), 8);
        }
        take(level, "first.obj" + scene_name, casts_in(level, seed), 250);
    }
    const auto number = [](std::uint64_t x) { return static_cast<unsigned long long>(x); };
    std::printf(
        "claim=shapes_by_kernel family=total count=%llu seed=%llu kernels=%s wrong=%llu touched=%llu by_face=%llu "
        "result=%s\n",
        number(total.casts), number(options.seed), kernels.c_str(), number(total.wrong), number(total.touched),
        number(total.by_face), total.wrong == 0 ? "pass" : "fail");
    return total.wrong == 0 && total.touched > 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
