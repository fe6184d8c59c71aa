# SPDX-License-Identifier: MIT
"""Runs the built `firma` for the tests: path of the binary as first argument or in FIRMA."""
import json
import os
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

FIRMA = os.path.abspath(sys.argv.pop(1) if len(sys.argv) > 1 and not sys.argv[1].startswith('-')
                        else os.environ.get('FIRMA', 'build/release/bin/firma'))
ROOT = os.path.abspath(os.path.join(os.path.dirname(__file__), '..', '..'))
FIRST = os.path.join(ROOT, 'levels', 'first.obj')
# Whether it was built under the address or thread sanitizer: then all takes ten times as long.
with open(FIRMA, 'rb') as program:
    SANITIZED = re.search(b'__[at]san_init', program.read()) is not None
PATIENCE = 3000 if SANITIZED else 300  # seconds, for one call


class CliTest(unittest.TestCase):
    """A test with a folder of its own, in which firma runs."""

    def setUp(self):
        self.folder = tempfile.mkdtemp(prefix='firma-test-')
        self.addCleanup(shutil.rmtree, self.folder)

    def path(self, name):
        return os.path.join(self.folder, name)

    def write(self, name, text):
        with open(self.path(name), 'wb') as file:
            file.write(text if isinstance(text, bytes) else text.encode())
        return name

    def read(self, name):
        with open(self.path(name), 'rb') as file:
            return file.read()

    def files(self):
        return sorted(os.listdir(self.folder))

    def run_firma(self, *arguments, **options):
        return subprocess.run([FIRMA, *map(str, arguments)], cwd=self.folder, capture_output=True, timeout=PATIENCE, **options)

    def firma(self, *arguments):
        """A call that works; returns what it printed."""
        done = self.run_firma(*arguments)
        self.assertEqual(done.returncode, 0, (arguments, done.stderr))
        self.assertEqual(done.stderr, b'')
        return done.stdout.decode()

    def firma_json(self, *arguments, code=0):
        """A call with --json; standard output must be one object and nothing else."""
        done = self.run_firma(*arguments, '--json')
        self.assertEqual(done.returncode, code, (arguments, done.stderr))
        return json.loads(done.stdout)

    def refuse(self, *arguments, says=(), **options):
        """A call that must end with 2, a sentence on stderr, nothing on stdout, and no file made or changed."""
        before = {name: self.read(name) for name in self.files() if os.path.isfile(self.path(name))}
        done = self.run_firma(*arguments, **options)
        message = done.stderr.decode()
        self.assertEqual(done.returncode, 2, (arguments, message))
        self.assertEqual(done.stdout, b'', arguments)
        self.assertRegex(message, r'^firma: .+\n$', arguments)
        for text in [says] if isinstance(says, str) else says:
            self.assertIn(text, message, arguments)
        after = {name: self.read(name) for name in self.files() if os.path.isfile(self.path(name))}
        self.assertEqual(before, after, arguments)
        return message


def box(size_x, size_y, size_z, low=(0, 0, 0)):
    """A closed room with its faces wound into the air, as .obj text."""
    corners = [(low[0] + size_x * (k & 1), low[1] + size_y * (k >> 1 & 1), low[2] + size_z * (k >> 2 & 1)) for k in range(8)]
    faces = [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]
    return obj(corners, faces)


def obj(corners, faces):
    return (''.join('v %.12f %.12f %.12f\n' % c for c in corners) +
            ''.join('f %s\n' % ' '.join(str(k + 1) for k in face) for face in faces))


if __name__ == '__main__':
    sys.exit('a helper of the tests beside it')
