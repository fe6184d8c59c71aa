# SPDX-License-Identifier: MIT
"""What stands about: machines, crates, desks, lamps, a truck, rocks; glass, water and clips that are no room's."""

import random

from depot.building import STEEL, railing
from depot.shapes import box, hull, octagon, prism

CLIP = "common/clip"


def crate(x, y, z, size, texture="depot/crate"):
    """A cube on a floor."""
    return box((x, x + size), (y, y + size), (z, z + size), texture)


def hall_things():
    """Crates and pallets in the hall."""
    places = [(680, 176, 0, 40), (720, 184, 0, 40), (696, 180, 40, 32), (656, 232, 0, 32), (32, 280, 0, 48), (80, 296, 0, 32),
              (40, 288, 48, 32), (340, 200, 0, 40), (344, 240, 0, 32), (568, 24, 0, 48), (760, 24, 0, 40), (560, 392, 0, 40)]
    brushes = [crate(*place) for place in places]
    brushes.append(box((24, 96), (144, 216), (0, 8), "depot/wood"))
    brushes.append(prism(2, (8, 48), octagon((60, 180), 24, 12), "depot/drum"))
    return brushes


def dock_things():
    """Goods on the platform, and a truck that backs up to it."""
    brushes = [crate(*place) for place in [(888, 200, 0, 40), (888, 240, 0, 40), (892, 216, 40, 32), (936, 224, 0, 32),
                                           (880, 16, 0, 48), (928, 24, 0, 32)]]
    brushes += truck(1080, 184)
    return brushes


def truck(x, y):
    """Chassis, load bed, cab and six wheels, facing east; its bed is level with the dock's platform."""
    brushes = [box((x, x + 216), (y + 16, y + 64), (-16, -8), STEEL)]
    brushes.append(box((x, x + 136), (y, y + 80), (-8, 0), "depot/wood"))
    brushes += [box((x, x + 136), side, (0, 24), "depot/truck_blue") for side in ((y, y + 4), (y + 76, y + 80))]
    cab = [(x + 144, -8), (x + 216, -8), (x + 216, 24), (x + 200, 56), (x + 144, 56)]
    brushes.append(prism(1, (y, y + 80), cab, "depot/truck_blue"))
    for centre in (x + 24, x + 56, x + 184):
        for side in ((y, y + 16), (y + 64, y + 80)):
            brushes.append(prism(1, side, octagon((centre, -20), 12, 6), "depot/rubber"))
    return brushes


def table(x, y, z, height=24, texture="depot/wood"):
    """A top on two solid ends, along the first axis of the pairs (low, high)."""
    sides = [(x[0], x[0] + 4), (x[1] - 4, x[1])]
    top = box(x, y, (z + height - 4, z + height), texture)
    return [top] + [box(side, y, (z, z + height - 4), texture) for side in sides]


def chair(x, y, z, back):
    """A seat on a foot; its back stands to the north (1) or to the south (-1)."""
    side = (y + 12, y + 16) if back > 0 else (y, y + 4)
    return [box((x + 4, x + 12), (y + 4, y + 12), (z, z + 12), STEEL),
            box((x, x + 16), (y, y + 16), (z + 12, z + 16), "depot/chair"),
            box((x, x + 16), side, (z + 16, z + 32), "depot/chair")]


def offices():
    """The row of offices and the lockers, on the ground floor."""
    brushes = []
    for x, y in ((24, 592), (120, 592), (226, 600), (440, 624)):
        brushes += table((x, x + 64), (y, y + 32), 0) + chair(x + 24, y + 36, 0, 1)
    for x in (8, 32, 56, 376, 584):
        brushes.append(box((x, x + 16), (652, 672), (0, 48), "depot/cabinet"))
    brushes.append(box((240, 296), (480, 488), (8, 26), "depot/radiator"))
    brushes.append(box((464, 560), (668, 672), (40, 80), "depot/board"))
    brushes += table((544, 604), (500, 532), 0) + chair(568, 536, 0, 1)
    for x in range(640, 816, 20):
        brushes.append(box((x, x + 16), (648, 672), (0, 60), "depot/locker"))
    brushes += table((656, 800), (568, 584), 0, 16)
    brushes += [box((816, 832), (y, y + 24), (24, 32), "depot/porcelain") for y in (504, 544)]
    return brushes


def upper_offices():
    """The director's desk, the archive's shelves, a long table, boards and benches of the corridor."""
    brushes = table((40, 112), (640, 672), 128) + chair(68, 680, 128, 1) + chair(56, 616, 128, -1) + chair(84, 616, 128, -1)
    brushes.append(box((16, 160), (584, 696), (128, 129), "depot/carpet"))
    brushes += [box((176, 248), (720, 736), (z, z + 4), "depot/wood") for z in (148, 172, 196)]
    brushes += [box(side, (720, 736), (128, 204), "depot/wood") for side in ((172, 176), (248, 252))]
    for x in range(288, 528, 72):
        for y in (624, 696):
            brushes += [box((x, x + 48), (y, y + 20), (z, z + 4), "depot/wood") for z in (152, 176, 200)]
            brushes += [box(side, (y, y + 20), (128, 216), STEEL) for side in ((x - 4, x), (x + 48, x + 52))]
    for x, y, z in ((292, 626, 156), (364, 628, 180), (440, 700, 156), (508, 698, 204), (300, 700, 132)):
        brushes.append(box((x, x + 20), (y, y + 16), (z, z + 16), "depot/crate"))
    brushes += table((632, 776), (632, 672), 128, 28, "depot/drawing_table")
    for x in (648, 696, 744):
        brushes += chair(x, 676, 128, 1)
    brushes.append(box((828, 832), (600, 704), (160, 208), "depot/board"))
    brushes += [box((x, x + 64), (540, 544), (160, 192), "depot/board") for x in (216, 560)]
    brushes += table((32, 88), (528, 544), 128, 16) + table((600, 656), (528, 544), 128, 16)
    return brushes


def workshop():
    """Workbenches, a lathe, a tool cabinet, a pipe along the wall."""
    brushes = table((0, 32), (-272, -64), 0, 28) + table((32, 136), (-288, -256), 0, 28)
    brushes += [box((8, 16), (y, y + 12), (28, 36), STEEL) for y in (-240, -136)]
    brushes.append(box((96, 224), (-192, -136), (0, 24), STEEL))
    brushes.append(prism(0, (112, 176), octagon((-164, 36), 12, 6), "depot/machine_green"))
    brushes.append(box((176, 216), (-184, -144), (24, 52), "depot/machine_green"))
    brushes += [box((x, x + 32), (-288, -268), (0, 64), "depot/locker") for x in (200, 236, 272)]
    brushes.append(prism(0, (0, 320), octagon((-44, 92), 6, 2), "depot/pipe"))
    brushes.append(prism(2, (0, 86), octagon((308, -44), 6, 2), "depot/pipe"))
    return brushes


def cistern():
    """Railings round the basin, a ladder of rungs down into it, pumps and pipes; the water itself is basin()."""
    brushes = railing(0, -108, (444, 640), 0) + railing(0, -108, (704, 776), 0) + railing(0, -276, (440, 776), 0)
    brushes += railing(1, 772, (-272, -112), 0) + railing(1, 444, (-272, -112), 0)
    brushes += [box((648, 696), (-120, -112), (z, z + 4), STEEL) for z in range(-88, 0, 12)]
    brushes += [prism(0, (352, 832), octagon((y, z), 8, 4), "depot/pipe") for y, z in ((-332, 80), (-304, 88))]
    brushes.append(prism(2, (0, 72), octagon((424, -332), 10, 4), "depot/pipe"))
    for x in (512, 600):
        brushes.append(box((x, x + 40), (-344, -304), (0, 24), "depot/machine_green"))
        brushes.append(prism(2, (24, 74), octagon((x + 20, -332), 6, 2), "depot/pipe"))
    return brushes


def upper_south():
    """Batteries on a rack, and the control desks behind the windows to the hall."""
    brushes = []
    for x in range(88, 264, 48):
        brushes.append(box((x, x + 32), (-248, -216), (128, 168), "depot/machine_green"))
        brushes.append(box((x + 8, x + 24), (-256, -248), (140, 156), "depot/rubber"))
    brushes.append(box((64, 80), (-200, -72), (176, 184), "depot/pipe"))
    for x in (344, 480):
        outline = [(-64, 128), (-32, 128), (-32, 156), (-64, 148)]
        brushes.append(prism(0, (x, x + 72), outline, "depot/steel_panel"))
        brushes += chair(x + 28, -92, 128, -1)
    brushes += [box((x, x + 40), (-256, -232), (128, 200), "depot/cabinet") for x in (344, 388, 432, 504)]
    return brushes


def basin():
    """The water, its surface half a metre below the rim."""
    return [box((448, 768), (-272, -112), (-96, -16), "depot/liquids/water")]


def cellar_things():
    """The boiler on its plinth, its flue and pipes; barrels and coal in the fuel store; sleepers in the passage."""
    brushes = [box((152, 296), (200, 280), (-160, -144), "depot/stone")]
    brushes.append(prism(0, (160, 288), octagon((240, -104), 40, 20), "depot/boiler_red"))
    brushes.append(prism(0, (288, 300), octagon((240, -104), 28, 14), STEEL))
    brushes.append(prism(2, (-72, -40), octagon((188, 240), 12, 6), "depot/pipe"))
    brushes.append(prism(1, (64, 384), octagon((348, -60), 8, 4), "depot/pipe"))
    brushes.append(prism(0, (32, 416), octagon((364, -60), 8, 4), "depot/pipe"))
    for x, y in ((600, 80), (600, 120), (560, 80), (608, 160)):
        brushes.append(prism(2, (-160, -124), octagon((x + 8, y + 8), 14, 6), "depot/drum"))
    coal = [(464, 256, -160), (560, 256, -160), (464, 176, -160), (544, 192, -160), (464, 256, -108), (512, 256, -112)]
    brushes.append(hull(coal, "depot/coal"))
    brushes += [box((160, 224), (y, y + 8), (-160, -156), "depot/wood") for y in range(-448, 32, 48)]
    brushes += table((48, 120), (336, 384), -160, 28) + [box((40, 64), (64, 72), (-160, -96), "depot/locker")]
    brushes += [prism(2, (-160, -40), octagon((x, 160), 16, 8), "depot/stone") for x in (160, 304)]
    return brushes


def boulder(dice, x, y, z, size):
    """A rock that sits a little in the ground: the hull of random points around a place."""
    points = []
    for height in (-8, size // 2, size):
        reach = size if height < size else size // 2
        for a, b in ((1, 1), (-1, 1), (-1, -1), (1, -1)):
            points.append((x + a * dice.randrange(reach // 2, reach, 4), y + b * dice.randrange(reach // 2, reach, 4),
                           z + height + (dice.randrange(0, 12, 4) if height >= 0 else 0)))
    return hull(points, "depot/rock")


def cliff(dice, along, places, wall, turn, floor, height, reach):
    """Slopes of rubble at the foot of a wall across an axis, from place to place; each shares its end with the next."""
    ends = [(dice.randrange(reach // 3, reach, 8), dice.randrange(height // 3, height, 8)) for _ in places]
    brushes = []
    for (start, (foot, top)), (end, (next_foot, next_top)) in zip(zip(places, ends), zip(places[1:], ends[1:])):
        points = []
        for place, width, rise in ((start, foot, top), (end, next_foot, next_top)):
            for offset, z in ((0, floor), (width, floor), (0, floor + rise), (width // 3 // 4 * 4, floor + rise)):
                across = wall + turn * offset
                points.append((place, across, z) if along == 0 else (across, place, z))
        brushes.append(hull(points, "depot/rock"))
    return brushes


def yard_things():
    """Cliffs round the yard, boulders, a tank, containers, lamp posts."""
    dice = random.Random(5)
    brushes = cliff(dice, 1, list(range(-704, 705, 128)), 2112, -1, -32, 320, 128)
    brushes += cliff(dice, 0, list(range(1280, 2113, 104)), 704, -1, -32, 280, 120)
    brushes += cliff(dice, 0, list(range(1408, 2113, 88)), -704, 1, -32, 280, 88)
    brushes += cliff(dice, 1, [-560, -520, -480], 1280, 1, -32, 120, 64)
    brushes += cliff(dice, 1, [528, 616, 704], 1280, 1, -32, 300, 96)
    brushes += [boulder(dice, *place) for place in ((1900, -420, -32, 56), (1980, -300, -32, 40), (1840, -340, -32, 28),
                                                    (1500, 560, -32, 36), (1960, 420, -32, 64))]
    brushes.append(prism(2, (-32, 128), octagon((1480, -360), 80, 48), "depot/tank"))
    brushes.append(prism(2, (128, 144), octagon((1480, -360), 56, 32), "depot/tank"))
    brushes.append(box((1536, 1728), (-240, -160), (-32, 48), "depot/container_red"))
    brushes.append(box((1552, 1744), (-152, -72), (-32, 48), "depot/container_blue"))
    brushes.append(box((1560, 1720), (-224, -144), (48, 128), "depot/container_green"))
    brushes += [box((1280, 1288), (y, y + 24), (-32, 208), "depot/facade_light") for y in (-64, 56, 368, 488)]
    brushes.append(box((1280, 1296), (-64, 512), (208, 224), "depot/facade_light"))
    for x, y in ((1392, 400), (1720, 64), (2000, 64)):
        brushes.append(prism(2, (-32, 160), octagon((x, y), 6, 2), STEEL))
        brushes.append(box((x - 8, x + 8), (y - 8, y + 8), (160, 168), "depot/lamp"))
    return brushes


def hut():
    """The gatekeeper's hut in the yard: four walls, a sloped roof, a door to the south and a window to the west."""
    wall, floor = "depot/wood_panel", (-32, 64)
    brushes = [
        box((1696, 1856), (600, 608), floor, wall),
        box((1848, 1856), (488, 600), floor, wall),
        box((1696, 1752), (480, 488), floor, wall),
        box((1792, 1856), (480, 488), floor, wall),
        box((1752, 1792), (480, 488), (40, 64), wall),
        box((1696, 1704), (488, 600), (-32, 0), wall),
        box((1696, 1704), (488, 600), (40, 64), wall),
        box((1696, 1704), (488, 512), (0, 40), wall),
        box((1696, 1704), (576, 600), (0, 40), wall),
        prism(0, (1680, 1872), [(464, 64), (624, 64), (624, 96), (464, 72)], "depot/roof"),
        box((1696, 1700), (512, 576), (0, 40), "depot/glass"),
        box((1808, 1848), (520, 584), (-32, -8), "depot/wood"),
    ]
    return brushes


def cave_rocks():
    """Rubble along the cave's walls, hanging rock, boulders."""
    dice = random.Random(9)
    brushes = cliff(dice, 1, [-800, -740, -680], 416, -1, -160, 120, 48)
    brushes += cliff(dice, 1, [-800, -720, -640, -560, -480], 96, 1, -160, 160, 72)
    brushes += cliff(dice, 0, [96, 176, 256, 336, 416], -800, 1, -160, 150, 80)
    for x, y, depth in ((180, -620, 48), (300, -700, 64), (340, -560, 32), (240, -540, 24)):
        points = [(x + a, y + b, 0) for a, b in ((-32, -24), (28, -32), (36, 28), (-24, 32))]
        brushes.append(hull(points + [(x + 4, y, -depth), (x - 8, y + 8, -depth)], "depot/rock"))
    brushes += [boulder(dice, *place) for place in ((330, -600, -160, 28), (200, -700, -160, 36))]
    return brushes


def clips():
    """What only walkers meet: round the truck's wheels, and along the roofs' eastern edge above the parapets."""
    return [
        box((1080, 1296), (184, 264), (-32, -8), CLIP),
        box((1272, 1280), (16, 480), (248, 512), CLIP),
    ]


LAMPS = [  # x, y, z of a ceiling, brightness
    (96, 224, 320, 500), (360, 120, 320, 500), (360, 328, 320, 500), (760, 120, 320, 500), (760, 328, 320, 500),
    (960, 224, 192, 400), (1160, 120, 192, 300), (1160, 328, 192, 300), (100, 576, 104, 250), (300, 576, 104, 250),
    (512, 576, 104, 250), (728, 540, 104, 250), (160, -224, 104, 300), (64, -100, 104, 200), (400, -192, 104, 250),
    (600, -72, 104, 300), (600, -240, 104, 300), (128, 512, 232, 200), (448, 512, 232, 200), (760, 512, 232, 200),
    (128, 648, 232, 250), (408, 592, 232, 200), (696, 648, 232, 250), (176, -144, 232, 250), (448, -144, 232, 300),
    (-128, 320, 240, 300), (-128, 320, 48, 200), (-128, 120, -16, 200), (100, 320, -40, 250), (360, 120, -40, 250),
    (544, 160, -64, 200), (192, -60, -80, 150), (192, -360, -80, 150),
]
OPEN_LIGHTS = [(256, -640, -40, 300), (490, -624, -96, 150), (1000, -624, 8, 150), (1640, 0, 400, 900),
               (1392, 400, 184, 300), (1720, 64, 184, 300), (2000, 64, 184, 300), (1776, 544, 48, 150)]


def lamps():
    """A lamp on the ceiling wherever a light of LAMPS is."""
    return [box((x - 12, x + 12), (y - 12, y + 12), (z - 4, z), "depot/lamp") for x, y, z, _ in LAMPS]


def lights():
    """Where the lights are, and how bright."""
    return [(x, y, z - 12, bright) for x, y, z, bright in LAMPS] + OPEN_LIGHTS


START = (600, 224, 32, 180)
DEATHMATCH = [
    (944, 300, 32, 0), (1900, 224, 0, 180), (100, 540, 32, 270), (512, 540, 32, 270), (728, 616, 32, 270), (160, -96, 32, 270),
    (800, -64, 32, 180), (40, 224, 160, 0), (500, 512, 160, 180), (128, 600, 160, 90), (696, 592, 160, 90), (176, -180, 160, 90),
    (448, -160, 160, 90), (100, 120, -128, 0), (520, 120, -128, 90), (280, -560, -128, 180), (1700, -560, 0, 90), (1740, 540, 0, 180),
]
