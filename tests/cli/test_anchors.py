# SPDX-License-Identifier: MIT
"""Brushes of firma_anchor hold what reaches into them: carve, log, demo, check and info of a small level."""
import csv
import io
import unittest

from harness import CliTest
from test_rooms import brush

HEADER = 'x,y,z,radius,shape,seed\n'
# The beam lies along x, 10 m long between the hall's end walls, 3 m above the floor: shot at both ends.
ENDS = HEADER + '0.75,4,3.25,1,rocky,1\n9.25,4,3.25,1,rocky,1\n'
MIDDLE = (144, 112, 80), (176, 144, 160)  # units, from within the beam up into the air
NOTHING = {'materials': 0, 'sources': 0, 'edits': 0, 'hanging': 0}


def hall(*entities):
    """A hall of 10 x 8 x 6 m in a hull of 8 m, a beam from wall to wall; a player; and other entities."""
    (x0, y0, z0), (x1, y1, z1) = (-256, -256, -256), (576, 512, 448)
    boxes = [((x0, y0, z0), (x1, y1, 0)), ((x0, y0, 192), (x1, y1, z1)), ((x0, y0, 0), (0, y1, 192)),
             ((320, y0, 0), (x1, y1, 192)), ((0, y0, 0), (320, 0, 192)), ((0, 256, 0), (320, y1, 192)),
             ((0, 120, 96), (320, 136, 112))]
    return ('{\n"classname" "worldspawn"\n' + ''.join(brush(*each) for each in boxes) + '}\n'
            '{\n"classname" "info_player_start"\n"origin" "64 64 40"\n}\n' + ''.join(entities))


def anchor(*boxes):
    return '{\n"classname" "firma_anchor"\n' + ''.join(brush(*box, texture='common/anchor') for box in boxes) + '}\n'


class Anchors(CliTest):
    def setUp(self):
        super().setUp()
        self.write('plain.map', hall())
        self.write('held.map', hall(anchor(MIDDLE)))
        self.write('b.csv', ENDS)

    def carve(self, level, *options):
        return self.firma_json('carve', level, '--blasts', 'b.csv', '-o', 'a.firma', '--report', 'r.csv', *options)

    def test_carve(self):
        loose = self.carve('plain.map', '--chunks')
        self.assertEqual((loose['done'], loose['chunks'], loose['crumbs']), (2, 1, 0))
        self.assertTrue(1 < loose['chunk_volume'] < 2, loose)                 # 0.25 m2 of beam, some 6.5 m of it
        self.assertEqual({**loose['anchors'], 'hanging': 0}, {**NOTHING, 'volumes': 0})
        held = self.carve('held.map', '--chunks')
        self.assertEqual((held['done'], held['chunks'], held['crumbs'], held['chunk_volume']), (2, 0, 0, 0))
        self.assertEqual(held['anchors']['volumes'], 1)
        self.assertEqual([row['chunks'] for row in csv.DictReader(io.StringIO(self.read('r.csv').decode()))], ['0', '0'])
        self.assertAlmostEqual(held['volume'], loose['volume'], 12)            # the blasts took the same
        text = self.firma('carve', 'held.map', '--blasts', 'b.csv', '-o', 'b.firma', '--chunks')
        self.assertRegex(text, r'\n  anchors +0 anchors, 1 volume and \d+ faces that hung free\n')

        # The file keeps the volume: what is shot out of the beam beside it falls later.
        self.assertEqual(self.firma_json('check', 'a.firma')['anchors'], held['anchors'])
        self.write('b.csv', HEADER + '4.2,4,3.25,0.4,rocky,1\n5.8,4,3.25,0.4,rocky,2\n')
        beside = self.firma_json('carve', 'a.firma', '--blasts', 'b.csv', '-o', 'c.firma', '--chunks')
        self.assertEqual(beside['chunks'], 2)
        self.assertTrue(0.3 < beside['chunk_volume'] < loose['chunk_volume'], beside)

        # Without --chunks nothing is looked for, and nothing is said of what holds.
        none = self.carve('held.map')
        self.assertIsNone(none['anchors'])
        self.assertIsNone(self.firma_json('check', 'a.firma')['anchors'])

    def test_beside_options(self):
        self.assertEqual(self.carve('held.map', '--chunks', '--no-hanging')['chunks'], 0)
        held = self.carve('held.map', '--chunks', '--anchors', 'wall')
        self.assertEqual((held['chunks'], held['anchors']['materials'], held['anchors']['volumes']), (0, 1, 1))
        self.refuse('carve', 'held.map', '--blasts', 'b.csv', '-o', 'a.obj', '--chunks', '--anchors', 'no such',
                    says="--anchors: the level has no material 'no such'")

    def test_logs(self):
        for options in [['--chunks'], [], ['--chunks', '--no-hanging']]:
            call = ['carve', 'held.map', '--blasts', 'b.csv', '-o', 'a.firma', '--log', 'a.firmalog', *options]
            carved = self.firma_json(*call)
            same = options[1:]
            replayed = self.firma_json('log', 'replay', 'a.firmalog', 'held.map', '-o', 'r.firma', *same)
            self.assertEqual(replayed['hash'], carved['hash'], options)
            self.assertEqual(self.read('r.firma'), self.read('a.firma'), options)
            self.firma('log', 'compact', 'a.firmalog', 'held.map', '-o', 'c.firmalog', '--until', '1', *same)
            self.assertEqual(self.firma_json('log', 'verify', 'c.firmalog', 'held.map', *same)['hash'], carved['hash'])
            self.refuse('log', 'verify', 'a.firmalog', 'held.map', '--anchors', 'wall', says='other anchors')

    def test_demo(self):
        """Its craters are many: without the volume they cut the beam loose, with one around all of it never."""
        whole = anchor(((0, 120, 96), (320, 136, 112)))
        self.write('whole.map', hall(whole))
        told = [self.firma_json('demo', level, '--casts', '400', '--craters', '120', '-o', 'x.svg')['craters']
                for level in ['plain.map', 'whole.map']]
        self.assertGreater(told[0]['chunk_volume'], told[1]['chunk_volume'])
        self.assertEqual(told[0]['disagreements'] + told[1]['disagreements'], 0)

    def test_check_and_info(self):
        report = self.firma_json('check', 'held.map')
        self.assertEqual((report['sound'], report['anchor_volumes'], report['note_count'], report['entity_notes']), (True, 1, 0, []))
        self.assertIn(', 0 portals, 1 anchor volume; 0 notes\n', self.firma('check', 'held.map'))
        self.assertEqual(self.firma_json('info', 'held.map')['anchor_volumes'], 1)
        self.assertRegex(self.firma('info', 'held.map'), r'\nanchors +1 volume of firma_anchor\n')
        self.assertEqual(self.firma_json('check', 'plain.map')['anchor_volumes'], 0)
        self.assertNotIn('anchor', self.firma('check', 'plain.map') + self.firma('info', 'plain.map'))

        # One that touches the beam holds it; one in the air, one that is inside out, and one without brushes hold nothing.
        touching, air = ((144, 112, 112), (176, 144, 160)), ((144, 112, 113), (176, 144, 160))
        inside_out = (176, 112, 80), (144, 144, 160)
        text = hall(anchor(touching, air), anchor(inside_out), '{\n"classname" "firma_anchor"\n}\n')
        self.write('odd.map', text)
        report = self.firma_json('check', 'odd.map')
        reasons = [(note['entity'], note['reason']) for note in report['entity_notes']]
        self.assertEqual(reasons, [(2, 'no solid reaches into brush 8'), (3, 'brush 9 is open, or has no volume'), (4, 'it has no brush')])
        self.assertEqual((report['sound'], report['anchor_volumes'], report['note_count']), (True, 2, 3 + len(report['reader_notes'])))
        line = text[:text.rindex('{')].count('\n') + 1
        self.assertIn('odd.map:%d: entity 4 (firma_anchor): holds nothing: it has no brush\n' % line, self.firma('check', 'odd.map'))
        self.assertEqual(self.carve('odd.map', '--chunks')['chunks'], 0)


if __name__ == '__main__':
    unittest.main()
