# SPDX-License-Identifier: MIT
"""test_page.py ROOT NAME PROGRAM: docs/NAME.md shows docs/NAME.cpp, and the built program prints what the page says."""
import os
import subprocess
import sys
import tempfile
import unittest

ROOT, NAME, PROGRAM = sys.argv.pop(1), sys.argv.pop(1), os.path.abspath(sys.argv.pop(1))


def read(name):
    with open(f'{ROOT}/docs/{name}', encoding='utf-8') as file:
        return file.read()


class PageTest(unittest.TestCase):
    def test_the_page_shows_the_program(self):
        program = read(NAME + '.cpp').split('\n', 2)[2]  # without licence and purpose
        self.assertIn('```cpp\n' + program + '```', read(NAME + '.md'))

    def test_it_prints_what_the_page_says(self):
        with tempfile.TemporaryDirectory(prefix='firma-page-') as folder:  # as it may write into build/
            os.symlink(f'{os.path.abspath(ROOT)}/levels', f'{folder}/levels')
            os.mkdir(f'{folder}/build')
            done = subprocess.run([PROGRAM], cwd=folder, capture_output=True, text=True, check=True)
        self.assertIn(''.join(f'    {line}\n' for line in done.stdout.splitlines()), read(NAME + '.md'))


if __name__ == '__main__':
    unittest.main()
