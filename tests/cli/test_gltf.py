# SPDX-License-Identifier: MIT
"""Levels from .gltf and .glb: info, check, cast, carve, draw."""
import base64
import json
import struct
import unittest
import xml.etree.ElementTree

from harness import FIRST, CliTest, box

HEADER = 'x,y,z,radius,shape,seed\n'
# Of a box room, fronts inside.
TRIANGLES = [0, 3, 2, 0, 1, 3, 4, 7, 5, 4, 6, 7, 0, 5, 1, 0, 4, 5, 2, 7, 6, 2, 3, 7, 0, 6, 4, 0, 2, 6, 1, 7, 3, 1, 5, 7]


def room(size, nodes=None, triangles=TRIANGLES, uri=True):
    """A .gltf of a room from the origin, in glTF's axes, as a dictionary; and its buffer."""
    corners = [size[axis] * (k >> axis & 1) for k in range(8) for axis in range(3)]
    data = struct.pack('<24f', *corners) + struct.pack('<%dH' % len(triangles), *triangles)
    buffer = {'byteLength': len(data)}
    if uri:
        buffer['uri'] = 'data:application/octet-stream;base64,' + base64.b64encode(data).decode()
    return {
        'asset': {'version': '2.0'},
        'buffers': [buffer],
        'bufferViews': [{'buffer': 0, 'byteLength': 96}, {'buffer': 0, 'byteOffset': 96, 'byteLength': 2 * len(triangles)}],
        'accessors': [{'bufferView': 0, 'componentType': 5126, 'count': 8, 'type': 'VEC3'},
                      {'bufferView': 1, 'componentType': 5123, 'count': len(triangles), 'type': 'SCALAR'}],
        'meshes': [{'primitives': [{'attributes': {'POSITION': 0}, 'indices': 1, 'material': 0}]}],
        'materials': [{'name': 'rock'}],
        'nodes': nodes or [{'mesh': 0, 'name': 'room'}],
        'scenes': [{'nodes': list(range(len(nodes or [0])))}],
    }, data


class Gltf(CliTest):
    def write_room(self, name, size, **how):
        self.write(name, json.dumps(room(size, **how)[0]))
        return name

    def test_info(self):
        self.write_room('room.gltf', (4, 3, 5))
        info = self.firma_json('info', 'room.gltf')
        self.assertEqual((info['faces']['in_file'], info['faces']['total'], info['vertices']), (12, 12, 8))
        self.assertEqual((info['materials'], info['groups']), (['rock'], 2))
        self.assertEqual(info['bounds'], {'low': [0, -5, 0], 'high': [4, 0, 3]})     # y up became z up
        self.assertEqual(info['solid'], {'faces': 12, 'volume': -60, 'area': 94})
        self.assertEqual(info['gltf'], {'nodes': 1, 'parts': [], 'portals': [], 'undivided': None, 'notes': []})
        self.assertEqual(self.firma_json('info', 'room.gltf', '--scale', '2')['bounds']['high'], [8, 0, 6])
        self.assertNotIn('portals', self.firma('info', 'room.gltf'))
        self.assertNotIn('gltf', self.firma_json('info', FIRST))

    def test_portals_make_rooms(self):
        nodes = [{'mesh': 0}, {'mesh': 1, 'name': 'Portal 1', 'translation': [1, 0, 0]}]
        document, _ = room((4, 4, 4), nodes)
        square = {'componentType': 5121, 'count': 6, 'type': 'SCALAR', 'bufferView': 2}
        data = bytes([0, 2, 6, 0, 6, 4])
        document['buffers'].append({'byteLength': 6, 'uri': 'data:;base64,' + base64.b64encode(data).decode()})
        document['bufferViews'].append({'buffer': 1, 'byteLength': 6})
        document['accessors'].append(square)
        document['meshes'].append({'primitives': [{'attributes': {'POSITION': 0}, 'indices': 2}]})
        document['animations'] = [{}]
        self.write('room.gltf', json.dumps(document))
        told = self.firma_json('info', 'room.gltf')
        self.assertEqual(told['gltf']['portals'], [{'name': 'Portal 1', 'polygons': 1, 'idle': False}])
        self.assertEqual(told['gltf']['notes'], ['1 animations are left out'])
        self.assertEqual((told['faces']['in_file'], len(told['rooms'])), (12, 2))
        self.assertEqual([portal['name'] for portal in told['portals']], ['Portal 1'])
        self.assertIn('1 animations are left out', self.firma('info', 'room.gltf'))
        drawn = self.run_firma('draw', 'room.gltf', '-o', 'plan.svg')
        self.assertEqual((drawn.returncode, drawn.stderr), (0,
                                                              b'firma: warning: room.gltf: left out: animations: 1 (firma info --json says where)\n'))
        report = self.firma_json('check', 'room.gltf')
        self.assertEqual((report['sound'], report['rooms'], report['portals'], report['idle_portals']), (True, 2, 1, []))
        self.assertEqual((report['undivided'], report['reader_notes'], report['note_count']),
                         (None, ['1 animations are left out'], 1))
        self.assertIn('2 rooms, 1 portal; 0 faults, 1 note;', self.firma('check', 'room.gltf'))
        nodes[1]['translation'] = [40, 0, 0]                                     # in the rock
        self.write('room.gltf', json.dumps(document))
        self.assertEqual(len(self.firma_json('info', 'room.gltf')['rooms']), 1)
        nodes[1].update({'translation': [2, 1, -1], 'scale': [1, 0.5, 0.5]})        # in the air alone
        self.write('room.gltf', json.dumps(document))
        told = self.firma_json('info', 'room.gltf')
        self.assertEqual((len(told['rooms']), told['gltf']['portals'][0]['idle']), (1, True))
        self.assertIn('1 of them in whole or part with one room', self.firma('info', 'room.gltf'))
        report = self.firma_json('check', 'room.gltf')
        self.assertEqual((report['rooms'], report['portals'], report['idle_portals']), (1, 0, ['Portal 1']))
        self.assertIn("portal 'Portal 1': one room on both sides", self.firma('check', 'room.gltf'))
        document['meshes'][0]['primitives'][0]['indices'] = 2                    # nothing closed
        self.write('room.gltf', json.dumps(document))
        self.assertEqual(self.firma_json('info', 'room.gltf')['gltf']['undivided'], 'none of its faces bounds a solid')
        self.assertEqual(self.firma_json('check', 'room.gltf', code=1)['undivided'], 'none of its faces bounds a solid')

    def test_check(self):
        self.write_room('room.gltf', (4, 4, 4))
        self.assertTrue(self.firma('check', 'room.gltf').strip().endswith('0 notes; solid, rock outside'))
        report = self.firma_json('check', 'room.gltf')
        self.assertEqual((report['sound'], report['faces'], report['vertices'], report['solid_faces']), (True, 12, 8, 12))
        self.write_room('open.gltf', (4, 4, 4), triangles=TRIANGLES[:30])
        report = self.firma_json('check', 'open.gltf', code=1)
        self.assertEqual(report['fault_count'], 4)
        for fault in report['faults']:
            self.assertEqual((fault['what'], fault['line'], fault['from'][0], fault['to'][0]), ('open_edge', None, 4, 4))
        self.assertIn('open.gltf: face', self.run_firma('check', 'open.gltf').stdout.decode())
        # A sliver that the snap closes.
        triangles = TRIANGLES + [0, 1, 1]
        self.write_room('note.gltf', (4, 4, 4), triangles=triangles)
        report = self.firma_json('check', 'note.gltf')
        self.assertEqual([(note['what'], note['face']) for note in report['notes']], [('dropped', 12)])

    def test_cast_carve_and_draw(self):
        self.write_room('room.gltf', (4, 4, 4))
        self.write('q.csv', 'px,py,pz,dx,dy,dz,radius\n2,-2,2,9,0,0,0.5\n')
        self.firma('cast', 'room.gltf', '--queries', 'q.csv', '-o', 'h.csv')
        self.assertIn('hit', self.read('h.csv').decode())
        self.write('b.csv', HEADER + '2,-2,0,1,rocky,1\n')
        self.firma('carve', 'room.gltf', '--blasts', 'b.csv', '-o', 'after.glb')
        info = self.firma_json('info', 'after.glb')
        self.assertEqual(info['materials'], ['rock', 'matter/rock'])
        self.assertLess(info['solid']['volume'], -64.3)
        self.assertTrue(self.firma_json('check', 'after.glb')['sound'])
        self.firma('draw', 'after.glb', '-o', 'plan.svg')
        xml.etree.ElementTree.parse(self.path('plan.svg'))

    def test_written_and_read(self):
        self.write('b.csv', HEADER)
        self.firma('carve', FIRST, '--blasts', 'b.csv', '-o', 'first.GLB')
        before, after = self.firma_json('info', FIRST), self.firma_json('info', 'first.GLB')
        for what in ['bounds', 'solid']:
            self.assertEqual(before[what], after[what])
        self.assertEqual(before['faces']['total'], after['faces']['total'])
        self.assertEqual(sorted(before['materials']), sorted(after['materials']))
        self.write('box.obj', box(4, 4, 4))
        self.firma('carve', 'box.obj', '--blasts', 'b.csv', '-o', 'box.glb')
        self.firma('carve', 'box.glb', '--blasts', 'b.csv', '-o', 'again.glb')
        self.assertEqual(self.read('box.glb')[:20], self.read('again.glb')[:20])

    def test_files_beside(self):
        document, data = room((4, 4, 4), uri=False)
        document['buffers'][0]['uri'] = 'room%20data.bin'
        self.write('room data.bin', data)
        self.write('room.gltf', json.dumps(document))
        self.assertEqual(self.firma_json('info', 'room.gltf')['faces']['total'], 12)
        self.write('room data.bin', data[1:])
        self.refuse('info', 'room.gltf', says='room.gltf: buffer 0: has 167 of its 168 bytes')
        document['buffers'][0]['uri'] = '/etc/passwd'
        self.write('room.gltf', json.dumps(document))
        self.refuse('info', 'room.gltf', says="names '/etc/passwd', which is no file beside this one")

    def test_refusals(self):
        self.refuse('info', 'none.glb', says='none.glb')
        self.write('a.glb', 'no glTF')
        for verb in [['info'], ['check'], ['draw', '-o', 'x.svg']]:
            self.refuse(*verb, 'a.glb', says='a.glb:1: its JSON breaks off at column 2')
        document, _ = room((4, 4, 4))
        document['meshes'][0]['primitives'][0]['indices'] = 7
        self.write('a.gltf', json.dumps(document))
        self.refuse('check', 'a.gltf', says='a.gltf')
        self.refuse('info', 'a.gltf', '--surfaces', says='--surfaces')
        self.refuse('check', 'a.gltf', '--scale', '0', says='--scale')


if __name__ == '__main__':
    unittest.main()
