# SPDX-License-Identifier: MIT
"""test_page.py ROOT PAGE SOURCE PROGRAM: docs/PAGE.md shows docs/SOURCE, and the built program prints what the page says.

For a .mjs PROGRAM is node; it finds the package `firma` in bindings/js."""
import os
import shutil
import subprocess
import sys
import tempfile
import unittest

ROOT, PAGE, SOURCE, PROGRAM = os.path.abspath(sys.argv.pop(1)), sys.argv.pop(1), sys.argv.pop(1), sys.argv.pop(1)
LANGUAGE = {'.cpp': 'cpp', '.c': 'c', '.mjs': 'js'}[os.path.splitext(SOURCE)[1]]


def read(name):
    with open(f'{ROOT}/docs/{name}', encoding='utf-8') as file:
        return file.read()


def run_in(folder):
    """In a folder that has the levels, and takes what the program writes into build/."""
    os.symlink(f'{ROOT}/levels', f'{folder}/levels')
    os.mkdir(f'{folder}/build')
    command = [shutil.which(PROGRAM) or os.path.abspath(PROGRAM)]
    if LANGUAGE == 'js':
        os.mkdir(f'{folder}/node_modules')
        os.symlink(f'{ROOT}/bindings/js', f'{folder}/node_modules/firma')
        command.append(shutil.copy(f'{ROOT}/docs/{SOURCE}', folder))
    return subprocess.run(command, cwd=folder, capture_output=True, text=True, check=True)


class PageTest(unittest.TestCase):
    def test_the_page_shows_the_program(self):
        program = read(SOURCE).split('\n', 2)[2]  # without licence and purpose
        self.assertIn(f'```{LANGUAGE}\n{program}```', read(f'{PAGE}.md'))

    def test_it_prints_what_the_page_says(self):
        with tempfile.TemporaryDirectory(prefix='firma-page-') as folder:
            done = run_in(folder)
        self.assertIn(''.join(f'    {line}\n' for line in done.stdout.splitlines()), read(f'{PAGE}.md'))


if __name__ == '__main__':
    unittest.main()
