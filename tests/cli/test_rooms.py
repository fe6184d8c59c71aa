# SPDX-License-Identifier: MIT
"""--rooms auto, in every verb that reads brushes."""
import os
import unittest

from harness import FIRST, ROOT, CliTest, box

DEPOT = os.path.join(ROOT, 'levels', 'depot.map')


def bare_depot():
    """The depot without its portals."""
    with open(DEPOT, encoding='utf-8') as file:
        return file.read().replace('func_areaportal', 'trigger').replace('common/portal', 'common/trigger')


def brush(low, high, texture='wall'):
    """A box of a .map, in units."""
    (x0, y0, z0), (x1, y1, z1) = low, high
    sides = [((x0, y0, z0), (x0, y1, z0), (x0, y0, z1)), ((x1, y0, z0), (x1, y0, z1), (x1, y1, z0)),
             ((x0, y0, z0), (x0, y0, z1), (x1, y0, z0)), ((x0, y1, z0), (x1, y1, z0), (x0, y1, z1)),
             ((x0, y0, z0), (x1, y0, z0), (x0, y1, z0)), ((x0, y0, z1), (x0, y1, z1), (x1, y0, z1))]
    lines = [' '.join('( %d %d %d )' % point for point in side) + ' %s 0 0 0 1 1\n' % texture for side in sides]
    return '{\n' + ''.join(lines) + '}\n'


def two_halls(roof=True):
    """Two halls of 8 x 8 x 4 m, a wall of half a metre between them, a doorway of 1 x 2 m in it; a player in the first."""
    walls = [((-16, -16, -16), (544, 272, 0)), ((-16, -16, 0), (0, 272, 128)), ((528, -16, 0), (544, 272, 128)),
             ((0, -16, 0), (528, 0, 128)), ((0, 256, 0), (528, 272, 128)),
             ((256, 0, 0), (272, 112, 128)), ((256, 144, 0), (272, 256, 128)), ((256, 112, 64), (272, 144, 128))]
    walls.append(((-16, -16, 128), (544 if roof else 272, 272, 144)))
    return ('{\n"classname" "worldspawn"\n' + ''.join(brush(*wall) for wall in walls) + '}\n'
            '{\n"classname" "info_player_start"\n"origin" "64 64 40"\n}\n')


class RoomsAuto(CliTest):
    def setUp(self):
        super().setUp()
        self.write('halls.map', two_halls())

    def test_info(self):
        plain = self.firma_json('info', 'halls.map')
        self.assertIsNone(plain['divided'])
        self.assertEqual((len(plain['rooms']), plain['portals']), (2, []))
        divided = self.firma_json('info', 'halls.map', '--rooms', 'auto')
        self.assertEqual(len(divided['rooms']), 3)
        [portal] = divided['portals']
        self.assertEqual(sorted(portal['rooms']), [0, 1])
        self.assertTrue(8 <= portal['bounds']['low'][0] <= portal['bounds']['high'][0] <= 8.5)
        self.assertEqual((portal['bounds']['low'][1:], portal['bounds']['high'][1:]), ([3.5, 0], [4.5, 2]))
        self.assertEqual((divided['divided']['portals'], divided['divided']['idle']), (1, 0))
        self.assertGreater(divided['divided']['cells'], 100)
        self.assertEqual(divided['brushes'], plain['brushes'])                 # those of the file
        self.assertEqual((divided['brushes']['portal'], divided['brushes']['total']), (0, 9))
        self.assertRegex(self.firma('info', 'halls.map', '--rooms', 'auto'), r'brushes +9 \(9 solid\)')
        self.assertEqual(divided['solid'], plain['solid'] | {'faces': divided['solid']['faces']})
        self.assertIn('1 portal added', self.firma('info', 'halls.map', '--rooms', 'auto'))
        self.assertNotIn('divided', self.firma('info', 'halls.map'))

    def test_check(self):
        report = self.firma_json('check', 'halls.map', '--rooms', 'auto')
        self.assertEqual((report['sound'], report['rooms'], report['portals'], report['leak']), (True, 3, 1, None))
        self.assertEqual(report['brushes'], 9)
        self.assertIn('sound; 9 brushes, ', self.firma('check', 'halls.map', '--rooms', 'auto'))
        self.write('one.map', '{\n"classname" "worldspawn"\n' + brush((0, 0, 0), (64, 64, 64)) + '}\n')
        self.assertIn('sound; 1 brush, ', self.firma('check', 'one.map'))
        # Half the roof is missing: the player's hall has a roof, but the way out leads through an added portal.
        self.write('open.map', two_halls(roof=False))
        for arguments in [], ['--rooms', 'auto']:
            report = self.firma_json('check', 'open.map', *arguments, code=1)
            self.assertIsNotNone(report['leak'], arguments)
        self.assertEqual(report['rooms'], 2)

    def test_rooms_that_no_one_names(self):
        text = two_halls() + '{\n"classname" "firma_room"\n"name" "rock"\n"origin" "264 10 40"\n}\n'
        self.write('named.map', text)
        report = self.firma_json('check', 'named.map')
        line = text[:text.rindex('{')].count('\n') + 1
        self.assertEqual(report['entity_notes'], [{'entity': 2, 'line': line, 'reason': 'it stands in the solid'}])
        self.assertEqual((report['sound'], report['note_count']), (True, 1))
        self.assertIn('named.map:%d: entity 2 (firma_room): names no room: it stands in the solid' % line,
                      self.firma('check', 'named.map'))

    def test_brushes_inside_out(self):
        turned = [' '.join(words[k] for k in [*range(5, 10), *range(5), *range(10, len(words))])
                  for words in (line.split(' ') for line in two_halls().splitlines()) if words[0] == '(']
        self.write('turned.map', '{\n{\n' + '\n'.join(turned[:6]) + '\n}\n}\n')
        self.refuse('check', 'turned.map', says=['no face is left', 'its planes leave no volume; perhaps they look inward'])
        sound = [line for line in two_halls().splitlines() if line.startswith('(')][6:12]
        self.write('turned.map', '{\n{\n' + '\n'.join(turned[:6]) + '\n}\n{\n' + '\n'.join(sound) + '\n}\n}\n')
        report = self.firma_json('check', 'turned.map')
        self.assertEqual([note['what'] for note in report['notes']], ['no_volume'])
        self.assertIn('its planes leave no volume; perhaps they look inward', report['notes'][0]['reason'])

    def test_casts_are_the_same(self):
        rays = ['px,py,pz,dx,dy,dz,radius'] + ['1,%s,1,15,%s,0,%s' % (1 + k / 3, (20 - k) / 8, k % 4 / 10) for k in range(20)]
        self.write('q.csv', '\n'.join(rays) + '\n')
        self.firma('cast', 'halls.map', '--queries', 'q.csv', '-o', 'one.csv')
        self.firma('cast', 'halls.map', '--rooms', 'auto', '--queries', 'q.csv', '-o', 'two.csv')

        def met(name):
            lines = [line.split(',') for line in self.read(name).decode().splitlines()]
            kept = [k for k, title in enumerate(lines[0]) if title in ('hit', 'fraction', 'px', 'py', 'pz')]
            return [[line[k] for k in kept] for line in lines]
        self.assertGreaterEqual(len(met('one.csv')[0]), 2)
        self.assertEqual(met('one.csv'), met('two.csv'))

    def test_carve_walk_demo(self):
        self.write('b.csv', 'x,y,z,radius,shape,seed\n8.2,3.4,1,0.7,rocky,1\n')
        self.firma('carve', 'halls.map', '--rooms', 'auto', '--blasts', 'b.csv', '-o', 'after.firma')
        self.assertGreaterEqual(len(self.firma_json('info', 'after.firma')['rooms']), 3)
        walk = ['--start', '1,1,1', '--radius', '0.3', '--frames', '200', '--seed', '1']
        self.firma('walk', 'halls.map', '--rooms', 'auto', *walk, '-o', 'walk.csv')
        self.firma('demo', 'halls.map', '--rooms', 'auto', '--casts', '200', '--craters', '0', '-o', 'demo.svg')

    def test_draw(self):
        args = ['halls.map', '--below', '3', '-o', 'plan.svg']
        self.assertFalse(self.firma_json('draw', *args)['shows_rooms'])
        report = self.firma_json('draw', '--rooms', 'auto', *args)
        self.assertEqual((report['shows_rooms'], report['rooms_labelled'], report['portals_drawn']), (True, 2, 1))
        self.assertEqual(self.firma_json('draw', *args, '--rooms', 'auto'), report)
        self.assertEqual(self.firma_json('draw', *args, '--rooms=auto'), report)
        bare = self.firma_json('draw', '--rooms', *args)  # a flag: the next word is the level
        self.assertEqual((bare['shows_rooms'], bare['portals_drawn']), (True, 0))
        view = ['draw', 'halls.map', '--view', '--eye', '1,1,2', '--look', '8,4,1', '-o']
        self.firma(*view, 'plain.png', '--rooms')
        self.firma(*view, 'auto.png', '--rooms', 'auto')
        self.assertNotEqual(self.read('plain.png'), self.read('auto.png'))

    def test_the_depot_without_its_portals(self):
        self.write('bare.map', bare_depot())
        self.assertEqual(len(self.firma_json('info', 'bare.map')['rooms']), 2)
        divided = self.firma_json('info', 'bare.map', '--rooms', 'auto')
        self.assertGreaterEqual(len(divided['rooms']), 12)
        self.assertEqual(divided['idle_portals'], 0)
        self.assertEqual(self.firma_json('check', 'bare.map', '--rooms', 'auto')['notes'], [])

    def test_refusals(self):
        self.write('box.obj', box(4, 4, 4))
        self.firma('carve', 'halls.map', '--blasts', self.write('b.csv', 'x,y,z,radius,shape,seed\n1,1,0,0.5,rocky,1\n'), '-o', 'a.firma')
        for level in FIRST, 'box.obj', 'a.firma':
            self.refuse('info', level, '--rooms', 'auto', says=['--rooms', 'brushes'])
            self.refuse('info', '--rooms', level, says=['--rooms', 'is auto or not given'])
            self.refuse('draw', level, '--rooms', 'auto', '-o', 'x.svg', says=['--rooms', 'brushes'])
        self.refuse('info', 'halls.map', '--rooms', 'many', says=['--rooms', 'many'])
        self.refuse('info', 'halls.map', '--rooms', says='info: --rooms: wants a value: auto (firma info --help tells more)')
        self.refuse('info', 'halls.map', '--scale', says='info: --scale: wants a value: S (')
        self.refuse('draw', 'halls.map', '--rooms=many', '-o', 'x.svg', says=['--rooms', 'many'])


if __name__ == '__main__':
    unittest.main()
