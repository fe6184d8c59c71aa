// SPDX-License-Identifier: MIT
// Fractures: patterns, solids broken into pieces, bodies that shatter.
#include "firma/fracture.h"

#include <algorithm>
#include <memory>
#include <utility>
#include <vector>

#include "bindings/c/debris_object.h"
#include "bindings/c/numbers.h"

namespace firma::c {
namespace {

static_assert(FIRMA_CRACK_LUMPS == int(CrackStyle::kLumps) && FIRMA_CRACK_BRICKS == int(CrackStyle::kBricks) &&
              FIRMA_CRACK_SHARDS == int(CrackStyle::kShards));

firma_fracture_pattern pattern_told(const FracturePattern& from) {
    firma_fracture_pattern out{};
    out.style = std::uint32_t(from.style);
    put(from.size, out.size_of_piece);
    out.growth = from.growth;
    out.crooked = from.crooked;
    out.axes[3] = 1;
    if (from.axes) {
        out.has_axes = 1;
        std::copy(from.axes->begin(), from.axes->end(), out.axes);
    }
    if (from.brick_corner) {
        out.has_brick_corner = 1;
        put(*from.brick_corner, out.brick_corner);
    }
    return out;
}

firma_code read_shatter(const firma_shatter_options* given, ShatterOptions& options, const char* function) {
    if (!given) return FIRMA_OK;
    if (!sized(given)) return bad_call(function, kWrongSize);
    firma_shatter_options whole{};
    take_sized(given, whole);
    if (whole.max_spheres) options.max_spheres = whole.max_spheres;
    if (whole.world.id == 0) return FIRMA_OK;
    const WorldObject* const level = find<WorldObject>(whole.world.id, function);
    if (!level) return FIRMA_ERROR_BAD_HANDLE;
    options.world = &level->world;
    return FIRMA_OK;
}

firma_shattered shattered_told(const Shattered& from) {
    firma_shattered out{};
    out.pieces = from.pieces.size();
    out.dust = from.dust;
    out.cracks = from.cracks;
    out.refused = from.refused;
    out.dust_mass = from.dust_mass;
    put(from.dust_momentum, out.dust_momentum);
    put(from.dust_angular_momentum, out.dust_angular_momentum);
    return out;
}

}  // namespace

firma_code read_pattern(const firma_fracture_pattern* given, FracturePattern& pattern, const char* function) {
    if (!given) return bad_call(function, kNull);
    if (!sized(given)) return bad_call(function, kWrongSize);
    firma_fracture_pattern whole = pattern_told({});
    take_sized(given, whole);
    if (whole.style > FIRMA_CRACK_SHARDS || whole.has_axes > 1 || whole.has_brick_corner > 1)
        return fail(FIRMA_ERROR_INVALID, function, "the pattern's style is none, or a flag is not 0 or 1");
    if (whole.has_axes && !is_rotation(whole.axes))
        return fail(FIRMA_ERROR_INVALID, function, "the pattern's axes are not finite, or no rotation");
    pattern.style = CrackStyle(whole.style);
    pattern.size = vec(whole.size_of_piece);
    pattern.growth = whole.growth;
    pattern.crooked = whole.crooked;
    const double(&axes)[4] = whole.axes;
    if (whole.has_axes) pattern.axes = Quaternion{axes[0], axes[1], axes[2], axes[3]};
    if (whole.has_brick_corner) pattern.brick_corner = vec(whole.brick_corner);
    return FIRMA_OK;
}

firma_code read_fracture(const firma_fracture_options* given, FractureOptions& options, const char* function) {
    if (!given) return FIRMA_OK;
    if (!sized(given)) return bad_call(function, kWrongSize);
    firma_fracture_options whole{};
    take_sized(given, whole);
    if (whole.has_impact > 1) return fail(FIRMA_ERROR_INVALID, function, "has_impact must be 0 or 1");
    if (whole.max_pieces) options.max_pieces = whole.max_pieces;
    if (whole.has_impact) options.impact = vec(whole.impact);
    if (whole.min_volume != 0) options.min_volume = whole.min_volume;
    if (whole.density != 0) options.density = whole.density;
    if (whole.seed) options.seed = whole.seed;
    options.material = whole.material;
    return FIRMA_OK;
}

}  // namespace firma::c

using namespace firma;
using namespace firma::c;

firma_code firma_fracture_pattern_of(firma_world world, uint32_t matter, firma_fracture_pattern* pattern) {
    return guarded(__func__, [&, function = __func__] {
        if (!pattern) return bad_call(function, kNull);
        if (!sized(pattern)) return bad_call(function, kWrongSize);
        const WorldObject* const object = find<WorldObject>(world.id, function);
        if (!object) return FIRMA_ERROR_BAD_HANDLE;
        const std::vector<Matter>& all = matters_of(object->world).matters;
        if (matter >= all.size()) return fail(FIRMA_ERROR_INVALID, function, "the world has no such matter");
        put_sized(pattern_told(fracture_pattern(all[matter])), pattern);
        return FIRMA_OK;
    });
}

firma_code firma_world_fracture(firma_world world, const firma_fracture_pattern* pattern,
                                const firma_fracture_options* options, firma_chunks* pieces) {
    return guarded(__func__, [&, function = __func__] {
        if (!pieces) return bad_call(function, kNull);
        FracturePattern how;
        if (const firma_code code = read_pattern(pattern, how, function)) return code;
        FractureOptions chosen;
        if (const firma_code code = read_fracture(options, chosen, function)) return code;
        const WorldObject* const object = find<WorldObject>(world.id, function);
        if (!object) return FIRMA_ERROR_BAD_HANDLE;
        const Result<Fracture> broken = fracture(object->world.solid(), how, chosen);
        if (!broken) return fail(broken.error());
        std::vector<firma::Chunk> all;
        for (const FracturePiece& piece : broken.value().pieces) all.push_back({piece.solid, {}, piece.mass, {}});
        return give(std::make_unique<ChunksObject>(std::move(all), object->world), pieces, function);
    });
}

firma_code firma_shatter(firma_debris debris, firma_bodies bodies, firma_body_id id,
                         const firma_fracture_pattern* pattern, const firma_fracture_options* fracture,
                         const firma_shatter_options* options, firma_shattered* report) {
    return guarded(__func__, [&, function = __func__] {
        if (report && !sized(report)) return bad_call(function, kWrongSize);
        FracturePattern how;
        if (const firma_code code = read_pattern(pattern, how, function)) return code;
        ShatterOptions chosen;
        if (const firma_code code = read_fracture(fracture, chosen.fracture, function)) return code;
        if (const firma_code code = read_shatter(options, chosen, function)) return code;
        DebrisThere there;
        if (const firma_code code = there.find_piece(debris, bodies, id, function)) return code;
        Result<Shattered> broken =
            there.change([&](Bodies& all, Debris& of) { return shatter(all, of, id_of(id), how, chosen); });
        if (!broken) return fail(broken.error());
        if (report) put_sized(shattered_told(broken.value()), report);
        there.debris->forget();
        there.debris->named[FIRMA_DEBRIS_PIECES].swap(broken.value().pieces);
        return FIRMA_OK;
    });
}
