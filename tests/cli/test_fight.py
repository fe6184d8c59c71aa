# SPDX-License-Identifier: MIT
"""firma demo's fire fight: the bridge falls, the player goes through a fresh hole, nothing gets into walls; its pictures."""
import os
import struct
import unittest

from harness import FIRST, ROOT, SANITIZED, CliTest, box

DEPOT = os.path.join(ROOT, 'levels', 'depot.map')


class FireFight(CliTest):
    def all_holds(self, report):
        """What the fight itself judges in each frame, as it is told."""
        self.assertIsNone(report['fault'])
        self.assertEqual((report['bodies']['lost'], report['rays']['escaped']), (0, 0))
        self.assertLessEqual(report['bodies']['deepest_mm'], 1.001)
        self.assertEqual(report['rays']['cast'], 256 * report['frames'])
        for phase in ['casts', 'cuts', 'bodies', 'debris', 'player']:
            self.assertLessEqual(report['ms'][phase]['mean'], report['ms'][phase]['worst'])

    def test_depot(self):
        seconds = 2.5 if SANITIZED else 12.0
        report = self.firma_json('demo', DEPOT, '--seconds', seconds)
        self.all_holds(report)
        self.assertEqual(report['frames'], 60 * seconds)
        self.assertGreaterEqual(report['craters']['done'], 2)
        # The bridge: one long piece, and some of its rails.
        self.assertGreaterEqual(report['bodies']['loose'], 2)
        if not SANITIZED:
            self.assertGreater(report['bodies']['broken'], 0)
            self.assertGreater(report['bodies']['max'], 60)
            self.assertGreaterEqual(report['player']['through_solid'], 1)
            self.assertEqual(report['player']['rooms'][:2], ['hall', 'lockers'])
            self.assertGreater(report['player']['way'], 8)
        self.assertEqual(self.firma_json('demo', DEPOT, '--seconds', seconds)['hash'], report['hash'])

    @unittest.skipIf(SANITIZED, 'takes minutes')
    def test_all_comes_to_rest(self):
        # The last blast is 14.4 s after the start.
        report = self.firma_json('demo', DEPOT, '--seconds', '20')
        self.all_holds(report)
        self.assertGreater(report['bodies']['end'], 200)
        self.assertEqual(report['bodies']['at_rest'], report['bodies']['end'])

    def test_text(self):
        report = self.firma_json('demo', FIRST, '--seconds', '2', '--seed', '5')
        self.all_holds(report)
        text = self.firma('demo', FIRST, '--seconds', '2', '--seed', '5')
        self.assertIn('hash                     %s\n' % report['hash'], text)
        self.assertIn('lost bodies              0\n', text)
        self.assertRegex(text, r'processor ms a frame +casts \d+\.\d\d \(worst \d+\.\d\d\), cuts .*, bodies .*, debris .*, player ')
        self.assertRegex(text, r'\nframes +120: 2\.0 s of a fire fight, in ')
        self.assertNotEqual(self.firma_json('demo', FIRST, '--seconds', '2', '--seed', '6')['hash'], report['hash'])
        self.assertEqual(self.files(), [])

    def test_another_level(self):
        # The last shot is 5 s before the end.
        report = self.firma_json('demo', FIRST, '--seconds', '7' if SANITIZED else '8')
        self.all_holds(report)
        self.assertGreater(report['craters']['done'], 0)
        self.assertGreater(report['player']['way'], 2)

    def test_the_default_level(self):
        os.mkdir(self.path('levels'))
        self.write('levels/depot.map', 'no level')
        self.refuse('demo', says='levels/depot.map:1')

    def test_frames(self):
        report = self.firma_json('demo', FIRST, '--seconds', '0.4', '--frames', 'new/folder')
        self.assertEqual(report['pictures'], [])  # no crater in it, so no place to look from
        self.assertTrue(os.path.isdir(self.path('new/folder')))
        if SANITIZED: return
        report = self.firma_json('demo', DEPOT, '--seconds', '1', '--frames', 'pictures')
        self.assertEqual(report['pictures'], ['pictures/bridge.png', 'pictures/fight.png'])
        self.assertEqual([size(self.read(name)) for name in report['pictures']], [(804, 300), (400, 300)])
        text = self.firma('demo', DEPOT, '--seconds', '1', '--frames', 'again')
        self.assertIn('picture                  again/fight.png\n', text)
        self.assertEqual(self.read('again/bridge.png'), self.read('pictures/bridge.png'))

    def test_bad_calls(self):
        for bad in ['0', '-1', 'nan', '601', 'ten']:
            self.refuse('demo', FIRST, '--seconds=' + bad, says='--seconds')
        self.refuse('demo', FIRST, '--seed', '1.5', says='--seed')
        for option in ['--frames', '--seconds']:
            for other in [('--casts', '10'), ('--craters', '1'), ('-o', 'x.svg')]:
                self.refuse('demo', FIRST, option, '2', *other, says=[option, 'fire fight'])
        self.write('file', 'here')
        self.refuse('demo', FIRST, '--seconds', '0.1', '--frames', 'file', says='file: cannot be made')
        self.refuse('demo', FIRST, '--seconds', '0.1', '--frames', 'file/below', says='file/below: cannot be made')
        self.write('low.obj', box(4, 4, 1))
        self.refuse('demo', 'low.obj', says=['low.obj', 'no place was found'])


def size(data):
    """Of a PNG."""
    return struct.unpack('>II', data[16:24])


if __name__ == '__main__':
    unittest.main()
