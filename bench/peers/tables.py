#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Tables of a run of bench/peers/run.sh: medians, ratios within each round, and what the judge says.

    tables.py RAW.csv WORK_FOLDER RESULTS_FOLDER peer...
"""

import collections
import csv
import pathlib
import re
import statistics
import sys

SETS = ["sph_short", "sph_long", "sph_slow", "sph_tiny", "ray_short", "ray_long", "ray_edge"]


def read_raw(path):
    """{(scene, metric, peer): {round: value}}"""
    values = collections.defaultdict(dict)
    with open(path, newline="") as file:
        for row in csv.DictReader(file):
            metric = re.sub(r"\[.*\]", "", row["metric"])
            values[row["scene"], metric, row["peer"]][int(row["round"])] = float(row["value"])
    return values


def ratio(values, scene, metric, ours, theirs):
    """Median over the rounds of theirs / ours: above 1, we are faster."""
    mine, other = values.get((scene, metric, ours), {}), values.get((scene, metric, theirs), {})
    both = [other[k] / mine[k] for k in mine if k in other and mine[k] > 0]
    return statistics.median(both) if both else None


def number(value):
    return "" if value is None else f"{value:.0f}" if value >= 100 else f"{value:.3g}"


def speed_rows(values, peers):
    scenes = sorted({scene for scene, _, _ in values})
    for scene in scenes:
        for metric in [f"ns_{s}" for s in SETS] + ["build_ms", "edit_ms", "own_bytes_per_tri", "resident_bytes_per_tri"]:
            row = {"scene": scene, "metric": metric}
            for peer in peers:
                rounds = values.get((scene, metric, peer), {})
                row[peer] = number(statistics.median(rounds.values()) if rounds else None)
            for peer in peers[1:]:
                row[f"{peer} / firma"] = number(ratio(values, scene, metric, "firma", peer))
            if any(row[peer] for peer in peers):
                yield row


PATTERNS = {
    "SPH": r"n (?P<judged>\d+) refhits (?P<hits>\d+) miss (?P<missed>\d+) .*false (?P<false>\d+) .*"
           r"penetrating>0.1mm (?P<deep>\d+) .*max (?P<deepest>\S+) \| early>0.1mm (?P<early>\d+) ",
    "RAY": r"n (?P<judged>\d+) refhits (?P<hits>\d+) miss (?P<missed>\d+) false (?P<false>\d+) .*late>1cm (?P<deep>\d+) ",
    "EDGE": r"n (?P<aimed>\d+) .*leak_per_million (?P<leaks>\S+)",
}


def judged_rows(work, peers):
    """One row a scene and peer: sums over the sets, the largest depth."""
    for path in sorted(pathlib.Path(work).glob("judged_*.txt")):
        rows = {}
        for line in path.read_text().splitlines():
            word = line.split()
            found = re.search(PATTERNS.get(word[0], "$^"), line)
            if not found:
                continue
            row = rows.setdefault(word[1], collections.Counter())
            for key, value in found.groupdict().items():
                row[key] = max(row[key], float(value)) if key == "deepest" else row[key] + float(value)
            row["scene"] = word[2]
        for peer in peers:
            if peer in rows:
                row = rows[peer]
                yield {"scene": row["scene"], "peer": peer,
                       **{k: f"{row[k]:.0f}" for k in ("judged", "hits", "missed", "false", "deep", "early", "aimed", "leaks") if k in row},
                       **({"deepest": f"{row['deepest']:.1e}"} if "deepest" in row else {})}


def write(path, rows, columns):
    with open(path, "w", newline="") as file:
        writer = csv.DictWriter(file, columns, restval="", lineterminator="\n")
        writer.writeheader()
        writer.writerows(rows)
    print(f"\n| {' | '.join(columns)} |\n|{'---|' * len(columns)}")
    for row in rows:
        print("| " + " | ".join(str(row.get(c, "")) for c in columns) + " |")
    print(f"\n(also in {path})")


def main():
    raw, work, results, peers = sys.argv[1], sys.argv[2], pathlib.Path(sys.argv[3]), sys.argv[4:]
    rows = list(speed_rows(read_raw(raw), peers))
    write(results / "peers_speed.csv", rows, ["scene", "metric"] + peers + [f"{p} / firma" for p in peers[1:]])
    write(results / "peers_answers.csv", list(judged_rows(work, peers)),
          ["scene", "peer", "judged", "hits", "missed", "false", "deep", "deepest", "early", "aimed", "leaks"])


if __name__ == "__main__":
    main()
