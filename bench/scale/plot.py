#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Draws the tables of bench_scale as pictures, without any library: a panel for each scene and kind of work.

    plot.py RESULTS_FOLDER PICTURES_FOLDER
"""

import math
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
from plot_carving import Scale, escape, label, rows, value  # noqa: E402

PANEL_WIDTH, PANEL_HEIGHT = 380, 230
LEFT, TOP, GAP_X, GAP_Y, BOTTOM, RIGHT = 64, 92, 118, 62, 52, 112
INK, FAINT, GREY = "#202124", "#e9ebee", "#5f6368"
COLOURS = {"Firma": "#1b6ca8", "Embree": "#e08e1b", "Bullet": "#d1495b", "CGAL": "#3a7d44", "FCL": "#6a4c93",
           "jolt-physics": "#d1495b", "rapier": "#6a4c93"}
SCENES = ("ground", "rooms")


def colour(name):
    """Everything of Firma's has its colour, a peer the one of its library."""
    return next((COLOURS[library] for library in COLOURS if name.startswith(library)), GREY)


def of_time(ns):
    for unit, size in (("s", 1e9), ("ms", 1e6), ("µs", 1e3)):
        if ns >= size * 0.9999:
            return f"{ns / size:g} {unit}"
    return f"{ns:g} ns"


def of_bytes(size):
    return f"{size:g} B"


def log_ticks(low, high):
    """Powers of ten; with few of them, twos and fives between."""
    decades = math.log10(high / low)
    parts = (1, 2, 5) if decades < 2.5 else (1,)
    exponents = range(math.floor(math.log10(low)), math.ceil(math.log10(high)) + 1)
    return [part * 10.0**e for e in exponents for part in parts if low * 0.999 <= part * 10.0**e <= high * 1.001]


def limits(values):
    """A little wider than the values, and at least a decade."""
    low, high = min(values), max(values)
    low, high = low / 1.25, high * 1.25
    if high / low < 10:
        middle = math.sqrt(low * high)
        low, high = middle / math.sqrt(10), middle * math.sqrt(10)
    return low, high


def spread(places, apart, low, high):
    """The same places in order, moved until each is so far from the next, within limits."""
    order = sorted(range(len(places)), key=lambda k: places[k])
    at = [places[k] for k in order]
    for _ in range(50):
        for k in range(1, len(at)):
            if at[k] - at[k - 1] < apart:
                middle = (at[k] + at[k - 1]) / 2
                at[k - 1], at[k] = middle - apart / 2, middle + apart / 2
        shift = max(0, low - at[0]) - max(0, at[-1] - high) if at else 0
        at = [x + shift for x in at]
    found = [0.0] * len(places)
    for k, x in zip(order, at):
        found[k] = x
    return found


def panel(out, left, top, title, series, x_limits, y_limits, unit, last_row):
    """series: (name, points, whether dashed); points: (triangles, value)"""
    right, bottom = left + PANEL_WIDTH, top + PANEL_HEIGHT
    x_axis = Scale(*x_limits, left, right, True)
    y_axis = Scale(*y_limits, bottom, top, True)
    out.append(f'<text x="{left}" y="{top - 10}" fill="{INK}" font-weight="600">{escape(title)}</text>')
    for y in log_ticks(*y_limits):
        at = y_axis.at(y)
        out.append(f'<path d="M{left} {at:.1f}H{right}" stroke="{FAINT}"/>')
        out.append(f'<text x="{left - 8}" y="{at + 4:.1f}" text-anchor="end" fill="{GREY}" font-size="12">{unit(y)}</text>')
    for x in log_ticks(*x_limits):
        at = x_axis.at(x)
        out.append(f'<path d="M{at:.1f} {top}V{bottom}" stroke="{FAINT}"/>')
        out.append(f'<text x="{at:.1f}" y="{bottom + 17}" text-anchor="middle" fill="{GREY}" font-size="12">{label(x)}</text>')
    out.append(f'<path d="M{left} {bottom}H{right}" stroke="{GREY}"/>')
    if last_row:
        out.append(f'<text x="{(left + right) / 2}" y="{bottom + 36}" text-anchor="middle" fill="{GREY}" font-size="12">triangles</text>')
    ends = [y_axis.at(points[-1][1]) for _, points, _ in series]
    places = spread(ends, 15, top + 6, bottom - 4)
    # Firma's lines last, so that they lie on top.
    for k in sorted(range(len(series)), key=lambda k: series[k][0].startswith("Firma")):
        name, points, dashed = series[k]
        ink, own = colour(name), name.startswith("Firma")
        line = " ".join(f"{x_axis.at(x):.1f},{y_axis.at(y):.1f}" for x, y in points)
        out.append(f'<polyline points="{line}" fill="none" stroke="{ink}" stroke-width="{3 if own else 1.8}" stroke-linejoin="round"'
                   + (' stroke-dasharray="7 4"' if dashed else "") + "/>")
        out += [f'<circle cx="{x_axis.at(x):.1f}" cy="{y_axis.at(y):.1f}" r="{4 if own else 3}" fill="{ink}" stroke="#ffffff"/>'
                for x, y in points]
        end = x_axis.at(points[-1][0])
        if abs(places[k] - ends[k]) > 3 or end < right - 8:
            out.append(f'<path d="M{end + 5:.1f} {ends[k]:.1f}L{right + 6} {places[k]:.1f}" stroke="{ink}" stroke-width="0.8" opacity="0.5"/>')
        out.append(f'<text x="{right + 9}" y="{places[k] + 4:.1f}" fill="{ink}" font-size="12"'
                   + (' font-weight="600"' if own else "") + f'>{escape(name)}</text>')


def figure(path, title, below, grid, unit):
    """grid: rows of panels (title, series). One scale of values a row, one of sizes for all."""
    grid = [[(name, [s for s in series if s[1]]) for name, series in row] for row in grid]
    grid = [row for row in grid if any(series for _, series in row)]
    if not grid:
        print(f"{path}: nothing was measured")
        return
    columns = max(len(row) for row in grid)
    width = LEFT + columns * PANEL_WIDTH + (columns - 1) * (GAP_X + LEFT) + RIGHT
    height = TOP + len(grid) * PANEL_HEIGHT + (len(grid) - 1) * GAP_Y + BOTTOM
    out = [f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width} {height}" width="{width}" height="{height}" '
           'font-family="sans-serif" font-size="13">',
           f'<rect width="{width}" height="{height}" fill="#ffffff"/>',
           f'<text x="{LEFT}" y="30" font-size="18" font-weight="600" fill="{INK}">{escape(title)}</text>',
           f'<text x="{LEFT}" y="50" fill="{GREY}">{escape(below)}</text>']
    every = [point for row in grid for _, series in row for _, points, _ in series for point in points]
    x_limits = (min(x for x, _ in every) / 1.3, max(x for x, _ in every) * 1.3)
    for r, row in enumerate(grid):
        y_limits = limits([y for _, series in row for _, points, _ in series for _, y in points])
        for c, (name, series) in enumerate(row):
            if series:
                panel(out, LEFT + c * (PANEL_WIDTH + GAP_X + LEFT), TOP + r * (PANEL_HEIGHT + GAP_Y), name, series,
                      x_limits, y_limits, unit, r == len(grid) - 1)
    out.append("</svg>")
    path.write_text("\n".join(out) + "\n")


def points(table, wanted, column, factor=1):
    return [(value(row["triangles"]), value(row[column]) * factor) for row in table
            if row[column] and all(row[key] == cell for key, cell in wanted.items())]


def in_order(table, column):
    return list(dict.fromkeys(row[column] for row in table))


def casts(results, pictures, name, title, chosen):
    table = rows(results, "scale_casts")
    who = [column.removesuffix(" ns") for column in table[0] if column.endswith(" ns")]
    grid = [[(f"{kind}, {scene}", [(peer, points(table, {"scene": scene, "casts": kind}, f"{peer} ns"), False) for peer in who])
             for scene in SCENES] for kind in in_order(table, "casts") if chosen(kind)]
    figure(pictures / f"{name}.svg", title, "time a cast, one thread; both axes logarithmic; lower is better", grid, of_time)


def builds(results, pictures):
    table = rows(results, "scale_builds")
    who = [name for name in in_order(table, "who") if "before" not in name]
    short = {"Firma, castable only": "Firma", "Firma, with the exact part": "Firma, exact"}

    def series(scene, column, factor):
        return [(short.get(name, name), points(table, {"scene": scene, "who": name}, column, factor), name == "Firma, with the exact part")
                for name in who]

    figure(pictures / "scale_builds.svg", "Ready to cast, by the size of the scene", "one thread; \"exact\": what cutting needs is made, too; both axes logarithmic; lower is better",
           [[(f"time of the build, {scene}", series(scene, "build ms", 1e6)) for scene in SCENES]], of_time)
    figure(pictures / "scale_memory.svg", "Memory, by the size of the scene", "bytes a triangle that the process holds once it is built; both axes logarithmic; lower is better",
           [[(f"bytes a triangle, {scene}", series(scene, "resident bytes a triangle", 1)) for scene in SCENES]], of_bytes)


def cuts(results, pictures):
    table = rows(results, "scale_cuts")
    series = (("Firma", "Firma median ms", False), ("Firma, p99", "Firma p99 ms", True), ("CGAL", "CGAL median ms", False))
    grid = [[(f"a crater, {scene}", [(name, points(table, {"scene": scene}, column, 1e6), dashed) for name, column, dashed in series])
             for scene in SCENES]]
    figure(pictures / "scale_cuts.svg", "One crater, ready to cast again, by the size of the scene", "median unless said; CGAL: corefinement in place; both axes logarithmic; lower is better",
           grid, of_time)


def node(results, pictures):
    if not (results / "scale_node.csv").exists():
        return
    table = rows(results, "scale_node")
    who = [column.removesuffix(" ns") for column in table[0] if column.endswith(" ns")]
    grid = [[(f"{kind}, {scene}",
              [(peer.replace(" in a batch", ", batch"), points(table, {"scene": scene, "casts": kind}, f"{peer} ns"), "batch" in peer) for peer in who])
             for scene in SCENES] for kind in in_order(table, "casts")]
    figure(pictures / "scale_node.svg", "In node, by the size of the scene", "time a cast, by modules for JavaScript; both axes logarithmic; lower is better", grid, of_time)


def main():
    results, pictures = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])
    pictures.mkdir(parents=True, exist_ok=True)
    casts(results, pictures, "scale_rays", "Rays, by the size of the scene", lambda kind: kind.startswith("rays"))
    casts(results, pictures, "scale_shapes", "Spheres, by the size of the scene", lambda kind: not kind.startswith("rays"))
    builds(results, pictures)
    cuts(results, pictures)
    node(results, pictures)


if __name__ == "__main__":
    main()
