# SPDX-License-Identifier: MIT
"""test_hello.py ROOT HELLO: docs/hello.md shows docs/hello.cpp, and the built program prints what the page says."""
import subprocess
import sys
import unittest

ROOT, HELLO = sys.argv.pop(1), sys.argv.pop(1)


def read(name):
    with open(f'{ROOT}/docs/{name}', encoding='utf-8') as file:
        return file.read()


class HelloTest(unittest.TestCase):
    def test_the_page_shows_the_program(self):
        program = read('hello.cpp').split('\n', 2)[2]  # without licence and purpose
        self.assertIn('```cpp\n' + program + '```', read('hello.md'))

    def test_it_prints_what_the_page_says(self):
        done = subprocess.run([HELLO], cwd=ROOT, capture_output=True, text=True, check=True)
        self.assertIn('    ' + done.stdout, read('hello.md'))


if __name__ == '__main__':
    unittest.main()
