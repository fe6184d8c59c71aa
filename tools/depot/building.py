# SPDX-License-Identifier: MIT
"""What is built into the rooms and carries weight: gallery, bridge, stairs, pillars, crane, dock, roofs, slopes."""

from depot.shapes import box, hull, octagon, prism

STEEL = "depot/steel"
DECK = {"top": "depot/deck", "": "depot/steel"}
SLAB = {"top": "depot/concrete", "side": "depot/hazard", "bottom": "depot/concrete_wall"}
STEP = {"top": "depot/concrete", "": "depot/concrete_wall"}
RAIL, RAIL_HIGH, POST = 4, 32, 64  # half a rail's width, its top above the floor, the most between two posts


def railing(axis, at, reach, floor):
    """Posts with two rails along an axis, centred on `at`."""
    across = (at - RAIL, at + RAIL)

    def piece(along, z):
        return box(along, across, z, STEEL) if axis == 0 else box(across, along, z, STEEL)

    length = reach[1] - reach[0] - 8
    count = -(-length // POST)
    starts = [reach[0] + length * k // count // 4 * 4 for k in range(count + 1)]
    posts = [piece((start, start + 8), (floor, floor + RAIL_HIGH)) for start in starts]
    rails = []
    for start, following in zip(starts, starts[1:]):
        rails.append(piece((start + 8, following), (floor + 24, floor + RAIL_HIGH)))
        rails.append(piece((start + 8, following), (floor + 10, floor + 14)))
    return posts + rails


def steps(axis, start, run, floor, count, across, depth=16):
    """A flight of `count` steps of 8 units with a sloped underside; `run` is a step's tread, negative downward the axis."""
    brushes = []
    for k in range(count):
        near, far = start + k * run, start + (k + 1) * run
        top = floor + (k + 1) * 8
        below = max(top - 8 - depth, floor), max(top - depth, floor)
        outline = [(near, below[0]), (far, below[1]), (far, top), (near, top)]
        if axis == 0:
            points = [(a, side, z) for a, z in outline for side in across]
        else:
            points = [(side, a, z) for a, z in outline for side in across]
        brushes.append(hull(points, STEP))
    return brushes


def slope_rail(axis, ends, heights, across):
    """A sloped band of steel beside a flight, from (ends[0], heights[0]) to (ends[1], heights[1])."""
    points = []
    for end, height in zip(ends, heights):
        for z in (height, height + RAIL_HIGH):
            for side in across:
                points.append((end, side, z) if axis == 0 else (side, end, z))
    return hull(points, STEEL)


def gallery():
    """Round the west half of the hall, on z = 128, with a flight of steps from its south end down to the floor."""
    slabs = [
        box((0, 88), (0, 448), (112, 128), DECK),
        box((88, 256), (0, 88), (112, 128), DECK),
        box((88, 320), (360, 448), (112, 128), DECK),
    ]
    rails = railing(1, 84, (88, 360), 128) + railing(0, 84, (88, 256), 128) + railing(0, 364, (88, 320), 128)
    rails += railing(1, 316, (368, 448), 128)
    rails += railing(1, 252, (64, 88), 128)
    flight = steps(0, 448, -12, 0, 16, (0, 64))
    band = slope_rail(0, (436, 256), (8, 128), (64, 68))
    return slabs + rails + flight + [band]


def bridge():
    """From wall to wall across the hall; it touches nothing but the two walls."""
    deck = [box((416, 480), (0, 448), (112, 128), DECK)]
    beams = [box(x, (0, 448), (96, 112), STEEL) for x in ((416, 424), (472, 480))]
    rails = railing(1, 420, (8, 440), 128) + railing(1, 476, (8, 440), 128)
    return deck + beams + rails


def pillars():
    """Eight-sided, from the hall's floor to its roof, on square feet; and two under the dock's roof."""
    brushes = []
    for x in (152, 240, 608, 736):
        for y in (104, 344):
            brushes.append(prism(2, (16, 320), octagon((x, y), 16, 8), "depot/concrete_wall"))
            brushes.append(box((x - 24, x + 24), (y - 24, y + 24), (0, 16), "depot/hazard"))
    for y in (88, 360):
        brushes.append(prism(2, (0, 192), octagon((1016, y), 16, 8), "depot/hazard"))
    return brushes


def crane():
    """Rails on both long walls of the hall, a girder across, its trolley and hook."""
    girder = [box(x, (0, 448), (264, 296), "depot/crane_yellow") for x in ((512, 520), (544, 552))]
    rails = [box((0, 832), y, (248, 264), STEEL) for y in ((0, 24), (424, 448))]
    trolley = box((504, 560), (288, 336), (296, 308), "depot/rust")
    cable = box((528, 536), (308, 316), (176, 296), STEEL)
    hook = hull([(532 + a, 312 + b, 176) for a, b in ((-16, -8), (16, -8), (16, 8), (-16, 8))]
                + [(532, 304, 144), (532, 320, 144)], "depot/rust")
    return girder + rails + [trolley, cable, hook]


def roof_frames():
    """Sloped haunches under the hall's roof along both walls, and frames across."""
    brushes = []
    for y, inner in ((0, 80), (448, 368)):
        brushes.append(prism(0, (0, 832), [(y, 280), (y, 320), (inner, 320)], "depot/roof_sheet"))
    for x in (64, 312, 400, 768):
        brushes.append(box((x, x + 12), (0, 448), (304, 320), STEEL))
    return brushes


def sawtooth():
    """Three sheds of glassless sawtooth roof, a parapet round the hall's roof and a chimney."""
    brushes = []
    for x in (0, 304, 432, 736):
        brushes.append(prism(1, (64, 384), [(x, 352), (x + 96, 352), (x + 96, 400)], {"": "depot/roof", "+x": "depot/facade"}))
    cap = "depot/facade"
    brushes += [box((848, 864), y, (352, 376), cap) for y in ((-32, 392), (440, 480))]
    brushes.append(box((1264, 1280), (16, 480), (224, 248), cap))
    brushes.append(prism(2, (224, 448), octagon((936, 400), 32, 16), "depot/brick_dark"))
    return brushes


def roof_stairs():
    """Outer flights of steps: from the yard to the dock's roof, and from there to the hall's."""
    brushes = steps(1, -416, 12, -32, 32, (1280, 1336))
    brushes.append(slope_rail(1, (-404, -32), (-24, 224), (1336, 1340)))
    brushes.append(box((1280, 1340), (-32, 16), (208, 224), DECK))
    brushes += railing(1, 1336, (-32, 16), 224) + railing(0, 12, (1280, 1332), 224)
    brushes += steps(1, 200, 12, 224, 16, (864, 904))
    brushes.append(slope_rail(1, (212, 392), (232, 352), (904, 908)))
    brushes.append(box((864, 908), (392, 440), (336, 352), DECK))
    brushes += railing(1, 904, (392, 440), 352) + railing(0, 436, (864, 900), 352)
    return brushes


def dock():
    """The platform of the loading dock, steps and a ramp from the bay up to it, bumpers, and a roof over the gate."""
    brushes = [box((864, 1056), (0, 448), (-32, 0), SLAB)]
    brushes += steps(0, 1092, -12, -32, 3, (400, 448), 32)
    brushes.append(prism(1, (0, 64), [(1056, -32), (1184, -32), (1056, 0)], "depot/concrete_dark"))
    for y in (120, 216, 312):
        brushes.append(box((1056, 1064), (y, y + 16), (-24, -8), "depot/rubber"))
    brushes.append(prism(1, (80, 368), [(1280, 128), (1280, 144), (1344, 128)], "depot/rust"))
    return brushes


def stairwell():
    """Two turning flights: from the cellar to the hall, and from there to the gallery."""
    west, east, south = (-224, -136), (-120, -32), (96, 160)
    brushes = steps(1, 160, 12, -160, 10, west)
    brushes.append(box((-224, -32), (280, 352), (-96, -80), STEP))
    brushes += steps(1, 280, -12, -80, 10, east)
    brushes.append(box((-224, -32), south, (-16, 0), STEP))
    brushes += steps(1, 160, 12, 0, 8, west)
    brushes.append(box((-224, -32), (256, 352), (48, 64), STEP))
    brushes += steps(1, 256, -12, 64, 8, east)
    brushes.append(box((-224, -32), south, (112, 128), STEP))
    brushes.append(box((-136, -120), (160, 280), (-160, -16), "depot/plaster"))
    brushes.append(box((-136, -120), (160, 256), (-16, 160), "depot/plaster"))
    brushes += railing(0, 156, (-224, -136), 128)
    return brushes


def tunnel_slopes():
    """Floor and roof of the tunnel's two slopes, and what takes the edge off its corners."""
    brushes = []
    low, high = -672, -576
    for x, z in (((512, 832), (-160, -112)), ((832, 1152), (-112, -32))):
        brushes.append(prism(1, (low, high), [(x[0], z[0]), (x[1], z[0]), (x[1], z[1])], "depot/rock_floor"))
        roof = [(x[0], z[0] + 88), (x[0], z[1] + 88), (x[1], z[1] + 88)]
        brushes.append(prism(1, (low, high), roof, "depot/rock"))
    bends = [(416, -160), (512, -160), (832, -112), (1152, -32), (1248, -32)]
    for (x0, z0), (x1, z1) in zip(bends, bends[1:]):
        for wall, turn in ((low, 1), (high, -1)):
            for across, foot in ((24, 0), (32, 88)):
                lift = 16 if foot == 0 else -24
                points = []
                for x, z in ((x0, z0), (x1, z1)):
                    corner = z + foot
                    points += [(x, wall, corner), (x, wall + turn * across, corner), (x, wall, corner + lift)]
                brushes.append(hull(points, "depot/rock"))
    return brushes + tunnel_frames()


def tunnel_frames():
    """Props and beams of timber in the tunnel, their feet in its floor."""
    brushes = []
    for x, floor in ((464, -160), (592, -148), (720, -128), (848, -108), (976, -76), (1104, -44), (1200, -32)):
        for y in ((-656, -644), (-604, -592)):
            brushes.append(box((x, x + 12), y, (floor - 4, floor + 72), "depot/timber"))
        brushes.append(box((x, x + 12), (-664, -584), (floor + 72, floor + 84), "depot/timber"))
    return brushes


def anchors():
    """Volumes in which nothing falls: what reaches into one is held. Roof, stairs, gallery's west end, chimney's foot."""
    name = "common/anchor"
    return [
        box((-32, 832), (0, 448), (312, 344), name),
        box((-224, -32), (96, 352), (-160, 128), name),
        box((-16, 16), (0, 448), (104, 136), name),
        box((896, 976), (360, 440), (208, 232), name),
    ]
