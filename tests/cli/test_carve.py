# SPDX-License-Identifier: MIT
"""firma carve: the blasts it reads, the report and the level it writes; firma draw of blasts."""
import csv
import io
import os
import re
import unittest
import zlib

from harness import FIRST, CliTest, box, obj

HEADER = 'x,y,z,radius,shape,seed\n'
REPORT = 'blast,status,ms,faces_gone,faces_new,retries,volume,hash,castable_only,portals,rooms,chunks,chunk_volume,' \
         'open_trimmed,open_removed,panes,clips,reason'
FLOOR = '35,29,0.2,1.6,rocky,1\n'     # in the floor of the hall
AIR = '35,29,3,0.5,rocky,4\n'         # in the middle of its air
OUTSIDE = '9000,0,0,1,rocky,3\n'


class CarveTest(CliTest):
    def carve(self, level, rows, *options, out='a.obj', stderr=False):
        """Carves, and returns the report's rows."""
        self.write('b.csv', HEADER + rows)
        done = self.run_firma('carve', level, '--blasts', 'b.csv', '-o', out, '--report', 'r.csv', *options)
        self.assertEqual(done.returncode, 0, done.stderr)
        if not stderr: self.assertEqual(done.stderr, b'')
        self.stderr = done.stderr.decode()
        text = self.read('r.csv').decode()
        self.assertEqual(text.splitlines()[0], REPORT)
        return list(csv.DictReader(io.StringIO(text)))

    def sound(self, level):
        return self.firma_json('check', level)


class Report(CarveTest):
    def test_rows(self):
        rows = self.carve(FIRST, FLOOR + AIR + OUTSIDE + '35,29,0,0,rocky,1\n35,29,0,-2,box,1\n30,25,0,0.5,drill,2\n', stderr=True)
        self.assertEqual([row['blast'] for row in rows], ['0', '1', '2', '3', '4', '5'])
        self.assertEqual([row['status'] for row in rows], ['done', 'nothing', 'refused', 'refused', 'refused', 'done'])
        for row in rows:
            self.assertGreater(float(row['ms']), 0)
            self.assertRegex(row['hash'], r'^[0-9a-f]{16}$')
            self.assertEqual(row['volume'], '%.17g' % float(row['volume']))
            if row['status'] == 'done':
                self.assertGreater(int(row['faces_gone']), 0)
                self.assertGreater(int(row['faces_new']), 50)
                self.assertGreater(float(row['volume']), 0)
            else:
                self.assertEqual((row['faces_gone'], row['faces_new'], row['volume']), ('0', '0', '0'))
        hashes = [row['hash'] for row in rows]
        self.assertEqual(len(set(hashes)), 2)                                  # what did nothing left the hash as it was
        self.assertEqual(hashes[:5], hashes[:1] * 5)
        for blast, line in [(2, 4), (3, 5), (4, 6)]:
            self.assertIn('firma: b.csv:%d: blast %d refused: ' % (line, blast), self.stderr)
        self.assertEqual(self.stderr.count('\n'), 3)

    def test_chunks(self):
        """The bridge across the hall of levels/first.obj, as in docs/chunks.md; of other turns."""
        shots = '22,29,4.75,3,rocky,1\n42,29,4.75,3,rocky,1\n'
        plain = self.carve(FIRST, shots)
        self.assertEqual([(row['chunks'], row['chunk_volume']) for row in plain], [('0', '0')] * 2)
        rows = self.carve(FIRST, shots, '--chunks', '--density', '2400', '--min-volume', '0.01', '--chunk-report', 'c.csv', out='a.firma')
        self.assertEqual([row['chunks'] for row in rows], ['0', '1'])
        self.assertEqual([row['volume'] for row in rows], [row['volume'] for row in plain])  # what the cutters took
        self.assertEqual(rows[0]['hash'], plain[0]['hash'])
        self.assertNotEqual(rows[1]['hash'], plain[1]['hash'])
        chunk, = csv.DictReader(io.StringIO(self.read('c.csv').decode()))
        self.assertEqual((chunk['blast'], chunk['chunk'], chunk['volume']), ('1', '0', rows[1]['chunk_volume']))
        chunk = {key: float(value) for key, value in chunk.items()}
        self.assertTrue(20 < chunk['volume'] < 40, chunk)
        self.assertAlmostEqual(chunk['mass'], 2400 * chunk['volume'], 6)
        self.assertTrue(abs(chunk['x'] - 32) < 1 and abs(chunk['y'] - 29) < 0.2 and abs(chunk['z'] - 4.75) < 0.1, chunk)
        self.assertTrue(chunk['ixx'] < chunk['iyy'] < chunk['izz'], chunk)
        self.assertLess(max(abs(chunk[k]) for k in ['ixy', 'ixz', 'iyz']), chunk['ixx'])
        self.assertTrue(self.sound('a.firma')['sound'])
        self.assertIsNotNone(self.sound('a.firma')['anchors'])
        call = ['carve', FIRST, '--blasts', 'b.csv', '-o', 'b.firma']
        told = self.firma_json(*call, '--chunks', '--density', '2400')
        self.assertEqual((told['chunks'], told['chunk_volume'], told['chunk_mass'], told['crumbs']), (1, chunk['volume'], chunk['mass'], 0))
        self.assertIn('1 came loose, ', self.firma(*call, '--chunks'))
        # Everything is a crumb; it leaves as well.
        crumbs = self.firma_json(*call, '--chunks', '--min-volume', '1000')
        self.assertEqual((crumbs['chunks'], crumbs['crumbs'], crumbs['crumb_volume']), (0, 1, chunk['volume']))
        self.assertEqual(crumbs['hash'], rows[1]['hash'])
        none = self.firma_json(*call)
        self.assertEqual([none[k] for k in ['chunks', 'chunk_volume', 'chunk_mass', 'crumbs', 'crumb_volume', 'chunk_report']], [None] * 6)
        self.assertNotIn('came loose', self.firma(*call))
        # A file between the two shots changes nothing.
        self.write('one.csv', HEADER + '22,29,4.75,3,rocky,1\n')
        self.write('two.csv', HEADER + '42,29,4.75,3,rocky,1\n')
        self.firma('carve', FIRST, '--blasts', 'one.csv', '-o', 'one.firma', '--chunks')
        two = self.firma_json('carve', 'one.firma', '--blasts', 'two.csv', '-o', 'two.firma', '--chunks')
        self.assertEqual((two['hash'], two['chunks']), (rows[1]['hash'], 1))
        self.assertEqual(self.read('two.firma'), self.read('a.firma'))

    def test_bad_calls_of_chunks(self):
        self.write('b.csv', HEADER + FLOOR)
        call = ['carve', FIRST, '--blasts', 'b.csv', '-o', 'a.firma']
        for option in [['--min-volume', '1'], ['--density', '1'], ['--anchors', 'bridge'], ['--no-hanging'], ['--chunk-report', 'c.csv']]:
            self.refuse(*call, *option, says=option[0] + ': is for --chunks')
        call.append('--chunks')
        self.refuse(*call, '--min-volume', '-1', says='--min-volume')
        self.refuse(*call, '--density', '0', says='--density')
        self.refuse(*call, '--density', 'inf', says='--density')
        self.refuse(*call, '--anchors', 'no such', says="--anchors: the level has no material 'no such'")
        self.refuse(*call, '--chunk-report', '-', says='--chunk-report')
        self.refuse(*call, '--chunk-report', 'a.firma', says='--chunk-report')
        self.refuse(*call, '--chunk-report', 'b.csv', says='b.csv')

    def test_volume(self):
        """A box turned at random, all of it in the rock around a room: 8 cubic metres but for the snap."""
        self.write('room.obj', box(4, 4, 4))
        row, = self.carve('room.obj', '20,2,2,1,box,5\n')
        self.assertEqual((row['status'], row['faces_gone']), ('done', '0'))
        self.assertAlmostEqual(float(row['volume']), 8, 2)

    def test_all_shapes(self):
        self.write('room.obj', box(8, 8, 4))
        rows = self.carve('room.obj', ''.join('%d,%d,0,0.7,%s,%d\n' % (1 + 1.5 * k, 4, shape, k) for k, shape in
                                              enumerate(['rocky', 'spiky', 'drill', 'wedge', 'box'])))
        self.assertEqual([row['status'] for row in rows], ['done'] * 5)
        self.assertTrue(self.sound('a.obj')['sound'])

    def test_summary(self):
        self.write('b.csv', HEADER + FLOOR + AIR)
        text = self.firma('carve', FIRST, '--blasts', 'b.csv', '-o', 'a.obj', '--report', 'r.csv')
        for words in ['a.obj: 2 blasts: 1 done, 1 nothing, 0 refused', '5,944 before', 'median', '99th percentile', 'r.csv']:
            self.assertIn(words, text)
        report = self.firma_json('carve', FIRST, '--blasts', 'b.csv', '-o', 'a.obj')
        self.assertEqual([report[k] for k in ['blasts', 'done', 'nothing', 'refused', 'faces_before', 'out', 'report']],
                         [2, 1, 1, 0, 5944, 'a.obj', None])
        self.assertEqual(report['faces_after'], self.sound('a.obj')['faces'])
        self.assertRegex(text, 'hash +' + report['hash'])

    def test_no_blasts(self):
        self.assertEqual(self.carve(FIRST, ''), [])
        self.assertEqual(self.sound('a.obj')['faces'], 5944)

    def test_the_same_twice_and_in_slices(self):
        rows = ''.join('%d,%g,0.1,%g,%s,%d\n' % (20 + k, 22 + 0.7 * k, 0.5 + 0.1 * k, shape, k)
                       for k, shape in enumerate(['rocky', 'spiky', 'wedge', 'box', 'drill'] * 4))
        def plain(report):
            return [{k: v for k, v in row.items() if k != 'ms'} for row in report]
        first = plain(self.carve(FIRST, rows))
        level = self.read('a.obj')
        for options in [(), ('--slices', '50'), ('--slices', '0')]:
            self.assertEqual(plain(self.carve(FIRST, rows, *options)), first, options)
            self.assertEqual(self.read('a.obj'), level)
        self.assertEqual(len({row['hash'] for row in first}), sum(row['status'] == 'done' for row in first))
        self.assertGreater(len(first), 15)


class After(CarveTest):
    def test_it_is_sound_and_only_the_crater_changed(self):
        row, = self.carve(FIRST, FLOOR)
        checked = self.sound('a.obj')
        self.assertTrue(checked['sound'])
        self.assertEqual(checked['note_count'], 0)
        self.assertEqual(checked['faces'], 5944 - int(row['faces_gone']) + int(row['faces_new']))
        before = self.faces(FIRST)
        after = self.faces('a.obj')
        self.assertEqual(len(before - after), int(row['faces_gone']))
        self.assertEqual(len(after - before), int(row['faces_new']))

    def faces(self, name):
        """As sets of positions: numbers, so that -0.50 is -0.5."""
        vertices, faces = [], set()
        with open(os.path.join(self.folder, name)) as file:
            for line in file:
                words = line.split()
                if line[0] == 'v': vertices.append(tuple(float(word) for word in words[1:]))
                if line[0] == 'f': faces.add(frozenset(vertices[int(word) - 1] for word in words[1:]))
        return faces

    def test_the_file(self):
        self.carve(FIRST, FLOOR, '--material', 'fresh # rock')
        lines = self.read('a.obj').decode().splitlines()
        vertices = [line for line in lines if line.startswith('v ')]
        self.assertEqual(len(vertices), len(set(vertices)))
        for line in vertices:
            for number in line.split()[1:]:
                self.assertRegex(number, r'^-?\d+(\.\d*[1-9])?$')              # decimals, none to spare
                self.assertEqual(float(number) * 262144 % 1, 0)
        materials = {line for line in lines if line.startswith('usemtl')}
        self.assertIn('usemtl fresh _ rock', materials)
        self.assertIn('usemtl floor', materials)
        for before, line in zip(lines, lines[1:]):
            self.assertFalse(before.startswith('usemtl') and line.startswith('usemtl'))
        self.assertIn('fresh _ rock', self.firma_json('info', 'a.obj')['materials'])

    def test_many(self):
        rows = ''.join('%g,%g,%g,%g,%s,%d\n' % (20 + 24 * (k * 0.618 % 1), 20 + 18 * (k * 0.733 % 1), 5 * (k * 0.437 % 1), 0.4 + k % 3,
                                                ['rocky', 'spiky', 'drill', 'wedge', 'box'][k % 5], k) for k in range(150))
        report = self.carve(FIRST, rows)
        self.assertGreater(sum(row['status'] == 'done' for row in report), 80)
        self.assertEqual(sum(row['status'] == 'refused' for row in report), 0)
        self.assertTrue(self.sound('a.obj')['sound'])

    def test_carved_again(self):
        self.carve(FIRST, FLOOR)
        row, = self.carve('a.obj', '36,29,0.2,1.2,spiky,9\n', out='b.obj')
        self.assertEqual(row['status'], 'done')
        self.assertTrue(self.sound('b.obj')['sound'])

    def test_what_is_not_closed_gets_holes(self):
        self.write('open.obj', obj([(0, 0, 0), (4, 0, 0), (4, 4, 0), (0, 4, 0)], [(0, 1, 2, 3)]))
        row, = self.carve('open.obj', '2,2,0,1,rocky,1\n')
        self.assertEqual((row['status'], row['open_trimmed'], row['open_removed']), ('done', '1', '0'))
        self.assertEqual((float(row['volume']), row['faces_gone']), (0, '1'))
        self.assertEqual(len(self.faces('a.obj')), int(row['faces_new']))
        self.assertGreater(int(row['faces_new']), 8)
        self.assertIn(f"{row['faces_new']} of the faces bound no closed solid", self.firma('carve', 'open.obj', '--blasts', 'b.csv', '-o', 'a.obj'))
        self.assertEqual(self.firma_json('carve', 'open.obj', '--blasts', 'b.csv', '-o', 'a.obj')['castable_only'],
                         int(row['faces_new']))
        self.assertEqual(self.firma_json('carve', FIRST, '--blasts', 'b.csv', '-o', 'a.obj')['castable_only'], 0)

    def test_what_stays_is_told(self):
        """A blast that meets nothing but faces that no blast changes is told apart from one in the air."""
        corners = [(x, y, z) for z in (0, 3) for y in (0, 4) for x in (0, 4)]
        self.write('open.obj', 'usemtl vault\n' + obj(corners, [(0, 1, 3, 2), (4, 5, 7, 6)]))
        self.write('hard.matter', 'matter vault\n  texture vault\n  hardness 1\n')
        self.write('b.csv', HEADER + '2,2,0,1,rocky,1\n2,2,1.5,0.5,rocky,1\n2,2,1.5,3,rocky,1\n')
        arguments = ['carve', 'open.obj', '--matter', 'hard.matter', '--blasts', 'b.csv', '-o', 'a.obj']
        self.assertIn('nothing      2 met only faces that stay (3), 1 met only air',
                      self.firma(*arguments, '--report', 'r.csv'))
        rows = list(csv.DictReader(self.read('r.csv').decode().splitlines()))
        self.assertEqual([(row['status'], row['castable_only']) for row in rows],
                         [('nothing', '1'), ('nothing', '0'), ('nothing', '2')])
        told = self.firma_json(*arguments)
        self.assertEqual((told['nothing'], told['nothing_castable_only']), (3, 2))
        self.carve(FIRST, FLOOR + AIR)
        told = self.firma('carve', FIRST, '--blasts', 'b.csv', '-o', 'a.obj')
        self.assertNotIn('castable', told)

    def test_nothing_left(self):
        corners = [(k & 1, k >> 1 & 1, k >> 2 & 1) for k in range(8)]
        sides = [(0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5)]
        self.write('block.obj', obj(corners, sides))
        row, = self.carve('block.obj', '0.5,0.5,0.5,4,rocky,1\n', stderr=True)
        self.assertEqual(row['status'], 'done')
        self.assertEqual(self.faces('a.obj'), set())
        self.assertIn('a.obj: the blasts left no face', self.stderr)
        self.refuse('check', 'a.obj', says='a.obj')

    def test_scale(self):
        self.write('large.obj', box(400, 400, 400))
        row, = self.carve('large.obj', '2,2,0,1,rocky,1\n', '--scale', '0.01')
        self.assertEqual(row['status'], 'done')
        self.assertEqual(self.firma_json('info', 'a.obj')['bounds']['high'], [4, 4, 4])


class Malformed(CarveTest):
    def refuse_rows(self, rows, line, header=HEADER):
        self.write('b.csv', header + rows)
        self.write('old.obj', 'as it was')
        for out in ['new.obj', 'old.obj', '-']:
            self.refuse('carve', FIRST, '--blasts', 'b.csv', '-o', out, '--report', 'r.csv', says='b.csv:%d: ' % line)

    def test_rows(self):
        for row in ['35,29,0.2,1.6,rocky', '35,29,0.2,1.6', '35,29,0.2,1.6,rocky,1,2', '35,29,0.2,1.6,rocky,', '35,29,,1.6,rocky,1',
                    '35,29,0.2,,rocky,1', '35,29,0.2,1.6,,1', '35,29,0.2,1.6,Rocky,1', '35,29,0.2,1.6,ball,1', 'nan,29,0.2,1.6,rocky,1',
                    '35,inf,0.2,1.6,rocky,1', '35,29,0x1,1.6,rocky,1', '35,29,0.2,nan,rocky,1', '35,29,0.2,inf,rocky,1',
                    '35,29,0.2,1.6m,rocky,1', '1e999,29,0.2,1.6,rocky,1', '35,29,0.2,1.6,rocky,-1', '35,29,0.2,1.6,rocky,1.5',
                    '35,29,0.2,1.6,rocky,18446744073709551616', '35,29,0.2,1.6,rocky,one', '', ' ', ',,,,,', '# a remark']:
            self.refuse_rows(row + '\n', 2)
            self.refuse_rows(FLOOR + row + '\n' + FLOOR, 3)

    def test_headers(self):
        for header in ['', '\n', FLOOR, HEADER.upper(), HEADER.replace('seed', 'seeds'), HEADER.replace(',seed', ''),
                       HEADER.replace('\n', ',fill\n'), HEADER.replace('y', 'x')]:
            self.refuse_rows('' if header == FLOOR else FLOOR, 1, header)

    def test_forms_that_are_fine(self):
        def hash_of(text):
            self.write('b.csv', text)
            return self.firma_json('carve', FIRST, '--blasts', 'b.csv', '-o', 'a.obj')['hash']
        plain = hash_of(HEADER + FLOOR)
        self.assertEqual(plain, hash_of(HEADER + FLOOR.rstrip()))
        self.assertEqual(plain, hash_of((HEADER + FLOOR).replace('\n', '\r\n')))
        self.assertEqual(plain, hash_of(HEADER + ' 35 ,29.0,2e-1,+1.6, rocky ,\t01\n'))
        self.assertEqual(plain, hash_of('seed,shape,radius,z,y,x\n1,rocky,1.6,0.2,29,35\n'))
        hash_of(HEADER + FLOOR.replace(',1\n', ',18446744073709551615\n'))
        self.write('b.csv', HEADER + FLOOR)
        with open(self.path('b.csv')) as blasts:
            done = self.run_firma('carve', FIRST, '--blasts', '-', '-o', '-', stdin=blasts)
        self.assertEqual((done.returncode, done.stdout), (0, self.read('a.obj') if hash_of(HEADER + FLOOR) == plain else b''))


class Calls(CarveTest):
    def setUp(self):
        super().setUp()
        self.write('box.obj', box(4, 4, 4))
        self.write('b.csv', HEADER + '2,2,0,1,rocky,1\n')

    def call(self, *more):
        return ['carve', 'box.obj', '--blasts', 'b.csv', *more]

    def test_outputs(self):
        os.mkdir(self.path('folder'))
        for out in ['folder', 'missing/a.obj', '/dev/full', '']:
            self.refuse(*self.call('-o', out))
            if out: self.refuse(*self.call('-o', 'a.obj', '--report', out))
        for same in ['a.obj', './a.obj', os.path.join(self.folder, 'a.obj')]:
            self.refuse(*self.call('-o', 'a.obj', '--report', same), says='--report')
        self.refuse(*self.call('-o', '-', '--report', '/dev/stdout'), says='--report')
        self.refuse(*self.call('-o', 'a.obj', '--report', '-', '--json'), says='--json')
        for taken in ['box.obj', './b.csv']:
            self.refuse(*self.call('-o', taken), says='is an input as well')
            self.refuse(*self.call('-o', 'a.obj', '--report', taken), says='is an input as well')
        self.assertTrue(self.firma(*self.call('-o', 'a.obj', '--report', '-')).startswith(REPORT + '\n0,done,'))
        self.assertEqual(sorted(name for name in self.files() if 'part' in name), [])

    def test_endings(self):
        for out, ending in [('after.map', '.map'), ('after.bsp', '.bsp'), ('a.b.xyz', '.xyz'), ('after.objx', '.objx'), ('./after.', '.')]:
            self.assertTrue(self.refuse(*self.call('-o', out), says=out + ': a level is written as .obj, .glb or .firma').endswith(' not as %s\n' % ending))
        self.refuse(*self.call('-o', 'after.gltf'), says='after.gltf: glTF is written as one binary file')
        os.mkdir(self.path('folder.map'))
        for out in ['after', 'AFTER.OBJ', 'folder.map/after', '.after']:
            self.firma(*self.call('-o', out))
            self.assertRegex(self.read(out), rb'(^|\n)v ')
        self.assertRegex(self.firma(*self.call('-o', '-')), r'(^|\n)v ')
        self.assertRegex(self.firma(*self.call('-o', '/dev/stdout')), r'(^|\n)v ')
        self.firma(*self.call('-o', '/dev/null'))

    def test_options(self):
        self.refuse(*self.call(), says='--out is required')
        self.refuse('carve', 'box.obj', '-o', 'a.obj', says='--blasts is required')
        self.refuse('carve', 'box.obj', '--blasts', 'none.csv', '-o', 'a.obj', says='none.csv')
        for bad in ['-1', 'nan', 'x', '']:
            self.refuse(*self.call('-o', 'a.obj', '--slices=' + bad), says='--slices')

    def test_help_shows_a_call_that_works(self):
        text = self.firma('carve', '--help')
        for column in (HEADER.strip() + ',' + REPORT).split(','): self.assertIn(column, text)
        self.assertIn('microseconds, 0: as short as they can be', ' '.join(text.split()))
        example = re.search(r"printf '(.*)' > blasts.csv", text).group(1).replace('\\n', '\n')
        self.write('blasts.csv', example)
        self.firma('carve', FIRST, '--blasts', 'blasts.csv', '-o', 'after.obj', '--report', 'report.csv')
        self.assertEqual(self.read('report.csv').count(b',done,'), 2)


class Draw(CarveTest):
    def setUp(self):
        super().setUp()
        self.write('box.obj', box(8, 8, 4))
        self.write('b.csv', HEADER + '4,4,0,1,rocky,1\n')

    def test_plan(self):
        before = self.firma_json('draw', 'box.obj', '-o', 'x.svg')
        self.assertEqual((before['blasts'], before['new_faces']), (0, 0))
        self.assertNotIn(b'made by an edit', self.read('x.svg'))
        after = self.firma_json('draw', 'box.obj', '--blasts', 'b.csv', '--at', '4', '-o', 'x.svg')
        self.assertEqual(after['blasts'], 1)
        self.assertGreater(after['new_faces'], 50)
        self.assertIn(b'made by an edit', self.read('x.svg'))
        self.assertIn(b'class="cut new"', self.read('x.svg'))

    def test_view(self):
        views = []
        for options in [['--eye', '1,1,3', '--look', '4,4,0'], ['--eye', '1,1,3', '--look', '4,4,0', '--blasts', 'b.csv'],
                        ['--blasts', 'b.csv'], ['--blasts', 'b.csv', '--before-after']]:
            report = self.firma_json('draw', 'box.obj', '--view', *options, '-o', 'x.png')
            png = self.read('x.png')
            self.assertEqual(len(png), report['bytes'])
            views.append(self.pixels(png))
        self.assertEqual([width for width, _ in views], [640, 640, 640, 1292])
        plain, crater = views[0][1], views[1][1]
        changed = sum(plain[k:k + 3] != crater[k:k + 3] for k in range(0, len(plain), 3))
        self.assertGreater(changed, 5000)                                      # of 307,200 pixels
        self.assertLess(changed, 100000)

    def pixels(self, png):
        """Width and rows without their filters, by Python's own zlib."""
        self.assertEqual(png[:8], b'\x89PNG\r\n\x1a\n')
        chunks, at = {}, 8
        while at < len(png):
            size, kind = int.from_bytes(png[at:at + 4], 'big'), png[at + 4:at + 8]
            data = png[at + 8:at + 8 + size]
            chunks[kind] = chunks.get(kind, b'') + data
            self.assertEqual(zlib.crc32(kind + data), int.from_bytes(png[at + 8 + size:at + 12 + size], 'big'))
            at += size + 12
        width, height = (int.from_bytes(chunks[b'IHDR'][k:k + 4], 'big') for k in (0, 4))
        self.assertEqual(chunks[b'IHDR'][8:], b'\x08\x02\0\0\0')                # 8 bits of red, green and blue
        raw, row = zlib.decompress(chunks[b'IDAT']), 1 + 3 * width
        self.assertEqual(len(raw), height * row)
        rows = [bytes(3 * width)]
        for k in range(0, len(raw), row): rows.append(self.without_filter(raw[k], raw[k + 1:k + row], rows[-1]))
        return width, b''.join(rows[1:])

    def without_filter(self, kind, row, above):
        """A row as it was, by the row above it. Source: W3C, Portable Network Graphics, 2003, section 9."""
        def paeth(a, b, c): return min((abs(b - c), 0, a), (abs(a - c), 1, b), (abs(a + b - 2 * c), 2, c))[2]
        predicted = [lambda a, b, c: 0, lambda a, b, c: a, lambda a, b, c: b, lambda a, b, c: (a + b) // 2, paeth][kind]
        out = bytearray(3) + row                                               # three bytes of zeros before the first
        above = bytes(3) + above
        for k in range(3, len(out)): out[k] = out[k] + predicted(out[k - 3], above[k], above[k - 3]) & 255
        return bytes(out[3:])

    def test_bad_calls(self):
        view = ['draw', 'box.obj', '-o', 'x.png', '--view']
        self.refuse(*view, says='--eye and --look')                            # nothing to look at
        self.refuse(*view, '--eye', '1,1,1', says='--look')
        self.refuse(*view, '--eye', '1,1,1', '--look', '1,1,1', says='--look')
        self.refuse(*view, '--eye', '1,1', '--look', '2,2,2', says='--eye')
        self.refuse(*view, '--eye', '1,1,1', '--look', '2,2,2', '--zoom', '0', says='--zoom')
        self.refuse(*view, '--at', '1', says='--view')
        self.refuse('draw', 'box.obj', '-o', 'x.svg', '--before-after', says='--view')
        for name in ['z.png', 'Z.PNG']: self.refuse('draw', 'box.obj', '-o', name, says=name + ': a .png is a view: add --view; a plan is an .svg')
        at = ['--eye', '1,1,1', '--look', '2,2,2']
        self.refuse('draw', 'box.obj', '-o', 'z.svg', '--view', *at, says='z.svg: an .svg is a plan: leave --view out; a view is a .png')
        self.firma('draw', 'box.obj', '-o', 'z')
        self.assertIn(b'<svg', self.read('z'))
        self.firma('draw', 'box.obj', '-o', 'z', '--view', *at)
        self.assertEqual(self.read('z')[:4], b'\x89PNG')
        self.refuse('draw', 'box.obj', '-o', 'x.svg', '--blasts', self.write('bad.csv', HEADER + '1\n'), says='bad.csv:2')


if __name__ == '__main__':
    unittest.main()
