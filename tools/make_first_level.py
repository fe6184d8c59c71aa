# SPDX-License-Identifier: MIT
"""Writes levels/first.obj: one closed mesh around the air of a place carved into rock.

    /usr/bin/python3 tools/make_first_level.py -o levels/first.obj

How it works. The air is built from pieces. Every piece is a box of air, cut
by planes into a lattice of cells; some cells can be solid (the bridge, the
pillars), and a move can displace the lattice points (bumpy ground, stairs,
the tunnel, the octagonal pillars). On its own every piece is closed: there is
a face wherever an air cell meets a solid cell or the outside of the piece,
wound so that its corners run counter-clockwise as seen from the air.

Where two pieces touch through the very same face, the two copies (of opposite
winding) are both dropped: that is how doorways open. Touching pieces share
their planes, so the faces do match, and no corner of one face can end up in
the inside of an edge of another.

All coordinates are integers in steps of 1/4096 m, so every check is exact.
Axes: x east, y north, z up. Nothing depends on hash order, and the random
numbers have fixed seeds.
"""

import argparse
import random
import sys
from typing import Callable, NamedTuple

STEPS_PER_METRE = 4096
AXES = (0, 1, 2)
DECIMALS = 12  # 1/4096 has exactly twelve decimals

Point = tuple[int, int, int]
Move = Callable[[Point], Point]


class CheckFailed(Exception):
    """Raised when the mesh is not what it has to be."""


def metres(value):
    """Turns metres into steps; the value must be an exact multiple of a step."""
    steps = value * STEPS_PER_METRE
    if steps != int(steps):
        raise ValueError(f"{value} m is not a multiple of 1/{STEPS_PER_METRE} m")
    return int(steps)


PANEL = metres(2)       # flat walls are cut into panels no longer than this
PANEL_SNAP = metres(1 / 16)
THIN_WALL = 205         # 5 cm, snapped to the step: 205/4096 m = 0.050048828125 m


class Materials(NamedTuple):
    """Surface names for the outer sides of a piece."""

    floor: str = "floor"
    wall: str = "wall"
    ceiling: str = "ceiling"


class Solid(NamedTuple):
    """A box of rock left standing inside a piece."""

    low: Point
    high: Point
    material: str


class Face(NamedTuple):
    """A polygon, counter-clockwise as seen from the air cell that owns it."""

    group: str
    material: str
    corners: tuple
    cell: tuple


class Piece:
    """A box of air with lattice planes, solid boxes and a move."""

    def __init__(self, name, x, y, z, materials=Materials(), solids=()):
        self.name = name
        self.low = (x[0], y[0], z[0])
        self.high = (x[1], y[1], z[1])
        self.materials = materials
        self.solids = list(solids)
        self.planes = [[self.low[axis], self.high[axis]] for axis in AXES]
        self.move: Move = lambda point: point
        self.extra_faces = lambda: []
        for solid in self.solids:
            for axis in AXES:
                self.add_plane(axis, solid.low[axis])
                self.add_plane(axis, solid.high[axis])

    def add_plane(self, axis, position):
        """Adds a plane if it is new and crosses the piece; says whether it did."""
        planes = self.planes[axis]
        if position in planes or not self.low[axis] < position < self.high[axis]:
            return False
        planes.append(position)
        planes.sort()
        return True

    def fill_planes(self):
        """Cuts wide gaps between planes into even panels."""
        for axis in AXES:
            planes = self.planes[axis]
            filled = planes[:1]
            for start, end in zip(planes, planes[1:]):
                filled += even_cuts(start, end) + [end]
            self.planes[axis] = filled


# ---------------------------------------------------------------------------
# Small geometry helpers, all in integers.


def subtract(a, b):
    """The vector from b to a."""
    return (a[0] - b[0], a[1] - b[1], a[2] - b[2])


def dot(a, b):
    """The scalar product."""
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def cross(a, b):
    """The vector product."""
    return (
        a[1] * b[2] - a[2] * b[1],
        a[2] * b[0] - a[0] * b[2],
        a[0] * b[1] - a[1] * b[0],
    )


def area_normal(corners):
    """Twice the polygon's area vector (zero when the area is zero)."""
    total = (0, 0, 0)
    first = corners[0]
    for second, third in zip(corners[1:], corners[2:]):
        part = cross(subtract(second, first), subtract(third, first))
        total = (total[0] + part[0], total[1] + part[1], total[2] + part[2])
    return total


def is_planar(corners):
    """Whether all corners lie in exactly one plane."""
    normal = area_normal(corners)
    return all(dot(normal, subtract(corner, corners[0])) == 0 for corner in corners)


def edges_of(corners):
    """The directed edges of a polygon."""
    return zip(corners, corners[1:] + corners[:1])


def even_cuts(start, end):
    """Positions between start and end, so that no gap is longer than a panel."""
    count = -(-(end - start) // PANEL)
    cuts = []
    for index in range(1, count):
        exact = start + (end - start) * index // count
        cuts.append(exact // PANEL_SNAP * PANEL_SNAP)
    return cuts


def holds_point(piece, point):
    """Whether the point is in the closed box of the piece."""
    return all(piece.low[axis] <= point[axis] <= piece.high[axis] for axis in AXES)


def other_axes(axis):
    """The two axes after this one, in turning order."""
    return (axis + 1) % 3, (axis + 2) % 3


def touching_axis(a, b):
    """The axis across which two boxes share part of a side, or None."""
    for axis in AXES:
        meets = a.high[axis] == b.low[axis] or b.high[axis] == a.low[axis]
        if meets and all(
            max(a.low[other], b.low[other]) < min(a.high[other], b.high[other])
            for other in other_axes(axis)
        ):
            return axis
    return None


# ---------------------------------------------------------------------------
# From pieces to faces.


def share_planes(pieces):
    """Gives touching pieces the same planes where they touch, then fills the gaps."""
    pairs = []
    for index, a in enumerate(pieces):
        for b in pieces[index + 1 :]:
            axis = touching_axis(a, b)
            if axis is not None:
                pairs.append((a, b, axis))
    changed = True
    while changed:
        changed = False
        for a, b, axis in pairs:
            for other in other_axes(axis):
                for giver, taker in ((a, b), (b, a)):
                    for position in list(giver.planes[other]):
                        changed |= taker.add_plane(other, position)
    for piece in pieces:
        piece.fill_planes()


def solid_at(piece, cell):
    """The solid box that covers a cell of the lattice, or None."""
    low = [piece.planes[axis][cell[axis]] for axis in AXES]
    high = [piece.planes[axis][cell[axis] + 1] for axis in AXES]
    for solid in piece.solids:
        if all(solid.low[a] <= low[a] and high[a] <= solid.high[a] for a in AXES):
            return solid
    return None


def without_repeats(corners):
    """Drops corners equal to the one before (a move may have joined them)."""
    return tuple(c for c, before in zip(corners, corners[-1:] + corners[:-1]) if c != before)


def cell_side(piece, cell, axis, side):
    """The moved corners of one side of a cell, counter-clockwise seen from inside it."""
    u, v = other_axes(axis)
    corners = []
    for step_u, step_v in ((0, 0), (1, 0), (1, 1), (0, 1)):
        index = list(cell)
        index[axis] += side
        index[u] += step_u
        index[v] += step_v
        corners.append(tuple(piece.planes[a][index[a]] for a in AXES))
    if side == 1:
        corners.reverse()
    return without_repeats(tuple(piece.move(corner) for corner in corners))


def outer_material(piece, axis, side):
    """The material of a side of the whole piece."""
    if axis != 2:
        return piece.materials.wall
    return piece.materials.ceiling if side == 1 else piece.materials.floor


def piece_cells(piece):
    """All cells of the lattice: a dict from the cell to its solid box (None for air)."""
    counts = [len(piece.planes[axis]) - 1 for axis in AXES]
    return {
        (i, j, k): solid_at(piece, (i, j, k))
        for i in range(counts[0])
        for j in range(counts[1])
        for k in range(counts[2])
    }


def piece_faces(piece):
    """Returns the closed faces of a piece and the pairs of air cells that adjoin."""
    cells = piece_cells(piece)
    faces, links = [], []
    for cell, solid in cells.items():
        if solid is not None:
            continue
        for axis in AXES:
            for side in (0, 1):
                beside = list(cell)
                beside[axis] += 1 if side == 1 else -1
                beside = tuple(beside)
                if beside in cells and cells[beside] is None:
                    links.append(((piece.name, cell), (piece.name, beside)))
                    continue
                if beside in cells:
                    material = cells[beside].material
                else:
                    material = outer_material(piece, axis, side)
                corners = cell_side(piece, cell, axis, side)
                if len(corners) >= 3:
                    faces.append(Face(piece.name, material, corners, (piece.name, cell)))
    return faces + piece.extra_faces(), links


def turned_key(corners):
    """The corners, turned to start at the smallest: the same for equal polygons."""
    start = corners.index(min(corners))
    return corners[start:] + corners[:start]


def open_passages(faces):
    """Drops every pair of faces that differ only in winding; returns the air they join."""
    by_key = {turned_key(face.corners): face for face in faces}
    if len(by_key) != len(faces):
        raise CheckFailed("two faces are the same")
    kept, links = [], []
    for face in faces:
        partner = by_key.get(turned_key(face.corners[::-1]))
        if partner is None:
            kept.append(face)
        else:
            links.append((face.cell, partner.cell))
    return kept, links


def split_bent(faces):
    """Splits quads that are not exactly planar along their shorter diagonal."""
    result = []
    for face in faces:
        c = face.corners
        if len(c) == 3 or is_planar(c):
            result.append(face)
            continue
        first, second = subtract(c[2], c[0]), subtract(c[3], c[1])
        if dot(first, first) <= dot(second, second):
            halves = ((c[0], c[1], c[2]), (c[0], c[2], c[3]))
        else:
            halves = ((c[0], c[1], c[3]), (c[1], c[2], c[3]))
        result += [face._replace(corners=half) for half in halves]
    return result


# ---------------------------------------------------------------------------
# Moves: how the lattice points of some pieces are displaced.


def rough_move(piece, neighbours, seed, amounts):
    """Pushes points of the outer sides into the piece by random lengths.

    `amounts` gives the largest push for (axis, side). Only points that lie on
    exactly one side move, so the edges of the box stay straight, and points of
    the openings to neighbours stay where they are.
    """
    rng = random.Random(seed)
    moved = {}
    for x in piece.planes[0]:
        for y in piece.planes[1]:
            for z in piece.planes[2]:
                point = (x, y, z)
                share = rng.random()
                sides = [(a, 0) for a in AXES if point[a] == piece.low[a]]
                sides += [(a, 1) for a in AXES if point[a] == piece.high[a]]
                if len(sides) != 1 or any(holds_point(n, point) for n in neighbours):
                    continue
                axis, side = sides[0]
                push = int(share * amounts.get((axis, side), 0))
                goal = list(point)
                goal[axis] += push if side == 0 else -push
                moved[point] = tuple(goal)
    return lambda point: moved.get(point, point)


def smooth_noise(seed, spacing, height):
    """A smooth random height over (x, y), between -height and height."""
    rng = random.Random(seed)
    size = 64
    table = [rng.random() * 2 - 1 for _ in range(size * size)]

    def at_node(i, j):
        return table[i % size * size + j % size]

    def noise(x, y):
        i, j = x // spacing, y // spacing
        u, v = (x - i * spacing) / spacing, (y - j * spacing) / spacing
        u, v = u * u * (3 - 2 * u), v * v * (3 - 2 * v)
        near = at_node(i, j) * (1 - u) + at_node(i + 1, j) * u
        far = at_node(i, j + 1) * (1 - u) + at_node(i + 1, j + 1) * u
        return height * (near * (1 - v) + far * v)

    return noise


def gap_to(piece, x, y):
    """The larger of the distances in x and y from a point to a piece's plan."""
    gap_x = max(piece.low[0] - x, 0, x - piece.high[0])
    gap_y = max(piece.low[1] - y, 0, y - piece.high[1])
    return max(gap_x, gap_y)


def ground_move(piece, neighbours, seed, rough):
    """Bumpy ground: lifts columns of points, all at the floor and none at the top.

    Points only rise or sink here, so upright walls stay exactly planar. The
    ground is level near the openings.
    """
    broad = smooth_noise(seed, metres(9), metres(1.75))
    fine = smooth_noise(seed + 1, metres(3), metres(0.375))
    level_until, full_from = metres(1), metres(6)
    top, height = piece.high[2], piece.high[2] - piece.low[2]

    def move(point):
        x, y, z = point
        gap = min(gap_to(neighbour, x, y) for neighbour in neighbours)
        share = (min(max(gap, level_until), full_from) - level_until) / (full_from - level_until)
        lift = int(share * (broad(x, y) + fine(x, y)))
        moved = rough(point)
        return (moved[0], moved[1], moved[2] + lift * (top - z) // height)

    return move


def tunnel_move(piece, drop, bow, rough):
    """Leads a straight tunnel along x down by `drop`, and in a bow to the north.

    Every ring of points is moved as a whole: floor quads become exact
    parallelograms and so stay planar.
    """
    start, run = piece.low[0], piece.high[0] - piece.low[0]

    def move(point):
        along = point[0] - start
        x, y, z = rough(point)
        return (x, y + 4 * bow * along * (run - along) // (run * run), z - drop * along // run)

    return move


def octagon_move(pillars, chamfer):
    """Turns square pillars, solid in the shape of a plus, into octagonal ones.

    Each inward corner of the plus is joined to the end of one of its arms, so
    that a slanted face remains between the ends of two arms.
    """
    joined = {}
    for x0, x1, y0, y1 in pillars:
        for outer_x, inner_x in ((x0, x0 + chamfer), (x1, x1 - chamfer)):
            for inner_y in (y0 + chamfer, y1 - chamfer):
                joined[(inner_x, inner_y)] = (outer_x, inner_y)

    def move(point):
        x, y = joined.get((point[0], point[1]), (point[0], point[1]))
        return (x, y, point[2])

    return move


# ---------------------------------------------------------------------------
# Stairs: a sloped passage with a wedge of air cut below it for every step.


def facing(corners, inside):
    """The corners, wound to be counter-clockwise as seen from an inside point.

    `inside` is the sum of six points of the body (its centre times six).
    """
    p = corners[0]
    towards = (inside[0] - 6 * p[0], inside[1] - 6 * p[1], inside[2] - 6 * p[2])
    return corners if dot(area_normal(corners), towards) > 0 else corners[::-1]


def step_faces(name, index, near, far):
    """The closed prism of air below the slope, over one tread.

    `near` and `far` are its two triangles: (front of the tread, back of the
    tread, top of the riser), one at either side.
    """
    inside = tuple(sum(point[axis] for point in near + far) for axis in AXES)
    (a, b, c), (d, e, f) = near, far
    sides = [
        ("stairs", (a, b, e, d)),  # tread
        ("stairs", (b, c, f, e)),  # riser
        ("stairs", (c, a, d, f)),  # slope: meets the floor of the passage
        ("wall", near),
        ("wall", far),
    ]
    cell = (name, "step", index)
    return [Face(name, material, facing(c, inside), cell) for material, c in sides]


def stairs(name, axis, x, y, z, step_count, step_rise):
    """Stairs that climb along +x (axis 0) or +y (axis 1); x, y, z as at the foot."""
    piece = Piece(name, x, y, z, Materials(floor="stairs"))
    across = 1 - axis
    start = piece.low[axis]
    tread = (piece.high[axis] - start) // step_count
    if start + tread * step_count != piece.high[axis]:
        raise ValueError(f"{name}: the run is not a multiple of the steps")
    for index in range(1, step_count):
        piece.add_plane(axis, start + index * tread)
    piece.fill_planes()

    def move(point):
        lift = step_rise * (point[axis] - start) // tread
        return (point[0], point[1], point[2] + lift)

    def triangle(position, index):
        front = [0, 0, piece.low[2] + index * step_rise]
        front[axis], front[across] = start + index * tread, position
        back = list(front)
        back[axis] += tread
        top = list(back)
        top[2] += step_rise
        return (tuple(front), tuple(back), tuple(top))

    def wedges():
        faces = []
        for index in range(step_count):
            for near, far in zip(piece.planes[across], piece.planes[across][1:]):
                number = len(faces)
                faces += step_faces(name, number, triangle(near, index), triangle(far, index))
        return faces

    piece.move = move
    piece.extra_faces = wedges
    return piece


# ---------------------------------------------------------------------------
# The place itself, in metres.


def span(start, end):
    """A range in metres, as steps."""
    return (metres(start), metres(end))


def room(name, x, y, z, materials=Materials(), solids=()):
    """A box of air given in metres."""
    return Piece(name, span(*x), span(*y), span(*z), materials, solids)


def block(x, y, z, material):
    """A solid box given in metres."""
    low = tuple(metres(pair[0]) for pair in (x, y, z))
    high = tuple(metres(pair[1]) for pair in (x, y, z))
    return Solid(low, high, material)


def hall():
    """The hall: a bridge from wall to wall, two square and four octagonal pillars."""
    height = (0, 9.5)
    chamfer = 0.4375
    solids = [block((20, 44), (27, 31), (4.5, 5), "bridge")]
    octagons = []
    for y in (22.75, 33.75):
        solids.append(block((31.25, 32.75), (y, y + 1.5), height, "pillar"))
        for x in (24.25, 38.25):
            inner_x = (x + chamfer, x + 1.5 - chamfer)
            inner_y = (y + chamfer, y + 1.5 - chamfer)
            solids.append(block((x, x + 1.5), inner_y, height, "pillar"))
            solids.append(block(inner_x, (y, y + 1.5), height, "pillar"))
            octagons.append(span(x, x + 1.5) + span(y, y + 1.5))
    piece = room("hall", (20, 44), (20, 38), height, solids=solids)
    piece.move = octagon_move(octagons, metres(chamfer))
    return piece


def rooms():
    """The indoor places apart from the hall."""
    thin_x = (metres(10), metres(10) + THIN_WALL)
    door_z, side_y = (0, 2.5), (25, 26.5)
    upper_y, upper_z = (27.75, 30.25), (5, 7.5)
    table = block((49, 50.75), (23, 24.5), (0, 1.25), "rock")
    post = block((36, 37), (43, 44), (0, 4.5), "pillar")
    return [
        room("room_a", (2, 10), (22, 30), (0, 3.5)),
        Piece("thin_door", thin_x, span(23, 24.5), span(*door_z)),
        Piece("room_b", (thin_x[1], metres(19)), span(22, 31), span(0, 3.5)),
        room("door_b_hall", (19, 20), side_y, door_z),
        room("window_b_hall", (19, 20), upper_y, (1.25, 2.5)),
        room("room_c", (22, 30), (39, 45), (0, 3.5)),
        room("door_c_hall", (27.5, 29), (38, 39), door_z),
        room("door_c_d", (30, 31), (41, 42.5), door_z),
        room("room_d", (31, 43), (39, 48), (0, 4.5), solids=[post]),
        room("door_d_hall", (41, 42.5), (38, 39), door_z),
        room("room_e", (45, 53), (21, 31), (0, 3.5), solids=[table]),
        room("door_e_hall", (44, 45), side_y, door_z),
        room("gallery", (12, 19), (25, 39), (5, 8.5)),
        room("door_gallery_bridge", (19, 20), upper_y, upper_z),
        room("door_bridge_loft", (44, 45), upper_y, upper_z),
        room("loft", (45, 53), (25, 33), (5, 8.75)),
        room("foot_of_stairs", (4, 6), (30, 31), door_z),
        room("turn_of_stairs", (4, 6), (34.125, 34.5), (2.5, 5)),
        room("landing", (3, 7), (34.5, 38.5), (2.5, 5.75)),
        room("door_landing", (7, 7.5), (35.5, 37.5), (2.5, 5)),
        room("head_of_stairs", (10.625, 12), (35.5, 37.5), (5, 7.5)),
    ]


def flights():
    """Two flights of ten steps each: from room_a to the landing, and to the gallery."""
    rise = metres(0.25)
    return [
        stairs("stairs_lower", 1, span(4, 6), span(31, 34.125), span(0, 2.5), 10, rise),
        stairs("stairs_upper", 0, span(7.5, 10.625), span(35.5, 37.5), span(2.5, 5), 10, rise),
    ]


def rocky_places():
    """The cave at the foot of the tunnel, and the passages of bare rock."""
    rock = Materials("rock", "rock", "rock")
    cave = room("cave", (72, 79), (25, 34), (0, 4.5), rock)
    return cave, [
        room("mouth_upper", (53, 54), (27.75, 30.25), (5, 7.5), rock),
        room("mouth_lower", (71, 72), (27.75, 30.25), (0, 2.5), rock),
        room("passage_cave", (74, 76.5), (14, 25), (0, 2.5), rock),
        room("passage_room_e", (47.5, 49), (14, 21), (0, 2.5), rock),
        room("gate", (34, 37.5), (14, 20), (0, 3.75), rock),
    ]


def tunnel():
    """The sloped tunnel: leaves the loft at z = 5 m and reaches the cave at z = 0."""
    rock = Materials("rock", "rock", "rock")
    piece = room("tunnel", (54, 71), (27.75, 30.25), (5, 7.5), rock)
    for index in range(1, 16):
        piece.add_plane(0, metres(54) + index * metres(17) // 16)
    piece.fill_planes()
    push = metres(0.25)
    amounts = {(1, 0): push, (1, 1): push, (2, 1): push}
    rough = rough_move(piece, [], 11, amounts)
    piece.move = tunnel_move(piece, metres(5), metres(3), rough)
    return piece


def outdoors():
    """The open air: ground, cliffs and a closed sky, with an arch and rocks standing in it."""
    materials = Materials("ground", "rock", "sky")
    solids = [
        block((56, 57.5), (-5, -3), (0, 3.75), "rock"),
        block((61, 62.5), (-5, -3), (0, 3.75), "rock"),
        block((56, 62.5), (-5, -3), (3.75, 5), "rock"),
        block((34, 37.5), (-5, -3), (0, 2.5), "rock"),
        block((67, 74), (-5, -4), (0, 2.5), "rock"),
    ]
    return room("outdoors", (32, 78), (-10, 14), (0, 8.75), materials, solids)


def build_pieces():
    """All pieces of the level, with planes and moves set."""
    cave, passages = rocky_places()
    field = outdoors()
    level = [hall()] + rooms() + [cave] + passages + [field]
    share_planes(level)

    cave_push = {(0, 0): 0.5, (0, 1): 0.5, (1, 0): 0.5, (1, 1): 0.5, (2, 0): 0.1875, (2, 1): 0.75}
    cave_push = {side: metres(push) for side, push in cave_push.items()}
    cave.move = rough_move(cave, neighbours_of(cave, level), 23, cave_push)

    cliff = metres(0.75)
    beside = neighbours_of(field, level)
    cliffs = {(0, 0): cliff, (0, 1): cliff, (1, 0): cliff, (1, 1): cliff}
    field.move = ground_move(field, beside, 41, rough_move(field, beside, 42, cliffs))
    return level + flights() + [tunnel()]


def neighbours_of(piece, level):
    """The pieces that touch this one."""
    others = [other for other in level if other is not piece]
    return [other for other in others if touching_axis(piece, other) is not None]


# ---------------------------------------------------------------------------
# Checks. Each raises CheckFailed.


def require(condition, message):
    """Raises CheckFailed with the message unless the condition holds."""
    if not condition:
        raise CheckFailed(message)


def bounds_of(points):
    """The smallest box around points, as (low, high)."""
    low = tuple(min(point[axis] for point in points) for axis in AXES)
    high = tuple(max(point[axis] for point in points) for axis in AXES)
    return low, high


def check_pieces_apart(faces_by_piece):
    """No two pieces may overlap: compares the boxes around their moved points."""
    boxes = []
    for name, faces in faces_by_piece:
        boxes.append((name, bounds_of([corner for face in faces for corner in face.corners])))
    for index, (name, (low, high)) in enumerate(boxes):
        for other_name, (other_low, other_high) in boxes[index + 1 :]:
            overlap = all(
                max(low[a], other_low[a]) < min(high[a], other_high[a]) for a in AXES
            )
            require(not overlap, f"{name} and {other_name} overlap")


def check_air_connected(cells, links):
    """All air cells must be reachable from the first one."""
    beside = {cell: [] for cell in cells}
    for a, b in links:
        beside[a].append(b)
        beside[b].append(a)
    first = next(iter(beside))
    reached, waiting = {first}, [first]
    while waiting:
        for cell in beside[waiting.pop()]:
            if cell not in reached:
                reached.add(cell)
                waiting.append(cell)
    apart = sorted({cell[0] for cell in beside if cell not in reached})
    require(not apart, "air that cannot be reached in " + ", ".join(apart))


def check_faces(faces):
    """Every face must be exactly planar and strictly convex, with an area."""
    for face in faces:
        normal = area_normal(face.corners)
        require(normal != (0, 0, 0), f"face without area in {face.group}: {face.corners}")
        require(is_planar(face.corners), f"bent face in {face.group}: {face.corners}")
        require(len(face.corners) <= 4, "the test of convexity needs at most four corners")
        edges = [subtract(b, a) for a, b in edges_of(face.corners)]
        for edge, following in edges_of(tuple(edges)):
            turn = dot(cross(edge, following), normal)
            require(turn > 0, f"face not convex in {face.group}: {face.corners}")


def check_edges(faces):
    """Every directed edge must be used once, and its opposite once."""
    used = {}
    for face in faces:
        for edge in edges_of(face.corners):
            require(edge not in used, f"edge used twice in one direction: {edge}")
            used[edge] = face
    for a, b in used:
        require((b, a) in used, f"edge without its opposite: {a} {b} of {used[(a, b)].group}")


def check_corners(faces):
    """The faces around every vertex must form one ring (no two parts touch in a point)."""
    following = {}
    for face in faces:
        corners = face.corners
        befores = corners[-1:] + corners[:-1]
        afters = corners[1:] + corners[:1]
        for before, corner, after in zip(befores, corners, afters):
            following.setdefault(corner, {})[before] = after
    for corner, ring in following.items():
        start = next(iter(ring))
        here, count = ring[start], 1
        while here != start:
            here, count = ring[here], count + 1
        require(count == len(ring), f"two parts touch only in the point {corner}")


def check_no_t_joints(faces):
    """No vertex may lie in the inside of an edge."""
    side = metres(2)
    buckets = {}
    for vertex in unique_vertices(faces):
        buckets.setdefault(tuple(c // side for c in vertex), []).append(vertex)
    for face in faces:
        for a, b in edges_of(face.corners):
            if a > b:
                continue  # the opposite edge is looked at instead
            for vertex in vertices_near(buckets, side, a, b):
                require(not is_inside_edge(vertex, a, b), f"vertex {vertex} in edge {a} {b}")


def vertices_near(buckets, side, a, b):
    """The vertices in all buckets that the box around an edge touches."""
    low, high = bounds_of([a, b])
    for i in range(low[0] // side, high[0] // side + 1):
        for j in range(low[1] // side, high[1] // side + 1):
            for k in range(low[2] // side, high[2] // side + 1):
                yield from buckets.get((i, j, k), [])


def is_inside_edge(vertex, a, b):
    """Whether a vertex lies on the edge, strictly between its ends."""
    along, offset = subtract(b, a), subtract(vertex, a)
    if cross(along, offset) != (0, 0, 0):
        return False
    return 0 < dot(along, offset) < dot(along, along)


def check_one_surface(faces):
    """All faces must hang together through shared corners."""
    parent = {vertex: vertex for vertex in unique_vertices(faces)}

    def root(vertex):
        while parent[vertex] != vertex:
            parent[vertex] = parent[parent[vertex]]
            vertex = parent[vertex]
        return vertex

    for face in faces:
        for a, b in edges_of(face.corners):
            parent[root(a)] = root(b)
    roots = {root(vertex) for vertex in parent}
    require(len(roots) == 1, f"the surface is in {len(roots)} parts")


def signed_volume_times_six(faces):
    """Six times the signed volume that the faces enclose.

    By the divergence theorem this is the volume inside when the normals point
    out of it. Here they point into the air, so for a closed mesh around air
    the result must be negative: minus six times the volume of the air.
    """
    total = 0
    for face in faces:
        first = face.corners[0]
        for second, third in zip(face.corners[1:], face.corners[2:]):
            total += dot(first, cross(second, third))
    return total


def check_mesh(faces):
    """Runs all checks of the finished mesh."""
    check_faces(faces)
    check_edges(faces)
    check_corners(faces)
    check_no_t_joints(faces)
    check_one_surface(faces)
    require(signed_volume_times_six(faces) < 0, "the faces do not face into the air")


# ---------------------------------------------------------------------------
# Output.


def unique_vertices(faces):
    """All corners in the order of first use: a dict from the point to its number."""
    numbers = {}
    for face in faces:
        for corner in face.corners:
            numbers.setdefault(corner, len(numbers) + 1)
    return numbers


def decimal(steps):
    """A coordinate in metres as an exact decimal."""
    scaled = abs(steps) * (10**DECIMALS // STEPS_PER_METRE)
    whole, fraction = divmod(scaled, 10**DECIMALS)
    text = f"{whole}.{fraction:0{DECIMALS}d}".rstrip("0").rstrip(".")
    return "-" + text if steps < 0 else text


def obj_lines(faces):
    """The lines of the OBJ file."""
    vertices = unique_vertices(faces)
    yield "# SPDX-License-Identifier: MIT"
    yield "# Written by tools/make_first_level.py; change the script, not this file."
    yield "# One closed mesh around air carved into rock. Metres, z up, all coordinates"
    yield "# multiples of 1/4096. Corners are counter-clockwise as seen from the air."
    yield "# The wall between room_a and room_b is 205/4096 m thick (5 cm, snapped)."
    for point in vertices:
        yield "v " + " ".join(decimal(coordinate) for coordinate in point)
    group = material = None
    for face in faces:
        if face.group != group:
            group, material = face.group, None
            yield f"g {group}"
        if face.material != material:
            material = face.material
            yield f"usemtl {material}"
        yield "f " + " ".join(str(vertices[corner]) for corner in face.corners)


def print_summary(faces):
    """Says on stderr what was made."""
    vertices = unique_vertices(faces)
    low, high = bounds_of(list(vertices))
    volume = -signed_volume_times_six(faces) / 6 / STEPS_PER_METRE**3
    counts = {}
    for face in faces:
        counts[face.material] = counts.get(face.material, 0) + 1
    triangles = sum(len(face.corners) == 3 for face in faces)
    print(f"faces {len(faces)} ({triangles} triangles), vertices {len(vertices)}", file=sys.stderr)
    print("low  " + " ".join(decimal(c) for c in low), file=sys.stderr)
    print("high " + " ".join(decimal(c) for c in high), file=sys.stderr)
    print(f"volume of the air {volume:.3f} m^3", file=sys.stderr)
    print("by material: " + ", ".join(f"{m} {counts[m]}" for m in sorted(counts)), file=sys.stderr)


def make_faces():
    """Builds the level and checks it; returns its faces."""
    faces_by_piece, faces, links = [], [], []
    for piece in build_pieces():
        own_faces, own_links = piece_faces(piece)
        own_faces.sort(key=lambda face: face.material)
        faces_by_piece.append((piece.name, own_faces))
        faces += own_faces
        links += own_links
    check_pieces_apart(faces_by_piece)
    cells = [face.cell for face in faces] + [cell for link in links for cell in link]
    faces, opened = open_passages(faces)
    check_air_connected(cells, links + opened)
    faces = split_bent(faces)
    check_mesh(faces)
    return faces


def main():
    """Reads the command line, builds, checks and writes the level."""
    parser = argparse.ArgumentParser(description="Writes the first level as an OBJ file.")
    parser.add_argument("-o", "--output", help="the file to write (standard output without it)")
    options = parser.parse_args()
    try:
        faces = make_faces()
    except CheckFailed as failure:
        print(f"make_first_level.py: {failure}", file=sys.stderr)
        return 1
    text = "\n".join(obj_lines(faces)) + "\n"
    if options.output is None:
        sys.stdout.write(text)
    else:
        with open(options.output, "w", encoding="ascii", newline="\n") as file:
            file.write(text)
    print_summary(faces)
    return 0


if __name__ == "__main__":
    sys.exit(main())
