#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Writes levels/depot.map: the depot, our demo level of brushes, in the Valve 220 form that TrenchBroom writes.

    /usr/bin/python3 tools/make_depot.py -o levels/depot.map

How it works. tools/depot/plan.py has the rooms and the openings between them as boxes of air; tools/depot/rock.py
divides what is left of a large block of rock into boxes, so the level is sealed by how it is made. Everything else is
convex hulls of integer points (tools/depot/shapes.py): what is built (building.py) and what stands about (furniture.py),
each in a group of its own. Portals lie in a layer that can be hidden.

All coordinates are integers in map units, 32 a metre. Nothing depends on hash order; random numbers have fixed seeds.
"""

import argparse
import sys

sys.dont_write_bytecode = True

from depot import building, furniture, plan  # noqa: E402
from depot.rock import rock_around  # noqa: E402
from depot.shapes import entity_lines  # noqa: E402

HEAD = [
    "// Game: Firma",
    "// Format: Valve",
    "// SPDX-License-Identifier: MIT",
    "// Written by tools/make_depot.py; change the script, not this file.",
]


def world_brushes(rooms, openings):
    """The rock and walls around all air."""
    airs = [box for room in rooms for box in room.boxes]
    airs += [plan.Air(opening.low, opening.high, opening.textures) for opening in openings]
    return rock_around(airs, plan.LOW, plan.HIGH, "depot/rock")


def groups(openings):
    """Name and brushes of each group."""
    return [
        ("gallery", building.gallery()),
        ("bridge", building.bridge()),
        ("pillars", building.pillars()),
        ("crane", building.crane()),
        ("roof frames", building.roof_frames()),
        ("roofs", building.sawtooth()),
        ("outer stairs", building.roof_stairs()),
        ("loading dock", building.dock()),
        ("stairs", building.stairwell()),
        ("tunnel", building.tunnel_slopes()),
        ("hut", furniture.hut()),
        ("glass", [plan.glass_of(opening) for opening in openings if opening.glass]),
        ("water", furniture.basin()),
        ("hall things", furniture.hall_things()),
        ("dock things", furniture.dock_things()),
        ("offices", furniture.offices()),
        ("upper offices", furniture.upper_offices()),
        ("workshop", furniture.workshop()),
        ("cistern", furniture.cistern()),
        ("control room", furniture.upper_south()),
        ("cellar", furniture.cellar_things()),
        ("cave", furniture.cave_rocks()),
        ("yard", furniture.yard_things()),
        ("lamps", furniture.lamps()),
        ("clips", furniture.clips()),
    ]


def entities():
    """Keys and brushes of every entity, the world first."""
    openings = plan.openings()
    yield [("mapversion", "220"), ("classname", "worldspawn"), ("message", "Depot")], world_brushes(
        plan.all_rooms(), openings)
    yield [("classname", "func_group"), ("_tb_type", "_tb_layer"), ("_tb_name", "portals"), ("_tb_id", "1")], []
    for name, brush in plan.portals():
        yield [("classname", "func_areaportal"), ("targetname", name), ("_tb_layer", "1")], [brush]
    for name, place in plan.room_names():
        yield [("classname", "firma_room"), ("origin", "%d %d %d" % place), ("name", name)], []
    for number, (name, brushes) in enumerate(groups(openings), start=2):
        keys = [("classname", "func_group"), ("_tb_type", "_tb_group"), ("_tb_name", name), ("_tb_id", str(number))]
        yield keys, brushes
    yield [("classname", "firma_anchor")], building.anchors()
    yield spawn_keys("info_player_start", furniture.START), []
    for place in furniture.DEATHMATCH:
        yield spawn_keys("info_player_deathmatch", place), []
    for x, y, z, bright in furniture.lights():
        yield [("classname", "light"), ("origin", f"{x} {y} {z}"), ("light", str(bright))], []


def spawn_keys(name, place):
    """The keys of a spawn point."""
    x, y, z, angle = place
    return [("classname", name), ("origin", f"{x} {y} {z}"), ("angle", str(angle))]


def main():
    """Reads the command line and writes the level."""
    parser = argparse.ArgumentParser(description="Writes the depot as a .map file.")
    parser.add_argument("-o", "--output", help="the file to write (standard output without it)")
    options = parser.parse_args()
    lines, brushes = list(HEAD), 0
    for number, (keys, own) in enumerate(entities()):
        lines += entity_lines(number, keys, own)
        brushes += len(own)
    text = "\n".join(lines) + "\n"
    if options.output is None:
        sys.stdout.write(text)
    else:
        with open(options.output, "w", encoding="ascii", newline="\n") as file:
            file.write(text)
    print(f"entities {number + 1}, brushes {brushes}", file=sys.stderr)
    return 0


if __name__ == "__main__":
    sys.exit(main())
