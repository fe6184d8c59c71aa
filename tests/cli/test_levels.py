# SPDX-License-Identifier: MIT
"""firma info, check, draw and demo."""
import os
import re
import unittest
import xml.etree.ElementTree

from harness import FIRST, ROOT, SANITIZED, CliTest, box, obj

# Half a box: the sixth face is missing, and the fifth is wound the wrong way.
CORNERS = [(4 * (k & 1), 4 * (k >> 1 & 1), 4 * (k >> 2 & 1)) for k in range(8)]
FACES = [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]


class Info(CliTest):
    def test_a_box(self):
        self.write('box.obj', 'usemtl "odd\\name"\n' + box(4, 2, 3, (-1, 0, 0.5)) + 'p 1\n')
        info = self.firma_json('info', 'box.obj')
        self.assertEqual(info['faces']['total'], 6)
        self.assertEqual(info['faces']['in_file'], 6)
        self.assertEqual(info['faces']['polygon'], 6)
        self.assertEqual(info['faces']['dropped'], 0)
        self.assertEqual(info['vertices'], 8)
        self.assertEqual(info['corners'], 24)
        self.assertEqual(info['materials'], ['"odd\\name"'])
        self.assertEqual(info['bounds'], {'low': [-1, 0, 0.5], 'high': [3, 2, 3.5]})
        self.assertEqual(info['tree']['faces'], 6)
        text = self.firma('info', 'box.obj')
        self.assertIn('(-1, 0, 0.5) .. (3, 2, 3.5) m', text)

    def test_scale(self):
        self.write('box.obj', box(4, 2, 3))
        self.assertEqual(self.firma_json('info', 'box.obj', '--scale', '0.5')['bounds']['high'], [2, 1, 1.5])

    def test_tree_options(self):
        whole = self.firma_json('info', FIRST)['tree']
        self.assertLessEqual(whole['largest_bin'], 8)
        flat = self.firma_json('info', FIRST, '--max-depth', '0')['tree']
        self.assertGreater(flat['largest_bin'], whole['largest_bin'])
        self.assertLess(flat['bins'], whole['bins'])
        self.assertLessEqual(flat['largest_bin'], 64)
        coarse = self.firma_json('info', FIRST, '--faces-per-bin', '100')['tree']
        self.assertLess(coarse['bins'], whole['bins'])
        self.assertLess(self.firma_json('info', FIRST, '--min-bin-volume', '1000')['tree']['bins'], whole['bins'])
        by_area = self.firma_json('info', FIRST, '--split', 'surface-area')['tree']
        self.assertEqual(by_area['faces'], whole['faces'])
        self.refuse('info', FIRST, '--split', 'middle', says='--split')
        for option, bad in [('--max-depth', '65'), ('--max-depth', '-1'), ('--faces-per-bin', '0'),
                            ('--faces-per-bin', '2.5'), ('--min-bin-volume', '-1'), ('--min-bin-volume', 'nan')]:
            self.refuse('info', FIRST, option, bad, says=option)


class Check(CliTest):
    def test_sound(self):
        self.write('box.obj', box(4, 4, 4))
        self.assertIn('box.obj: sound', self.firma('check', 'box.obj'))
        report = self.firma_json('check', 'box.obj')
        self.assertEqual((report['sound'], report['faces'], report['vertices'], report['fault_count']), (True, 6, 8, 0))
        self.assertTrue(self.firma_json('check', FIRST)['sound'])

    def test_solid(self):
        self.write('box.obj', box(4, 4, 4))
        self.assertTrue(self.firma('check', 'box.obj').strip().endswith('0 notes; solid, rock outside'))
        report = self.firma_json('check', 'box.obj')
        self.assertEqual((report['solid_faces'], report['castable_only'], report['rock_outside']), (6, [], True))
        solid = self.firma_json('info', 'box.obj')['solid']
        self.assertEqual(solid, {'faces': 6, 'volume': -64, 'area': 96})
        self.assertIn('6 faces bound 64 m3 of air, by 96 m2', self.firma('info', 'box.obj'))

    def test_castable_only(self):
        # Two boxes that cross: closed, so no fault, but nothing that can be carved.
        second = [tuple(c + 2 for c in corner) for corner in CORNERS]
        self.write('crossing.obj', obj(CORNERS + second, FACES + [[i + 8 for i in face] for face in FACES]))
        text = self.firma('check', 'crossing.obj')
        self.assertIn('2 pieces castable only:', text)
        self.assertIn('piece of 6 faces: crosses or touches face', text)
        self.assertIn('0 of 12 faces bound solids', text)
        report = self.firma_json('check', 'crossing.obj')
        self.assertTrue(report['sound'])
        self.assertEqual((report['solid_faces'], report['castable_only_count']), (0, 2))
        for note, other in zip(report['castable_only'], [range(6, 12), range(6)]):
            self.assertEqual((note['what'], note['faces']), ('crossing', 6))
            self.assertIn(note['other'], other)
            self.assertNotIn(note['face'], other)

    def test_open(self):
        self.write('open.obj', obj(CORNERS, FACES[:5]))
        done = self.run_firma('check', 'open.obj')
        self.assertEqual(done.returncode, 1)
        self.assertIn('open.obj:9: face 0: open edge', done.stdout.decode())
        report = self.firma_json('check', 'open.obj', code=1)
        self.assertFalse(report['sound'])
        self.assertEqual(report['fault_count'], 4)
        self.assertEqual({fault['what'] for fault in report['faults']}, {'open_edge'})
        self.assertEqual(report['faults'][0]['line'], 9)
        for fault in report['faults']:
            self.assertEqual(fault['from'][0], 4)                              # all edges of the missing face
            self.assertEqual(fault['to'][0], 4)
        [note] = report['castable_only']
        self.assertEqual((note['what'], note['faces'], note['other']), ('open_edge', 5, None))
        self.assertEqual((note['at'][0], note['to'][0]), (4, 4))
        self.assertEqual(report['solid_faces'], 0)

    def test_reversed(self):
        faces = FACES[:5] + [FACES[5][::-1]]
        self.write('reversed.obj', obj(CORNERS, faces))
        report = self.firma_json('check', 'reversed.obj', code=1)
        self.assertIn(('reversed_face', 5, 14), [(f['what'], f['face'], f['line']) for f in report['faults']])

    def test_notes_alone_are_no_fault(self):
        self.write('note.obj', box(4, 4, 4) + 'v 1 1 1\nv 1 1 1.00001\nv 1.00001 1 1\nf 9 10 11\nf 11 10 9\n')
        report = self.firma_json('check', 'note.obj')
        self.assertEqual([(n['what'], n['face'], n['line']) for n in report['notes']], [('dropped', 6, 18), ('dropped', 7, 19)])
        self.assertIn('2 notes', self.firma('check', 'note.obj'))

    def test_many_faults_are_cut_short(self):
        corners, faces = [], []
        for k in range(30):
            faces.append(tuple(len(corners) + i for i in range(3)))
            corners += [(k, 0, 0), (k + 1, 0, 1), (k, 1, 0)]
        self.write('many.obj', obj(corners, faces))
        short = self.run_firma('check', 'many.obj').stdout.decode()
        self.assertIn('and 70 more', short)
        self.assertEqual(short.count('open edge'), 20)
        self.assertEqual(self.run_firma('check', 'many.obj', '--all').stdout.decode().count('open edge'), 90)
        self.assertEqual(len(self.firma_json('check', 'many.obj', code=1)['faults']), 20)
        self.assertEqual(len(self.firma_json('check', 'many.obj', '--all', code=1)['faults']), 90)


class Draw(CliTest):
    def setUp(self):
        super().setUp()
        self.write('a<b>&.obj', box(8, 6, 4))
        self.write('q.csv', 'px,py,pz,dx,dy,dz,radius\n1,1,1,9,0,0,0.5\n1,3,1,1,0,0,0\n3,3,0.25,0,0,-1,0.5\n')
        self.firma('cast', 'a<b>&.obj', '--queries', 'q.csv', '-o', 'h.csv')

    def texts(self, name):
        tree = xml.etree.ElementTree.parse(self.path(name))
        self.assertTrue(tree.getroot().tag.endswith('svg'))
        return [element.text for element in tree.iter() if element.tag.endswith('text')]

    def test_level(self):
        report = self.firma_json('draw', 'a<b>&.obj', '-o', 'plan.svg')
        self.assertEqual((report['cut_axis'], report['faces_in_plan'], report['bytes']), ('y', 1, len(self.read('plan.svg'))))
        texts = self.texts('plan.svg')
        for text in ['a<b>&.obj', '6 faces; 8 x 6 x 4 m', 'x (m)', 'y (m)', 'z (m)', 'Legend']:
            self.assertIn(text, texts)

    def test_casts(self):
        report = self.firma_json('draw', 'a<b>&.obj', '--queries', 'q.csv', '--casts', 'h.csv', '-o', 'plan.svg')
        self.assertEqual((report['casts'], report['casts_drawn']), (3, 3))
        texts = self.texts('plan.svg')
        for text in ['hit (1)', 'miss (1)', 'initial overlap (1)']:
            self.assertIn(text, texts)
        self.firma('draw', 'a<b>&.obj', '--queries', 'q.csv', '--out', 'same.svg')
        self.assertEqual(self.read('plan.svg'), self.read('same.svg'))
        few = self.firma_json('draw', 'a<b>&.obj', '--queries', 'q.csv', '--most-casts', '1', '-o', 'few.svg')
        self.assertEqual((few['casts'], few['casts_drawn']), (3, 1))

    def test_views(self):
        for up, axis in [('x', 'z'), ('y', 'x'), ('z', 'y')]:
            report = self.firma_json('draw', 'a<b>&.obj', '--up', up, '--at', '1.5', '-o', 'plan.svg')
            self.assertEqual((report['cut_axis'], report['cut_at']), (axis, 1.5))
            self.assertEqual(report['faces_cut'], 4)
            self.texts('plan.svg')
        self.firma('draw', 'a<b>&.obj', '--at', '1e300', '-o', 'plan.svg')
        self.texts('plan.svg')
        self.refuse('draw', 'a<b>&.obj', '--up', 'w', '-o', 'x.svg', says='--up')
        self.refuse('draw', 'a<b>&.obj', '--at', 'nan', '-o', 'x.svg', says='--at')
        self.refuse('draw', 'a<b>&.obj', '--most-casts', '-1', '-o', 'x.svg', says='--most-casts')

    def test_rooms(self):
        depot = os.path.join(ROOT, 'levels', 'depot.map')
        report = self.firma_json('draw', depot, '-o', 'rooms.svg')
        self.assertTrue(report['shows_rooms'])
        self.assertGreater(report['rooms_labelled'], 10)
        self.assertGreater(report['portals_drawn'], 20)
        texts = self.texts('rooms.svg')
        for text in ['Rooms', 'yard', '1 yard', 'portal below a floor']:
            self.assertIn(text, texts)
        self.assertIn(', 35 portals drawn,', self.firma('draw', depot, '-o', 'rooms.svg'))
        plain = self.firma_json('draw', depot, '--plain', '-o', 'plain.svg')
        self.assertEqual((plain['shows_rooms'], plain['rooms_labelled'], plain['portals_drawn']), (False, 0, 0))
        self.assertNotIn('Rooms', self.texts('plain.svg'))
        self.firma('draw', depot, '--below', '3', '-o', 'ground.svg')
        self.assertIn('Plan: cut at z = 3 m, seen along -z', self.texts('ground.svg'))
        one = self.firma_json('draw', 'a<b>&.obj', '--rooms', '-o', 'one.svg')
        self.assertEqual((one['shows_rooms'], one['rooms_labelled']), (True, 1))
        view = ['draw', depot, '--view', '--eye', '8,16,5.7', '--look', '4,15,5.5', '-o']
        self.firma(*view, 'grey.png')
        self.firma(*view, 'rooms.png', '--rooms')
        self.assertNotEqual(self.read('grey.png'), self.read('rooms.png'))
        self.refuse('draw', depot, '--rooms', '--plain', '-o', 'x.svg', says='--plain')
        self.refuse('draw', depot, '--below', 'nan', '-o', 'x.svg', says='--below')
        self.refuse(*view, 'x.png', '--below', '3', says='--view')

    def test_wild_casts(self):
        """Far, huge and endless ones make a page of ordinary size."""
        self.write('wild.csv', 'px,py,pz,dx,dy,dz,radius\n1,1,1,1e30,0,0,0\n-1e9,1,1,1e12,0,0,1e7\n1e50,1e50,1e50,0,0,1,0\n')
        self.firma('draw', 'a<b>&.obj', '--queries', 'wild.csv', '-o', 'plan.svg')
        self.texts('plan.svg')
        self.assertLess(len(self.read('plan.svg')), 20000)

    def test_hits_that_do_not_fit(self):
        rows = self.read('h.csv').decode().splitlines(True)
        draw = ['draw', 'a<b>&.obj', '--queries', 'q.csv', '-o', 'x.svg', '--casts']
        self.refuse(*draw[:2], '--casts', 'h.csv', '-o', 'x.svg', says='--queries')
        self.refuse(*draw, 'none.csv', says='none.csv')
        self.refuse(*draw, self.write('few.csv', ''.join(rows[:3])), says='few.csv')
        self.refuse(*draw, self.write('more.csv', ''.join(rows) + rows[-1]), says='more.csv:5')
        self.refuse(*draw, self.write('swap.csv', rows[0] + rows[2] + rows[1] + rows[3]), says='swap.csv:2')
        self.refuse(*draw, self.write('nan.csv', ''.join(rows).replace(',7.5,', ',nan,', 1)), says='nan.csv:2')
        self.refuse(*draw, self.write('word.csv', ''.join(rows).replace('hit', 'hot', 1)), says='word.csv:2')


# A box of 4 x 4 x 1 m, as TrenchBroom begins a map.
BOX_MAP = '''{
"classname" "worldspawn"
{
( -64 -64 -16 ) ( -64 -63 -16 ) ( -64 -64 -15 ) stone 0 0 0 1 1
( -64 -64 -16 ) ( -64 -64 -15 ) ( -63 -64 -16 ) stone 0 0 0 1 1
( -64 -64 -16 ) ( -63 -64 -16 ) ( -64 -63 -16 ) stone 0 0 0 1 1
( 64 64 16 ) ( 64 65 16 ) ( 65 64 16 ) stone 0 0 0 1 1
( 64 64 16 ) ( 65 64 16 ) ( 64 64 17 ) stone 0 0 0 1 1
( 64 64 16 ) ( 64 64 17 ) ( 64 65 16 ) stone 0 0 0 1 1
}
}
'''


class Demo(CliTest):
    def test_why_craters_are_refused(self):
        depot = os.path.join(ROOT, 'levels', 'depot.map')
        text = self.firma('demo', depot, '--casts', '2000', '--craters', '20', '-o', 'x.svg')
        refused = int(re.search(r'(\d+) refused\n', text).group(1))
        self.assertGreater(refused, 0)
        self.assertIn('%d refused: material depot/sky may not be carved\n' % refused, text)

    def test_demo(self):
        count = 40 if SANITIZED else 200
        casts = 100 * count
        sample = ['--casts', casts] + ['--craters', count] * SANITIZED  # 200 by itself
        report = self.firma_json('demo', FIRST, *sample, '-o', 'new/folder/demo.svg')
        self.assertEqual((report['casts'], report['disagreements']), (casts, 0))
        self.assertEqual(report['checked'], 2000)
        self.assertLess(report['share_of_faces'], 0.02)
        self.assertGreater(report['hit'], casts / 4)
        xml.etree.ElementTree.parse(self.path('new/folder/demo.svg'))
        craters = report['craters']
        self.assertEqual([craters[k] for k in ['count', 'refused', 'casts', 'rays', 'escaped_before', 'escaped', 'disagreements']],
                         [count, 0, casts, casts, 0, 0, 0])
        self.assertGreater(craters['done'], 0.75 * count)
        self.assertGreater(craters['faces_after'], report['faces'] + 50 * craters['done'])
        self.assertGreater(craters['checked'], 2 * count)
        self.assertEqual(report['view'], 'new/folder/demo_view.png')
        self.assertEqual(self.read('new/folder/demo_view.png')[:4], b'\x89PNG')
        again = self.firma_json('demo', FIRST, *sample, '-o', 'x.svg')
        self.assertEqual(again['craters']['hash'], craters['hash'])
        self.assertEqual(self.read('x.svg'), self.read('new/folder/demo.svg'))
        text = self.firma('demo', FIRST, '--casts', '2000', '--craters', '20')
        self.assertIn('0 disagreements', text)
        self.assertIn('rays that escape         0 of 2,000', text)
        self.assertIn('before and after         firma_demo_view.png', text)
        self.assertIn('firma_demo.svg', text)
        self.assertTrue(os.path.exists(self.path('firma_demo.svg')))

    def test_default_level(self):
        os.mkdir(self.path('levels'))
        self.write('levels/depot.map', BOX_MAP)
        report = self.firma_json('demo', '--casts', '100')
        self.assertEqual((report['faces'], report['out']), (6, 'build/demo.svg'))
        self.assertTrue(os.path.exists(self.path('build/demo.svg')))

    def test_open_level(self):
        self.write('open.obj', obj(CORNERS, FACES[:3]))
        report = self.firma_json('demo', 'open.obj', '--casts', '500')
        self.assertEqual((report['disagreements'], report['craters']['volume'], report['view']), (0, 0, None))
        self.assertGreater(report['craters']['done'], 20)  # holes
        self.assertIn('nothing here bounds a closed solid', self.firma('demo', 'open.obj', '--casts', '500', '-o', 'x.svg'))

    def test_bad_calls(self):
        self.refuse('demo', FIRST, '--casts', '0', says='--casts')
        self.refuse('demo', FIRST, '--seed', '1.5', says='--seed')
        self.refuse('demo', FIRST, '--craters', '-1', says='--craters')


if __name__ == '__main__':
    unittest.main()
