#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Cuts and casts of this version beside those of another, in one run, taking turns.

    bench/against/run.py COMMIT [--rounds N] [--repeats N] [--tries-a-turn N]
    bench/against/run.py COMMIT --instructions [--rounds N]

Builds the library of COMMIT in build/against, and this one, both with -O3 -march=native, and work.cpp over each. A
round runs both with the same seed, several times: each round runs once before any runs again. They take turns after
every try of a cut, so that each finds the caches as the other left them, or after several tries. Of a cut the least time
counts: what else the machine does only adds to it, and these machines change their speed, within seconds or for longer.
Cuts: medians and 99th percentiles of all rounds' cuts, and their ratio. Casts: medians of the rounds' least medians, and
the median of their ratios. The least and the most are of rounds. Writes bench/results/against.csv.

With --instructions, what each cut executes is counted by callgrind (Debian's valgrind): the same on every machine and
at every load. Writes bench/results/against_instructions.csv.
"""
import argparse
import concurrent.futures
import csv
import glob
import os
import statistics
import subprocess
import tempfile

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


def measure(before, now, options):
    """By round the least of its runs: times by name, before and now. Each round runs once before any runs again: these
    machines may be slow for longer than a run takes."""
    rounds = [({}, {}) for _ in range(options.rounds)]
    for _ in range(options.repeats):
        for seed, least in enumerate(rounds):
            for times, known in zip(run_both(before, now, seed, options.tries_a_turn), least):
                for key, took in times.items():
                    known[key] = min(known.get(key, took), took)
    return [tuple(by_name(side) for side in least) for least in rounds]


def by_name(times):
    names = {}
    for (name, _), took in times.items():
        names.setdefault(name, []).append(took)
    return names


def count(work, seed):
    """What the cuts of a round executed, each."""
    with tempfile.TemporaryDirectory() as folder:
        out = os.path.join(folder, 'out')
        run('valgrind', '--quiet', '--tool=callgrind', f'--callgrind-out-file={out}', work, LEVEL, str(seed), 'instructions')
        counts = []
        for path in glob.glob(out + '.*'):
            with open(path) as file:
                head = [next(file) for _ in range(20)]  # the last file is of the program's end
            if any('Client Request' in line for line in head):
                counts.append(next(int(line.split()[1]) for line in head if line.startswith('summary:')))
    return counts


def count_rounds(before, now, options, commit):
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        old, new = ([n for counts in pool.map(lambda seed: count(work, seed), range(options.rounds)) for n in counts] for work in (before, now))
    with open(os.path.join(ROOT, 'bench', 'results', 'against_instructions.csv'), 'w', newline='') as file:
        table = csv.writer(file, lineterminator='\n')
        table.writerow(['share of cuts', f'{commit} instructions', 'now instructions', 'ratio'])
        for part in (0.5, 0.9, 0.98, 0.99, 0.995):
            row = [part, share(old, part), share(new, part), f'{share(new, part) / share(old, part):.3f}']
            table.writerow(row)
            print('{:<6} of {} cuts: at most {:>8}, now {:>8} instructions, {} times'.format(row[0], len(new), *row[1:]))


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


def time_rounds(before, now, options, commit):
    rounds = measure(before, now, options)
    with open(os.path.join(ROOT, 'bench', 'results', 'against.csv'), 'w', newline='') as file:
        table = csv.writer(file, lineterminator='\n')
        table.writerow(['work', f'{commit} us', 'now us', 'ratio', 'least', 'most'])
        for name, old, new, *ratios in table_of(rounds):
            row = [name, f'{old:.3g}', f'{new:.3g}', *(f'{ratio:.3f}' for ratio in ratios)]
            table.writerow(row)
            print('{:<22} {:>9} us {:>9} us  {} times ({} to {})'.format(*row))


def main():
    parser = argparse.ArgumentParser(description='Cuts and casts beside those of another version, taking turns.')
    parser.add_argument('commit')
    parser.add_argument('--rounds', type=int, default=7)
    parser.add_argument('--repeats', type=int, default=9)
    parser.add_argument('--tries-a-turn', type=int, default=1)
    parser.add_argument('--instructions', action='store_true')
    options = parser.parse_args()
    commit = run('git', 'rev-parse', '--short', options.commit).strip()
    source = os.path.join(WORK, 'source')
    if os.path.exists(source):
        run('git', 'worktree', 'remove', '--force', source)
    run('git', 'worktree', 'add', '--detach', source, commit)
    before, now = program('before', source), program('now', ROOT)
    (count_rounds if options.instructions else time_rounds)(before, now, options, commit)
    run('git', 'worktree', 'remove', '--force', source)


if __name__ == '__main__':
    main()
