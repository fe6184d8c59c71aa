// SPDX-License-Identifier: MIT
// Parts that move, and debris, as bytes.
#include "game/part_bytes.h"

#include <algorithm>
#include <utility>

#include "firma/save.h"
#include "game/number_bytes.h"

namespace firma {
namespace {

constexpr std::size_t kStopBytes = 48, kLeastPieceBytes = 1;

/// A world within other bytes.
World take_world(ByteReader& in) {
    const std::uint64_t length = in.whole();
    const std::size_t where = in.place();
    const std::span<const std::byte> bytes = in.bytes(length);
    if (!in.ok()) return {};
    Result<World> world = unpack_world(bytes, in.name());
    if (world) return std::move(world).value();
    in.fail_at(where, world.error().code, "a solid is no .firma file: " + world.error().text());
    return {};
}

void put_motion(ByteWriter& out, const RigidMotion& motion) {
    put_vec(out, motion.position);
    put_turn(out, motion.rotation);
    put_vec(out, motion.path);
    put_vec(out, motion.turn);
}
RigidMotion take_motion(ByteReader& in) {
    RigidMotion motion;
    motion.position = take_vec(in);
    motion.rotation = take_turn(in);
    motion.path = take_vec(in);
    motion.turn = take_vec(in);
    return motion;
}

void put_path(ByteWriter& out, const PartPath& path) {
    put_whole(out, path.stops.size());
    for (const PartStop& stop : path.stops) {
        put_vec(out, stop.position);
        put_numbers(out, {stop.angle, stop.wait, stop.seconds});
    }
    put_flags(out, {path.repeats});
    put_turn(out, path.rotation);
    put_vec(out, path.axis);
    put_vec(out, path.swing.reach);
    put_numbers(out, {path.spin, path.swing.angle, path.swing.period, path.swing.phase});
}
PartPath take_path(ByteReader& in) {
    PartPath path;
    path.stops.resize(take_count(in, kStopBytes));
    for (PartStop& stop : path.stops) {
        stop.position = take_vec(in);
        stop.angle = in.f64();
        stop.wait = take_length_of_time(in);
        stop.seconds = take_length_of_time(in);
    }
    take_flags(in, {&path.repeats});
    path.rotation = take_turn(in);
    path.axis = take_vec(in);
    path.swing.reach = take_vec(in);
    take_numbers(in, {&path.spin, &path.swing.angle, &path.swing.period, &path.swing.phase});
    return path;
}

}  // namespace

void put_part(ByteWriter& out, const MovingPart& part, const PartDrive& drive) {
    put_text(out, part.name);
    out.u32(part.mask);
    out.u32(part.entity);
    put_motion(out, part.motion);
    put_path(out, drive.path);
    put_flags(out, {drive.waits});
    put_whole(out, std::uint64_t(drive.when_blocked));
    out.u64(drive.started);
    out.u64(drive.held);
    put_numbers(out, {drive.ahead});
    put_whole(out, drive.portals.size());
    for (const PortalId portal : drive.portals) put_whole(out, portal.value);
    put_content(out, pack_world(part.world()));
}

void take_part(ByteReader& in, MovingPart& part, PartDrive& drive) {
    std::string name = in.text();
    const std::uint32_t mask = in.u32(), entity = in.u32();
    const RigidMotion motion = take_motion(in);
    drive.path = take_path(in);
    take_flags(in, {&drive.waits});
    drive.when_blocked = WhenBlocked(std::min(take_u32_whole(in), 255u));  // fault_of_game() judges it
    drive.started = in.u64();
    drive.held = in.u64();
    take_numbers(in, {&drive.ahead});
    drive.portals.resize(take_count(in, 1));
    for (PortalId& portal : drive.portals) portal.value = take_u32_whole(in);
    part = MovingPart(take_world(in), motion);
    part.name = std::move(name);
    part.mask = mask;
    part.entity = entity;
}

void put_debris(ByteWriter& out, const Debris& debris) {
    put_whole(out, debris.slots.size());
    for (const DebrisPiece& piece : debris.slots) {
        const bool is_there = piece.solid.face_count() > 0;
        put_flags(out, {is_there, is_there && piece.never_ground, is_there && piece.of_part});
        if (!is_there) continue;
        put_whole(out, piece.use);
        put_whole(out, piece.matter);
        put_vec(out, piece.origin);
        put_whole(out, piece.broken);
        put_numbers(out, {piece.age, piece.asleep_for});
        put_content(out, pack_world(make_world(piece.solid).value()));
    }
}

Debris take_debris(ByteReader& in) {
    Debris debris;
    const std::size_t count = take_count(in, kLeastPieceBytes);
    for (std::size_t k = 0; k < count && in.ok(); ++k) {
        DebrisPiece piece;
        bool is_there = false;
        take_flags(in, {&is_there, &piece.never_ground, &piece.of_part});
        if (is_there) {
            piece.use = take_u32_whole(in);
            piece.matter = take_u32_whole(in);
            piece.origin = take_vec(in);
            piece.broken = take_u32_whole(in);
            take_numbers(in, {&piece.age, &piece.asleep_for});
            piece.solid = take_world(in).solid();
            if (in.ok() && (piece.solid.face_count() == 0 || piece.age < 0 || piece.asleep_for < 0))
                in.fail("debris without a solid, or of an age below 0");
        } else if (piece.never_ground || piece.of_part) {
            in.fail("flags that mean nothing");
        }
        debris.slots.push_back(std::move(piece));
    }
    return debris;
}

}  // namespace firma
