# SPDX-License-Identifier: MIT
"""test_full.py ROOT: which lines of tools/full.py count, which make a claim fail, and which seed comes next."""
import contextlib
import importlib.util
import io
import os
import re
import subprocess
import sys
import tempfile
import unittest

ROOT = sys.argv.pop(1)


def load():
    spec = importlib.util.spec_from_file_location('full', os.path.join(ROOT, 'tools', 'full.py'))
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


class Lines(unittest.TestCase):
    def setUp(self):
        self.full = load()
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.full.RESULTS = os.path.join(self.folder.name, 'full.txt')
        self.full.same_sources = lambda commit, claim: commit == 'now'
        self.full.changed = lambda claim: False
        self.full.head = lambda: 'now'
        self.full.build = lambda preset, target=None: None
        self.code = 0
        self.claim = self.full.Claim('stones', 'turned', 100, 40, 'stones', [], 'test', self.command)
        self.full.CLAIMS = [self.claim]
        self.ran = []

    def command(self, seed, count):
        self.ran.append((seed, count))
        return [sys.executable, '-c', f'import sys; print("claim=x family=total count={count}"); {self.code}']

    def line(self, seed, count, result='pass', commit='now', claim='stones'):
        with open(self.full.RESULTS, 'a', encoding='utf-8') as file:
            file.write(f'claim={claim} count={count} unit=stones seed={seed} result={result} commit={commit}\n')

    def run_main(self, *arguments):
        said = io.StringIO()
        with contextlib.redirect_stdout(said), contextlib.redirect_stderr(said):
            sys.argv = ['full.py', *arguments]
            code = self.full.main()
        return code, said.getvalue()

    def test_lines_add_up(self):
        self.line(1, 60)
        self.assertEqual(self.run_main('--list')[0], 1)
        self.line(2, 40)
        self.line(9, 1, 'fail', claim='others')
        code, said = self.run_main('--list')
        self.assertEqual(code, 0)
        self.assertIn('100 of 100 stones: holds', said)

    def test_a_failed_line_fails_the_claim(self):
        self.line(1, 100)
        self.line(2, 40, 'fail')
        self.line(3, 100)
        code, said = self.run_main('--list')
        self.assertEqual(code, 1)
        self.assertIn('FAILS', said)
        self.assertIn('seed=2', said)
        self.assertEqual(self.run_main()[0], 1)
        self.assertEqual(self.ran, [], 'there is no outvoting it')

    def test_until_the_sources_change(self):
        self.line(1, 40, 'fail', commit='before')
        self.line(2, 100)
        self.assertEqual(self.run_main('--list')[0], 0)

    def test_what_a_chunk_exercises_goes_by_its_seed(self):
        self.full.same_sources = lambda commit, sources: commit == 'now' or sources == ['few']
        self.claim.sources_of = lambda seed: ['few'] if seed == 1 else ['few', 'more']
        self.line(1, 40, commit='before')
        self.line(2, 40, 'fail', commit='before')
        self.assertEqual(self.run_main()[0], 0)
        self.assertEqual(self.ran, [(2, 40), (3, 20)])

    def test_seeds_are_not_used_twice(self):
        self.line(7, 10, 'fail')
        self.line(3, 10)
        self.line(50, 10, commit='before')
        self.assertEqual(self.full.next_seed(self.claim), 1)
        self.line(1, 10)
        self.line(2, 10, 'fail')
        self.assertEqual(self.full.next_seed(self.claim), 4)

    def test_works_off_in_chunks(self):
        self.assertEqual(self.run_main()[0], 0)
        self.assertEqual(self.ran, [(1, 40), (2, 40), (3, 20)])

    def test_stops_at_a_failure(self):
        self.code = 'sys.exit(1)'
        code, said = self.run_main()
        self.assertEqual(code, 1)
        self.assertIn('FAILS', said)
        self.assertEqual(len(self.ran), 1)
        self.assertEqual(self.full.next_seed(self.claim), 2)

    def test_broken_off_is_no_failure(self):
        self.code = 'import os; os.kill(os.getpid(), 15)'
        self.assertEqual(self.run_main()[0], 1)
        self.assertEqual(self.full.lines_of(self.claim), [])


class Shares(unittest.TestCase):
    def test_what_lapses_with_the_first_shares_alone_is_of_no_other_program(self):
        """Of firma_tests alone: no source of another test program includes a header of these folders, by whatever way."""
        full = load()
        tests = os.path.join(ROOT, 'tests')
        for folder in full.shares.OF_FIRST_SHARES:
            self.assertTrue(os.path.isdir(os.path.join(tests, folder)), folder)
        of_others = [os.path.join(tests, 'world', 'test_cast_touches_nothing.cpp'), os.path.join(tests, 'carve', 'test_carve_no_memory.cpp')]
        for folder in ('bullet', 'c', 'cli', 'draw', 'gltf', 'threads'):
            of_others += [os.path.join(tests, folder, name) for name in os.listdir(os.path.join(tests, folder))]
        self.assertGreater(len(of_others), 50)
        seen = set()
        while of_others:
            path = of_others.pop()
            if path in seen or not path.endswith(('.h', '.cpp', '.c')):
                continue
            seen.add(path)
            self.assertNotIn(os.path.relpath(path, tests).split(os.sep)[0], full.shares.OF_FIRST_SHARES)
            with open(path, encoding='utf-8') as file:
                of_others += [os.path.join(ROOT, line.split('"')[1]) for line in file if line.startswith('#include "tests/')]

    def test_each_share_of_the_list_sees_the_sources_of_its_tests(self):
        full = load()
        by_source = dict(full.shares.suites_by_source())
        shares = full.shares.HEAVY_PARTS // full.shares.HEAVY_SHARE
        self.assertIsNone(full.shares.suites_of_share(shares + 1))
        in_list = set()
        for seed in range(1, shares + 1):
            suites, sources = full.shares.suites_of_share(seed), full.shares.sanitized_sources(seed)
            seen = {path: there for path, there in by_source.items() if f':(exclude){path}' not in sources}
            self.assertEqual(suites - set().union(*seen.values()), set())
            self.assertEqual([path for path, there in seen.items() if not there & suites], [])
            in_list |= suites
        with open(os.path.join(ROOT, 'tests', 'heavy_sanitized.txt'), encoding='utf-8') as lines:
            names = [line.strip() for line in lines if not line.startswith('#')]
        self.assertEqual(in_list, {name.partition('.')[0].rpartition('/')[2] for name in names})
        with open(os.path.join(ROOT, 'tests', 'CMakeLists.txt'), encoding='utf-8') as lines:
            self.assertIn(f'foreach(part RANGE {full.shares.HEAVY_PARTS - 1})', lines.read())

    def test_each_share_of_the_command_line_sees_its_scripts(self):
        full = load()
        shares = full.shares.HEAVY_PROGRAMS // full.shares.HEAVY_SHARE
        there = {f'tests/cli/{name}' for name in os.listdir(os.path.join(ROOT, 'tests', 'cli')) if re.fullmatch(r'test_\w+\.py', name)}
        self.assertEqual(set(full.shares.scripts()), there)
        seen_by = {script: [] for script in there}
        for seed in range(full.shares.SHARES_OF_CPP + 1, shares + 1):
            sources = full.shares.sanitized_sources(seed)
            for script in there:
                if f':(exclude){script}' not in sources:
                    seen_by[script].append(seed)
        for place, script in enumerate(full.shares.scripts()):
            self.assertEqual(seen_by[script], [(full.shares.BEFORE_SCRIPTS + place) // full.shares.HEAVY_SHARE + 1], script)

    def test_what_saves_worlds_is_reached_by_its_headers_alone(self):
        """So a test that sees none of them, through whatever it includes, runs nothing of these folders."""
        full = load()
        others = set()
        for folder, _, names in os.walk(os.path.join(ROOT, 'src')):
            for name in names:
                path = os.path.relpath(os.path.join(folder, name), ROOT)
                with open(os.path.join(ROOT, path), encoding='utf-8') as source:
                    if not path.startswith(full.shares.SAVES) and full.shares.REACHES_SAVES.search(source.read()):
                        others.add(path)
        # The one is read_world(), the other implements write_obj(), which save.h declares.
        self.assertEqual(others, {'src/brush/read_brush_level.cpp', 'src/level/write_obj.cpp'})
        with open(os.path.join(ROOT, 'src', 'level', 'write_obj.cpp'), encoding='utf-8') as source:
            self.assertNotRegex(source.read(), r'(pack|unpack|save|load)_world\(')
        with open(os.path.join(ROOT, 'src', 'brush', 'read_brush_level.cpp'), encoding='utf-8') as source:
            self.assertEqual(len(re.findall(r'(?:pack|unpack|save|load)_world\(', source.read())), 1)

    def test_shares_that_do_not_lapse_with_it(self):
        full = load()
        of_others = ['tests/carve/test_carve_no_memory.cpp', 'tests/world/test_cast_touches_nothing.cpp']
        with open(os.path.join(ROOT, 'tests', 'boost_tests.txt'), encoding='utf-8') as lines:
            of_others += [f'tests/{line.strip()}' for line in lines if line.strip() and not line.startswith('#')]
        self.assertEqual([path for path in of_others if full.shares.reaches_saves(path)], [])
        apart = full.shares.tests_that_reach_saves()
        self.assertGreater(len(apart), 50)
        told = [test for seed in range(1, full.shares.SAVES_SHARES + 1) for test in full.sanitized_saves(seed, 1)[2].split(':')]
        self.assertEqual(sorted(told), sorted(apart))
        for seed in range(1, full.shares.HEAVY_PROGRAMS // full.shares.HEAVY_SHARE + 1):
            for folder in full.shares.SAVES:
                self.assertEqual(f':(exclude){folder}' in full.shares.sanitized_sources(seed), seed <= full.shares.FIRST_SHARES, (seed, folder))
        # Through headers, through what they are implemented in, and by a call.
        for path in ('tests/save/test_save_world.cpp', 'tests/solid/test_solid.cpp', 'tests/body/test_energy.cpp'):
            self.assertTrue(full.shares.reaches_saves(path), path)
        self.assertFalse(full.shares.reaches_saves('tests/player/test_player_worlds.cpp'))

    def test_programs_are_in_the_order_that_shares_go_by(self):
        full = load()
        made = os.path.join(ROOT, 'build', 'sanitize', 'build.ninja')
        lists = [os.path.join(ROOT, path) for path in ('tests/CMakeLists.txt', 'tests/cli/CMakeLists.txt')]
        if not os.path.isfile(made) or any(os.path.getmtime(path) > os.path.getmtime(made) for path in lists):
            self.skipTest('build/sanitize is not configured, or not since its lists changed')
        told = subprocess.run(['ctest', '--preset', 'sanitize', '-N', '-L', 'heavy'], cwd=ROOT, check=True, capture_output=True, text=True).stdout
        programs = re.findall(r'^ *Test *#\d+: (\S+)', told, re.M)
        self.assertEqual(len(programs), full.shares.HEAVY_PROGRAMS)
        self.assertEqual([name.startswith('firma_tests_heavy_') for name in programs], [k < full.shares.HEAVY_PARTS for k in range(len(programs))])
        names = [f'cli_{os.path.basename(script)[5:-3]}' for script in full.shares.scripts()]
        self.assertEqual(programs[full.shares.BEFORE_SCRIPTS:full.shares.BEFORE_SCRIPTS + len(names)], names)


if __name__ == '__main__':
    unittest.main()
