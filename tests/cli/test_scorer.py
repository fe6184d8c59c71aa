# SPDX-License-Identifier: MIT
"""All cases of ../shared/casts by its scorer, one-sided and two-sided, for two skins; skipped (77) where they are not at hand."""
import os
import subprocess
import sys
import tempfile

from harness import FIRMA, ROOT

CASTS = os.path.join(ROOT, '..', 'shared', 'casts')


def main():
    cases = os.path.join(CASTS, 'cases')
    if not os.path.isdir(cases):
        print('no', cases)
        return 77
    names = sorted(file[:-len('.queries.csv')] for file in os.listdir(cases) if file.endswith('.queries.csv'))
    for skin in ['0', '0.01']:
        with tempfile.TemporaryDirectory(prefix='firma-scorer-') as hits:
            for name in names:
                base = os.path.join(cases, name)
                call = [FIRMA, 'cast', base + '.obj', '--queries', base + '.queries.csv', '--skin', skin, '--out']
                subprocess.run([*call, os.path.join(hits, name + '.hits.csv')], check=True, stdout=subprocess.DEVNULL)
                subprocess.run([*call, os.path.join(hits, name + '.hits2.csv'), '--two-sided'], check=True, stdout=subprocess.DEVNULL)
            score = [sys.executable, os.path.join(CASTS, 'score.py'), cases, hits, '--skin', skin, '--list', '3']
            if subprocess.run(score).returncode != 0: return 1
    return 0


if __name__ == '__main__':
    sys.exit(main())
