# SPDX-License-Identifier: MIT
"""The plan of the depot: its rooms, and the doors and windows between them, in map units (32 a metre).

West to east: stairwell, hall, loading dock, yard. North of the hall are offices, on two storeys; south of it the
workshop and the cistern, with the battery room and the control room above; under it boiler room and fuel store, from
where a passage leads to the cave, and a sloped tunnel from there up to the yard.
"""

from typing import NamedTuple

from depot.rock import Air
from depot.shapes import box, portal

LOW, HIGH = (-640, -1088, -416), (2432, 992, 544)  # the block that everything is cut from
OVERSHOOT = 8  # portals reach that far into the walls around them


def paint(floor, wall, ceiling, **sides):
    """Textures of a room; single sides by west, east, south, north."""
    names = {"west": "-x", "east": "+x", "south": "-y", "north": "+y"}
    textures = {"floor": "depot/" + floor, "wall": "depot/" + wall, "ceiling": "depot/" + ceiling}
    textures.update({names[side]: "depot/" + texture for side, texture in sides.items()})
    return textures


FRAME = paint("threshold", "door_frame", "door_frame")
CAVE = paint("rock_floor", "rock", "rock")


class Room(NamedTuple):
    """Boxes of air that make a room, each with its textures."""

    name: str
    boxes: list


def air(x, y, z, textures):
    """A box of air from pairs (low, high)."""
    return Air((x[0], y[0], z[0]), (x[1], y[1], z[1]), textures)


def two_tone(x, y, z, textures, height, lower):
    """A box of air whose walls have another texture up to a height above the floor."""
    below = {k: v for k, v in textures.items() if k in ("floor", "ceiling")} | {"wall": "depot/" + lower}
    return [air(x, y, (z[0], z[0] + height), below), air(x, y, (z[0] + height, z[1]), textures)]


def ground_floor():
    """Rooms on z = 0."""
    hall = paint("concrete", "brick", "roof_sheet")
    office = paint("linoleum", "plaster", "ceiling_tiles")
    dock = paint("concrete", "concrete_wall", "roof_sheet")
    return [
        Room("hall", two_tone((0, 832), (0, 448), (0, 320), hall, 48, "brick_dark")),
        Room("dock", two_tone((864, 1248), (0, 448), (-32, 192), dock, 32, "concrete_dark")),
        Room("office_west", two_tone((0, 200), (480, 672), (0, 104), office, 32, "plaster_green")),
        Room("office_middle", two_tone((202, 400), (480, 672), (0, 104), office, 32, "plaster_green")),
        Room("office_east", two_tone((416, 608), (480, 672), (0, 104), office, 32, "plaster_green")),
        Room("lockers", two_tone((624, 832), (480, 672), (0, 104), paint("tiles", "plaster", "ceiling_tiles"), 56,
                                 "tiles_white")),
        Room("workshop", [air((0, 320), (-288, -32), (0, 104), paint("concrete", "brick", "concrete_wall"))]),
        Room("cistern", [air((352, 832), (-352, -32), (0, 104), paint("tiles", "tiles_white", "concrete_wall")),
                         air((448, 768), (-272, -112), (-96, 0), paint("tiles_blue", "tiles_blue", "tiles_blue"))]),
    ]


def upper_floor():
    """Rooms on z = 128."""
    office = paint("wood", "plaster", "ceiling_tiles")
    plain = paint("concrete", "concrete_wall", "concrete_wall")
    return [
        Room("corridor", two_tone((0, 832), (480, 544), (128, 232), paint("linoleum", "plaster", "ceiling_tiles"), 32,
                                  "plaster_green")),
        Room("director", two_tone((0, 256), (560, 736), (128, 232), office, 32, "wood_panel")),
        Room("archive", [air((272, 544), (560, 736), (128, 232), plain)]),
        Room("plan_room", two_tone((560, 832), (560, 736), (128, 232), office, 32, "wood_panel")),
        Room("battery_room", [air((64, 288), (-256, -32), (128, 232), plain)]),
        Room("control_room", two_tone((320, 576), (-256, -32), (128, 232),
                                      paint("linoleum", "steel_panel", "ceiling_tiles"), 32, "steel_dark")),
    ]


def below_ground():
    """The cellar, the cave and what leads from there to the yard; slopes are put into the tunnel's boxes."""
    cellar = paint("concrete", "stone", "concrete_wall")
    tunnel = [
        air((416, 512), (-672, -576), (-160, -72), CAVE),
        air((512, 832), (-672, -576), (-160, -24), CAVE),
        air((832, 1152), (-672, -576), (-112, 56), CAVE),
        air((1152, 1280), (-672, -576), (-32, 56), CAVE),
    ]
    return [
        Room("stairwell", two_tone((-224, -32), (96, 352), (-160, 240), paint("concrete", "plaster", "ceiling_tiles"),
                                   160, "stone")),
        Room("boiler_room", [air((32, 416), (64, 384), (-160, -40), cellar)]),
        Room("fuel_store", [air((448, 640), (64, 256), (-160, -64), cellar)]),
        Room("passage", [air((160, 224), (-480, 64), (-160, -80), paint("concrete", "stone", "stone"))]),
        Room("cave", [air((96, 416), (-800, -480), (-160, 0), CAVE)]),
        Room("tunnel", tunnel),
    ]


def yard():
    """The open air: the yard in front of the dock, and above the roofs of dock and hall."""
    ground = paint("gravel", "rock", "sky")
    road = paint("asphalt", "rock", "sky", west="facade")
    facade = paint("gravel", "rock", "sky", west="facade")
    roof = paint("roof", "rock", "sky")
    return Room("yard", [
        air((1280, 2112), (-704, 704), (-32, 512), ground),
        air((1280, 1400), (-64, 512), (-32, 224), facade),
        air((1280, 2112), (96, 352), (-32, 224), road),
        air((864, 1280), (-32, 480), (224, 512), roof | {"-x": "depot/facade"}),
        air((-32, 864), (-32, 480), (352, 512), roof),
    ])


def all_rooms():
    """Every room, in a fixed order."""
    return ground_floor() + upper_floor() + below_ground() + [yard()]


class Opening(NamedTuple):
    """A passage through a wall along an axis, with a portal across it; glass fills a window's."""

    name: str
    axis: int
    low: tuple[int, int, int]
    high: tuple[int, int, int]
    glass: bool = False
    textures: dict = FRAME


def door(name, axis, x, y, z, textures=FRAME):
    """A door or gate."""
    return Opening(name, axis, (x[0], y[0], z[0]), (x[1], y[1], z[1]), False, textures)


def window(name, axis, x, y, z):
    """A window of glass."""
    return Opening(name, axis, (x[0], y[0], z[0]), (x[1], y[1], z[1]), True, FRAME)


def openings():
    """All doors and windows that are boxes of their own."""
    north, south, rock = (448, 480), (-32, 0), paint("concrete", "stone", "stone")
    return [
        door("hall_dock_south", 0, (832, 864), (64, 160), (0, 112)),
        door("hall_dock_north", 0, (832, 864), (288, 384), (0, 112)),
        door("dock_yard", 0, (1248, 1280), (96, 352), (-32, 112)),
        door("hall_office_west", 1, (120, 160), north, (0, 72)),
        door("hall_office_middle", 1, (328, 368), north, (0, 72)),
        door("hall_office_east", 1, (480, 520), north, (0, 72)),
        door("hall_lockers", 1, (712, 752), north, (0, 72)),
        door("office_east_lockers", 0, (608, 624), (560, 600), (0, 72)),
        door("hall_workshop", 1, (96, 168), south, (0, 88)),
        door("hall_cistern", 1, (640, 704), south, (0, 88)),
        door("workshop_cistern", 0, (320, 352), (-160, -112), (0, 72)),
        door("stairs_hall", 0, (-32, 0), (104, 152), (0, 80)),
        door("stairs_gallery", 0, (-32, 0), (104, 152), (128, 208)),
        door("stairs_boiler", 0, (-32, 32), (104, 152), (-160, -80)),
        door("gallery_corridor", 1, (192, 240), north, (128, 200)),
        door("bridge_corridor", 1, (424, 472), north, (128, 200)),
        door("bridge_control", 1, (424, 472), south, (128, 200)),
        door("gallery_battery", 1, (160, 208), south, (128, 200)),
        door("battery_control", 0, (288, 320), (-160, -120), (128, 200)),
        door("corridor_director", 1, (104, 144), (544, 560), (128, 200)),
        door("corridor_archive", 1, (384, 424), (544, 560), (128, 200)),
        door("corridor_plan", 1, (680, 720), (544, 560), (128, 200)),
        door("boiler_fuel", 0, (416, 448), (128, 176), (-160, -88), rock),
        window("office_window", 1, (232, 304), north, (32, 80)),
        window("corridor_window", 1, (560, 752), north, (160, 208)),
        window("control_window_west", 1, (336, 408), south, (160, 208)),
        window("control_window_east", 1, (488, 560), south, (160, 208)),
        window("skylight_west", 2, (144, 272), (176, 272), (320, 352)),
        window("skylight_middle", 2, (576, 704), (176, 272), (320, 352)),
    ]


def glass_of(opening):
    """The pane that fills a window, a quarter of the wall thick."""
    spans = [[low, high] for low, high in zip(opening.low, opening.high)]
    spans[opening.axis] = [opening.low[opening.axis] + 8, opening.low[opening.axis] + 16]
    return box(*spans, "depot/glass")


def portal_of(opening):
    """The portal across an opening: in the middle of a door, behind the pane of a window."""
    low, high = opening.low, opening.high
    middle = (low[opening.axis] + high[opening.axis]) // 2 + (4 if opening.glass else 0)
    lows = [k - OVERSHOOT for k in low]
    highs = [k + OVERSHOOT for k in high]
    return portal(opening.axis, middle, lows, highs)


def portals():
    """Names and brushes of all portals: across the openings, and in those that are no boxes of their own."""
    named = [(opening.name, portal_of(opening)) for opening in openings()]
    return named + [
        ("boiler_passage", portal(1, 40, (152, 0, -168), (232, 0, -72))),
        ("passage_cave", portal(1, -464, (152, 0, -168), (232, 0, -72))),
        ("cave_tunnel", portal(0, 440, (0, -680, -168), (0, -568, -64))),
        ("tunnel_yard", portal(0, 1264, (0, -680, -40), (0, -568, 64))),
        ("hut_yard", portal(1, 484, (1744, 0, -40), (1800, 0, 48))),
        ("hut_window", portal(0, 1702, (0, 504, -8), (0, 584, 48))),
    ]


def room_names():
    """Each room's name, and a place in its air where nothing stands."""
    places = {
        "hall": (580, 224, 64), "dock": (960, 300, 64), "office_west": (100, 540, 64), "office_middle": (300, 540, 64),
        "office_east": (560, 600, 64), "lockers": (728, 616, 64), "workshop": (160, -96, 64), "cistern": (800, -64, 64),
        "corridor": (500, 512, 160), "director": (200, 600, 160), "archive": (408, 592, 160), "plan_room": (696, 592, 160),
        "battery_room": (176, -180, 160), "control_room": (448, -160, 160), "stairwell": (-128, 128, 64),
        "boiler_room": (64, 300, -100), "fuel_store": (520, 100, -100), "passage": (192, -200, -100),
        "cave": (256, -560, -100), "tunnel": (900, -624, -40), "yard": (1700, -500, 96),
    }
    return [(room.name, places[room.name]) for room in all_rooms()] + [("hut", (1740, 540, 16))]
