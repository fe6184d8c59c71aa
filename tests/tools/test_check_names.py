# SPDX-License-Identifier: MIT
"""test_check_names.py ROOT: no two files of the project define one type each of one name, and such files would be found."""
import os
import subprocess
import sys
import tempfile
import unittest

ROOT = sys.argv.pop(1)
TOOL = os.path.join(ROOT, 'tools', 'check_names.py')


sys.path.insert(0, os.path.dirname(TOOL))
sys.dont_write_bytecode = True
import check_names  # noqa: E402


def run(root):
    return subprocess.run([sys.executable, TOOL, root], capture_output=True, text=True)


class NamesTest(unittest.TestCase):
    def project(self, files):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        for name, text in files.items():
            path = os.path.join(folder.name, name)
            os.makedirs(os.path.dirname(path), exist_ok=True)
            with open(path, 'w', encoding='utf-8') as file:
                file.write(text)
        return folder.name

    def pair(self, one, other, places=('src/base/a.h', 'src/carve/b.cpp')):
        return check_names.check(self.project(dict(zip(places, (one, other)))))

    def finds(self, name, one, other, line=1, **given):
        faults = self.pair(one, other, **given)[2]
        self.assertEqual(len(faults), 1, f'{one!r} {other!r} {faults}')
        self.assertIn(f':{line}: {name} is defined in ', faults[0])

    def passes(self, one, other, types=None, **given):
        found, files, faults = self.pair(one, other, **given)
        self.assertEqual((files, faults), (2, []), other)
        if types is not None:
            self.assertEqual(found, types, other)

    def test_the_project_holds(self):
        done = run(ROOT)
        self.assertEqual(done.returncode, 0, done.stdout)
        count = int(done.stdout.split('\n')[-2].split()[0])
        self.assertGreater(count, 500, done.stdout)  # it has them all before its eyes

    def test_two_of_one_name_are_named_with_their_places(self):
        done = run(self.project({'src/base/a.h': '\nnamespace firma {\nstruct Walk {\n    int k;\n};\n}\n',
                                 'src/carve/b.cpp': '\n\nnamespace firma { class Walk final { int j; }; }\n'}))
        self.assertEqual(done.returncode, 1)
        self.assertIn('src/carve/b.cpp:3: firma::Walk is defined in src/base/a.h:3 too', done.stdout)
        self.assertIn('2 types in 2 files, 1 faults', done.stdout)

    def test_every_way_to_define_one(self):
        for other in ('struct Walk { };', 'class Walk { };', 'union Walk { int k; };', 'enum Walk { kOne };', 'enum class Walk { kOne };',
                      'enum class Walk : unsigned char { kOne };', 'struct Walk final { };', 'struct FIRMA_EXPORT Walk { };', 'struct alignas(16) Walk { };',
                      'struct [[nodiscard]] Walk { };', 'struct Walk : Base<int, 3>, private Other { };', 'template <class T, int (*f)(int)> struct Walk { };',
                      'template <class T = Map<int, Set<int>>> class Walk { };', 'struct Walk { } walk;', 'typedef struct Walk { int k; } Walk;'):
            self.finds('firma::Walk', 'namespace firma { struct Walk { }; }', f'namespace firma {{ {other} }}')
            self.finds('firma::Walk', f'namespace firma {{ {other} }}', 'namespace firma { struct Walk { }; }')

    def test_a_namespace_is_one_however_it_is_opened(self):
        self.finds('firma::c::Walk', 'namespace firma::c { struct Walk { }; }', 'namespace firma { namespace c { struct Walk { }; } }')
        self.finds('Walk', 'struct Walk { };', 'extern "C" { struct Walk { }; }')
        self.finds('firma::Walk', 'namespace firma { struct Walk { }; }', 'namespace firma { int f() { return 1; } }\nnamespace firma { struct Walk { }; }', line=2)
        self.passes('namespace firma { struct Walk { }; }', 'namespace firma::c { struct Walk { }; } struct Walk { };', types=3)
        self.passes('namespace firma { struct Walk { }; }', 'namespace other = firma; struct Walk { };', types=2)

    def test_what_is_no_second_definition(self):
        for other in ('struct Walk;', 'enum class Walk : int;', 'struct Walk walk();', 'template <class Walk> void go(Walk) {}', 'struct Walk* next = nullptr;',
                      'using Walk = int;', 'friend class Walk;', 'struct Walk walk{};', '// struct Walk { };', '/* struct Walk { }; */', 'const char* a = "struct Walk { };";',
                      'const char* a = R"x(struct Walk { };)x";', '#define A struct Walk { }', '#define A \\\n    struct Walk { };',
                      "const char a = '{'; const int b = 1'000;"):
            self.passes('namespace firma { struct Walk { }; }', f'namespace firma {{\n{other}\n}}', types=1)

    def test_types_that_others_do_not_see(self):
        self.passes('namespace firma { struct Walk { }; }', 'namespace firma { namespace { struct Walk { }; } }', types=1)
        self.passes('namespace firma { struct Walk { }; }', 'namespace { namespace firma { struct Walk { }; } }', types=1)
        self.passes('namespace firma { struct Walk { }; }', 'namespace firma { void f() { struct Walk { }; } }', types=1)
        self.passes('namespace firma { struct Walk { }; }', 'namespace firma { struct Run { struct Walk { }; enum Sort { kA }; }; }', types=2)
        self.passes('namespace firma { struct Walk { }; }', 'namespace firma { auto f = [] { struct Walk { }; return 1; }; }', types=1)

    def test_types_within_others_by_their_whole_name(self):
        self.finds('firma::Job::State', 'namespace firma { struct Job::State { }; }', 'namespace firma { struct Job::State { int k; }; }')
        self.passes('namespace firma { struct Job::State { }; }', 'namespace firma { struct Cut::State { }; struct State { }; }', types=3)

    def test_specialisations_by_their_arguments(self):
        self.finds('std::hash< int >', 'template <> struct std::hash<int> { };', 'template <> struct std::hash<int> { };')
        self.passes('template <> struct std::hash<int> { };', 'template <> struct std::hash<long> { };', types=2)
        self.passes('template <class T> struct Hash { };', 'template <class T> struct Hash<T*> { };', types=2)

    def test_programs_are_compared_with_the_library_and_with_their_folder(self):
        walk = 'namespace firma { struct Walk { }; }'
        self.finds('firma::Walk', walk, walk, places=('include/firma/a.h', 'tests/base/b.cpp'))
        self.finds('firma::Walk', walk, walk, places=('cli/a.h', 'src/base/b.cpp'))
        self.finds('firma::Walk', walk, walk, places=('tests/base/a.h', 'tests/base/b.cpp'))
        self.passes(walk, walk, places=('tests/base/a.h', 'bench/b.cpp'))
        self.passes(walk, walk, places=('src/base/file_aside.cpp', 'src/base/file_aside_windows.cpp'))

    def test_a_file_that_cannot_be_read_is_a_fault(self):
        for text in ('namespace firma {', 'struct Walk { (] };', '}', 'void f() { ( }'):
            faults = self.pair(text, '')[2]
            self.assertEqual(len(faults), 1)
            self.assertIn('src/base/a.h: its brackets do not close each other', faults[0])

    def test_a_folder_without_sources_is_a_bad_call(self):
        self.assertEqual(run(self.project({})).returncode, 2)


if __name__ == '__main__':
    unittest.main()
