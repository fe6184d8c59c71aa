# SPDX-License-Identifier: MIT
"""test_check_words.py ROOT: the project uses the field's words, and others would be found where people read them."""
import os
import subprocess
import sys
import tempfile
import unittest

ROOT = sys.argv.pop(1)
TOOL = os.path.join(ROOT, 'tools', 'check_words.py')


def check(root):
    return subprocess.run([sys.executable, TOOL, root], capture_output=True, text=True)


class WordsTest(unittest.TestCase):
    def project(self, files):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        for name, text in files.items():
            path = os.path.join(folder.name, name)
            os.makedirs(os.path.dirname(path), exist_ok=True)
            with open(path, 'w', encoding='utf-8') as file:
                file.write(text)
        return folder.name

    def finds(self, name, text, line, instead):
        done = check(self.project({name: text}))
        self.assertEqual(done.returncode, 1, f'{name}: {text!r}')
        self.assertIn(f'{name}:{line}: ', done.stdout)
        self.assertIn(instead, done.stdout)

    def passes(self, name, text):
        done = check(self.project({name: text}))
        self.assertEqual((done.returncode, done.stdout), (0, '0 faults\n'), f'{name}: {text!r}')

    def test_the_project_holds(self):
        done = check(ROOT)
        self.assertEqual(done.returncode, 0, done.stdout)

    def test_prose_of_documents(self):
        for word, instead in (('The skin is kept.', 'contact offset'), ('Two bins meet.', 'node or leaf'), ('It visits them.', 'traverse'),
                              ('Faces that it looked at.', 'candidate faces'), ('Then casts look at fewer.', 'candidate faces'),
                              ('The face is gone.', 'removed'), ('No ray told.', 'unclassified'), ('A shelf of pieces.', 'size class'),
                              ('It is dressed.', 'fill'), ('The exact twin.', 'reference oracle'), ('Large numbers hold.', 'soak tests'),
                              ('A number that is no good.', 'non-finite'), ('Where it is touching.', 'initial overlap'), ('The point is unsure.', 'unknown'),
                              ('We visit a face.', 'traverse'), ('Two faces came.', 'added'), ('Not most_faces.', 'max_'), ('The largest_cutter.', 'max_')):
            self.finds('docs/a.md', f'# Title\n\n{word}\n', 3, instead)

    def test_the_code_is_no_building(self):
        for name in ('README.md', 'CONTRIBUTING.md', 'docs/architecture.md', 'docs/STATUS.md', 'docs/install.md'):
            self.finds(name, 'Layers point toward the roof.\n', 1, 'module or layer')
            self.finds(name, 'Two floors of it.\n', 1, 'module or layer')
            self.finds(name, 'The new house stands.\n', 1, 'the code')
        self.passes('docs/rooms.md', 'The roof of a level closes it.\n')

    def test_code_in_documents_is_left_alone(self):
        for text in ('The column `skin` stays.\n', 'Run\n\n    build/bin/bins --skin\n\nand read.\n', '```cpp\nint bins = 0;\n```\n',
                     'See [it](skin.md) and https://example.org/skin.\n', '<!-- table a: bins; skin -->\n', '    bins a skin\n'):
            self.passes('docs/a.md', '# Title\n\n' + text)

    def test_lines_that_go_on_are_no_code(self):
        self.finds('docs/a.md', '1. A cast meets\n    some bins.\n', 2, 'node or leaf')

    def test_words_after_code_are_found(self):
        self.finds('docs/a.md', 'Of `bins` two\nbins are left.\n', 2, 'node or leaf')
        self.finds('docs/a.md', 'Run\n\n    bins\n\nall bins.\n', 5, 'node or leaf')

    def test_words_of_others_are_right_where_they_are_said_to_be(self):
        self.passes('docs/benchmarks.md', "Against the article's bins.\n\n<!-- table a -->\n| rule | bins |\n|---|---|\n| skin | 1 |\n")
        self.finds('docs/benchmarks.md', '| rule | bins |\n|---|---|\n', 1, 'node or leaf')
        self.finds('docs/benchmarks.md', '<!-- table a -->\n| bins |\n\n| bins |\n', 4, 'node or leaf')
        self.finds('docs/benchmarks.md', 'Against bins.\n', 1, 'node or leaf')
        self.passes('docs/migration.md', '| skin | contact offset |\n')
        self.finds('docs/migration.md', 'The skin.\n', 1, 'contact offset')
        self.passes('docs/coming_from.md', '| its skin | ours |\n')
        self.finds('docs/a.md', '| its skin | ours |\n', 1, 'contact offset')

    def test_plain_words_that_only_look_alike(self):
        for text in ('Points come from the file.\n', 'Faces come from brushes, rooms come to an end.\n', 'The largest side counts.\n', 'Until `visit` returns.\n',
                     'Most faces touch.\n', 'It lands on floors.\n'):
            self.passes('docs/a.md', text)

    def test_names_in_headers(self):
        for line, instead in (('double skin = 0;', 'contact_offset'), ('int faces_per_bin = 4;', 'nodes, leaves'), ('int most_faces;', 'max_'),
                              ('int kMostTiles;', 'kMax'), ('double largest_cutter;', 'max_'), ('int faces_looked_at;', 'candidate_faces'),
                              ('int faces_gone;', 'removed'), ('int portals_come;', 'removed, added'), ('kTouching,', 'initial overlap'),
                              ('RoomId part_of;', 'merged_into'), ('kUnsure,', 'unknown'), ('void visit_faces();', 'each_'), ('struct twin_world;', 'oracle')):
            self.finds('include/firma/a.h', f'#pragma once\n{line}\n', 2, instead)
        for line, instead in (('    facesPerBin?: number;', 'nodes, leaves'), ('    mostFaces?: number;', 'max'), ('    facesGone: number;', 'removed')):
            self.finds('bindings/js/index.d.ts', f'interface A {{\n{line}\n}}\n', 2, instead)

    def test_names_that_only_look_alike(self):
        for line in ('std::size_t binary_size;', 'int robin;', 'int max_almost_all;', 'double largest(double a);', 'int welcome;', 'int combined;'):
            self.passes('include/firma/a.h', f'#pragma once\n{line}\n')

    def test_comments_of_headers(self):
        self.finds('include/firma/a.h', 'int a;\nint b;  ///< how much of the skin is kept\n', 2, 'contact offset')
        self.finds('include/firma/firma_c.h', '/* Of all\n * bins. */\nint a;\n', 2, 'node or leaf')
        self.finds('bindings/js/index.d.ts', '/** What casts looked at. */\nexport {};\n', 1, 'candidate faces')
        self.passes('include/firma/a.h', 'int a;  ///< CSV calls it `skin`\n')

    def test_names_of_the_version_before_stand_at_the_end_of_the_c_header(self):
        old = '/* ---- names of version 0.1 ---- */\n/* The skin. */\n#define skin contact_offset\n'
        self.passes('include/firma/firma_c.h', 'int a;\n' + old)
        self.finds('include/firma/firma_c.h', 'int bins;\n' + old, 1, 'nodes, leaves')

    def test_help_and_messages(self):
        self.finds('cli/verb_a.cpp', 'int a;\nconst char* help = "how far the skin reaches";\n', 2, 'contact offset')
        self.finds('cli/verb_a.cpp', 'const char* footer = R"(first line\nbins a cast\n)";\n', 2, 'node or leaf')
        self.finds('src/level/a.cpp', 'throw "a number that is no good";\n', 1, 'non-finite')
        self.finds('bindings/js/src/a.js', "throw new Error('the skin must be a length');\n", 1, 'contact offset')
        self.finds('playground/src/a.js', 'const text = `the cast looked at ${n} nodes`;\n', 1, 'candidate faces')
        self.finds('test', 'echo "the large numbers"\n', 1, 'soak tests')

    def test_what_programs_read_is_left_alone(self):
        self.passes('cli/verb_a.cpp', 'json.key("bins"); csv << "skin"; // the skin\nconst int bins = 0;\n')
        self.passes('bindings/js/src/a.js', "names.push('skin'); // bins\n")
        self.passes('cli/verb_a.cpp', 'const char* footer = R"(columns\n\n--json: skin, bins (how many)\n)";\n')

    def test_each_fault_is_counted(self):
        done = check(self.project({'docs/a.md': 'bins, bins\nskin\n', 'README.md': 'twins\n'}))
        self.assertTrue(done.stdout.endswith('\n4 faults\n'), done.stdout)

    def test_packages_of_others_are_not_read(self):
        root = self.project({'docs/a.md': 'fine\n', 'tools/node_modules/a/README.md': 'bins\n'})
        self.assertEqual(check(root).returncode, 0)

    def test_a_folder_with_nothing_to_read_is_a_bad_call(self):
        done = check(self.project({'a.txt': 'bins\n'}))
        self.assertEqual(done.returncode, 2)
        self.assertIn('no documents', done.stderr)


if __name__ == '__main__':
    unittest.main()
