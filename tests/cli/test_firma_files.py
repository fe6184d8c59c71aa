# SPDX-License-Identifier: MIT
"""Saved worlds, .firma: carve writes them, every verb reads them, damage is told with its place."""
import csv
import io
import os
import unittest

from harness import FIRST, ROOT, CliTest, obj
from test_rooms import DEPOT

HEADER = 'x,y,z,radius,shape,seed\n'
ONE = '35,29,0.2,1.6,rocky,1\n'
TWO = '30,25,0,0.5,drill,2\n31,26,0.1,0.6,box,3\n'
GOLDEN = os.path.join(ROOT, 'tests', 'data', 'golden_v1.firma')


class FirmaFile(CliTest):
    def carve(self, level, rows, out, *options):
        self.write('b.csv', HEADER + rows)
        return self.firma_json('carve', level, '--blasts', 'b.csv', '-o', out, *options)

    def saved(self):
        self.carve(FIRST, ONE, 'one.firma')
        return 'one.firma'

    def test_blasts_go_on_as_if_without_a_file(self):
        whole = self.carve(FIRST, ONE + TWO, 'whole.firma')
        self.saved()
        parts = self.carve('one.firma', TWO, 'parts.firma')
        self.assertEqual(parts['hash'], whole['hash'])
        self.assertEqual(parts['castable_only'], whole['castable_only'])
        self.assertEqual(self.read('parts.firma'), self.read('whole.firma'))
        self.assertEqual(self.files(), ['b.csv', 'one.firma', 'parts.firma', 'whole.firma'])
        self.carve('parts.firma', '35,29,3,0.5,rocky,4\n', 'level.obj')
        self.carve(FIRST, ONE + TWO, 'direct.obj')
        self.assertEqual(self.read('level.obj'), self.read('direct.obj'))

    def test_endings_count_whatever_their_case(self):
        self.carve(FIRST, ONE, 'A.FIRMA')
        self.assertTrue(self.read('A.FIRMA').startswith(b'FIRMA\r\n\x1a'))
        self.assertTrue(self.firma_json('check', 'A.FIRMA')['sound'])

    def test_not_over_its_input(self):
        self.saved()
        self.write('b.csv', HEADER + TWO)
        self.refuse('carve', 'one.firma', '--blasts', 'b.csv', '-o', 'one.firma', says=['is an input as well'])

    def test_nothing_left(self):
        """No face at all is a world as any other."""
        corners = [(k & 1, k >> 1 & 1, k >> 2 & 1) for k in range(8)]
        sides = [(0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5)]
        self.write('block.obj', obj(corners, sides))
        told = self.carve('block.obj', '0.5,0.5,0.5,4,rocky,1\n', 'none.firma')
        self.assertEqual(told['faces_after'], 0)
        self.assertTrue(self.firma_json('check', 'none.firma')['sound'])
        self.assertIsNone(self.firma_json('info', 'none.firma')['bounds'])

    def test_info(self):
        info = self.firma_json('info', self.saved())
        self.assertEqual([info[k] for k in ['level', 'version', 'edits', 'exact']], ['one.firma', 1, 1, True])
        self.assertEqual(info['bytes'], len(self.read('one.firma')))
        self.assertGreater(info['faces']['total'], 5944)
        self.assertGreater(info['faces']['exact'], 100)
        self.assertGreaterEqual(info['faces']['solid'], info['faces']['exact'])
        self.assertEqual(info['tree']['faces'], info['faces']['total'])
        text = self.firma('info', 'one.firma')
        for words in ['one.firma', 'after 1 edits', 'bound solids', 'nodes', 'bounds', 'to read and check']:
            self.assertIn(words, text)

    def test_check(self):
        check = self.firma_json('check', self.saved())
        self.assertEqual([check[k] for k in ['sound', 'world_fault', 'solid_fault', 'edits']], [True, None, None, 1])
        self.assertEqual([check['rooms'], check['portals']], [1, 0])
        self.assertRegex(self.firma('check', 'one.firma'), r'^one.firma: sound; a saved world of [0-9,]+ faces, 1 room and 0 portals after 1 edit; ')
        self.refuse('check', 'one.firma', '--pts', 'x.pts', says='--pts: only of levels of brushes')

    def test_check_counts_rooms_and_portals(self):
        self.carve(DEPOT, '19,8,0,1,rocky,1\n', 'depot.firma')
        check, info = self.firma_json('check', 'depot.firma'), self.firma_json('info', 'depot.firma')
        self.assertEqual([check['rooms'], check['portals']], [len(info['rooms']), len(info['portals'])])
        self.assertGreaterEqual(check['rooms'], 12)
        self.assertIn(' faces, %d rooms and %d portals after 1 edit; ' % (check['rooms'], check['portals']), self.firma('check', 'depot.firma'))

    def test_cast_walk_draw(self):
        self.saved()
        self.carve(FIRST, ONE, 'one.obj')
        self.write('q.csv', 'px,py,pz,dx,dy,dz,radius\n35,29,3,0,0,-9,0.1\n35,29,3,0,9,0,0\n')
        for level, hits in [('one.firma', 'a.csv'), ('one.obj', 'b.csv')]:
            self.firma('cast', level, '--queries', 'q.csv', '--out', hits)
        rows = [list(csv.DictReader(io.StringIO(self.read(name).decode()))) for name in ['a.csv', 'b.csv']]
        for saved, level in zip(*rows):
            self.assertEqual([saved[k] for k in ['status', 'fraction']], [level[k] for k in ['status', 'fraction']])
        self.firma('walk', 'one.firma', '--start', '35,29,3', '--radius', '0.3', '--frames', '50', '--seed', '1', '--out', 'w.csv')
        self.assertEqual(len(self.read('w.csv').splitlines()), 52)
        self.firma('draw', 'one.firma', '-o', 'plan.svg')
        self.assertIn(b'one.firma', self.read('plan.svg'))

    def test_demo(self):
        self.saved()
        demo = self.firma_json('demo', 'one.firma', '--casts', '2000', '--craters', '3', '-o', 'd.svg')
        self.assertEqual(demo['level'], 'one.firma')

    def test_options_without_sense(self):
        self.saved()
        for verb in ['info', 'check']:
            self.refuse(verb, 'one.firma', '--scale', '2', says=['--scale', '.firma'])
        for option, value in [('--split', 'surface-area'), ('--max-depth', '9'), ('--faces-per-bin', '2'), ('--min-bin-volume', '1')]:
            self.refuse('info', 'one.firma', option, value, says=[option, 'says how its tree is built'])

    def test_damage_is_told_with_its_place(self):
        bytes_before = bytearray(self.read(self.saved()))
        damaged = bytearray(bytes_before)
        damaged[-100] ^= 1
        self.write('bad.firma', bytes(damaged))
        for verb in ['info', 'check']:
            self.refuse(verb, 'bad.firma', says=['bad.firma: section MTTR', 'checksum'])
        self.write('short.firma', bytes(bytes_before[:-8]))
        self.refuse('check', 'short.firma', says=['short.firma: it is not as long as its head says'])
        self.write('text.firma', 'o level\n')
        self.refuse('info', 'text.firma', says=['text.firma: it does not begin as a .firma file does'])
        damaged = bytearray(bytes_before)
        damaged[8] = 9
        self.write('new.firma', bytes(damaged))
        self.refuse('check', 'new.firma', says=['new.firma: it is of version 9'])
        self.refuse('check', 'none.firma', says=['none.firma: cannot be read'])

    def test_files_of_version_1_stay_readable(self):
        self.assertTrue(self.firma_json('check', GOLDEN)['sound'])
        self.assertEqual(self.firma_json('info', GOLDEN)['rules'], {'zones': 1, 'hard_materials': 1})


if __name__ == '__main__':
    unittest.main()
