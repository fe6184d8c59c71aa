# SPDX-License-Identifier: MIT
"""What a file holds and a world does not: info counts it, other verbs warn of it; a level of nothing is an error."""
import unittest

from harness import CliTest, box

CORNERS = '''( -64 -64 -16 ) ( -64 -63 -16 ) ( -64 -64 -15 )
( -64 -64 -16 ) ( -64 -64 -15 ) ( -63 -64 -16 )
( -64 -64 -16 ) ( -63 -64 -16 ) ( -64 -63 -16 )
( 64 64 16 ) ( 64 65 16 ) ( 65 64 16 )
( 64 64 16 ) ( 65 64 16 ) ( 64 64 17 )
( 64 64 16 ) ( 64 64 17 ) ( 64 65 16 )'''.splitlines()
BOX = '{\n' + ''.join(points + ' stone 0 0 0 1 1\n' for points in CORNERS) + '}\n'
PRIMITIVE = '{\nbrushDef\n{\n' + ''.join(
    points + ' ( ( 0.03 0 0 ) ( 0 0.03 0 ) ) base/stone 0 0 0\n' for points in CORNERS) + '}\n}\n'
PLANES = '{\nbrushDef3\n{\n' + ''.join(
    '( %s ) ( ( 0.03 0 0 ) ( 0 0.03 0 ) ) "textures/base/stone" 0 0 0\n' % plane
    for plane in ['-1 0 0 -64', '0 -1 0 -64', '0 0 -1 -16', '0 0 1 -16', '0 1 0 -64', '1 0 0 -64']) + '}\n}\n'


def entity(classname, content=''):
    return '{\n"classname" "%s"\n%s}\n' % (classname, content)


class Primitives(CliTest):
    def test_all_forms_are_one_box(self):
        """Finding 24: these two were an empty world, and the exit code 0."""
        self.write('q.csv', 'px,py,pz,dx,dy,dz,radius\n0,0,4,0,0,-9,0\n')
        for form in [BOX, PRIMITIVE, PLANES]:
            self.write('box.map', entity('worldspawn', form))
            info = self.firma_json('info', 'box.map')
            self.assertEqual((info['brushes']['solid'], info['faces']['solid'], info['left_out']), (1, 6, []))
            self.assertEqual(info['solid'], {'faces': 6, 'volume': 16, 'area': 48})
            self.firma('cast', 'box.map', '--queries', 'q.csv', '-o', 'h.csv')
            self.assertIn('hit', self.read('h.csv').decode())
        self.assertIn('left out        nothing\n', self.firma('info', 'box.map'))


class LeftOut(CliTest):
    def setUp(self):
        super().setUp()
        self.write('q.csv', 'px,py,pz,dx,dy,dz,radius\n0,0,4,0,0,-9,0\n')
        self.write('b.csv', 'x,y,z,radius,shape,seed\n1,1,0.5,0.25,rocky,1\n')

    def expect_warning(self, level, *says, walks=False):
        """Of every verb but those that tell it on standard output."""
        calls = [('cast', level, '--queries', 'q.csv', '-o', 'h.csv'),
                 ('carve', level, '--blasts', 'b.csv', '-o', 'after.firma', '--report', 'r.csv'),
                 ('draw', level, '-o', 'plan.svg')]
        if walks:  # in a closed room alone
            calls.append(('walk', level, '--start', '1,1,3', '--radius', '0.1', '--frames', '2', '--seed', '1', '-o', 'w.csv'))
        for call in calls:
            done = self.run_firma(*call)
            self.assertEqual(done.returncode, 0, (call, done.stderr))
            text = done.stderr.decode()
            self.assertEqual(text.count('warning'), 1, (call, text))
            self.assertTrue(text.startswith('firma: warning: %s: left out: ' % level), (call, text))
            for say in says:
                self.assertIn(say, text)
        for verb in ['info', 'check']:
            done = self.run_firma(verb, level)
            self.assertEqual(done.stderr, b'')
            for say in says:
                self.assertIn(say, done.stdout.decode())

    def test_map(self):
        self.write('some.map', entity('worldspawn', BOX + '{ brushDef9 { } }\n{ brushDef9 { } }\n') +
                   entity('func_door', BOX) + entity('trigger_push', BOX))
        found = self.firma_json('info', 'some.map')['left_out']
        self.assertEqual(found, [
            {'what': "primitives 'brushDef9'", 'count': 2, 'first': 'some.map:11 in brush 1 of entity 0'},
            {'what': "brushes of 'func_door'", 'count': 1, 'first': 'some.map:16: entity 1 (func_door), brush 0'}])
        self.assertEqual(self.firma_json('check', 'some.map')['left_out'], found)
        self.expect_warning('some.map', "primitives 'brushDef9': 2; brushes of 'func_door': 1")

    def test_brushes_without_volume(self):
        inward = '{\n' + ''.join('%s %s %s %s %s stone 0 0 0 1 1\n' % (
            line[:line.index(')') + 1], line[line.rindex('('):], line[line.index(') (') + 2:line.rindex('(')], '', '')
            for line in CORNERS) + '}\n'
        self.write('flat.map', entity('worldspawn', BOX + inward))
        found = self.firma_json('info', 'flat.map')['left_out']
        self.assertEqual([(f['what'], f['count'], f['first']) for f in found],
                         [('brushes without volume', 1, 'flat.map:11')])
        self.expect_warning('flat.map', 'brushes without volume: 1')

    def test_obj(self):
        self.write('some.obj', box(4, 4, 4) + 'l 1 2\nl 2 3\np 1\nvn 0 0 1\ns 1\nf 1 1 1\n')
        found = self.firma_json('info', 'some.obj')
        self.assertEqual(found['ignored_entries'], 5)
        self.assertEqual(found['left_out'], [{'what': 'lines (l)', 'count': 2, 'first': 'some.obj:15'},
                                             {'what': 'points (p)', 'count': 1, 'first': 'some.obj:17'},
                                             {'what': 'faces without area', 'count': 1, 'first': 'some.obj:20'}])
        self.expect_warning('some.obj', 'lines (l): 2; points (p): 1; faces without area: 1', walks=True)


class Nothing(CliTest):
    VERBS = [('info',), ('check',), ('cast', '--queries', 'q.csv', '-o', 'h.csv'),
             ('carve', '--blasts', 'b.csv', '-o', 'after.firma'), ('draw', '-o', 'plan.svg'),
             ('walk', '--start', '0,0,0', '--radius', '0.1', '--frames', '2', '--seed', '1', '-o', 'w.csv'),
             ('demo',)]

    def expect_error(self, level, *says):
        self.write('q.csv', 'px,py,pz,dx,dy,dz,radius\n0,0,4,0,0,-9,0\n')
        self.write('b.csv', 'x,y,z,radius,shape,seed\n1,1,0.5,0.25,rocky,1\n')
        for verb in self.VERBS:
            self.refuse(verb[0], level, *verb[1:], says=[level, *says])

    def test_map(self):
        no_face = 'no face is left that a cast could meet'
        self.write('door.map', entity('worldspawn') + entity('func_door', BOX))
        self.expect_error('door.map', no_face + "; 1 brush, 1 of them portals or data; left out: brushes of 'func_door': 1")
        self.write('unknown.map', entity('worldspawn', '{ brushDef9 { } }\n'))
        self.expect_error('unknown.map', no_face, "left out: primitives 'brushDef9': 1")
        self.write('points.map', entity('worldspawn') + entity('info_player_start'))
        self.expect_error('points.map', no_face + '; 0 brushes, 0 of them portals or data; left out: nothing')

    def test_obj(self):
        self.write('flat.obj', 'v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3\n')
        self.expect_error('flat.obj', 'no face is left that a cast could meet; left out: faces without area: 1')


if __name__ == '__main__':
    unittest.main()
