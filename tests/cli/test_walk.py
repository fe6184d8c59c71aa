# SPDX-License-Identifier: MIT
"""firma walk: rows, distances by a computation of its own, coverage, the same bytes."""
import math
import random
import unittest

from harness import FIRST, CliTest, box, obj


def dot(a, b): return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
def sub(a, b): return (a[0] - b[0], a[1] - b[1], a[2] - b[2])
def add(a, b, s=1.0): return (a[0] + s * b[0], a[1] + s * b[1], a[2] + s * b[2])
def cross(a, b): return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])
def length(a): return math.sqrt(dot(a, a))


def between_segments(p, q, a, b):
    """distance of two segments: closest points of the lines, moved back onto the segments"""
    d, e, r = sub(q, p), sub(b, a), sub(p, a)
    dd, ee, de, dr, er = dot(d, d), dot(e, e), dot(d, e), dot(d, r), dot(e, r)
    clamp = lambda x: min(max(x, 0.0), 1.0)
    candidates = [(0.0, clamp(er / ee)), (1.0, clamp((er + de) / ee))]
    if dd > 0:
        candidates += [(clamp(-dr / dd), 0.0), (clamp((de - dr) / dd), 1.0)]
        if dd * ee - de * de > 0:
            s = clamp((de * er - dr * ee) / (dd * ee - de * de))
            candidates.append((s, clamp((er + s * de) / ee)))
    return min(length(sub(add(p, d, s), add(a, e, t))) for s, t in candidates)


class Triangle:
    def __init__(self, corners):
        self.corners = corners
        normal = cross(sub(corners[1], corners[0]), sub(corners[2], corners[0]))
        self.normal = tuple(x / length(normal) for x in normal)

    def covers(self, point):
        return all(dot(cross(sub(b, a), sub(point, a)), self.normal) >= 0
                   for a, b in zip(self.corners, self.corners[1:] + self.corners[:1]))

    def distance(self, p, q):
        """of a segment"""
        above = [dot(sub(x, self.corners[0]), self.normal) for x in (p, q)]
        if (above[0] > 0) != (above[1] > 0) and self.covers(add(p, sub(q, p), above[0] / (above[0] - above[1]))): return 0.0
        found = [abs(h) for x, h in zip((p, q), above) if self.covers(add(x, self.normal, -h))]
        return min(found + [between_segments(p, q, a, b) for a, b in zip(self.corners, self.corners[1:] + self.corners[:1])])


def triangles_of(text):
    corners = [tuple(round(float(x) * 4096) / 4096 for x in line.split()[1:]) for line in text.splitlines() if line[0] == 'v']
    faces = [[corners[int(k) - 1] for k in line.split()[1:]] for line in text.splitlines() if line[0] == 'f']
    return [Triangle([face[0], face[k], face[k + 1]]) for face in faces for k in range(1, len(face) - 1)]


def voxel_room(cells, seed, jitter, low=(0, 0, 0)):
    """a room grown of cubes of 4 m, its corners moved by up to `jitter` steps of the grid; all of triangles"""
    number = random.Random(seed)
    steps = [(1, 0, 0), (-1, 0, 0), (0, 1, 0), (0, -1, 0), (0, 0, 1), (0, 0, -1)]
    air = [(0, 0, 0)]
    while len(air) < cells:
        cell, step = number.choice(air), number.choice(steps)
        cell = tuple(cell[k] + step[k] for k in range(3))
        if cell not in air: air.append(cell)
    index, corners, faces = {}, [], []
    def corner(place):
        if place not in index:
            index[place] = len(corners)
            corners.append(tuple(low[k] + 4 * place[k] + number.randint(-jitter, jitter) / 4096 for k in range(3)))
        return index[place]
    for cell in air:
        for step in steps:
            if tuple(cell[k] + step[k] for k in range(3)) in air: continue
            axis = [k for k in range(3) if step[k]][0]
            across, up = [(1, 2), (2, 0), (0, 1)][axis]
            quad = []
            for a, b in [(0, 0), (1, 0), (1, 1), (0, 1)]:
                place = list(cell)
                place[axis] += step[axis] > 0
                place[across] += a
                place[up] += b
                quad.append(corner(tuple(place)))
            if step[axis] > 0: quad.reverse()
            faces += [(quad[0], quad[1], quad[2]), (quad[0], quad[2], quad[3])]
    return air, obj(corners, faces)


class Walk(CliTest):
    def walk(self, level, start, radius, frames, seed=1, name='w.csv'):
        self.write('level.obj', level)
        self.firma('walk', 'level.obj', '--start', start, '--radius', radius, '--frames', frames, '--seed', seed, '--out', name)
        lines = self.read(name).decode().splitlines()
        self.assertEqual(lines[0], 'frame,px,py,pz')
        rows = [line.split(',') for line in lines[1:]]
        self.assertEqual([row[0] for row in rows], [str(k) for k in range(frames + 1)])
        for row in rows[:50]:
            self.assertEqual(row[1:], ['%.17g' % float(x) for x in row[1:]])
        places = [tuple(map(float, row[1:])) for row in rows]
        self.assertEqual(places[0], tuple(map(float, start.split(','))))
        return places

    def clearance(self, level, places, radius):
        """the least distance to a face along the way, less the radius"""
        triangles, least = triangles_of(level), math.inf
        for p, q in zip(places, places[1:]):
            for triangle in triangles:
                box = zip(*triangle.corners)
                near = all(min(c) - radius - 0.01 <= max(p[k], q[k]) and max(c) + radius + 0.01 >= min(p[k], q[k])
                           for k, c in enumerate(box))
                if near: least = min(least, triangle.distance(p, q) - radius)
        return least

    def assert_sound(self, level, places, radius):
        self.assertGreaterEqual(self.clearance(level, places, radius), -1e-6)

    def test_box(self):
        level = box(4, 4, 4)
        for radius in ['0', '1e-7', '0.001', '0.5', '1.5', '1.999']:
            places = self.walk(level, '2,2,2', radius, 500)
            self.assert_sound(level, places, float(radius))
            room = 4 - 2 * float(radius)
            for axis in range(3):
                reach = [p[axis] for p in places]
                self.assertGreater(max(reach) - min(reach), 0.9 * room)

    def test_rooms_are_visited_all_over(self):
        for cells, seed, jitter, radius, frames in [(20, 1, 0, '0.4', 3000), (30, 2, 800, '0.4', 4000), (12, 3, 400, '1.6', 3000)]:
            air, level = voxel_room(cells, seed, jitter)
            places = self.walk(level, '2,2,2', radius, frames)
            self.assert_sound(level, places, float(radius))
            visited = {tuple(math.floor(x / 4) for x in p) for p in places}
            self.assertEqual(set(air) - visited, set())

    def test_far_from_the_origin(self):
        air, level = voxel_room(8, 4, 300, (8100, -8100, 8100))
        places = self.walk(level, '8102,-8098,8102', '0.7', 1500)
        self.assert_sound(level, places, 0.7)
        visited = {tuple(math.floor((x - o) / 4) for x, o in zip(p, (8100, -8100, 8100))) for p in places}
        self.assertEqual(set(air) - visited, set())

    def test_start_in_touch(self):
        level = box(4, 4, 4)
        for start, radius in [('0.5,0.5,0.5', '0.5'), ('1,1,3.9', '0.1'), ('2,2,0.3', '0.3')]:
            places = self.walk(level, start, radius, 300)
            self.assert_sound(level, places, float(radius))
            self.assertGreater(max(p[0] for p in places), 3)

    def test_hardly_any_room(self):
        """A slot as wide as the sphere, and hardly wider: nothing is passed, and it moves all the same."""
        level = box(4, 4, 0.5)
        for radius in ['0.25', '0.2499999', '0.249999', '0.2499']:
            places = self.walk(level, '2,2,0.25', radius, 600)
            self.assert_sound(level, places, float(radius))
            for axis in range(2):
                reach = [p[axis] for p in places]
                self.assertGreater(max(reach) - min(reach), 3)
        places = self.walk(box(4, 4, 4), '2,2,2', '2', 20)                     # no room at all
        self.assertEqual(set(places), {(2.0, 2.0, 2.0)})

    def test_sharp_corners(self):
        wedge = obj([(0, 0, 0), (8, 0, 0), (8, .7, 0), (0, 0, 4), (8, 0, 4), (8, .7, 4)],
                    [(0, 1, 2), (3, 5, 4), (0, 3, 4, 1), (1, 4, 5, 2), (0, 2, 5, 3)])
        needle = obj([(0, 0, 0), (10, .3, 0), (10, -.3, .1), (10, 0, .5)], [(0, 1, 2), (0, 2, 3), (0, 3, 1), (1, 3, 2)])
        for level, start in [(wedge, '7.5,.3,2'), (needle, '9.5,0,.1')]:
            for radius in ['0', '1e-6', '0.001', '0.05']:
                places = self.walk(level, start, radius, 1500)
                self.assert_sound(level, places, float(radius))
                self.assertGreater(len(set(places)), 1400)
                if float(radius) < 0.01: self.assertLess(min(p[0] for p in places), 4)

    def test_wound_the_other_way(self):
        level = ''.join(line if line[0] == 'v' else 'f ' + ' '.join(line.split()[:0:-1]) + '\n'
                        for line in box(4, 4, 4).splitlines(True))
        self.assert_sound(level, self.walk(level, '1,1,1', '0.5', 300), 0.5)

    def test_same_bytes(self):
        level = voxel_room(10, 5, 500)[1]
        for seed, name in [(7, 'a.csv'), (7, 'b.csv'), (8, 'c.csv')]:
            self.walk(level, '2,2,2', '0.3', 500, seed, name)
        self.assertEqual(self.read('a.csv'), self.read('b.csv'))
        self.assertNotEqual(self.read('a.csv'), self.read('c.csv'))

    def test_no_frames(self):
        self.assertEqual(len(self.walk(box(4, 4, 4), '1,2,3', '0.5', 0)), 1)

    def test_json(self):
        self.write('level.obj', box(4, 4, 4))
        report = self.firma_json('walk', 'level.obj', '--start', '1,1,1', '--radius', '0.5', '--frames', '100', '--seed', '3',
                                 '-o', 'w.csv')
        self.assertEqual((report['frames'], report['seed'], report['still'], report['start']), (100, 3, 0, [1, 1, 1]))

    def test_errors(self):
        self.write('box.obj', box(4, 4, 4))
        self.write('open.obj', ''.join(box(4, 4, 4).splitlines(True)[:-1]))
        good = {'--start': '1,1,1', '--radius': '0.5', '--frames': '100', '--seed': '1', '--out': 'x.csv'}
        def refuse(level, says, **changes):
            arguments = dict(good, **{'--' + key: value for key, value in changes.items()})
            self.refuse('walk', level, *(word for pair in arguments.items() for word in pair), says=says)
        refuse('open.obj', 'not closed')
        for start in ['0.4,1,1', '0.49999,1,1', '3.9,1,1', '-5,1,1', '4.4,1,1', '9,9,9', '1e300,1,1']:
            refuse('box.obj', '--start', start=start)
        for start in ['', '1', '1,1', '1,1,1,1', '1,1,', '1,1,nan', '1,1,inf', '1,1,0x1', 'a,b,c', '1;1;1', '1,1,1e999']:
            refuse('box.obj', '--start', start=start)
        refuse('box.obj', '--start', start='0,1,1', radius='0')
        for radius in ['-0.1', 'nan', 'inf', '', 'x', '1e999']:
            refuse('box.obj', '--radius', radius=radius)
        refuse('box.obj', '--start', radius='3')
        for frames in ['-1', '1.5', '', 'x', '1000000001', '99999999999999999999', '0x10']:
            refuse('box.obj', '--frames', frames=frames)
        for seed in ['-1', '1.5', '', 'x', '18446744073709551616']:
            refuse('box.obj', '--seed', seed=seed)

    def test_our_level(self):
        """All of it, through doors and down the tunnel."""
        with open(FIRST) as file: level = file.read()
        places = self.walk(level, '40,25,2', '0.3', 20000)
        for place, radius in [((5, 37, 5), 5), ((26, 42, 2), 5), ((37, 44, 2), 5), ((76, 30, 2), 5), ((60, 3, 3), 5), ((5, 25, 2), 5)]:
            self.assertTrue(any(length(sub(p, place)) < radius for p in places), place)


if __name__ == '__main__':
    unittest.main()
