# SPDX-License-Identifier: MIT
"""Brushes as convex hulls of integer points, and how they are written in the Valve 220 form.

Every coordinate is an integer in map units, so every plane is exact. A side is three corners of the hull and a
texture; they run clockwise as seen from outside, as Quake has it.
"""

from itertools import combinations
from math import gcd
from typing import NamedTuple

Point = tuple[int, int, int]

CAULK = "common/caulk"
SKIP = "common/skip"
PORTAL = "common/portal"


class Side(NamedTuple):
    """A plane by three points, and what is on it."""

    points: tuple[Point, Point, Point]
    texture: str


class Brush(NamedTuple):
    """The common part of its sides' half spaces."""

    sides: tuple[Side, ...]


def subtract(a, b):
    """The vector from b to a."""
    return (a[0] - b[0], a[1] - b[1], a[2] - b[2])


def cross(a, b):
    """The cross product."""
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def dot(a, b):
    """The scalar product."""
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def direction_of(normal):
    """'+x' to '-z': the axis that a normal follows most; a slope of 45 degrees counts as floor or ceiling."""
    axis = max((2, 0, 1), key=lambda k: abs(normal[k]))
    return ("+" if normal[axis] > 0 else "-") + "xyz"[axis]


def texture_for(textures, normal):
    """One texture for all sides, or a dict: by direction, else by 'top', 'bottom' and 'side', else by ''."""
    if isinstance(textures, str):
        return textures
    direction = direction_of(normal)
    part = {"+z": "top", "-z": "bottom"}.get(direction, "side")
    return textures.get(direction) or textures.get(part) or textures[""]


def hull(points, textures):
    """The brush around points: a side for every plane through three of them that has none in front of it."""
    sides = {}
    for a, b, c in combinations(points, 3):
        normal = cross(subtract(b, a), subtract(c, a))
        if normal == (0, 0, 0):
            continue
        heights = [dot(normal, subtract(point, a)) for point in points]
        if min(heights) < 0 < max(heights):
            continue
        if max(heights) == 0 == min(heights):
            raise ValueError(f"points in one plane: {points}")
        if max(heights) > 0:
            normal, b, c = (-normal[0], -normal[1], -normal[2]), c, b
        divisor = gcd(*normal)
        key = tuple(part // divisor for part in normal) + (dot(normal, a) // divisor,)
        sides.setdefault(key, Side((a, c, b), texture_for(textures, normal)))
    return Brush(tuple(sides[key] for key in sorted(sides)))


def box(x, y, z, textures):
    """The brush between two planes an axis; each is a pair (low, high)."""
    return hull([(i, j, k) for i in x for j in y for k in z], textures)


def prism(axis, reach, outline, textures):
    """A convex outline in the plane across an axis (of the other two in the order x, y, z), drawn out along it."""
    points = []
    for along in reach:
        for first, second in outline:
            point = [first, second]
            point.insert(axis, along)
            points.append(tuple(point))
    return hull(points, textures)


def octagon(centre, half, cut):
    """The outline of a square of twice `half` with corners cut off by `cut`."""
    near, far = half - cut, half
    turns = [(near, far), (far, near), (far, -near), (near, -far)]
    return [(centre[0] + sign * a, centre[1] + sign * b) for sign in (1, -1) for a, b in turns]


def portal(axis, at, lows, highs):
    """A thin brush whose side toward the low end of an axis is a portal, at `at`."""
    spans = [[low, high] for low, high in zip(lows, highs)]
    spans[axis] = [at, at + 2]
    return box(*spans, {"-" + "xyz"[axis]: PORTAL, "": SKIP})


# ---------------------------------------------------------------------------
# Text.


def texture_axes(normal):
    """The two axes that TrenchBroom gives a new face along its main direction."""
    return {
        "x": "[ 0 1 0 0 ] [ 0 0 -1 0 ]",
        "y": "[ 1 0 0 0 ] [ 0 0 -1 0 ]",
        "z": "[ 1 0 0 0 ] [ 0 -1 0 0 ]",
    }[direction_of(normal)[1]]


def brush_lines(brush):
    """The lines of a brush."""
    yield "{"
    for side in brush.sides:
        a, b, c = side.points
        normal = cross(subtract(c, a), subtract(b, a))
        points = " ".join("( %d %d %d )" % point for point in side.points)
        yield f"{points} {side.texture} {texture_axes(normal)} 0 1 1"
    yield "}"


def entity_lines(number, keys, brushes=()):
    """The lines of an entity, with the comments that TrenchBroom writes."""
    yield f"// entity {number}"
    yield "{"
    for key, value in keys:
        yield f'"{key}" "{value}"'
    for index, brush in enumerate(brushes):
        yield f"// brush {index}"
        yield from brush_lines(brush)
    yield "}"
