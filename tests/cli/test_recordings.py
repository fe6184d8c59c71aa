# SPDX-License-Identifier: MIT
"""firma simulate and firma replay."""
import json
import os
import struct
import unittest

from harness import ROOT, CliTest, box
from test_gltf import TRIANGLES, room

DEPOT = os.path.join(ROOT, 'levels', 'depot.map')

CRC = [0] * 256
for byte in range(256):
    value = byte
    for _ in range(8):
        value = value >> 1 ^ (0x82F63B78 if value & 1 else 0)
    CRC[byte] = value


def crc32c(data, before=0):
    value = before ^ 0xFFFFFFFF
    for byte in data:
        value = CRC[(value ^ byte) & 255] ^ value >> 8
    return value ^ 0xFFFFFFFF


def sections(data):
    """{type: (place in the table, first byte, length)}"""
    found = {}
    for k in range(struct.unpack_from('<I', data, 12)[0]):
        entry = 32 + 32 * k
        letters, _, first, length = struct.unpack_from('<4sIQQ', data, entry)
        found[letters.decode()] = (entry, first, length)
    return found


def with_right_checksums(data):
    data = bytearray(data)
    for entry, first, length in sections(data).values():
        struct.pack_into('<I', data, entry + 24, crc32c(data[first:first + length]))
    count = struct.unpack_from('<I', data, 12)[0]
    struct.pack_into('<I', data, 28, crc32c(data[:28] + data[32:32 + 32 * count]))
    return bytes(data)


FIGHT = {
    'seed': 3,
    'parts': [{'name': 'gate', 'box': [[-1, -0.125, 0], [1, 0.125, 2.25]],
               'stops': [{'position': [8, 4, 0], 'seconds': 1}, {'position': [8, 4, 2], 'wait': 1, 'seconds': 1}]}],
    'events': [
        {'time': 0, 'player': {'position': [8, 7, 0.01]}},
        {'time': 0.1, 'wish': {'velocity': [0, -4, 0]}},
        {'time': 0.2, 'part': 'gate'},
        {'time': 0.3, 'body': {'box': [0.3, 0.2, 0.2], 'position': [10, 6, 1.5], 'spin': [1, 2, 3]}},
        {'time': 0.4, 'body': {'ball': 0.2, 'position': [11, 6, 1.5], 'velocity': [0, 2, 0]}},
        {'time': 0.5, 'fire': {'weapon': 'rocket', 'from': [14, 7, 1], 'to': [14, 2, 3.75], 'speed': 30}},
        {'time': 1, 'blast': {'position': [14, 2, 3.75], 'crater': 2.2}},
        {'time': 1.5, 'blast': {'position': [14, 12, 3.75], 'crater': 2.2}},
        {'time': 2, 'fire': {'weapon': 'grenade', 'from': [12, 7, 2], 'velocity': [3, 1, 2]}},
        {'time': 2.5, 'wish': {'player': 0, 'velocity': [3, 3, 0], 'jump': True}},
        {'time': 3, 'carve': {'position': [20, 0, 1], 'scale': 1.2}},
        {'time': 3, 'fill': {'position': [16, 7, 0], 'scale': 0.5, 'shape': 'box', 'material': 'concrete'}},
        {'time': 99, 'part': 'gate'},
    ],
}


class Recordings(CliTest):
    def setUp(self):
        super().setUp()
        self.write('box.obj', box(8, 8, 8))
        self.write('s.json', json.dumps({'events': [
            {'time': 0, 'player': {'position': [2, 2, 0.01]}},
            {'time': 0.25, 'wish': {'velocity': [2, 0, 0]}},
            {'time': 0.5, 'fire': {'weapon': 'rocket', 'from': [4, 4, 4], 'to': [4, 4, 0], 'speed': 20}}]}))

    def simulate(self, *more, level='box.obj', script='s.json', seconds=2, out='r.firmarec'):
        return self.firma_json('simulate', level, '--script', script, '--seconds', seconds, '--out', out, *more)

    def test_a_recording_replays_the_same_twice(self):
        told = self.simulate()
        self.assertEqual((told['ticks'], told['rate'], told['events'], told['explosions']), (120, 60, 3, 1))
        self.assertEqual(told['edits']['done'], 1)
        first = self.read('r.firmarec')
        self.assertEqual(len(first), told['bytes'])
        self.assertEqual(self.simulate()['hash'], told['hash'])
        self.assertEqual(self.read('r.firmarec'), first)
        replayed = self.firma_json('replay', 'r.firmarec')
        self.assertTrue(replayed['holds'])
        self.assertEqual((replayed['same'], replayed['hash'], replayed['level']), (120, told['hash'], 'box.obj'))
        self.assertEqual(replayed['game'], told['game'])
        self.assertIn('120 ticks', self.firma('simulate', 'box.obj', '--script', 's.json', '--seconds', '2', '-o', 'r.firmarec'))
        self.assertIn('all as recorded', self.firma('replay', 'r.firmarec'))

    def test_a_saved_game_goes_on_as_never_saved(self):
        whole = self.simulate(seconds=2)
        self.simulate('--save', 'half.firma', seconds=1)
        self.write('later.json', json.dumps({'events': []}))
        half = self.simulate(level='half.firma', script='later.json', seconds=1, out='l.firmarec')
        self.assertEqual(half['first_tick'], 60)
        self.assertEqual(half['hash'], whole['hash'])
        self.assertTrue(self.firma_json('replay', 'l.firmarec')['holds'])
        # Other verbs read its world.
        self.assertEqual(self.firma_json('info', 'half.firma')['edits'], 1)
        self.firma('check', 'half.firma')
        self.refuse('simulate', 'half.firma', '--script', 's.json', '--seconds', '1', '-o', 'x.firmarec', '--hz', '30',
                    says='--hz: the game was saved at 60 ticks a second')
        # The end of a replay is a saved game, too.
        self.firma('replay', 'r.firmarec', '--save', 'end.firma')
        self.assertEqual(self.read('end.firma'), self.read('half.firma'))

    def test_a_changed_hash_is_told_at_its_tick(self):
        self.simulate()
        data = bytearray(self.read('r.firmarec'))
        _, first, length = sections(data)['TICK']
        data[first + 2] ^= 1
        self.write('d.firmarec', bytes(data))
        self.refuse('replay', 'd.firmarec', says='section TICK: is damaged: wrong checksum')
        self.write('d.firmarec', with_right_checksums(data))
        told = self.firma_json('replay', 'd.firmarec', code=1)
        self.assertEqual((told['holds'], told['tick'], told['same']), (False, 1, 0))
        done = self.run_firma('replay', 'd.firmarec')
        self.assertEqual(done.returncode, 1)
        self.assertIn(b'tick 1: the hash is ', done.stdout)

    def test_a_changed_event_is_told_with_what_differs(self):
        self.simulate()
        data = bytearray(self.read('r.firmarec'))
        _, first, length = sections(data)['EVNT']
        at = data.index(struct.pack('<d', 2.0), first + length - 120)  # the wish's velocity
        struct.pack_into('<d', data, at, 2.5)
        self.write('d.firmarec', with_right_checksums(data))
        told = self.firma_json('replay', 'd.firmarec', code=1)
        self.assertEqual((told['tick'], told['items']), (16, ['player 0']))

    def test_damage_is_refused(self):
        self.simulate()
        data = self.read('r.firmarec')
        for k in range(0, len(data), len(data) // 150):
            self.write('d.firmarec', data[:k] + bytes([data[k] ^ 32]) + data[k + 1:])
            self.refuse('replay', 'd.firmarec', says='d.firmarec')
            if k % 3 == 0:
                self.write('d.firmarec', data[:k])
                self.refuse('replay', 'd.firmarec', says='d.firmarec')
        self.refuse('replay', 'box.obj', says='box.obj: it does not begin as a .firma file does')
        self.write('w.csv', 'x,y,z,radius,shape,seed\n')
        self.firma('carve', 'box.obj', '--blasts', 'w.csv', '-o', 'w.firma')
        self.refuse('replay', 'w.firma', says='w.firma: it is no recording')

    def write_lift(self, name, extras, more=()):
        """A room of 8 m and in it slabs of 2 x 2 x 0.25 m, nodes that are parts; fronts outside. y is up."""
        nodes = [{'mesh': 0, 'name': 'room'}]
        for part, place, its in [('lift', [3, 0.5, 3], extras), *more]:
            nodes.append({'mesh': 1, 'name': part, 'translation': place, 'scale': [0.25, 0.03125, 0.25],
                          'extras': {'part': True, **its}})
        document, data = room((8, 8, 8), nodes, TRIANGLES + TRIANGLES[::-1], uri=False)
        count = len(TRIANGLES)
        document['accessors'][1]['count'] = count
        document['accessors'].append({'bufferView': 1, 'byteOffset': 2 * count, 'componentType': 5123, 'count': count,
                                      'type': 'SCALAR'})
        document['meshes'].append({'primitives': [{'attributes': {'POSITION': 0}, 'indices': 2}]})
        text = json.dumps(document).encode()
        text += b' ' * (-len(text) % 4)
        data += bytes(-len(data) % 4)
        self.write(name, struct.pack('<4sIIII', b'glTF', 2, 28 + len(text) + len(data), len(text), 0x4e4f534a) + text +
                   struct.pack('<II', len(data), 0x004e4942) + data)

    LIFT = {'stops': [{'seconds': 1}, {'position': [0, 0, 3], 'wait': 'forever'}]}
    RIDE = [{'time': 0, 'player': {'position': [4, -4, 0.76]}}, {'time': 0.5, 'part': 'lift'}]

    def ride(self, *more, script, level='lift.glb'):
        self.write('ride.json', json.dumps(script))
        return self.simulate(*more, level=level, script='ride.json', seconds=2)

    def test_parts_of_glb_carry_who_stands_on_them(self):
        self.write_lift('lift.glb', {'motion': self.LIFT})
        info = self.firma_json('info', 'lift.glb')
        self.assertEqual(info['gltf']['parts'], [{'name': 'lift', 'node': 1, 'faces': 12}])
        self.assertEqual(info['faces']['total'], 12)
        self.assertRegex(self.firma('info', 'lift.glb'), 'parts that move +1, whose faces are not counted')
        told = self.ride(script={'events': self.RIDE})
        self.assertEqual(told['game']['parts'], 1)
        player = told['game']['players'][0]
        # Up with it, by 3 m.
        self.assertTrue(player['on_ground'])
        self.assertAlmostEqual(player['position'][2], 3.75, delta=0.01)
        replayed = self.firma_json('replay', 'r.firmarec')
        self.assertTrue(replayed['holds'])
        self.assertEqual((replayed['same'], replayed['hash']), (120, told['hash']))
        # Nobody sets it off: it stands where it was drawn, with who stands on it.
        told = self.ride(script={'events': self.RIDE[:1]})
        self.assertAlmostEqual(told['game']['players'][0]['position'][2], 0.75, delta=0.01)

    def test_a_script_says_how_parts_of_glb_go(self):
        # Without a motion a part stands; the script has one for it, the same as the level had.
        self.write_lift('lift.glb', {'motion': json.dumps(self.LIFT)})
        by_level = self.ride(script={'events': self.RIDE})
        self.write_lift('lift.glb', {})
        by_script = self.ride(script={'parts': [{'name': 'lift', **self.LIFT}], 'events': self.RIDE})
        self.assertEqual(by_script['hash'], by_level['hash'])
        stands = self.ride(script={'events': self.RIDE})
        self.assertAlmostEqual(stands['game']['players'][0]['position'][2], 0.75, delta=0.01)
        # A saved game has it, and others can load it.
        self.ride('--save', 'lift.firma', script={'parts': [{'name': 'lift', **self.LIFT}], 'events': self.RIDE})
        self.write('later.json', json.dumps({'events': []}))
        later = self.simulate(level='lift.firma', script='later.json', seconds=1, out='l.firmarec')
        self.assertAlmostEqual(later['game']['players'][0]['position'][2], 3.75, delta=0.01)

    def test_parts_of_glb_have_names_of_their_own(self):
        self.write_lift('lift.glb', {}, [('lift', [0, 0.5, 0], {}), ('', [6, 0.5, 6], {})])
        told = self.ride(script={'events': self.RIDE + [{'time': 0, 'part': name} for name in ('part_1', 'part_2')]})
        self.assertEqual(told['game']['parts'], 3)
        self.write('none.json', json.dumps({'events': [{'time': 0, 'part': 'part_3'}]}))
        self.refuse('simulate', 'lift.glb', '--script', 'none.json', '--seconds', '1', '-o', 'x.firmarec',
                    says="there is no part 'part_3'")

    def test_faults_of_motions_in_glb_are_refused_with_their_node(self):
        call = ['simulate', 'lift.glb', '--script', 's.json', '--seconds', '1', '-o', 'x.firmarec']
        for motion, says in [({'stop': []}, "node 1: motion: there is no key 'stop' here"),
                             ('{"stops": ', 'node 1: motion: at line 1'), (3, 'node 1: motion: is not an object'),
                             ({'stops': [{'wait': 'x'}]}, 'node 1: motion: stop 0: wait: is not a number')]:
            self.write_lift('lift.glb', {'motion': motion})
            self.refuse(*call, says=says)
        self.write_lift('lift.glb', {'firma_motion': {'axis': [0, 0, 0]}})
        self.refuse(*call, says='node 1: firma_motion: axis: is no direction')

    def refuse_script(self, script, says):
        self.write('f.json', script if isinstance(script, str) else json.dumps(script))
        return self.refuse('simulate', 'box.obj', '--script', 'f.json', '--seconds', '1', '-o', 'x.firmarec', says=says)

    def refuse_event(self, event, says):
        self.refuse_script({'events': [{'time': 0, 'player': {'position': [2, 2, 0]}}, event]}, 'f.json: event 1' + says)

    def test_faults_of_scripts_are_refused_with_their_place(self):
        self.refuse_script('{"events": [\n  {"time": 1,, }]}', 'f.json: at line 2, column 14')
        self.refuse_script('{"events": [], "events": []}', "f.json: an object has the key 'events' twice")
        self.refuse_script('[]', 'f.json: is not an object')
        self.refuse_script({'event': []}, "f.json: there is no key 'event' here; there are seed, rules, weapons, parts, events")
        self.refuse_script({'events': {}}, 'f.json: events: is not a list')
        self.refuse_script({'events': [3]}, 'f.json: event 0: is not an object')
        self.refuse_event({'wish': {}}, ": 'time' is missing")
        self.refuse_event({'time': -1, 'wish': {}}, ': time: is -1')
        self.refuse_event({'time': 'x', 'wish': {}}, ': time: is not a number')
        self.refuse_event({'time': 0}, ': has none of player, wish, fire')
        self.refuse_event({'time': 0, 'wish': {}, 'blast': {}}, ": has both 'wish' and 'blast'")
        self.refuse_event({'time': 0, 'wish': {'player': 1}}, ': wish: player: there is no player 1')
        self.refuse_event({'time': 0, 'wish': {'velocity': [1, 2]}}, ': wish: velocity: is not three numbers')
        self.refuse_event({'time': 0, 'wish': {'jumps': True}}, ": wish: there is no key 'jumps' here; there are player, velocity")
        self.refuse_event({'time': 0, 'fire': {'weapon': 'laser', 'from': [1, 1, 1], 'to': [2, 2, 2], 'speed': 3}},
                          ": fire: weapon: 'laser' is no weapon; there are bullet, rocket, grenade")
        self.refuse_event({'time': 0, 'fire': {'weapon': 'rocket', 'from': [1, 1, 1], 'to': [1, 1, 1], 'speed': 3}},
                          ": fire: to: is where 'from' is")
        self.refuse_event({'time': 0, 'blast': {'position': [1, 1, 1], 'crater': -1}}, ': blast: crater: is -1')
        self.refuse_event({'time': 0, 'carve': {'position': [1, 1, 1], 'shape': 'round'}}, ": carve: shape: 'round' is none of")
        self.refuse_event({'time': 0, 'body': {'position': [1, 1, 1]}}, ": body: has either 'ball' or 'box'")
        self.refuse_event({'time': 0, 'body': {'box': [9, 9, 0.01], 'position': [1, 1, 1]}}, ': body: box: is more than 64 times')
        self.refuse_event({'time': 0, 'part': 'gate'}, ": part: there is no part 'gate'")
        self.refuse_event({'time': 0, 'door': {'portal': 0, 'open': True}}, ': door: portal: there is no portal 0')
        self.refuse_event({'time': 0, 'player': {'position': [1, 1, 1], 'radius': 2, 'height': 1}}, ': player: ')
        self.refuse_script({'parts': [{'name': 'a', 'box': [[0, 0, 0], [1, 1, 0]]}]}, 'f.json: part 0: box: the second corner')
        self.refuse_script({'parts': [{'name': 'a', 'box': [[0, 0, 0], [1, 1, 1]], 'stops': [{'wait': 'x'}]}]},
                           'f.json: part 0: stop 0: wait: is not a number')
        self.refuse_script({'weapons': [{'name': 'x', 'mass': 0}]}, 'f.json: weapon 0: mass: is 0')
        self.refuse_script({'rules': {'max_age': -1}}, 'f.json: rules: max_age: is -1')

    def test_bad_calls(self):
        call = ['simulate', 'box.obj', '--script', 's.json', '--seconds', '1', '-o']
        self.refuse(*call, 'r.bin', says='--out: the name of a recording ends in .firmarec')
        self.refuse(*call, '-', says='--out: it is bytes; name a file')
        self.refuse(*call, 'r.firmarec', '--save', 'x.obj', says='--save: the name of a saved game ends in .firma')
        self.refuse(*call, 'r.firmarec', '--hz', '3', says='--hz: ')
        self.refuse('simulate', 'box.obj', '--script', 's.json', '--seconds', '-1', '-o', 'r.firmarec', says='--seconds: ')
        self.refuse('simulate', 'box.obj', '--script', 'none.json', '--seconds', '1', '-o', 'r.firmarec', says='none.json')

    def test_a_fight_in_the_depot(self):
        self.write('fight.json', json.dumps(FIGHT))
        told = self.simulate(level=DEPOT, script='fight.json', seconds=10)
        self.assertEqual((told['ticks'], told['events'], told['events_after_end']), (600, 12, 1))
        self.assertEqual(told['explosions'], 4)
        self.assertGreaterEqual(told['loose'] + told['broken'], 10)
        self.assertEqual(told['edits']['refused'], 0)
        game = told['game']
        self.assertEqual((len(game['players']), game['parts'], game['tick']), (1, 1, 600))
        replayed = self.firma_json('replay', 'r.firmarec')
        self.assertTrue(replayed['holds'])
        self.assertEqual((replayed['same'], replayed['hash']), (600, told['hash']))


if __name__ == '__main__':
    unittest.main()
