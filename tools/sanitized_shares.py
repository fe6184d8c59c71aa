# SPDX-License-Identifier: MIT
"""What a share of the claims `sanitized` and `sanitized_saves` runs, and the files that it exercises. For tools/full.py."""
import glob
import os
import re

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))

# Test programs that ctest labels "heavy" under the sanitizers; tests/full/sanitized.sh fails when there are others.
HEAVY_PROGRAMS = 54
HEAVY_SHARE = 3
SAVES_SHARES = 2
SANITIZED_SOURCES = ['include', 'src', 'gltf', 'scenes', 'cli', 'draw', 'bindings/c', 'tests', ':(exclude)tests/tools', 'CMakeLists.txt',
                     'CMakePresets.json', 'cmake']
SHARES_OF_CPP = 10  # shares before the first of the command line
# What saves worlds, keeps logs of edits, plays games. Of the first shares those tests that reach into it run again in a claim of their own,
# so that a share's line does not lapse with it; tests reach it by these headers alone, or by read_world() of a .firma file.
SAVES = ('src/save', 'src/log', 'src/game')
REACHES_SAVES = re.compile(r'^\s*#\s*include\s+"((?:save|log|game|bindings/c|cli)/\w+\.h|firma/(?:save|world_patch|edit_log|game|recording|firma_c)\.h)"', re.M)
# Folders of tests that of all these programs firma_tests and firma_boost_tests alone have, which are in the first shares.
FIRST_SHARES = 9
OF_FIRST_SHARES = ('cast', 'geometry', 'join', 'player')
HEAVY_PARTS = 24  # the first programs: parts of tests/heavy_sanitized.txt, as tests/CMakeLists.txt cuts it
BEFORE_SCRIPTS = 31  # programs before the first that is a script of tests/cli; these follow in the order of its CMakeLists.txt


def suites_of_share(seed):
    """The test suites that a share runs; None where it runs more than parts of the list."""
    if seed * HEAVY_SHARE > HEAVY_PARTS:
        return None
    tests = tests_of_list()
    first, end = ((seed - 1) * HEAVY_SHARE * len(tests) // HEAVY_PARTS, seed * HEAVY_SHARE * len(tests) // HEAVY_PARTS)
    # Of parameterised ones Prefix/Suite.Test/0.
    return {name.partition('.')[0].rpartition('/')[2] for name in tests[first:end]}


def suites_by_source():
    """Each source of firma_tests, with the suites that it has tests of, or makes of parameters."""
    for path in sorted(glob.glob(os.path.join(ROOT, 'tests', '*', 'test_*.cpp'))):
        with open(path, encoding='utf-8') as source:
            text = source.read()
        suites = set(re.findall(r'^(?:TEST|TYPED_TEST)\w*\(\s*(\w+)', text, re.M))
        suites.update(re.findall(r'^INSTANTIATE\w*\(\s*\w+,\s*(\w+)', text, re.M))
        yield os.path.relpath(path, ROOT), suites


def files_reached(path, known):
    """A source of the tests, the files of ours that it includes, and the sources of those of them that tests and scenes have."""
    todo = [path]
    while todo:
        path = todo.pop()
        if path in known:
            continue
        with open(os.path.join(ROOT, path), encoding='utf-8') as source:
            known[path] = source.read()
        for name in re.findall(r'^\s*#\s*include\s+"([^"]+)"', known[path], re.M):
            there = [os.path.normpath(os.path.join(folder, name)) for folder in ('include', 'src', '', os.path.dirname(path))]
            there = [found for found in there if os.path.isfile(os.path.join(ROOT, found))][:1]
            there += [found[:-2] + '.cpp' for found in there if found.startswith(('tests/', 'scenes/'))
                      and os.path.isfile(os.path.join(ROOT, found[:-2] + '.cpp'))]
            todo += there
    return known


def reaches_saves(path):
    return any(REACHES_SAVES.search(text) or (name.startswith(('tests/', 'scenes/')) and re.search(r'\bread_world\(', text))
               for name, text in files_reached(path, {}).items())


def tests_of_list():
    with open(os.path.join(ROOT, 'tests', 'heavy_sanitized.txt'), encoding='utf-8') as lines:
        return [line.strip() for line in lines if line.strip() and not line.startswith('#')]


def tests_that_reach_saves():
    """Of the list, in its order."""
    suites = set().union(*(there for path, there in suites_by_source() if reaches_saves(path)))
    return [test for test in tests_of_list() if test.partition('.')[0].rpartition('/')[2] in suites]


def scripts():
    """The scripts that drive the command line, in the order of their programs."""
    with open(os.path.join(ROOT, 'tests', 'cli', 'CMakeLists.txt'), encoding='utf-8') as lists:
        names = re.search(r'^foreach\(name ([\w ]+)\)', lists.read(), re.M).group(1).split()
    return [f'tests/cli/test_{name}.py' for name in names]


def scripts_of_share(seed):
    first, end = (max(0, k * HEAVY_SHARE - BEFORE_SCRIPTS) for k in (seed - 1, seed))
    return scripts()[first:end]


def sanitized_sources(seed):
    without = ['cli'] if seed <= FIRST_SHARES else [f'tests/{folder}' for folder in OF_FIRST_SHARES]
    if seed <= FIRST_SHARES:
        without += SAVES
    if seed <= SHARES_OF_CPP:
        without.append('tests/cli')
    else:
        mine = scripts_of_share(seed)
        without += [script for script in scripts() if script not in mine]
    suites = suites_of_share(seed)
    if suites is not None:
        without += [path for path, there in suites_by_source() if not there & suites]
    return SANITIZED_SOURCES + [f':(exclude){folder}' for folder in without]
