#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Tells which includes point up: a file may include its own layer and those below it, never one above.

  tools/check_layers.py [ROOT]     exit 0: none does; 1: some do, each named; 2: a bad call
"""
import os
import re
import sys

# Foundation first. Layers on one line are wings: they stand on the same floor and never see each other.
FLOORS = [
    ['include/firma'],
    ['src/base'],
    ['src/geometry'],
    ['src/cast'],
    ['src/index'],
    ['src/solid'],
    ['src/carve', 'src/join'],
    ['src/world'],
    ['src/level', 'src/save', 'src/store', 'src/body'],
    ['src/brush'],
    ['src/debug'],
    ['scenes'],
    ['gltf'],
    ['bindings', 'cli', 'bench', 'playground', 'tests'],
]
SEARCHED = ['include', 'src', '', 'bench', 'tests']  # where the compiler looks for a quoted include
SOURCES = ('.h', '.cpp', '.c')
# The roof tests and measures everything, itself included: tests may look at the command line's parts, benchmarks share with tests.
ROOF = len(FLOORS) - 1
INCLUDE = re.compile(r'^\s*#\s*include\s+"([^"]+)"')


def layer_of(path):
    """(floor, layer) of a file named from the root, or None when it belongs to none."""
    for floor, layers in enumerate(FLOORS):
        for layer in layers:
            if path.startswith(layer + '/'):
                return floor, layer
    return None


def files_below(root):
    for floor in FLOORS:
        for layer in floor:
            for folder, _, names in os.walk(os.path.join(root, layer)):
                for name in sorted(names):
                    if name.endswith(SOURCES):
                        yield os.path.relpath(os.path.join(folder, name), root)


def resolve(root, included, including):
    """The included file named from the root, or None when it is not ours."""
    beside = os.path.join(os.path.dirname(including), included)
    for candidate in [os.path.join(base, included) for base in SEARCHED] + [beside]:
        if os.path.isfile(os.path.join(root, candidate)):
            return os.path.normpath(candidate)
    return None


def faults_in(root, path):
    floor, layer = layer_of(path)
    with open(os.path.join(root, path), encoding='utf-8') as file:
        for number, line in enumerate(file, 1):
            match = INCLUDE.match(line)
            target = match and resolve(root, match.group(1), path)
            if match and target is None and floor != ROOF:  # the roof may lean on files of peers
                yield f'{path}:{number}: includes "{match.group(1)}", which is nowhere in the project'
            there = target and layer_of(target)
            if not there or floor == ROOF:
                continue
            if there[0] > floor:
                yield f'{path}:{number}: {layer} includes {target}, which stands above it'
            elif there[0] == floor and there[1] != layer:
                yield f'{path}:{number}: {layer} includes {target}, a wing beside it'


def main():
    if len(sys.argv) > 2:
        print(__doc__, file=sys.stderr)
        return 2
    root = sys.argv[1] if len(sys.argv) == 2 else os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
    files = list(files_below(root))
    if not files:
        print(f'{root}: no sources here', file=sys.stderr)
        return 2
    faults = [fault for path in files for fault in faults_in(root, path)]
    for fault in faults:
        print(fault)
    print(f'{len(files)} files, {len(faults)} includes that point up')
    return 1 if faults else 0


if __name__ == '__main__':
    sys.exit(main())
