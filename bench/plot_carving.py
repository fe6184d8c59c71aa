#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Draws the tables of carving as pictures, without any library.

    plot_carving.py RESULTS_FOLDER PICTURES_FOLDER
"""

import csv
import math
import pathlib
import sys

WIDTH, HEIGHT = 760, 420
LEFT, RIGHT, TOP, BOTTOM = 70, 190, 40, 60
COLOURS = ["#1b6ca8", "#d1495b", "#3a7d44", "#e08e1b", "#6a4c93", "#5f6368", "#0f8b8d", "#a44a3f"]


def rows(folder, name):
    with open(folder / f"{name}.csv", newline="") as file:
        return list(csv.DictReader(file))


def value(cell):
    return float(cell.replace(" ", "").rstrip("x%"))


class Scale:
    """Values along an axis; from data to the picture."""

    def __init__(self, low, high, start, end, log):
        self.low, self.high, self.start, self.end, self.log = low, high, start, end, log

    def at(self, x):
        if self.log:
            part = math.log(x / self.low) / math.log(self.high / self.low)
        else:
            part = (x - self.low) / (self.high - self.low)
        return self.start + part * (self.end - self.start)

    def ticks(self):
        if self.log:
            exponent = math.ceil(math.log10(self.low) - 1e-9)
            found = []
            while 10.0**exponent <= self.high * 1.0001:
                found.append(10.0**exponent)
                exponent += 1
            return found
        step = 10.0 ** math.floor(math.log10((self.high - self.low) / 4))
        for more in (2, 2.5, 2):
            if (self.high - self.low) / step > 8:
                step *= more
        return [step * k for k in range(math.ceil(self.low / step), math.floor(self.high / step + 1e-9) + 1)]


def label(x):
    if x >= 1e6:
        return f"{x / 1e6:g} M"
    return f"{x / 1e3:g} k" if x >= 1e3 else f"{x:g}"


def escape(text):
    return text.replace("&", "&amp;").replace("<", "&lt;")


def plot(path, title, x_name, y_name, series, log_x, log_y):
    """series: (name, points, whether dashed)"""
    xs = [x for _, points, _ in series for x, _ in points]
    ys = [y for _, points, _ in series for _, y in points]
    x_low, x_high = (10 ** math.floor(math.log10(min(xs)) + 1e-9), max(xs) * 1.3) if log_x else (0, max(xs))
    y_low, y_high = (10 ** math.floor(math.log10(min(ys))), 10 ** math.ceil(math.log10(max(ys)))) if log_y else (0, max(ys) * 1.1)
    x_axis = Scale(x_low, x_high, LEFT, WIDTH - RIGHT, log_x)
    y_axis = Scale(y_low, y_high, HEIGHT - BOTTOM, TOP, log_y)
    out = [
        f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {WIDTH} {HEIGHT}" width="{WIDTH}" height="{HEIGHT}" '
        'font-family="sans-serif" font-size="13">',
        f'<rect width="{WIDTH}" height="{HEIGHT}" fill="#ffffff"/>',
        f'<text x="{LEFT}" y="24" font-size="16" fill="#202124">{escape(title)}</text>',
    ]
    for x in x_axis.ticks():
        at = x_axis.at(x)
        out.append(f'<path d="M{at:.1f} {TOP}V{HEIGHT - BOTTOM}" stroke="#e3e5e8"/>')
        out.append(f'<text x="{at:.1f}" y="{HEIGHT - BOTTOM + 18}" text-anchor="middle" fill="#5f6368">{label(x)}</text>')
    for y in y_axis.ticks():
        at = y_axis.at(y)
        out.append(f'<path d="M{LEFT} {at:.1f}H{WIDTH - RIGHT}" stroke="#e3e5e8"/>')
        out.append(f'<text x="{LEFT - 8}" y="{at + 4:.1f}" text-anchor="end" fill="#5f6368">{label(y)}</text>')
    out.append(f'<path d="M{LEFT} {TOP}V{HEIGHT - BOTTOM}H{WIDTH - RIGHT}" fill="none" stroke="#5f6368"/>')
    middle = (LEFT + WIDTH - RIGHT) / 2
    out.append(f'<text x="{middle}" y="{HEIGHT - 16}" text-anchor="middle" fill="#202124">{escape(x_name)}</text>')
    out.append(f'<text transform="translate(18 {(TOP + HEIGHT - BOTTOM) / 2}) rotate(-90)" text-anchor="middle" fill="#202124">{escape(y_name)}</text>')
    # Names stand beside the last points, pushed apart where they would overlap.
    names = sorted(((y_axis.at(points[-1][1]), k) for k, (_, points, _) in enumerate(series)))
    last, places = -1e9, {}
    for at, k in names:
        last = max(at, last + 16)
        places[k] = last
    for k, (name, points, dashed) in enumerate(series):
        colour = COLOURS[k % len(COLOURS)]
        line = " ".join(f"{x_axis.at(x):.1f},{y_axis.at(y):.1f}" for x, y in points)
        dash = ' stroke-dasharray="6 4"' if dashed else ""
        out.append(f'<polyline points="{line}" fill="none" stroke="{colour}" stroke-width="2"{dash}/>')
        if len(points) < 8:
            out += [f'<circle cx="{x_axis.at(x):.1f}" cy="{y_axis.at(y):.1f}" r="3.5" fill="{colour}"/>' for x, y in points]
        out.append(f'<text x="{WIDTH - RIGHT + 10}" y="{places[k] + 4:.1f}" fill="{colour}">{escape(name)}</text>')
    out.append("</svg>")
    path.write_text("\n".join(out) + "\n")


def by_size(results, pictures):
    growth, cgal = rows(results, "carve_growth"), rows(results, "carve_cgal")

    def firma(places, column):
        return [(value(r["triangles"]), value(r[column])) for r in growth if r["craters"] == places]

    peer = [(value(r["triangles"]), value(r["CGAL in place, median ms"])) for r in cgal if r["craters"] == "spread"]
    plot(pictures / "carve_by_size.svg", "One crater, by the size of the level", "triangles of the level", "ms",
         [("CGAL's corefinement", peer, False), ("Firma, p99", firma("spread", "p99 ms"), True),
          ("Firma, median", firma("spread", "median ms"), False), ("Firma, one corner", firma("in one corner", "median ms"), False)],
         True, True)


def by_cuts(results, pictures):
    table = rows(results, "carve_by_cuts")
    series = []
    for name in table[0]:
        if name == "cuts":
            continue
        points = [(value(r["cuts"]), value(r[name])) for r in table if value(r[name]) > 0]
        series.append((name, points, name.endswith("corner")))
    plot(pictures / "carve_by_cuts.svg", "One crater, by how many were made before", "craters", "median ms of a hundred", series,
         False, False)


def memory(results, pictures):
    table = rows(results, "carve_memory")

    def column(name, places, unit):
        return [(value(r["triangles"]), value(r[name]) * unit) for r in table if r["craters"] == places]

    plot(pictures / "carve_memory.svg", "Memory: a world, and one more version of it after a crater", "triangles of the level", "KB",
         [("the world", column("world MB", "spread", 1e3), False),
          ("one more, spread", column("KB a version more, median", "spread", 1), False),
          ("one more, corner", column("KB a version more, median", "in one corner", 1), True)], True, True)


def main():
    results, pictures = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])
    pictures.mkdir(exist_ok=True)
    by_size(results, pictures)
    by_cuts(results, pictures)
    memory(results, pictures)


if __name__ == "__main__":
    main()
