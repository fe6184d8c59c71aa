# SPDX-License-Identifier: MIT
"""test_page.py ROOT PAGE SOURCE PROGRAM: docs/PAGE.md shows docs/SOURCE, and the built program prints what the page says.

A page shows a program, and what it prints, in one block each or in pieces: then all blocks of the language, one behind
the other, are the program, and all indented blocks are what it prints.

For a .mjs PROGRAM is node; it finds the package `firma` in bindings/js."""
import os
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

ROOT, PAGE, SOURCE, PROGRAM = os.path.abspath(sys.argv.pop(1)), sys.argv.pop(1), sys.argv.pop(1), sys.argv.pop(1)
LANGUAGE = {'.cpp': 'cpp', '.c': 'c', '.mjs': 'js'}[os.path.splitext(SOURCE)[1]]
FENCED = re.compile(r'^```(\w*)\n(.*?)^```$', re.S | re.M)


def read(name):
    with open(f'{ROOT}/docs/{name}', encoding='utf-8') as file:
        return file.read()


def lines_of(text):
    """Without empty ones: pieces of a program begin and end where it has them."""
    return [line for line in text.split('\n') if line]


def run_in(folder):
    """In a folder that has the levels, and takes what the program writes into build/."""
    os.symlink(f'{ROOT}/levels', f'{folder}/levels')
    os.mkdir(f'{folder}/build')
    command = [os.path.abspath(shutil.which(PROGRAM) or PROGRAM)]
    if LANGUAGE == 'js':
        os.mkdir(f'{folder}/node_modules')
        os.symlink(f'{ROOT}/bindings/js', f'{folder}/node_modules/firma')
        command.append(shutil.copy(f'{ROOT}/docs/{SOURCE}', folder))
    return subprocess.run(command, cwd=folder, capture_output=True, text=True, check=True)


class PageTest(unittest.TestCase):
    def test_the_page_shows_the_program(self):
        program = read(SOURCE).split('\n', 2)[2]  # without licence and purpose
        blocks = [text for language, text in FENCED.findall(read(f'{PAGE}.md')) if language == LANGUAGE]
        if program not in blocks:
            self.assertEqual(lines_of(''.join(blocks)), lines_of(program))

    def test_it_prints_what_the_page_says(self):
        with tempfile.TemporaryDirectory(prefix='firma-page-') as folder:
            printed = run_in(folder).stdout
        self.assertTrue(printed)
        page = read(f'{PAGE}.md')
        if ''.join(f'    {line}\n' for line in printed.splitlines()) in page:
            return
        shown = [line[4:] for line in FENCED.sub('', page).split('\n') if line.startswith('    ')]
        self.assertEqual(shown, printed.splitlines())


if __name__ == '__main__':
    unittest.main()
