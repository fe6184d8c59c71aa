#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Cuts and casts of this version beside those of another, in one run, taking turns.

    bench/against/run.py COMMIT [--rounds N]

Builds the library of COMMIT in build/against, and this one, both with -O3 -march=native, and work.cpp over each. Every
round runs both, first the one, then the other, with another seed; told is the median of the rounds' ratios. Writes
bench/results/against.csv.
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


def measure(work, seed):
    lines = [line.split() for line in run(work, LEVEL, str(seed)).splitlines()]
    return {name: float(value) for name, value in lines}


def main():
    parser = argparse.ArgumentParser(description='Cuts and casts beside those of another version, taking turns.')
    parser.add_argument('commit')
    parser.add_argument('--rounds', type=int, default=7)
    options = parser.parse_args()
    commit = run('git', 'rev-parse', '--short', options.commit).strip()
    source = os.path.join(WORK, 'source')
    if os.path.exists(source):
        run('git', 'worktree', 'remove', '--force', source)
    run('git', 'worktree', 'add', '--detach', source, commit)
    before, now = program('before', source), program('now', ROOT)
    rounds = []
    for seed in range(options.rounds):
        pair = (measure(before, seed), measure(now, seed)) if seed % 2 == 0 else (measure(now, seed), measure(before, seed))[::-1]
        rounds.append(pair)
    run('git', 'worktree', 'remove', '--force', source)
    with open(os.path.join(ROOT, 'bench', 'results', 'against.csv'), 'w', newline='') as file:
        table = csv.writer(file, lineterminator='\n')
        table.writerow(['work', f'{commit} us', 'now us', 'ratio', 'least', 'most'])
        for name in rounds[0][0]:
            ratios = [after[name] / old[name] for old, after in rounds]
            row = [name, f'{statistics.median(old[name] for old, _ in rounds) / 1e3:.3g}',
                   f'{statistics.median(after[name] for _, after in rounds) / 1e3:.3g}', f'{statistics.median(ratios):.3f}',
                   f'{min(ratios):.3f}', f'{max(ratios):.3f}']
            table.writerow(row)
            print('{:<22} {:>9} us {:>9} us  {} times ({} to {})'.format(*row))


if __name__ == '__main__':
    main()
