# SPDX-License-Identifier: MIT
"""Levels that are open to the void, and the depot, which is not."""
import csv
import io
import unittest

from harness import CliTest, box
from test_rooms import DEPOT, brush, two_halls

PORTAL = ('{\n"classname" "func_areaportal"\n' + brush((256, 112, 0), (272, 144, 64), 'common/areaportal') + '}\n')


class Leaks(CliTest):
    def leak(self, text, code=1):
        self.write('halls.map', text)
        return self.firma_json('check', 'halls.map', '--pts', 'halls.pts', code=code)['leak']

    def said(self):
        done = self.run_firma('check', 'halls.map')
        self.assertEqual(done.returncode, 1)
        return done.stdout.decode()

    def points(self):
        return [[float(word) for word in line.split()] for line in self.read('halls.pts').decode().splitlines()]

    def test_a_closed_level_leaks_nowhere(self):
        self.assertIsNone(self.leak(two_halls() + PORTAL, code=0))
        self.assertEqual(self.points(), [])

    def test_an_old_line_does_not_stay(self):
        for arguments in [], ['--rooms', 'auto']:
            self.write('halls.map', two_halls())
            self.write('halls.pts', '1 2 3\n4 5 6\n')
            self.firma('check', 'halls.map', '--pts', 'halls.pts', *arguments)
            self.assertEqual(self.read('halls.pts'), b'', arguments)
        self.assertIn('the file is empty', ' '.join(self.firma('check', '--help').split()))

    def test_bad_pts(self):
        self.write('halls.map', two_halls())
        self.write('box.obj', box(4, 4, 4))
        self.refuse('check', 'halls.map', '--pts', 'halls.map', says='is an input as well')
        for out in '-', '/dev/stdout': self.refuse('check', 'halls.map', '--pts', out, says='--pts: ')
        self.refuse('check', 'box.obj', '--pts', 'x.pts', says='--pts: only of levels of brushes')

    def test_a_missing_roof(self):
        leak = self.leak(two_halls(roof=False))
        points = self.points()
        self.assertEqual(leak['entity'], 1)
        self.assertEqual(len(points), len(leak['points']))
        self.assertEqual(points[0], [64, 64, 40], 'in units, from the player')
        for units, metres in zip(points, leak['points']):
            self.assertEqual([axis / 32 for axis in units], metres)
        self.assertTrue(any(low < -16 or low > high for low, high in zip(points[-1], (544, 272, 144))), 'beyond all')
        # Each sees the next: nothing is met on the way.
        rows = ['px,py,pz,dx,dy,dz,radius\n']
        for a, b in zip(leak['points'], leak['points'][1:]):
            rows.append('%r,%r,%r,%r,%r,%r,0\n' % (*a, *(q - p for p, q in zip(a, b))))
        self.write('way.csv', ''.join(rows))
        self.firma('cast', 'halls.map', '--queries', 'way.csv', '--out', 'hits.csv')
        hits = list(csv.DictReader(io.StringIO(self.read('hits.csv').decode())))
        self.assertEqual([hit['status'] for hit in hits], ['miss'] * (len(points) - 1))

    def test_behind_a_portal(self):
        leak = self.leak(two_halls(roof=False) + PORTAL)
        self.assertEqual(leak['entity'], 1)
        self.assertGreater(len(self.points()), 1)
        self.assertIn('leak: info_player_start (entity 1) is open to the void', self.said())

    def test_without_a_player(self):
        text = two_halls(roof=False).replace('info_player_start', 'light')
        self.assertEqual(self.leak(text)['entity'], 1)
        self.assertIsNone(self.leak(text[:text.rindex('{')], code=0), 'nothing says where the inside is')
        self.assertIn('in a level that has none, from any entity with an origin', ' '.join(self.firma('check', '--help').split()))

    def test_a_crack_too_narrow_to_be_shown(self):
        text = two_halls().replace(brush((-16, -16, 128), (544, 272, 144)), brush((-16, -16, 128), (400, 272, 144)) +
                                   brush((401, -16, 128), (544, 272, 144)))
        self.assertEqual(self.leak(text)['points'], [])
        self.assertEqual(self.points(), [])
        self.assertIn('by a way too narrow to be shown', self.said())

    def test_two_portals_in_one_place(self):
        self.write('halls.map', two_halls() + PORTAL + PORTAL)
        [note] = self.firma_json('check', 'halls.map')['notes']
        self.assertEqual((note['what'], note['reason']), ('idle_portal', 'it lies in the solid, or where another portal is'))

    def test_the_depot(self):
        report = self.firma_json('check', DEPOT)
        self.assertEqual((report['sound'], report['leak'], report['note_count']), (True, None, 0))
        info = self.firma_json('info', DEPOT)
        self.assertEqual(len(info['rooms']), report['rooms'])
        self.assertEqual(len(info['portals']), report['portals'])
        self.assertGreaterEqual(len(info['rooms']), 12)


if __name__ == '__main__':
    unittest.main()
