# SPDX-License-Identifier: MIT
"""What levels are made of, by the command line: textures, a table of one's own, extras of glTF materials."""
import base64
import struct
import unittest

from harness import CliTest


def brush(low, high, texture):
    """A box of a .map, in units."""
    (x, y, z), (X, Y, Z) = low, high
    sides = [((x, 0, 0), (x, 1, 0), (x, 0, 1)), ((X, 0, 0), (X, 0, 1), (X, 1, 0)), ((0, y, 0), (0, y, 1), (1, y, 0)),
             ((0, Y, 0), (1, Y, 0), (0, Y, 1)), ((0, 0, z), (1, 0, z), (0, 1, z)), ((0, 0, Z), (0, 1, Z), (1, 0, Z))]
    lines = [' '.join('( %d %d %d )' % p for p in side) + ' ' + texture + ' 0 0 0 1 1\n' for side in sides]
    return '{\n' + ''.join(lines) + '}\n'


WALLS = ('{\n"classname" "worldspawn"\n' + brush((0, 0, 0), (4, 4, 4), 'red_brick') +
         brush((4, 0, 0), (8, 4, 4), 'oak_planks') + '}\n')
TABLE = 'matter vault\n texture *brick*\n hardness 1\nmatter oak\n texture oak*\n inside oak/cut\n density 750\n'
BLAST = 'x,y,z,radius,shape,seed\n4,2,4,1,rocky,1\n'


def gltf(extras):
    """Two closed boxes, 2 m wide and 4 m apart, each of a material."""
    corners = [(i & 1, i >> 1 & 1, i >> 2 & 1) for i in range(8)]
    quads = [(0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5)]
    indices = [k for a, b, c, d in quads for k in (a, b, c, a, c, d)]
    data = b''.join(struct.pack('<3f', *(2.0 * x for x in c)) for c in corners) + struct.pack('<36H', *indices)
    uri = 'data:application/octet-stream;base64,' + base64.b64encode(data).decode()
    primitive = '{"attributes": {"POSITION": 0}, "indices": 1, "material": %d}'
    return '''{"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0, 1]}],
"nodes": [{"mesh": 0}, {"mesh": 1, "translation": [6, 0, 0]}],
"meshes": [{"primitives": [%s]}, {"primitives": [%s]}],
"materials": [{"name": "one", "extras": %s}, {"name": "old_brick"}],
"accessors": [{"bufferView": 0, "componentType": 5126, "count": 8, "type": "VEC3", "min": [0, 0, 0], "max": [2, 2, 2]},
{"bufferView": 1, "componentType": 5123, "count": 36, "type": "SCALAR"}],
"bufferViews": [{"buffer": 0, "byteOffset": 0, "byteLength": 96}, {"buffer": 0, "byteOffset": 96, "byteLength": 72}],
"buffers": [{"byteLength": 168, "uri": "%s"}]}''' % (primitive % 0, primitive % 1, extras, uri)


class Matter(CliTest):
    def setUp(self):
        super().setUp()
        self.write('walls.map', WALLS)
        self.write('game.matter', TABLE)
        self.write('blasts.csv', BLAST)

    def test_info_counts_pieces(self):
        found = self.firma_json('info', 'walls.map', '--scale', 1)['matter']
        self.assertEqual(found, {'pieces': 2, 'protected': 0, 'rest': '',
                                 'of': [{'name': 'brick', 'pieces': 1}, {'name': 'wood', 'pieces': 1}]})
        self.assertIn('2 pieces: brick 1, wood 1\n', self.firma('info', 'walls.map', '--scale', 1))
        found = self.firma_json('info', 'walls.map', '--scale', 1, '--matter', 'game.matter')['matter']
        self.assertEqual(found['protected'], 1)
        self.assertEqual([of['name'] for of in found['of']], ['vault', 'oak'])

    def test_craters_show_insides(self):
        def carve(*options):
            self.firma('carve', 'walls.map', '--scale', 1, '--blasts', 'blasts.csv', '-o', 'after.firma', *options)
            return self.firma_json('info', 'after.firma')
        self.assertEqual(carve()['materials'][-2:], ['matter/brick', 'matter/wood'])
        after = carve('--matter', 'game.matter')
        self.assertIn('oak/cut', after['materials'])
        self.assertEqual(after['matter']['protected'], 1)
        self.assertEqual(carve('--material', 'rubble')['materials'][-1], 'rubble')

    def test_bad_tables_say_where(self):
        self.write('bad.matter', 'matter a\ndensity heavy\n')
        for verb in [('info', 'walls.map'), ('carve', 'walls.map', '--blasts', 'blasts.csv', '-o', 'after.obj')]:
            self.refuse(*verb, '--matter', 'bad.matter', says="bad.matter:2: 'heavy' is no finite number")
            self.refuse(*verb, '--matter', 'none.matter', says='none.matter: cannot be read')
        self.firma('carve', 'walls.map', '--blasts', 'blasts.csv', '-o', 'after.firma')
        self.refuse('info', 'after.firma', '--matter', 'game.matter', says='has its own table')

    def test_extras_of_gltf_materials(self):
        for extras, name in [('{"matter": "steel"}', 'steel'), ('{"material": "wood"}', 'wood'),
                             ('{"material": "reinforced_concrete"}', 'concrete'), ('{"matter": 7}', None)]:
            self.write('boxes.gltf', gltf(extras))
            found = self.firma_json('info', 'boxes.gltf')['matter']
            self.assertEqual(found['pieces'], 2, extras)
            names = [of['name'] for of in found['of']]
            self.assertEqual(sorted(names), sorted(['brick', name or '']), extras)


if __name__ == '__main__':
    unittest.main()
