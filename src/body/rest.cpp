// SPDX-License-Identifier: MIT
// Rest and waking.
#include "body/rest.h"

#include <algorithm>
#include <vector>

#include "base/disjoint_sets.h"
#include "body/mover.h"
#include "body/turn_between.h"
#include "world/world_data.h"

namespace firma {
namespace {

/// What trembles in its place, or has no room to go where its velocity takes it, is as still as what has none.
void count_still(Body& body, double seconds, const StepOptions& options) {
    // What turns all the way round in a step comes back to where it was.
    constexpr double kClearTurn = 1;  // radians a step
    const double turned = length(turn_between(normalised(body.still_turn), normalised(body.rotation)));
    const double way = length(body.position - body.still_at) + turned * body.shape.reach();
    body.still_for += seconds;
    if (way < options.sleep_speed * options.sleep_after && length(body.spin) * seconds < kClearTurn) return;
    body.still_for = 0;
    body.still_at = body.position;
    body.still_turn = body.rotation;
}

}  // namespace

void rest(Bodies& bodies, std::span<const Mover> movers, std::span<const std::uint32_t> movers_of_slots, double seconds,
          const StepParts& parts, const StepOptions& options) {
    for (const Mover& mover : movers) count_still(bodies.slots[mover.slot], seconds, options);
    const auto moves = [&](std::uint32_t slot) { return movers_of_slots[slot] != kFixed; };
    DisjointSets islands(bodies.slots.size());
    std::vector<bool> held(bodies.slots.size());
    for (const BodyContact& contact : bodies.contacts) {
        if (contact.other != kFixed && moves(contact.body) && moves(contact.other))
            islands.join(contact.body, contact.other);
        held[contact.body] = true;
        if (parts.is_moving(contact.part)) bodies.slots[contact.body].still_for = 0;
        if (contact.other != kFixed) held[contact.other] = true;
    }
    std::vector<bool> is_still(bodies.slots.size(), true);
    for (std::uint32_t slot = 0; slot < bodies.slots.size(); ++slot) {
        if (!bodies.slots[slot].shape.valid() || !moves(slot)) continue;
        if (bodies.slots[slot].still_for < options.sleep_after || !held[slot]) is_still[islands.find(slot)] = false;
    }
    std::vector<std::uint32_t> numbers(bodies.slots.size(), ~0u);
    for (std::uint32_t slot = 0; slot < bodies.slots.size(); ++slot) {
        Body& body = bodies.slots[slot];
        if (!body.shape.valid() || !moves(slot)) continue;
        const std::uint32_t island = islands.find(slot);
        if (!is_still[island]) continue;
        if (numbers[island] == ~0u) numbers[island] = bodies.islands++;
        body.island = numbers[island];
        body.asleep = true;
        body.velocity = body.spin = {};
    }
}

std::size_t wake_island(Bodies& bodies, std::uint32_t slot) {
    const std::uint32_t island = bodies.slots[slot].island;
    std::size_t woken = 0;
    for (Body& body : bodies.slots) {
        const bool is_it = &body == &bodies.slots[slot];
        if (!body.shape.valid() || !body.asleep || !(is_it || body.island == island)) continue;
        body.asleep = false;
        body.still_for = 0;
        ++woken;
    }
    return woken;
}

std::size_t wake_unsupported(Bodies& bodies, const World& world, bool other_world, const StepParts& parts) {
    std::size_t woken = 0;
    const Cells& cells = world.data().cells;
    const auto is_there = [&](const BodyContact& contact) {
        if (contact.part != kNoPart) return contact.part < parts.size() && !parts[contact.part].changed;
        if (!other_world) return true;
        if (contact.portal.valid())
            return contact.portal.value < cells.portal_count() && cells.is_closed(contact.portal.value);
        return !contact.face.valid() || world.face_info(contact.face).has_value();
    };
    for (const BodyContact& contact : bodies.contacts)
        if (bodies.slots[contact.body].asleep && !is_there(contact)) woken += wake_island(bodies, contact.body);
    return woken;
}

std::size_t wake_in_the_way(Bodies& bodies, const StepParts& parts, double skin) {
    std::size_t woken = 0;
    std::vector<Sphere> spheres;
    for (std::uint32_t slot = 0; slot < bodies.slots.size(); ++slot) {
        const Body& body = bodies.slots[slot];
        if (!body.shape.valid() || !body.asleep) continue;
        const auto comes = [&](const StepPart& part) {
            return part.moves && (part.part.mask & body.mask) &&
                   part.may_meet(body.position, body.shape.reach() + 2 * skin);
        };
        bool any = false;
        for (std::size_t k = 0; k < parts.size(); ++k) any = any || comes(parts[k]);
        if (!any) continue;
        spheres.clear();
        for (const Sphere& sphere : body.shape.data().spheres)
            spheres.push_back({sphere.centre, sphere.radius + 2 * skin});
        CastOptions options;
        options.mask = body.mask;
        const RigidMotion stands{body.position, principal_rotation(body), {}, {}};
        if (parts.cast_set(spheres, stands, 0, 1, kNoPart, options).touched()) woken += wake_island(bodies, slot);
    }
    return woken;
}

}  // namespace firma
