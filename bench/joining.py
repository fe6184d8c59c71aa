#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""What joining late takes, by a log and by a compacted one, in bytes and in seconds of processor time.

  bench/joining.py FIRMA      the command line as built, from the root of the repository

Rocky craters of 0.4 to 1.2 m where random rays meet our level and the depot, and of 0.5 to 1.5 m in a pit of 12 m. Processor time counts what
applying takes beyond reading the level: `firma log verify` less the same with --until 0 (of a compacted log: of the one before); the best of three.
"""
import csv
import json
import os
import random
import resource
import subprocess
import sys
import tempfile

FIRMA = os.path.abspath(sys.argv[1])
HEADER = 'x,y,z,radius,shape,seed\n'


def run(*arguments):
    return subprocess.run([FIRMA, *arguments], check=True, capture_output=True).stdout


def processor(*arguments):
    best = None
    for _ in range(3):
        before = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
        run(*arguments)
        spent = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - before
        best = spent if best is None else min(best, spent)
    return best


def blast(rng, at, low, high):
    return '%.6f,%.6f,%.6f,%.6f,rocky,%d\n' % (*at, rng.uniform(low, high), rng.getrandbits(64))


def spread(level, count, folder):
    rng = random.Random(1)
    bounds = json.loads(run('info', level, '--json'))['bounds']
    queries, hits = os.path.join(folder, 'q.csv'), os.path.join(folder, 'h.csv')
    with open(queries, 'w', encoding='utf-8') as file:
        file.write('px,py,pz,dx,dy,dz,radius\n')
        for _ in range(8 * count):
            start = [rng.uniform(a, b) for a, b in zip(bounds['low'], bounds['high'])]
            file.write(','.join('%.6f' % x for x in start + [rng.gauss(0, 100) for _ in range(3)] + [0]) + '\n')
    run('cast', level, '--queries', queries, '-o', hits)
    with open(hits, encoding='utf-8') as file:
        met = [row for row in csv.DictReader(file) if row['status'] == 'hit'][:count]
    return HEADER + ''.join(blast(rng, [float(row[c]) for c in ('cx', 'cy', 'cz')], 0.4, 1.2) for row in met)


def pit(count):
    rng = random.Random(9)
    return HEADER + ''.join(blast(rng, [32 + rng.uniform(-6, 6), 28 + rng.uniform(-6, 6), rng.uniform(-4, 0.3)], 0.5, 1.5) for _ in range(count))


def measure(name, level, blasts, folder):
    def path(file):
        return os.path.join(folder, file)
    with open(path('b.csv'), 'w', encoding='utf-8') as file:
        file.write(blasts)
    told = json.loads(run('carve', level, '--blasts', path('b.csv'), '-o', path('a.firma'), '--log', path('a.firmalog'), '--material', 'crater', '--json'))
    run('log', 'compact', path('a.firmalog'), level, '-o', path('c.firmalog'))
    begin = processor('log', 'verify', path('a.firmalog'), level, '--until', '0')
    by_log = processor('log', 'verify', path('a.firmalog'), level) - begin
    by_patch = processor('log', 'verify', path('c.firmalog'), level) - begin
    size = [os.path.getsize(path(file)) for file in ('a.firmalog', 'c.firmalog', 'a.firma')]
    print('| %s | %d | %d | %.1f | %d | %d | %.2f | %.2f |' %
          (name, told['done'], told['faces_after'], size[0] / told['done'], size[1], size[2], by_log, by_patch), flush=True)


def main():
    print('| level | craters | faces after | log: bytes a crater | compacted: bytes | .firma: bytes | log: s | compacted: s |')
    with tempfile.TemporaryDirectory() as folder:
        for name, level in (('ours', 'levels/first.obj'), ('the depot', 'levels/depot.map')):
            for count in (100, 1000):
                measure(name, level, spread(level, count, folder), folder)
        for count in (300, 3000):
            measure('ours, a pit', 'levels/first.obj', pit(count), folder)


if __name__ == '__main__':
    main()
