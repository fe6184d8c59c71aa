# SPDX-License-Identifier: MIT
"""firma demo of the depot: its bridge comes loose, and a hole in a wall is a portal."""
import os
import struct
import unittest
import zlib

from harness import FIRST, ROOT, SANITIZED, CliTest

DEPOT = os.path.join(ROOT, 'levels', 'depot.map')
FEW = ['--casts', '500', '--craters', '3', '-o', 'x.svg']


class DemoOfTheDepot(CliTest):
    def test_what_is_told(self):
        report = self.firma_json('demo', DEPOT, *FEW)
        self.assertEqual((report['disagreements'], report['craters']['disagreements'], report['craters']['escaped']), (0, 0, 0))
        bridge, hole = report['depot']['bridge'], report['depot']['hole']
        largest = bridge['largest']
        self.assertEqual(bridge['shots'], 2)
        # The deck is 2 m wide and half a metre thick, with beams and rails; some 8 m are left between the craters.
        self.assertTrue(7 < largest['volume'] < 11, bridge)
        self.assertTrue(largest['volume'] < bridge['volume'] < 1.05 * largest['volume'], bridge)
        for piece in largest, bridge:
            self.assertAlmostEqual(piece['mass'], 2400 * piece['volume'], 6)
        self.assertTrue(all(abs(a - b) < 0.5 for a, b in zip(largest['centre'], [14, 7, 3.75])), bridge)
        self.assertEqual((hole['portals'], sorted(hole['rooms'])), (1, ['office_middle', 'office_west']))
        self.assertTrue(0.3 < hole['area'] < 1.2, hole)
        self.assertEqual(hole['before']['room'], 'office_west')
        self.assertAlmostEqual(hole['before']['distance'], 3.25, 9)
        self.assertEqual(hole['after']['room'], 'office_middle')
        self.assertAlmostEqual(hole['after']['distance'], 9.5, 1)
        self.assertEqual(report['view'], 'x_view.png')
        picture = self.read('x_view.png')

        text = self.firma('demo', DEPOT, *FEW)
        self.assertEqual(self.read('x_view.png'), picture)
        self.assertIn('a chunk of %.2f cubic metres, ' % largest['volume'], text)
        self.assertIn(' leaves, and %d of the rails; ' % (bridge['chunks'] - 1), text)
        self.assertIn('portal %d between ' % hole['portal'], text)
        self.assertRegex(text, r'met \S+ in office_west after 3\.25 m before, meets \S+ in office_middle after 9\.\d+ m now\n')

        # firma carve finds it, too: its craters are turned, so what is left is about as large.
        self.write('b.csv', 'x,y,z,radius,shape,seed\n14,2,3.75,2.2,rocky,3\n14,12,3.75,2.2,rocky,3\n')
        carved = self.firma_json('carve', DEPOT, '--blasts', 'b.csv', '-o', 'a.firma', '--chunks', '--density', '2400')
        self.assertLess(abs(carved['chunk_volume'] / bridge['volume'] - 1), 0.3)

        # Left and right half of the picture: a file that firma draw gives of the level before, and another.
        if not SANITIZED:
            self.firma('draw', DEPOT, '--view', '--eye', '10.5,13.2,5.9', '--look', '17,2,2', '-o', 'before.png')
            self.assertEqual(halves(picture)[0], halves(self.read('before.png'))[0])
            self.assertNotEqual(halves(picture)[1], halves(picture)[0])

    def test_other_levels(self):
        self.assertIsNone(self.firma_json('demo', FIRST, '--casts', '100', '--craters', '1', '-o', 'x.svg')['depot'])
        none = ['--casts', '100', '--craters', '0', '-o', 'x.svg']
        self.assertIsNone(self.firma_json('demo', DEPOT, *none)['depot'])
        self.assertNotIn('bridge', self.firma('demo', DEPOT, *none))


def halves(data):
    """The pixels of the first and the last 640 columns of a PNG of 8 bits a channel, row by row."""
    width, height, at, packed = *struct.unpack('>II', data[16:24]), 8, b''
    while at < len(data):
        length, = struct.unpack('>I', data[at:at + 4])
        if data[at + 4:at + 8] == b'IDAT': packed += data[at + 8:at + 8 + length]
        at += 12 + length
    raw, step = zlib.decompress(packed), 1 + 3 * width
    rows, last = [], bytes(step - 1)
    for y in range(height):
        how, row = raw[y * step], bytearray(raw[y * step + 1:(y + 1) * step])
        for x in range(step - 1):
            left = row[x - 3] if x >= 3 else 0
            above, corner = last[x], last[x - 3] if x >= 3 else 0
            if how == 1: row[x] = row[x] + left & 255
            if how == 2: row[x] = row[x] + above & 255
            if how == 3: row[x] = row[x] + (left + above) // 2 & 255
            if how == 4:
                guess = left + above - corner
                nearest = min((abs(guess - left), 0, left), (abs(guess - above), 1, above), (abs(guess - corner), 2, corner))
                row[x] = row[x] + nearest[2] & 255
        rows.append(bytes(row))
        last = row
    return [row[:1920] for row in rows], [row[-1920:] for row in rows]


if __name__ == '__main__':
    unittest.main()
