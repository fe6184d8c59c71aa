// SPDX-License-Identifier: MIT
// What parts bear, and how they break.
#include "firma/break_parts.h"

#include <algorithm>
#include <string>
#include <string_view>
#include <utility>

#include "base/random.h"
#include "firma/part_edits.h"
#include "firma/queries.h"
#include "firma/rooms.h"
#include "fracture/part_pieces.h"
#include "moving/part_frame.h"

namespace firma {
namespace {

/// What authors call matters: by `type` as in Return to Castle Wolfenstein, by the numbers of `material` as in
/// Half-Life.
struct MatterWord {
    std::string_view word, matter;
};
constexpr MatterWord kMatterWords[] = {{"metal", "steel"}, {"stone", "rock"}, {"0", "glass"}, {"1", "wood"},
                                       {"2", "steel"},     {"4", "concrete"}, {"7", "glass"}, {"8", "rock"}};

std::optional<std::uint32_t> named_matter(const World& world, std::string_view word) {
    if (word.empty()) return std::nullopt;
    for (const MatterWord& it : kMatterWords)
        if (it.word == word) word = it.matter;
    return matter_named(matters_of(world), word);
}

/// Metres: so far before a part's surface a blast has to get.
constexpr double kBefore = 1.0 / 64;

bool can_break(const MovingPart& part, const BreakOptions& options) {
    return is_usable_part(part) && options.fraction >= 0 && options.fraction <= 1;
}

void shatter_piece(const MovingPart& part, const Breakable* breakable, Bodies& bodies, Debris& debris, BodyId id,
                   std::uint64_t number, const BreakOptions& options, BrokenPart& broken) {
    const std::uint32_t of = debris.find(bodies, id)->matter;
    ShatterOptions shattering;
    shattering.world = &broken.level;
    if (!breakable || !breakable->matter) shattering.part = &part.world();
    shattering.max_spheres = std::clamp<std::size_t>(options.max_spheres, 1, kMaxSpheres);
    shattering.fracture.impact = options.impact;
    shattering.fracture.max_pieces = std::clamp<std::size_t>(options.max_pieces, 1, kMaxPieces);
    shattering.fracture.min_volume = options.min_volume;
    shattering.fracture.seed = mix_bits(options.seed + number);
    shattering.fracture.material = crack_material(broken.level, of).value_or(0);
    const FracturePattern pattern = fracture_pattern(matter(part.world(), of));
    const Result<Shattered> pieces = shatter(bodies, debris, id, pattern, shattering);
    if (!pieces) {
        broken.pieces.push_back(id);  // it stays whole
        return;
    }
    broken.pieces.insert(broken.pieces.end(), pieces.value().pieces.begin(), pieces.value().pieces.end());
    broken.dust += pieces.value().dust;
    broken.dust_mass += pieces.value().dust_mass;
}

void open_portals(const MovingPart& part, const BreakOptions& options, BrokenPart& broken) {
    std::vector<PortalId> portals = portals_closed_by(broken.level, part);
    portals.insert(portals.end(), options.portals.begin(), options.portals.end());
    std::sort(portals.begin(), portals.end());
    for (const PortalId portal : portals) {
        const std::optional<PortalInfo> info = portal_info(broken.level, portal);
        if (!info || info->open) continue;
        broken.level = *set_portal_open(broken.level, portal, true);
        if (portal_info(broken.level, portal)->open) broken.opened.push_back(portal);
    }
}

}  // namespace

Breakable breakable_of(const BrushPart& part) {
    Breakable breakable;
    breakable.health = part.health;
    breakable.damage = part.damage;
    breakable.whole = mass_properties(part.world.solid(), 1).volume;
    breakable.matter = named_matter(part.world, part.matter);
    return breakable;
}

bool hurt_part(Breakable& breakable, double damage) {
    if (breakable.broken || !(breakable.health > 0) || !is_finite(damage) || !(damage > 0)) return false;
    breakable.health -= damage;
    return breakable.health <= 0;
}

double blast_felt(const World& level, const MovingPart& part, const Blast& blast, double fraction) {
    if (!is_usable_part(part) || !(fraction >= 0 && fraction <= 1) || !is_finite(blast.at)) return 0;
    const PartFrame frame(part.motion, fraction);
    const NearFace near = closest(part.world(), frame.in(blast.at), kEverywhere);
    if (!near) return 0;
    const double share = blast_share(blast, near.distance);
    if (!(share > 0) || near.distance <= kBefore) return share;
    const Vec3 way = (frame.out(near.point) - blast.at) * (1 - kBefore / near.distance);
    return cast_any(level, Ray{blast.at, way}) == Status::kMiss ? share : 0;
}

BrokenPart break_part(const World& level, MovingPart& part, Breakable* breakable, Bodies& bodies, Debris& debris,
                      const BreakOptions& options) {
    BrokenPart broken;
    broken.level = level;
    if (!can_break(part, options)) return broken;
    open_portals(part, options, broken);
    const PartPieces pieces(broken.level, part, options);  // a closed portal would be in their way
    const std::uint32_t of = breakable && breakable->matter ? *breakable->matter : matter_of_surface(part.world());
    std::uint64_t number = 0;
    for (const Solid& solid : connected_pieces(part.world().solid())) {
        if (solid.rock_outside() || solid.face_count() == 0) continue;
        DebrisPiece piece;
        piece.solid = solid;
        piece.matter = of;
        const MassProperties mass = mass_properties(solid, matter(part.world(), of).density);
        const std::optional<BodyId> id = pieces.add(bodies, debris, std::move(piece), mass);
        if (!id)
            ++broken.unfit;
        else if (options.unbroken)
            broken.pieces.push_back(*id);
        else
            shatter_piece(part, breakable, bodies, debris, *id, number, options, broken);
        ++number;
    }
    if (breakable) breakable->broken = true;
    part.set_world({});
    return broken;
}

}  // namespace firma
