# SPDX-License-Identifier: MIT
"""firma carve -o AFTER.glb, read byte by byte as the glTF 2.0 specification has it, against the .obj of the same blasts."""
import json
import math
import os
import struct
import unittest

from harness import FIRST, CliTest, box, obj

HEADER = 'x,y,z,radius,shape,seed\n'
BLASTS = '35,29,0.2,1.6,rocky,1\n30,25,0,0.5,drill,2\n36,29,0.2,1.1,spiky,9\n'
FLOAT, UINT32, ARRAY_BUFFER, ELEMENT_ARRAY_BUFFER = 5126, 5125, 34962, 34963


def minus(a, b):
    return tuple(p - q for p, q in zip(a, b))


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def dot(a, b):
    return sum(p * q for p, q in zip(a, b))


def length(a):
    return math.sqrt(dot(a, a))


def fan(corners):
    return [(corners[0], corners[k], corners[k + 1]) for k in range(1, len(corners) - 1)]


def area(triangles):
    return sum(length(cross(minus(b, a), minus(c, a))) for a, b, c in triangles) / 2


def volume(triangles):
    return sum(dot(a, cross(b, c)) for a, b, c in triangles) / 6


def bounds(points):
    points = list(points)
    return [[f(p[k] for p in points) for k in range(3)] for f in (min, max)]


class Glb:
    """A .glb taken apart; anything that the specification does not allow raises."""

    def __init__(self, data):
        magic, version, size = struct.unpack_from('<4sII', data)
        assert (magic, version, size) == (b'glTF', 2, len(data)), (magic, version, size, len(data))
        at, chunks = 12, []
        while at < len(data):
            chunk_size, kind = struct.unpack_from('<I4s', data, at)
            assert chunk_size % 4 == 0 and at + 8 + chunk_size <= len(data)
            chunks.append((kind, data[at + 8:at + 8 + chunk_size]))
            at += 8 + chunk_size
        assert [kind for kind, _ in chunks] in ([b'JSON', b'BIN\0'], [b'JSON']), chunks
        self.json = json.loads(chunks[0][1].decode('utf-8'))
        self.buffer = chunks[1][1] if len(chunks) > 1 else b''
        assert [b['byteLength'] for b in self.json.get('buffers', [])] == ([len(self.buffer)] if self.buffer else [])
        self.primitives = [p for mesh in self.json.get('meshes', []) for p in mesh['primitives']]

    def values(self, accessor, kind, component, target):
        what = self.json['accessors'][accessor]
        view = self.json['bufferViews'][what['bufferView']]
        assert (what['type'], what['componentType'], view['target']) == (kind, component, target), (what, view)
        assert 'byteOffset' not in what and 'byteStride' not in view
        first, size = view.get('byteOffset', 0), view['byteLength']
        width = 3 if kind == 'VEC3' else 1
        assert first % 4 == 0 and size == 4 * width * what['count'] and first + size <= len(self.buffer)
        numbers = struct.unpack_from('<%d%s' % (size // 4, 'f' if component == FLOAT else 'I'), self.buffer, first)
        return numbers if width == 1 else list(zip(*[iter(numbers)] * 3))

    def part(self, primitive):
        """Positions, normals, indices by threes."""
        assert primitive['mode'] == 4
        positions = self.values(primitive['attributes']['POSITION'], 'VEC3', FLOAT, ARRAY_BUFFER)
        normals = self.values(primitive['attributes']['NORMAL'], 'VEC3', FLOAT, ARRAY_BUFFER)
        indices = self.values(primitive['indices'], 'SCALAR', UINT32, ELEMENT_ARRAY_BUFFER)
        assert len(positions) == len(normals) and len(indices) % 3 == 0 and max(indices) == len(positions) - 1
        return positions, normals, list(zip(*[iter(indices)] * 3))

    def triangles(self):
        """By name of the material."""
        found = {}
        for primitive in self.primitives:
            positions, _, indices = self.part(primitive)
            name = self.json['materials'][primitive['material']].get('name', '')
            assert name not in found, name
            found[name] = [tuple(positions[k] for k in triangle) for triangle in indices]
        return found


class GlbTest(CliTest):
    def carve(self, level, rows, out, *options):
        self.write('b.csv', HEADER + rows)
        return self.firma_json('carve', level, '--blasts', 'b.csv', '-o', out, *options)

    def glb(self, name):
        return Glb(self.read(name))

    def faces(self, name):
        """Corners of the faces of an .obj, by material."""
        vertices, found, material = [], {}, ''
        for line in self.read(name).decode().splitlines():
            word, _, rest = line.partition(' ')
            if word == 'v': vertices.append(tuple(float(number) for number in rest.split()))
            if word == 'usemtl': material = rest
            if word == 'f': found.setdefault(material, []).append([vertices[int(k) - 1] for k in rest.split()])
        return found


class File(GlbTest):
    def setUp(self):
        super().setUp()
        self.carve(FIRST, BLASTS, 'a.obj', '--material', 'fresh')
        self.told = self.carve(FIRST, BLASTS, 'a.glb', '--material', 'fresh')
        self.level = self.glb('a.glb')

    def test_it_is_the_level_of_the_obj(self):
        """Within 64 m of the origin a 32-bit float has every digit of the surface grid."""
        expected = {name: [t for face in faces for t in fan(face)] for name, faces in self.faces('a.obj').items()}
        got = self.level.triangles()
        self.assertEqual(set(got), set(expected) - {'fresh'} | {'fresh (cut)'})
        expected['fresh (cut)'] = expected.pop('fresh')
        self.assertGreater(len(expected['fresh (cut)']), 200)
        for name, triangles in expected.items():
            self.assertEqual(got[name], triangles, name)
        everything = [t for triangles in got.values() for t in triangles]
        wanted = [t for triangles in expected.values() for t in triangles]
        self.assertEqual((area(everything), volume(everything)), (area(wanted), volume(wanted)))
        self.assertLess(volume(everything), -1000)                             # air in rock

    def test_the_volume_taken_is_missing(self):
        self.carve(FIRST, '', 'before.glb')
        before, after = (sum(volume(t) for t in self.glb(name).triangles().values()) for name in ['before.glb', 'a.glb'])
        self.assertAlmostEqual(before - after, self.told['volume'], 4)

    def test_normals_and_windings(self):
        for primitive in self.level.primitives:
            positions, normals, indices = self.level.part(primitive)
            for triangle in indices:
                a, b, c = (positions[k] for k in triangle)
                self.assertEqual(len({normals[k] for k in triangle}), 1)
                normal, upright = normals[triangle[0]], cross(minus(b, a), minus(c, a))
                self.assertAlmostEqual(length(normal), 1, 6)
                if length(upright) > 1e-3: self.assertGreater(dot(normal, upright) / length(upright), 0.999)

    def test_bounds(self):
        every = []
        for primitive in self.level.primitives:
            positions = self.level.part(primitive)[0]
            accessor = self.level.json['accessors'][primitive['attributes']['POSITION']]
            self.assertEqual([accessor['min'], accessor['max']], bounds(positions))
            every += positions
        info = self.firma_json('info', 'a.obj')['bounds']
        self.assertEqual(bounds(every), [info['low'], info['high']])

    def test_views_cover_the_buffer(self):
        spans = sorted((v.get('byteOffset', 0), v['byteLength']) for v in self.level.json['bufferViews'])
        self.assertEqual(len(spans), 3 * len(self.level.primitives))
        at = 0
        for first, size in spans:
            self.assertEqual(first, at)
            at += size
        self.assertEqual(at, len(self.level.buffer))

    def test_materials(self):
        materials = self.level.json['materials']
        self.assertEqual([p['material'] for p in self.level.primitives], list(range(len(materials))))
        for material in materials:
            look = material['pbrMetallicRoughness']
            self.assertEqual((len(look['baseColorFactor']), look['baseColorFactor'][3], look['metallicFactor']), (4, 1, 0))
            self.assertEqual(material['extras']['cut'], material['name'].endswith(' (cut)'))
        self.assertEqual(len({tuple(m['pbrMetallicRoughness']['baseColorFactor']) for m in materials}), len(materials))

    def test_scene(self):
        asset, node = self.level.json['asset'], self.level.json['nodes'][0]
        self.assertEqual(asset['version'], '2.0')
        self.assertRegex(asset['generator'], r'^Firma \d')
        self.assertEqual(asset['extras'], {'version': 3, 'edits': 3, 'hash': self.told['hash']})
        self.assertEqual((self.level.json['scene'], self.level.json['scenes'][0]['nodes']), (0, [0]))
        self.assertEqual((len(self.level.json['nodes']), len(self.level.json['meshes']), node['mesh']), (1, 1, 0))
        self.assertEqual(set(node), {'mesh', 'name', 'rotation'})

    def test_up(self):
        """The node turns z, or what --up says, to y; positions stay."""
        half = math.sqrt(0.5)
        for up, rotation in [('z', [-half, 0, 0, half]), ('x', [0, 0, half, half]), ('y', None)]:
            self.carve(FIRST, BLASTS, 'up.glb', '--material', 'fresh', '--up', up)
            other = self.glb('up.glb')
            self.assertEqual(other.buffer, self.level.buffer)
            got = other.json['nodes'][0].get('rotation')
            self.assertEqual(got is None, rotation is None)
            for a, b in zip(got or [], rotation or []): self.assertAlmostEqual(a, b, 15)
            self.assertEqual(self.read('up.glb') == self.read('a.glb'), up == 'z')

    def test_the_same_through_a_saved_world(self):
        self.carve(FIRST, BLASTS, 'a.firma', '--material', 'fresh')
        self.carve('a.firma', '', 'b.glb')
        self.assertEqual(self.read('b.glb'), self.read('a.glb'))
        self.carve(FIRST, BLASTS, 'A.GLB', '--material', 'fresh', '--slices', '50')
        self.assertEqual(self.read('A.GLB'), self.read('a.glb'))


class Levels(GlbTest):
    def test_far_out_floats_round(self):
        """At the rim of the world by at most 1/4096 m."""
        self.write('far.obj', box(12, 12, 12, (8170.000244140625, -8190.5, 4090)))
        blasts = '8176.3,-8184.2,4090,2.1,rocky,3\n'
        self.carve('far.obj', blasts, 'far.glb')
        self.carve('far.obj', blasts, 'after.obj')
        got = sorted(p for triangles in self.glb('far.glb').triangles().values() for t in triangles for p in t)
        expected = sorted(p for faces in self.faces('after.obj').values() for face in faces for t in fan(face) for p in t)
        self.assertEqual(len(got), len(expected))
        worst = 0
        rounded = sorted(tuple(struct.unpack('<3f', struct.pack('<3f', *p))) for p in expected)
        self.assertEqual(got, rounded)
        for p in expected:
            worst = max(worst, max(abs(a - b) for a, b in zip(p, struct.unpack('<3f', struct.pack('<3f', *p)))))
        self.assertLessEqual(worst, 1 / 4096)
        self.assertGreater(worst, 1 / 8192)                                    # or nothing was put to the test

    def test_names(self):
        """Those that are not UTF-8 are mended; a level without names has none but that of cuts."""
        text = box(4, 4, 4).encode().replace(b'f 1', b'usemtl gr\xc3\xbcn "\\"\nf 1', 1).replace(b'f 2', b'usemtl br\xfcn\nf 2', 1)
        self.write('room.obj', text)
        self.carve('room.obj', '2,2,0,1,rocky,1\n', 'a.glb')
        self.assertEqual(set(self.glb('a.glb').triangles()), {'gr\u00fcn "\\"', 'br\ufffdn', '(cut)'})
        self.write('plain.obj', box(4, 4, 4))
        self.carve('plain.obj', '2,2,0,1,rocky,1\n', 'a.glb')
        self.assertEqual(set(self.glb('a.glb').triangles()), {'', '(cut)'})
        self.assertNotIn('name', self.glb('a.glb').json['materials'][0])

    def test_nothing_left(self):
        corners = [(k & 1, k >> 1 & 1, k >> 2 & 1) for k in range(8)]
        sides = [(0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5)]
        self.write('block.obj', obj(corners, sides))
        self.write('b.csv', HEADER + '0.5,0.5,0.5,4,rocky,1\n')
        done = self.run_firma('carve', 'block.obj', '--blasts', 'b.csv', '-o', 'none.glb')
        self.assertEqual(done.returncode, 0)
        self.assertIn(b'none.glb: the blasts left no face: its scene is empty', done.stderr)
        none = self.glb('none.glb')
        self.assertEqual((none.json['scenes'], none.buffer, none.primitives), ([{'name': 'world'}], b'', []))
        self.assertFalse({'nodes', 'meshes', 'accessors', 'bufferViews', 'buffers', 'materials'} & set(none.json))


class Calls(GlbTest):
    def setUp(self):
        super().setUp()
        self.write('box.obj', box(4, 4, 4))
        self.write('b.csv', HEADER + '2,2,0,1,rocky,1\n')

    def call(self, *more):
        return ['carve', 'box.obj', '--blasts', 'b.csv', *more]

    def test_where_it_cannot_be_written(self):
        os.mkdir(self.path('folder.glb'))
        self.write('plain', 'no folder')
        os.symlink('/dev/full', self.path('full.glb'))
        for out in ['folder.glb', 'missing/a.glb', 'plain/a.glb', 'full.glb']:
            self.refuse(*self.call('-o', out), says=out)
        self.write('old.glb', 'as it was')
        for bad in [['--up', 'w'], ['--slices', 'x']]:
            self.refuse(*self.call('-o', 'old.glb', *bad), says=bad[0])
        self.write('b.csv', HEADER + '2,2,0,1,rocky,1\n2,2,0,1,rocky\n')
        self.refuse(*self.call('-o', 'old.glb'), says='b.csv:3')
        self.assertEqual([name for name in self.files() if 'part' in name], [])

    def test_a_file_too_large_leaves_the_old_one(self):
        """A limit on file sizes, as a full disk: the write of a piece fails."""
        self.write('old.glb', 'as it was')
        def limit():
            import resource
            resource.setrlimit(resource.RLIMIT_FSIZE, (4096, 4096))
        self.refuse(*self.call('-o', 'old.glb'), says='old.glb: cannot be written: File too large', preexec_fn=limit)
        self.assertEqual(self.files(), ['b.csv', 'box.obj', 'old.glb'])
        self.firma(*self.call('-o', 'old.glb'))
        self.assertGreater(len(self.glb('old.glb').buffer), 4096)

    def test_calls(self):
        self.refuse(*self.call('-o', 'a.gltf'), says='.glb')
        self.refuse(*self.call('-o', 'a.obj', '--up', 'z'), says='--up')
        self.refuse('info', 'a.stl', says='.obj, .map, .bsp, .gltf, .glb, .firma')


if __name__ == '__main__':
    unittest.main()
