// SPDX-License-Identifier: MIT
// A level with rooms and a door, and commands of every kind for it.
#pragma once

#include <gtest/gtest.h>

#include <vector>

#include "base/random.h"
#include "firma/edit_log.h"
#include "firma/rooms.h"
#include "firma/save.h"
#include "firma/solid.h"
#include "tests/carve/cutters.h"
#include "tests/save/saved_worlds.h"
#include "tests/world/two_halves.h"

namespace firma {

/// Two halls of 32 m side by side along x, a portal between them.
inline World two_halls() {
    return assemble_world(two_halves_parts(32)).value();
}

/// A closed mesh that is no crater: a ring, turned inside out where told to.
inline Cutter ring_cutter(bool inside_out = false) {
    test::TriangleMesh mesh = test::ring_mesh(8, 5);
    if (inside_out) mesh.turn_over();
    return make_cutter(mesh.vertices, mesh.triangles, "ring").value();
}

/// A cutter that is a solid with cuts: a cube with a wedge out of a corner.
inline Cutter solid_cutter() {
    const test::TriangleMesh box = test::box_mesh({-2, -2, -2}, {2, 2, 2});
    const Solid cube = unite(Solid(), box.cutter().value(), Pose()).solid;
    const Solid cut = subtract(cube, make_crater(CutterShape::kWedge, 3), test::pose_at(2.1, 1.9, 2)).solid;
    return cutter_from_solid(cut, "cube").value();
}

inline EditCommand cut_command(std::uint32_t number, std::variant<CraterSeed, Cutter> cutter, const Pose& pose,
                               std::string material = "", EditKind kind = EditKind::kCarve) {
    EditCommand command;
    command.number = number;
    command.kind = kind;
    command.cutter = std::move(cutter);
    command.pose = pose;
    command.options.material = std::move(material);
    return command;
}

inline EditCommand door_command(std::uint32_t number, std::uint32_t portal, bool open) {
    return door_command(number, PortalId{portal}, open);
}

inline EditCommand group_command(std::vector<EditCommand> parts) {
    EditCommand command;
    command.kind = EditKind::kGroup;
    command.parts = std::move(parts);
    return command;
}

/// One of each for two_halls(): craters of all shapes with poses on the grid and off it, meshes, a solid, doors, a
/// group, what does nothing, what is refused.
inline std::vector<EditCommand> all_kinds() {
    std::vector<EditCommand> commands;
    std::uint32_t number = 0;
    for (const CutterShape shape :
         {CutterShape::kRocky, CutterShape::kSpiky, CutterShape::kDrill, CutterShape::kWedge, CutterShape::kBox}) {
        const CraterSeed crater{shape, mix_bits(std::uint64_t(shape) + 5)};
        const double x = 4 + 5.0 * double(shape);
        commands.push_back(crater_command(++number, crater, {x, 0.3, 10}, 1.6, {"crater"}));
        Pose pose = test::pose_at(x, 0.1, 20.0 / 3, 1.1);
        pose.rotation = random_turn(number);
        commands.push_back(cut_command(++number, crater, pose));
    }
    number += 3;  // a gap
    commands.push_back(cut_command(++number, ring_cutter(), test::pose_at(40, 0.7, 12), "ring"));
    commands.push_back(door_command(++number, 0, false));
    commands.push_back(cut_command(++number, ring_cutter(true), test::pose_at(50, 0.3, 9, 0.5)));
    commands.push_back(cut_command(++number, solid_cutter(), test::pose_at(60, 0, 20)));
    Pose turned = test::pose_at(45, 0, 22, 1.25);
    turned.rotation = {0.1, 0.2, 0.3, 0.9};
    commands.push_back(cut_command(++number, solid_cutter(), turned));
    commands.push_back(cut_command(++number, ring_cutter(), test::pose_at(41, 0.4, 13), "plug", EditKind::kFill));
    commands.push_back(cut_command(++number, CraterSeed{}, test::pose_at(16, 16, 16)));  // air
    commands.push_back(cut_command(++number, CraterSeed{}, test::pose_at(1e6, 0, 0)));   // outside: refused
    commands.push_back(door_command(++number, 7, true));                                 // there is none
    const EditCommand hole = cut_command(number + 1, CraterSeed{}, test::pose_at(10, 32, 10, 2), "group");
    const EditCommand door = door_command(number + 2, 0, true);
    const EditCommand plug = cut_command(number + 4, CraterSeed{CutterShape::kBox, 1}, test::pose_at(10, 32, 10, 0.5),
                                         "group", EditKind::kFill);
    commands.push_back(group_command({hole, door, plug}));
    number += 4;
    commands.push_back(crater_command(++number, {CutterShape::kRocky, 99}, {31, 0, 31}, 2));
    commands.back().options.chunks = ChunkOptions{.min_volume = 0.5, .density = 1000};
    return commands;
}

/// The log of commands, its checkpoints after every so many (0: none), and the world after them.
struct Logged {
    EditLog log;
    World world;
};
inline Logged log_of(const World& level, const std::vector<EditCommand>& commands, std::size_t every = 1) {
    Logged logged{EditLog(level), level};
    for (const EditCommand& command : commands) {
        EXPECT_FALSE(logged.log.append(command));
        logged.world = apply(logged.world, command).world;
        if (every > 0 && logged.log.commands().size() % every == 0) logged.log.add_checkpoint(logged.world);
    }
    return logged;
}

}  // namespace firma
