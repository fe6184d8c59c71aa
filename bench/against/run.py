#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Cuts and casts of this version beside those of another, in one run, taking turns.

    bench/against/run.py COMMIT [--rounds N] [--repeats N] [--tries-a-turn N]

Builds the library of COMMIT in build/against, and this one, both with -O3 -march=native, and work.cpp over each. A
round runs both with the same seed, several times over; they take turns after every try of a cut, so that
each finds the caches as the other left them, or after several tries. Of a cut the least
time counts: what else the machine does only adds to it, and these machines change their speed within seconds. Cuts:
medians and 99th percentiles of all rounds' cuts, and their ratio. Casts: medians of the rounds' least medians, and the
median of their ratios. The least and the most are of rounds. Writes bench/results/against.csv.
"""
import argparse
import csv
import os
import statistics
import subprocess

HERE = os.path.dirname(os.path.abspath(__file__))
ROOT = os.path.dirname(os.path.dirname(HERE))
WORK = os.path.join(ROOT, 'build', 'against')
LEVEL = os.path.join(ROOT, 'levels', 'depot.map')
OPTIONS = ['-G', 'Ninja', '-DCMAKE_BUILD_TYPE=Release', '-DCMAKE_CXX_FLAGS=-march=native', '-DFIRMA_BUILD_CLI=OFF', '-DFIRMA_BUILD_C=OFF', '-DFIRMA_UNITE=ON']


def run(*command):
    return subprocess.run(command, cwd=ROOT, check=True, stdout=subprocess.PIPE, text=True).stdout


def program(name, source):
    """Builds a version's library and work.cpp over it."""
    build = os.path.join(WORK, name)
    run('cmake', '-S', source, '-B', build, *OPTIONS)
    run('cmake', '--build', build, '--target', 'firma')
    work = os.path.join(WORK, f'work_{name}')
    run('c++', '-std=c++20', '-O3', '-DNDEBUG', '-march=native', f'-I{source}/include', f'{HERE}/work.cpp', '-o', work,
        f'{build}/libfirma.a', '-lpthread')
    return work


class Side:
    """A version at work."""

    def __init__(self, work, seed, tries_a_turn):
        self.process = subprocess.Popen([work, LEVEL, str(seed), str(tries_a_turn)], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True)
        self.times = {}

    def take_turn(self):
        """True if it told tries of a cut; the casts, which are its last turn, are told together."""
        self.process.stdin.write('\n')
        self.process.stdin.flush()
        for line in self.process.stdout:
            name, number, value, *end = line.split()
            key, took = (name, int(number)), float(value) / 1e3
            self.times[key] = min(self.times.get(key, took), took)
            if end:
                return True
        if self.process.wait() != 0:
            raise SystemExit('bench/against: a version ended with an error')
        return False


def run_both(before, now, seed, tries_a_turn):
    """What both took, in microseconds by name and number."""
    sides = [Side(before, seed, tries_a_turn), Side(now, seed, tries_a_turn)]
    turn = seed
    while True:
        first, second = (sides[0], sides[1]) if turn % 2 == 0 else (sides[1], sides[0])
        going = first.take_turn()
        if going != second.take_turn():
            raise SystemExit('bench/against: the versions made different numbers of cuts')
        if not going:
            return [side.times for side in sides]
        turn += 1


def measure(before, now, seed, options):
    """The least of several runs: times by name, before and now."""
    runs = [run_both(before, now, seed, options.tries_a_turn) for _ in range(options.repeats)]
    sides = []
    for side in (0, 1):
        times = {}
        for key in runs[0][side]:
            times.setdefault(key[0], []).append(min(both[side][key] for both in runs))
        sides.append(times)
    return sides


def share(times, part):
    return sorted(times)[int(part * len(times))]


def table_of(rounds):
    """Rows: name, before, now, their ratio, its least and most of the rounds."""
    for name in rounds[0][0]:
        if not name.startswith('cut'):
            pairs = [(old[name][0], new[name][0]) for old, new in rounds]
            ratios = [new / old for old, new in pairs]
            yield name, *(statistics.median(side) for side in zip(*pairs)), statistics.median(ratios), min(ratios), max(ratios)
            continue
        for part, what in ((0.5, name), (0.99, name + '_p99')):
            old, new = (share([t for pair in rounds for t in pair[side][name]], part) for side in (0, 1))
            ratios = [share(b[name], part) / share(a[name], part) for a, b in rounds]
            yield what, old, new, new / old, min(ratios), max(ratios)


def main():
    parser = argparse.ArgumentParser(description='Cuts and casts beside those of another version, taking turns.')
    parser.add_argument('commit')
    parser.add_argument('--rounds', type=int, default=7)
    parser.add_argument('--repeats', type=int, default=9)
    parser.add_argument('--tries-a-turn', type=int, default=1)
    options = parser.parse_args()
    commit = run('git', 'rev-parse', '--short', options.commit).strip()
    source = os.path.join(WORK, 'source')
    if os.path.exists(source):
        run('git', 'worktree', 'remove', '--force', source)
    run('git', 'worktree', 'add', '--detach', source, commit)
    before, now = program('before', source), program('now', ROOT)
    rounds = [measure(before, now, seed, options) for seed in range(options.rounds)]
    run('git', 'worktree', 'remove', '--force', source)
    with open(os.path.join(ROOT, 'bench', 'results', 'against.csv'), 'w', newline='') as file:
        table = csv.writer(file, lineterminator='\n')
        table.writerow(['work', f'{commit} us', 'now us', 'ratio', 'least', 'most'])
        for name, old, new, *ratios in table_of(rounds):
            row = [name, f'{old:.3g}', f'{new:.3g}', *(f'{ratio:.3f}' for ratio in ratios)]
            table.writerow(row)
            print('{:<22} {:>9} us {:>9} us  {} times ({} to {})'.format(*row))


if __name__ == '__main__':
    main()
