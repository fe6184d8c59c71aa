# SPDX-License-Identifier: MIT
"""firma carve --log, firma log and firma check of logs."""
import os
import random
import unittest

from harness import FIRST, ROOT, CliTest, box

DEPOT = os.path.join(ROOT, 'levels', 'depot.map')
HEADER = 'x,y,z,radius,shape,seed\n'


def blasts(count, seed, size):
    """Rows on the walls of a box."""
    rng = random.Random(seed)
    rows = ''
    for k in range(count):
        at = [rng.uniform(0, size) for _ in range(3)]
        at[rng.randrange(3)] = rng.choice([0, size])
        shape = ['rocky', 'spiky', 'drill', 'wedge', 'box'][k % 5]
        rows += '%r,%r,%r,%r,%s,%d\n' % (*at, rng.uniform(0.2, 0.6), shape, rng.getrandbits(64))
    return HEADER + rows


class Log(CliTest):
    def setUp(self):
        super().setUp()
        self.write('box.obj', box(8, 8, 8))
        self.write('b.csv', blasts(230, 1, 8))

    def carve(self, *more):
        return self.firma_json('carve', 'box.obj', '--blasts', 'b.csv', '-o', 'a.firma', '--log', 'a.firmalog', *more)

    def test_replay_gives_the_level_that_carve_wrote(self):
        carved = self.carve('--material', 'crater')
        self.assertEqual(carved['log'], 'a.firmalog')
        self.assertGreater(carved['done'], 220)
        replayed = self.firma_json('log', 'replay', 'a.firmalog', 'box.obj', '-o', 'r.firma')
        self.assertEqual(self.read('a.firma'), self.read('r.firma'))
        self.assertEqual(replayed['hash'], carved['hash'])
        self.assertEqual(replayed['commands'], carved['done'])
        self.assertEqual(replayed['done'], carved['done'])
        self.assertEqual(replayed['checkpoints'], 3)                           # after 100, 200, and at the end
        self.assertEqual(replayed['edits'], carved['done'])
        self.assertIsNone(replayed['fault'])
        # In slices as in one go, and the level as a .firma file.
        self.assertEqual(self.carve('--material', 'crater', '--slices', '30')['hash'], carved['hash'])
        self.write('none.csv', HEADER)
        self.firma('carve', 'box.obj', '--blasts', 'none.csv', '-o', 'box.firma')
        self.assertEqual(self.firma_json('log', 'verify', 'a.firmalog', 'box.firma')['hash'], carved['hash'])
        # A rocky crater and its material, with all else that a log has.
        self.assertLess(len(self.read('a.firmalog')), 48 * carved['done'])

    def test_log_of_the_depot_that_other_languages_replay(self):
        """tests/data/depot_bridge.firmalog is what is written; the tests of C and JavaScript compare this hash."""
        data = os.path.join(ROOT, 'tests', 'data', 'depot_bridge')
        carved = self.firma_json('carve', DEPOT, '--blasts', data + '.csv', '-o', 'd.firma', '--log', 'd.firmalog', '--chunks')
        self.assertEqual((carved['done'], carved['chunks'], carved['anchors']['volumes']), (3, 3, 4))
        self.assertEqual(carved['hash'], 'e1f4b967d5727f35')
        with open(data + '.firmalog', 'rb') as file:
            self.assertEqual(self.read('d.firmalog'), file.read())

    def test_rooms_become_one_by_a_share(self):
        """A crater through the thin wall between two offices of the depot; the share is a rule that a log is made under."""
        self.write('b.csv', HEADER + '6.25,18,1.5,1.4,rocky,2\n')

        def carve(level, *more):
            return self.firma_json('carve', level, '--blasts', 'b.csv', '-o', 'a.firma', '--log', 'a.firmalog', *more)

        def empty_rooms():
            rooms = self.firma_json('info', 'a.firma')['rooms']
            self.assertEqual(len(rooms), 23)
            return [room['name'] for room in rooms if room['faces'] == 0]
        apart = carve(DEPOT)
        self.assertEqual((apart['merge_share'], empty_rooms()), (0, []))
        for share, same in [('0', True), ('0.5', True), ('0.01', False)]:
            carved = carve(DEPOT, '--merge-share', share)
            self.assertEqual((carved['merge_share'], carved['hash'] == apart['hash']), (float(share), same))
            self.assertEqual(empty_rooms(), [] if same else ['office_middle'])
            call = ['log', 'verify', 'a.firmalog', DEPOT]
            self.assertEqual(self.firma_json(*call, '--merge-share', share)['hash'], carved['hash'])
        self.refuse(*call, says='other rules')
        self.refuse(*call, '--merge-share', '0.02', says='other rules')
        self.firma('log', 'replay', *call[2:], '-o', 'r.firma', '--merge-share', '0.01')
        self.assertEqual(self.read('r.firma'), self.read('a.firma'))
        self.firma('log', 'compact', *call[2:], '-o', 'c.firmalog', '--merge-share', '0.01')
        self.assertEqual(self.firma_json('log', 'verify', 'c.firmalog', DEPOT, '--merge-share', '0.01')['hash'], carved['hash'])
        # The file has it, until it is said anew.
        self.assertEqual(carve('r.firma')['merge_share'], 0.01)
        self.assertEqual(carve('r.firma', '--merge-share', '0')['merge_share'], 0)
        for bad in ['-1', 'x', 'nan', 'inf']:
            self.refuse('carve', DEPOT, '--blasts', 'b.csv', '-o', 'x.firma', '--merge-share', bad, says='--merge-share: ')
            self.refuse(*call, '--merge-share', bad, says='--merge-share: ')
        self.refuse('log', 'show', 'a.firmalog', '--merge-share', '1', says='--merge-share: is for verify')

    def test_show(self):
        self.write('b.csv', HEADER + '4,4,0,0.7,rocky,12345678901234567890\n4,4,4,0.1,box,1\n0,4,4.1,0.5,drill,3\n')
        self.carve('--material', 'crater')
        told = self.firma_json('log', 'show', 'a.firmalog')
        self.assertEqual(told['bytes'], len(self.read('a.firmalog')))
        self.assertEqual(told['version'], 1)
        self.assertEqual((told['command_count'], told['checkpoint_count']), (2, 1))  # the second met only air
        first, second = told['commands']
        self.assertEqual(first['seed'], 12345678901234567890)
        self.assertEqual((first['number'], second['number']), (1, 2))
        self.assertEqual((first['kind'], first['cutter'], first['material']), ('carve', 'rocky', 'crater'))
        self.assertEqual(second['position'], [0, 4, round(4.1 * 4096) / 4096])
        self.assertEqual(told['checkpoints'][0]['commands'], 2)
        text = self.firma('log', 'show', 'a.firmalog')
        self.assertIn('1 carve rocky of seed 12345678901234567890 at (4, 4, 0)', text)
        self.assertIn('hash ' + told['checkpoints'][0]['hash'], text)
        checked = self.firma_json('check', 'a.firmalog')
        self.assertTrue(checked['sound'])
        self.assertEqual(checked['level_hash'], told['level_hash'])
        self.assertIn('2 commands and 1 checkpoint', self.firma('check', 'a.firmalog'))

    def test_until(self):
        self.carve()
        half = self.firma_json('log', 'replay', 'a.firmalog', 'box.obj', '-o', 'half.firma', '--until', '120')
        self.assertEqual((half['commands'], half['edits'], half['checkpoints']), (120, 120, 1))
        self.assertEqual(self.firma_json('log', 'verify', 'a.firmalog', 'box.obj', '--until', '0')['commands'], 0)

    def test_compact(self):
        carved = self.carve()
        for until in [[], ['--until', '150'], ['--until', '0']]:
            told = self.firma_json('log', 'compact', 'a.firmalog', 'box.obj', '-o', 'c.firmalog', *until)
            self.assertEqual(told['bytes'], len(self.read('c.firmalog')))
            self.assertGreater(told['patch_bytes'], 0)
            self.assertEqual(told['patched_number'], int(until[1]) if until else carved['done'])
            self.assertEqual(told['command_count'], carved['done'] - told['patched_number'])
            replayed = self.firma_json('log', 'verify', 'c.firmalog', 'box.obj')
            self.assertEqual(replayed['hash'], carved['hash'])
            self.assertEqual(replayed['commands'], told['command_count'])
            self.assertIn('a patch of ', self.firma('log', 'show', 'c.firmalog'))
        self.firma('log', 'compact', 'a.firmalog', 'box.obj', '-o', 'c.firmalog', '--until', '100')
        self.refuse('log', 'verify', 'c.firmalog', 'box.obj', '--until', '99', says='was compacted up to edit 100')

    def test_logs_go_on_from_saved_worlds(self):
        carved = self.carve()
        self.write('c.csv', blasts(20, 2, 8))
        on = self.firma_json('carve', 'a.firma', '--blasts', 'c.csv', '-o', 'b.firma', '--log', 'b.firmalog')
        told = self.firma_json('log', 'show', 'b.firmalog')
        self.assertEqual(told['level_edits'], carved['done'])
        self.assertEqual(told['commands'][0]['number'], carved['done'] + 1)
        self.assertEqual(self.firma_json('log', 'verify', 'b.firmalog', 'a.firma')['hash'], on['hash'])
        self.refuse('log', 'verify', 'b.firmalog', 'box.obj', says='begins from another world')

    def test_rooms(self):
        self.write('b.csv', HEADER + '0,0,0.5,1,rocky,1\n12,3,0.2,1.2,spiky,2\n20,8,1,1,rocky,3\n')
        call = ['carve', DEPOT, '--blasts', 'b.csv', '-o', 'a.firma', '--log', 'a.firmalog']
        hash_after = self.firma_json(*call)['hash']
        self.assertEqual(self.firma_json('log', 'verify', 'a.firmalog', DEPOT)['hash'], hash_after)

    def test_chunks(self):
        self.write('b.csv', HEADER + '14,2,3.75,2.2,rocky,3\n14,12,3.75,2.2,rocky,3\n3,18,9,0.3,rocky,1\n')
        call = ['carve', DEPOT, '--blasts', 'b.csv', '-o', 'a.firma', '--log', 'a.firmalog', '--chunks', '--min-volume', '0.25']
        carved = self.firma_json(*call)
        self.assertEqual(carved['chunks'], 1)
        # Nothing is to be said again: what holds pieces is what the first blast found.
        replayed = self.firma_json('log', 'replay', 'a.firmalog', DEPOT, '-o', 'r.firma')
        self.assertEqual(replayed['hash'], carved['hash'])
        self.assertEqual(self.read('r.firma'), self.read('a.firma'))
        self.firma('log', 'compact', 'a.firmalog', DEPOT, '-o', 'c.firmalog', '--until', '1')
        self.assertEqual(self.firma_json('log', 'verify', 'c.firmalog', DEPOT)['hash'], carved['hash'])
        command = self.firma_json('log', 'show', 'a.firmalog')['commands'][0]
        self.assertEqual(command['chunks'], {'min_volume': 0.25, 'density': None})
        self.assertIn(', with chunks of 0.25 m3\n', self.firma('log', 'show', 'a.firmalog'))
        plain = self.firma_json(*call[:-3])
        self.assertNotEqual(plain['hash'], carved['hash'])                     # the bridge hangs there
        self.assertIsNone(self.firma_json('log', 'show', 'a.firmalog')['commands'][0]['chunks'])

    def test_chunks_with_anchors(self):
        """A box that stands in the open, held by a material."""
        self.write('solid.obj', standing_box())
        self.write('b.csv', HEADER + ''.join('%d,%d,4,1.6,rocky,%d\n' % (x, y, x + 9 * y + 10)
                                             for x in range(-1, 10) for y in range(-1, 10)))
        call = ['carve', 'solid.obj', '--blasts', 'b.csv', '-o', 'a.firma', '--log', 'a.firmalog', '--chunks']
        self.assertEqual(self.firma_json(*call)['chunks'], 0)                  # all of it hangs free
        options = ['--no-hanging', '--anchors', 'ground']
        carved = self.firma_json(*call, *options)
        self.assertGreaterEqual(carved['chunks'], 1)
        self.assertGreater(carved['chunk_volume'], 20)                         # the upper part
        verified = self.firma_json('log', 'verify', 'a.firmalog', 'solid.obj', *options)
        self.assertTrue(verified['holds'])
        self.assertEqual(verified['hash'], carved['hash'])
        self.firma('log', 'compact', 'a.firmalog', 'solid.obj', '-o', 'c.firmalog', '--until', '60', *options)
        self.assertEqual(self.firma_json('log', 'verify', 'c.firmalog', 'solid.obj', *options)['hash'], carved['hash'])
        for other in [[], ['--no-hanging'], ['--anchors', 'ground'], ['--no-hanging', '--anchors', 'rock,ground']]:
            self.refuse('log', 'verify', 'a.firmalog', 'solid.obj', *other, says='other anchors')
        checked = self.firma_json('check', 'a.firma')
        self.assertEqual((checked['sound'], checked['anchors']), (True, {'materials': 1, 'sources': 0, 'edits': 0, 'hanging': 0, 'volumes': 0}))
        self.assertIn('; 1 anchor and 0 faces that hung free\n', self.firma('check', 'a.firma'))
        self.assertIsNone(self.firma_json('check', self.plain())['anchors'])
        for bad in ['stone', 'ground,', ',', 'ground,ground ']:
            self.refuse(*call, '--anchors', bad, says="--anchors: the level has no material '")
        self.refuse('log', 'show', 'a.firmalog', '--anchors', 'ground', says='--anchors: is for verify, replay and compact')
        self.refuse('log', 'show', 'a.firmalog', '--no-hanging', says='--no-hanging: is for verify, replay and compact')

    def plain(self):
        self.write('none.csv', HEADER)
        self.firma('carve', 'box.obj', '--blasts', 'none.csv', '-o', 'plain.firma', '--chunks')
        return 'plain.firma'

    def test_a_log_that_does_not_hold(self):
        self.write('b.csv', HEADER + '4,4,0,0.7,rocky,1\n')
        self.carve()
        # The checkpoint is the last record: its hash, the end, the checksum.
        data = bytearray(self.read('a.firmalog'))
        for k in range(len(data)):
            damaged = bytearray(data)
            damaged[k] ^= 1
            self.write('d.firmalog', bytes(damaged))
            self.refuse('log', 'show', 'd.firmalog', says='d.firmalog')
        self.write('d.firmalog', bytes(data[:-1]))
        self.refuse('check', 'd.firmalog', says='byte')
        data[-6] ^= 1
        data[-4:] = crc32c(data[:-4]).to_bytes(4, 'little')
        self.write('d.firmalog', bytes(data))
        told = self.firma_json('log', 'verify', 'd.firmalog', 'box.obj', code=1)
        self.assertFalse(told['holds'])
        self.assertIn('command 0: the world\'s hash is', told['fault'])
        self.assertEqual(self.run_firma('log', 'verify', 'd.firmalog', 'box.obj').returncode, 1)
        self.refuse('log', 'replay', 'd.firmalog', 'box.obj', '-o', 'x.firma', says='checkpoint')

    def test_bad_calls(self):
        self.write('b.csv', HEADER + '4,4,0,0.7,rocky,1\n')
        self.carve()
        self.refuse('log', 'fly', 'a.firmalog', says="'fly' is none of show, verify, replay, compact")
        self.refuse('log', 'show', says='LOG is required')
        self.refuse('log', 'show', 'a.firmalog', 'box.obj', says='no level')
        self.refuse('log', 'verify', 'a.firmalog', says='LEVEL is required')
        self.refuse('log', 'replay', 'a.firmalog', 'box.obj', says='--out is required')
        self.refuse('log', 'verify', 'a.firmalog', 'box.obj', '-o', 'x.obj', says='--out: is for replay')
        self.refuse('log', 'compact', 'a.firmalog', 'box.obj', says='--out is required')
        self.refuse('log', 'compact', 'a.firmalog', 'box.obj', '-o', 'a.firmalog', says='a.firmalog')
        self.refuse('log', 'compact', 'a.firmalog', 'box.obj', '-o', 'x', '--castable', says='--castable')
        self.refuse('log', 'compact', 'a.firmalog', FIRST, '-o', 'x', says='begins from another world')
        self.refuse('log', 'show', 'a.firmalog', '--until', '3', says='--until')
        self.refuse('log', 'verify', 'a.firmalog', 'box.obj', '--until', '-3', says='--until')
        self.refuse('log', 'verify', 'a.firmalog', FIRST, says='begins from another world')
        self.refuse('log', 'show', 'box.obj', says='box.obj: byte 0: it does not begin as a log of edits does')
        self.refuse('log', 'show', 'missing.firmalog', says='missing.firmalog')
        self.refuse('log', 'replay', 'a.firmalog', 'box.obj', '-o', 'x.map', says='not as .map')
        self.refuse('log', 'replay', 'a.firmalog', 'box.obj', '-o', 'box.obj', says='box.obj')
        self.refuse('log', 'replay', 'a.firmalog', 'box.obj', '-o', './a.firmalog', says='a.firmalog')
        for bad in ['-', 'b.csv', 'box.obj', 'y.firma']:
            self.refuse('carve', 'box.obj', '--blasts', 'b.csv', '-o', 'y.firma', '--log', bad)


def standing_box():
    """8 m of rock with a lower side of ground."""
    lines = box(8, 8, 8).splitlines()
    faces = ['f ' + ' '.join(reversed(line.split()[1:])) for line in lines if line[0] == 'f']
    return '\n'.join([line for line in lines if line[0] == 'v'] + ['usemtl ground', faces[0], 'usemtl rock', *faces[1:]]) + '\n'


def crc32c(data):
    crc = 0xFFFFFFFF
    for byte in data:
        crc ^= byte
        for _ in range(8):
            crc = crc >> 1 ^ (0x82F63B78 if crc & 1 else 0)
    return crc ^ 0xFFFFFFFF


if __name__ == '__main__':
    unittest.main()
