# SPDX-License-Identifier: MIT
"""test_check_layers.py ROOT: every include of the project is one that its layer may have, and others would be found."""
import os
import subprocess
import sys
import tempfile
import unittest

ROOT = sys.argv.pop(1)
TOOL = os.path.join(ROOT, 'tools', 'check_layers.py')


def check(root):
    return subprocess.run([sys.executable, TOOL, root], capture_output=True, text=True)


class LayersTest(unittest.TestCase):
    def house(self, **files):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        for name, text in files.items():
            path = os.path.join(folder.name, name.replace('__', '/') + '.h')
            os.makedirs(os.path.dirname(path), exist_ok=True)
            with open(path, 'w', encoding='utf-8') as file:
                file.write(text)
        return folder.name

    def test_the_project_holds(self):
        done = check(ROOT)
        self.assertEqual(done.returncode, 0, done.stdout)

    def test_an_include_that_points_down_is_fine(self):
        self.assertEqual(check(self.house(src__base__a='', src__cast__b='#include "base/a.h"')).returncode, 0)

    def test_an_include_that_points_up_fails(self):
        done = check(self.house(src__base__a='\n#include "cast/b.h"', src__cast__b=''))
        self.assertEqual(done.returncode, 1)
        self.assertIn('src/base/a.h:2: src/base includes src/cast/b.h, which stands above it', done.stdout)

    def test_modules_do_not_include_each_other(self):
        for one, other in (('carve', 'join'), ('level', 'save'), ('save', 'store')):
            done = check(self.house(**{f'src__{one}__a': f'#include "{other}/b.h"', f'src__{other}__b': ''}))
            self.assertEqual(done.returncode, 1)
            self.assertIn('a module beside it', done.stdout)

    def test_solid_stands_below_carve_and_carve_below_world(self):
        self.assertEqual(check(self.house(src__solid__a='#include "carve/b.h"', src__carve__b='')).returncode, 1)
        self.assertEqual(check(self.house(src__carve__a='#include "world/b.h"', src__world__b='')).returncode, 1)
        self.assertEqual(check(self.house(src__world__a='#include "carve/b.h"', src__carve__b='')).returncode, 0)

    def test_gltf_includes_public_headers_and_level_alone(self):
        self.assertEqual(check(self.house(gltf__a='#include "level/b.h"', src__level__b='')).returncode, 0)
        self.assertEqual(check(self.house(gltf__a='#include "firma/b.h"', include__firma__b='')).returncode, 0)
        for layer in ('geometry', 'index', 'carve', 'join', 'world'):
            done = check(self.house(**{'gltf__a': f'#include "{layer}/b.h"', f'src__{layer}__b': ''}))
            self.assertEqual(done.returncode, 1)
            self.assertIn(f'gltf includes src/{layer}/b.h; it may include include/firma, src/level alone', done.stdout)

    def test_pictures_include_public_headers_alone_and_stand_beside_gltf(self):
        self.assertEqual(check(self.house(draw__a='#include "firma/b.h"', include__firma__b='')).returncode, 0)
        self.assertEqual(check(self.house(cli__a='#include "draw/b.h"', draw__b='')).returncode, 0)
        for layer in ('geometry', 'world', 'brush'):
            done = check(self.house(**{'draw__a': f'#include "{layer}/b.h"', f'src__{layer}__b': ''}))
            self.assertEqual(done.returncode, 1)
            self.assertIn(f'draw includes src/{layer}/b.h; it may include include/firma alone', done.stdout)
        self.assertEqual(check(self.house(draw__a='#include "gltf/b.h"', gltf__b='')).returncode, 1)
        self.assertEqual(check(self.house(src__world__a='#include "draw/b.h"', draw__b='')).returncode, 1)

    def test_a_folder_in_no_layer_fails(self):
        done = check(self.house(src__base__a='', src__attic__b=''))
        self.assertEqual(done.returncode, 1)
        self.assertIn('src/attic/b.h: its folder is in no layer', done.stdout)

    def test_an_include_of_nothing_fails(self):
        self.assertEqual(check(self.house(src__base__a='#include "base/none.h"')).returncode, 1)

    def test_a_folder_without_sources_is_a_bad_call(self):
        self.assertEqual(check(self.house()).returncode, 2)


if __name__ == '__main__':
    unittest.main()
