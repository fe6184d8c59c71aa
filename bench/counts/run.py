#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Counts the instructions of casts and craters, by valgrind, and compares them with bench/counts/bounds.json.

    bench/counts/run.py            exit 0: no count is above its bound; 1: some are, each named; 2: could not be run
    bench/counts/run.py --renew    writes what was counted as the new bounds
    bench/counts/run.py --where    a table for docs/performance.md instead: in which parts of a cast they are spent
    bench/counts/run.py --build FOLDER   builds there (build/counts)

Counts repeat where times do not: the library is built for any x86-64 processor by one compiler, valgrind shows programs
no AVX-512, and the scenes and casts are fixed. Wants cmake, ninja, g++ and valgrind: tools/count_work.sh installs them.
"""

import argparse
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
BOUNDS = ROOT / "bench/counts/bounds.json"
# Beyond this share of what the file holds a count is too high; below the other the file should be renewed.
ALLOWED, NOTED = 1.1, 0.9
TITLE = re.compile(r"^desc: Trigger: Client Request: (.*) / (\d+)$", re.M)
TOTAL = re.compile(r"^(?:totals|summary): (\d+)", re.M)


# Parts of a cast, by the functions that their instructions are spent in; the first that fits counts.
PARTS = {
    "tree and triangles, eight at a time": r"sweep_lanes\(",
    "the answer": r"::(make_(hull_|capsule_)?hit|closest_(to|on_rim|on_\w+)|put_(hit|face)|safe_fraction|name_of|points?_of_contact)\b"
                  r"|Touching|normal_toward_mover",
    "single faces, exactly": r"::(cast_\w+polygon|cast_particle_triangle|look_at_facet|KeepFirst|LaneShape|FaceShape|make_shape"
                             r"|line_meets\w*|exact_\w+|view_plane|enter_\w+|foot_inside|start_\w+|near\w*|out_of_reach|counted"
                             r"|side_crossing|cross_\w+|touch_sides|axis_meets|AxisSides|AroundCapsule|Capsule(Sweep|Start)|capsule_\w+"
                             r"|precise\w*|least_nearness|SumFacet|sum_\w+|SumVec|HullAgainstPolygon|HullLook|LowestCorner|glance|Landing|judge_\w+|guess"
                             r"|Expansion|DoubleDouble|VectorOf|dot|cross|difference\w*|square_root)\b|fm(ax|in)|operator[-+*/]",
    "set-up": r"",
}


def fail(text):
    print(f"bench/counts/run.py: {text}", file=sys.stderr)
    sys.exit(2)


def run(command, **options):
    """Its output; ends the program with its last lines when it fails."""
    done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, **options)
    if done.returncode != 0:
        print("\n".join(done.stdout.splitlines()[-40:]), file=sys.stderr)
        fail(f"{' '.join(map(str, command[:3]))} ... ended with {done.returncode}")
    return done.stdout


def compiler():
    first = run(["g++", "-dumpfullversion"]).strip()
    return f"g++ {first} for {run(['g++', '-dumpmachine']).strip()}"


def has_avx2():
    """As the C library chooses its functions by the processor, and valgrind passes on up to AVX2."""
    info = pathlib.Path("/proc/cpuinfo")
    return info.exists() and re.search(r"^flags\s*:.*\bavx2\b", info.read_text(), re.M) is not None


def build(folder):
    run(["cmake", "-S", ROOT, "-B", folder, "-G", "Ninja", "-DCMAKE_BUILD_TYPE=Release", "-DCMAKE_CXX_COMPILER=g++",
         "-DCMAKE_CXX_FLAGS=", "-DFIRMA_UNITE=ON", "-DFIRMA_BUILD_CLI=OFF", "-DFIRMA_BUILD_C=OFF", "-DFIRMA_BUILD_GLTF=OFF",
         "-DFIRMA_BUILD_COUNTS=ON"])
    run(["cmake", "--build", folder, "--target", "counted_work"])
    return pathlib.Path(folder) / "bin/counted_work"


def parts_of(path, units):
    """{part: instructions a unit}, those of functions themselves"""
    spent = dict.fromkeys(PARTS, 0)
    for line in run(["callgrind_annotate", "--threshold=100", path]).splitlines():
        found = re.match(r"^ *([\d,]+) \([ \d.]+%\)  [^:]+:(.*)$", line)
        if found and "PROGRAM TOTALS" not in line:
            part = next(part for part, pattern in PARTS.items() if re.search(pattern, found[2]))
            spent[part] += int(found[1].replace(",", ""))
    return {part: round(number / units) for part, number in spent.items()}


def count(program, parts=None):
    """{work: instructions a unit of it}
    @param parts  is filled with {work: {part: instructions}} of casts"""
    counts = {}
    with tempfile.TemporaryDirectory() as folder:
        # Nothing of the caller's surroundings: they lie on the stack that the program starts with.
        run(["valgrind", "--tool=callgrind", "--instr-atstart=no", "--callgrind-out-file=out", program],
            cwd=folder, env={"PATH": os.environ["PATH"], "LC_ALL": "C"})
        for path in sorted(pathlib.Path(folder).glob("out.*")):
            text = path.read_text()
            title = TITLE.search(text)
            if title:
                counts[title[1]] = round(int(TOTAL.search(text)[1]) / int(title[2]))
                if parts is not None and re.search(r"\bover\b|\bray\b", title[1]):
                    parts[title[1]] = parts_of(path, int(title[2]))
    if not counts:
        fail("callgrind wrote no counts")
    return dict(sorted(counts.items()))


def shown(number):
    return f"{number:,}".replace(",", " ")


def compare(counts, known):
    faults, notes = [], []
    width = max(map(len, counts))
    for work, now in counts.items():
        before = known.get(work)
        if before is None:
            faults.append(f"{work}: counted for the first time ({shown(now)} instructions)")
            continue
        print(f"{work:{width}}  {shown(now):>10} instructions, {100 * (now / before - 1):+6.1f}% to the {shown(before)} known")
        if now > before * ALLOWED:
            faults.append(f"{work}: {shown(now)} instructions, {100 * (now / before - 1):.1f}% more than the {shown(before)} of bounds.json; "
                          f"{100 * (ALLOWED - 1):.0f}% are allowed")
        elif now < before * NOTED:
            notes.append(f"{work}: {100 * (1 - now / before):.1f}% fewer instructions than bounds.json has")
    faults += [f"{work}: is no longer counted" for work in known if work not in counts]
    return faults, notes


def print_parts(parts, counts):
    print("| cast | instructions | " + " | ".join(PARTS) + " |")
    print("|---|" + "---|" * (len(PARTS) + 1))
    for work in sorted(parts):
        print(f"| {work} | {counts[work]:,} | " + " | ".join(f"{number:,}" for number in parts[work].values()) + " |")


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--renew", action="store_true", help="write what was counted as the new bounds")
    parser.add_argument("--where", action="store_true", help="tell where they are spent, and compare nothing")
    parser.add_argument("--build", default=ROOT / "build/counts", metavar="FOLDER", help="where to build")
    arguments = parser.parse_args()
    for tool in ("cmake", "ninja", "g++", "valgrind"):
        if not shutil.which(tool):
            fail(f"{tool} is missing: tools/count_work.sh installs it")
    known = json.loads(BOUNDS.read_text()) if BOUNDS.exists() else {"compiler": None, "instructions": {}}
    if not has_avx2():
        print("instructions are not compared: this processor has no AVX2, for which they were counted")
        return 0
    if arguments.where:
        parts = {}
        counts = count(build(arguments.build), parts)
        print_parts(parts, counts)
        return 0
    if not arguments.renew and known["compiler"] != compiler():
        print(f"instructions are not compared: they were counted with {known['compiler']}, this is {compiler()}")
        return 0
    counts = count(build(arguments.build))
    faults, notes = compare(counts, known["instructions"])
    if arguments.renew:
        BOUNDS.write_text(json.dumps({"compiler": compiler(), "instructions": counts}, indent=2) + "\n")
        print(f"{BOUNDS.relative_to(ROOT)} is renewed: commit it with the change that it measures, and say there why a count grew")
        return 0
    for note in notes:
        print(f"note: {note}: bench/counts/run.py --renew, so that what was gained stays")
    for fault in faults:
        print(f"FAILED: {fault}", file=sys.stderr)
    if faults:
        print("What grew, by function:  callgrind_annotate on the output of  valgrind --tool=callgrind --instr-atstart=no "
              f"{os.path.relpath(arguments.build)}/bin/counted_work\n"
              "If it is worth it:  bench/counts/run.py --renew, commit bounds.json, and say why in the message.", file=sys.stderr)
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
