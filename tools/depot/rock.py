# SPDX-License-Identifier: MIT
"""The rock and the walls around the air: what is left of a block when the boxes of air are taken from it, as boxes.

The planes of all boxes cut the block into cells. A cell that is no air wants a texture on each side where it borders on
air: that of the air's box for a floor, a wall, a ceiling. Cells are joined into boxes as long as no side of the box wants
two textures. So brushes never overlap, share their planes, and leave no crack: a level of such walls is sealed.
"""

from itertools import permutations, product
from typing import NamedTuple

from depot.shapes import CAULK, box

DIRECTIONS = ("-x", "+x", "-y", "+y", "-z", "+z")


class Air(NamedTuple):
    """A box of air. Textures: floor, wall, ceiling, or for one side '-x' to '+z' as seen from the air."""

    low: tuple[int, int, int]
    high: tuple[int, int, int]
    textures: dict


def wanted_texture(air, direction):
    """What the solid on this side of a box of air shows to it."""
    part = {"-z": "floor", "+z": "ceiling"}.get(direction, "wall")
    return air.textures.get(direction) or air.textures[part]


def cut_planes(airs, low, high):
    """Per axis, the sorted coordinates of all planes."""
    planes = []
    for axis in range(3):
        values = {low[axis], high[axis]}
        for air in airs:
            values |= {air.low[axis], air.high[axis]}
        planes.append(sorted(values))
        if planes[axis][0] < low[axis] or planes[axis][-1] > high[axis]:
            raise ValueError("air reaches out of the block")
    return planes


def air_cells(airs, planes):
    """From the cells that are air to their box; of several boxes the last."""
    places = [{value: index for index, value in enumerate(values)} for values in planes]
    cells = {}
    for air in airs:
        spans = [range(places[k][air.low[k]], places[k][air.high[k]]) for k in range(3)]
        for cell in product(*spans):
            cells[cell] = air
    return cells


def solid_cells(planes, cells, outside):
    """From the cells that are solid to the textures wanted on their six sides; None where nothing shows."""
    counts = [len(values) - 1 for values in planes]
    solid = {}
    for cell in product(*map(range, counts)):
        if cell in cells:
            continue
        wanted = []
        for direction in DIRECTIONS:
            axis, step = "xyz".index(direction[1]), 1 if direction[0] == "+" else -1
            beside = cell[:axis] + (cell[axis] + step,) + cell[axis + 1 :]
            opposite = ("-" if step > 0 else "+") + direction[1]
            air = cells.get(beside)
            if air is not None:
                wanted.append(wanted_texture(air, opposite))
            else:
                wanted.append(None if 0 <= beside[axis] < counts[axis] else outside)
        solid[cell] = wanted
    return solid


def joined_sides(sides, more, keep):
    """The textures of a box that grows by a cell: those of `keep` must go together, others are the cell's."""
    result = list(sides)
    for index in range(6):
        if index not in keep:
            continue
        if result[index] is not None and more[index] is not None and result[index] != more[index]:
            return None
        result[index] = result[index] or more[index]
    return result


def grow(solid, free, cell, order):
    """The largest box from a cell on that growing along the axes in this order comes to, and its textures."""
    low, high = list(cell), [k + 1 for k in cell]
    sides = list(solid[cell])
    for axis in order:
        while True:
            spans = [range(low[k], high[k]) for k in range(3)]
            spans[axis] = range(high[axis], high[axis] + 1)
            trial = list(sides)
            trial[2 * axis + 1] = None
            keep = [index for index in range(6) if index != 2 * axis]
            for beside in product(*spans):
                trial = joined_sides(trial, solid[beside], keep) if beside in free else None
                if trial is None:
                    break
            if trial is None:
                break
            sides = trial
            high[axis] += 1
    return low, high, sides


def partition(solid, order):
    """Boxes of cells that hold every solid cell once."""
    free, boxes = set(solid), []
    for cell in sorted(solid):
        if cell not in free:
            continue
        low, high, sides = grow(solid, free, cell, order)
        free.difference_update(product(*(range(low[k], high[k]) for k in range(3))))
        boxes.append((low, high, sides))
    return boxes


def rock_around(airs, low, high, outside):
    """The brushes of the block from low to high without the air; the fewest that any order of axes comes to."""
    planes = cut_planes(airs, low, high)
    solid = solid_cells(planes, air_cells(airs, planes), outside)
    boxes = min((partition(solid, order) for order in permutations(range(3))), key=len)
    brushes = []
    for first, last, sides in boxes:
        spans = [(planes[k][first[k]], planes[k][last[k]]) for k in range(3)]
        textures = {direction: side or CAULK for direction, side in zip(DIRECTIONS, sides)}
        brushes.append(box(*spans, textures))
    return brushes
