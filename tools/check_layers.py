#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Tells which includes point up: a file may include its own layer and those below it, never one above.

  tools/check_layers.py [ROOT]     exit 0: none does; 1: some do, each named; 2: a bad call
"""
import os
import re
import sys

# The lowest first. Layers on one line are modules: they stand on the same layers and never include each other.
LAYERS = [
    ['include/firma'],
    ['src/base'],
    ['src/geometry'],
    ['src/cast'],
    ['src/index'],
    ['src/solid'],
    ['src/arrange'],
    ['src/carve', 'src/join'],
    ['src/world'],
    ['src/moving'],
    ['src/level', 'src/save', 'src/store', 'src/body'],
    ['src/brush', 'src/log', 'src/player', 'src/fracture', 'src/convex'],
    ['src/game'],
    ['scenes'],
    ['gltf', 'draw'],
    ['bindings', 'cli', 'bench', 'playground', 'tests'],
]
# Layers that may not include all that stands below them: gltf reads a file and leaves the rest to level, pictures show what every user can ask for.
ONLY = {'gltf': ['include/firma', 'src/level'], 'draw': ['include/firma']}
# Public headers that speak of worlds: nothing below src/world includes them.
OF_WORLDS = ['blast.h', 'bodies.h', 'body_index.h', 'break_parts.h', 'brush_parts.h', 'brush_world.h', 'carve.h', 'cast_set.h', 'debris.h', 'edit_log.h', 'fracture.h', 'game.h', 'moving_parts.h', 'part_edits.h', 'pierce.h', 'players.h', 'projectiles.h', 'recording.h', 'rooms.h', 'save.h', 'support.h', 'versions.h', 'world.h', 'world_patch.h']
WORLD = next(height for height, layers in enumerate(LAYERS) if 'src/world' in layers)
SEARCHED = ['include', 'src', '', 'bench', 'tests']  # where the compiler looks for a quoted include
SOURCES = ('.h', '.cpp', '.c')
# Programs test and measure everything, themselves included: tests may look at the command line's parts, benchmarks share with tests.
PROGRAMS = len(LAYERS) - 1
INCLUDE = re.compile(r'^\s*#\s*include\s+"([^"]+)"')


def layer_of(path):
    """(height, layer) of a file named from the root, or None when it belongs to none."""
    for height, layers in enumerate(LAYERS):
        for layer in layers:
            if path.startswith(layer + '/'):
                return height, layer
    return None


def sources_in(root, folder):
    """Named from the root, in order."""
    for place, folders, names in os.walk(os.path.join(root, folder)):
        folders.sort()
        for name in sorted(names):
            if name.endswith(SOURCES):
                yield os.path.relpath(os.path.join(place, name), root)


def files_of_layers(root):
    for layers in LAYERS:
        for layer in layers:
            yield from sources_in(root, layer)


def files_of_no_layer(root):
    return [path for folder in ('include', 'src') for path in sources_in(root, folder) if not layer_of(path)]


def resolve(root, included, including):
    """The included file named from the root, or None when it is not ours."""
    beside = os.path.join(os.path.dirname(including), included)
    for candidate in [os.path.join(base, included) for base in SEARCHED] + [beside]:
        if os.path.isfile(os.path.join(root, candidate)):
            return os.path.normpath(candidate)
    return None


def faults_in(root, path):
    height, layer = layer_of(path)
    with open(os.path.join(root, path), encoding='utf-8') as file:
        for number, line in enumerate(file, 1):
            match = INCLUDE.match(line)
            target = match and resolve(root, match.group(1), path)
            if match and target is None and height != PROGRAMS:  # programs may include files of other projects
                yield f'{path}:{number}: includes "{match.group(1)}", which is nowhere in the project'
            there = target and layer_of(target)
            if not there or height == PROGRAMS:
                continue
            if there[0] > height:
                yield f'{path}:{number}: {layer} includes {target}, which stands above it'
            elif there[0] == height and there[1] != layer:
                yield f'{path}:{number}: {layer} includes {target}, a module beside it'
            elif 0 < height < WORLD and target in [f'include/firma/{name}' for name in OF_WORLDS]:
                yield f'{path}:{number}: {layer} includes {target}, which speaks of worlds'
            elif there[1] not in [layer] + ONLY.get(layer, [there[1]]):
                yield f'{path}:{number}: {layer} includes {target}; it may include {", ".join(ONLY[layer])} alone'


def main():
    if len(sys.argv) > 2:
        print(__doc__, file=sys.stderr)
        return 2
    root = sys.argv[1] if len(sys.argv) == 2 else os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
    files = list(files_of_layers(root))
    if not files:
        print(f'{root}: no sources here', file=sys.stderr)
        return 2
    faults = [f'{path}: its folder is in no layer: see LAYERS in tools/check_layers.py' for path in files_of_no_layer(root)]
    faults += [fault for path in files for fault in faults_in(root, path)]
    for fault in faults:
        print(fault)
    print(f'{len(files)} files, {len(faults)} faults')
    return 1 if faults else 0


if __name__ == '__main__':
    sys.exit(main())
