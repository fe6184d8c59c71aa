# SPDX-License-Identifier: MIT
"""firma carve of levels of brushes: what it writes is closed, as for levels of meshes."""
import os
import unittest

from harness import CliTest
from test_rooms import DEPOT

HEADER = 'x,y,z,radius,shape,seed\n'
MAPS = os.environ.get('FIRMA_OPENARENA', '')


class CarveLevels(CliTest):
    def carve(self, level, rows, out, *options):
        self.write('b.csv', HEADER + rows)
        return self.firma('carve', level, '--blasts', 'b.csv', '-o', out, *options)

    def faces_of(self, name):
        return sum(line.startswith(b'f ') for line in self.read(name).splitlines())

    def test_the_depot(self):
        solid = self.firma_json('info', DEPOT)['faces']['solid']
        said = self.carve(DEPOT, '30,8,2.5,0.3,rocky,1\n', 'air.obj')
        self.assertIn('not written (--castable writes them)', said)
        self.assertEqual(self.faces_of('air.obj'), solid)
        self.assertTrue(self.firma_json('check', 'air.obj')['sound'])
        self.carve(DEPOT, '20,0,2,0.8,rocky,1\n13,8,5,1,rocky,2\n4,10,0,1.2,spiky,3\n48,4,-1,1.5,drill,4\n', 'after.obj')
        self.assertGreater(self.faces_of('after.obj'), solid)
        self.assertTrue(self.firma_json('check', 'after.obj')['sound'])

    def test_what_is_castable_only(self):
        total = self.firma_json('info', DEPOT)['faces']['total']
        said = self.carve(DEPOT, '30,8,2.5,0.3,rocky,1\n', 'all.obj', '--castable')
        self.assertNotIn('not written', said)
        self.assertEqual(self.faces_of('all.obj'), total)
        self.assertFalse(self.firma_json('check', 'all.obj', code=1)['sound'])
        for out in 'a.glb', 'a.firma':
            self.refuse('carve', DEPOT, '--blasts', 'b.csv', '-o', out, '--castable', says=['--castable', '.obj'])

    def test_saved_and_gone_on(self):
        rows = '20,0,2,0.8,rocky,1\n', '13,8,5,1,rocky,2\n'
        self.carve(DEPOT, rows[0] + rows[1], 'once.obj')
        self.carve(DEPOT, rows[0], 'first.firma')
        self.carve('first.firma', rows[1], 'twice.obj')
        self.assertEqual(self.read('once.obj'), self.read('twice.obj'))

    @unittest.skipUnless(MAPS, 'FIRMA_OPENARENA names no folder of maps')
    def test_maps_of_openarena(self):
        for name in 'kaos2', 'oa_dm5', 'islandctf':
            with self.subTest(name):
                level = os.path.join(MAPS, name + '.bsp')
                start = self.firma_json('info', level)['bounds']
                middle = [(low + high) / 2 for low, high in zip(start['low'], start['high'])]
                rows = ''.join('%r,%r,%r,3,rocky,%d\n' % (middle[0] + 4 * (k - 4), middle[1], middle[2], k) for k in range(9))
                self.write('b.csv', HEADER + rows)
                self.assertEqual(self.run_firma('carve', level, '--blasts', 'b.csv', '-o', 'a.obj').returncode, 0)
                self.assertTrue(self.firma_json('check', 'a.obj')['sound'])


if __name__ == '__main__':
    unittest.main()
