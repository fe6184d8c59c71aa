# SPDX-License-Identifier: MIT
"""Every verb: help, bad calls, exit codes, outputs that cannot be written."""
import os
import resource
import signal
import subprocess
import time
import unittest

from harness import FIRMA, SANITIZED, CliTest, box

VERBS = ['info', 'check', 'cast', 'carve', 'log', 'walk', 'draw', 'serve', 'demo']
WALK = ['--start', '1,1,1', '--radius', '0.5', '--seed', '1']


class Calls(CliTest):
    def setUp(self):
        super().setUp()
        self.write('box.obj', box(4, 4, 4))
        self.write('q.csv', 'px,py,pz,dx,dy,dz,radius\n1,1,1,9,0,0,0.5\n')
        self.write('b.csv', 'x,y,z,radius,shape,seed\n2,2,0,1,rocky,1\n')

    def test_help(self):
        text = self.firma('--help')
        for verb in VERBS:
            self.assertIn('  %s ' % verb, text)
            own = self.firma(verb, '--help')
            self.assertIn('Exit codes: 0', own)
            self.assertIn('--json', own)
            self.assertEqual(own, self.firma(verb, '-h'))
            for line in own.splitlines():
                self.assertLess(len(line), 160, line)
        for verb in ['cast', 'carve', 'log', 'walk', 'draw', 'demo']:
            self.assertIn('-o,--out', self.firma(verb, '--help'))

    def test_version(self):
        self.assertRegex(self.firma('--version'), r'^firma \d+\.\d+\.\d+\n$')

    def test_no_verb_or_an_unknown_one(self):
        self.refuse(says='which verb')
        self.refuse('fly', says='fly: is no verb')
        self.refuse('-', says='is no verb')
        self.refuse('', says='is no verb')
        self.refuse('--json', says='--json')

    def test_bad_options(self):
        for verb in VERBS:
            self.refuse(verb, 'box.obj', '--bogus', says=verb)
            self.refuse(verb, 'box.obj', 'second.obj', says=verb)
        for verb in VERBS[:-1]:
            self.refuse(verb, says='required')
        self.refuse('cast', 'box.obj', '--queries', 'q.csv', says='--out is required')
        self.refuse('cast', 'box.obj', '--out', 'x.csv', says='--queries is required')
        self.refuse('walk', 'box.obj', '--out', 'x.csv', says='required')
        self.refuse('draw', 'box.obj', says='--out is required')
        self.refuse('info', 'box.obj', '--bogus', says='--bogus')
        self.refuse('info', 'box.obj', '--scale', says='--scale')

    def test_scale(self):
        for bad in ['0', '-1', 'nan', 'inf', '1e999', '0x10', '', 'one', '1,5']:
            self.refuse('info', 'box.obj', '--scale=' + bad, says='--scale')
        self.refuse('info', 'box.obj', '--scale', '5000', says='box.obj')      # out of the world

    def test_bad_levels(self):
        os.mkdir(self.path('folder.obj'))
        self.write('empty.obj', '')
        self.write('bad.obj', 'v 0 0 nan\n')
        for verb, rest in [('info', []), ('check', []), ('cast', ['--queries', 'q.csv', '-o', 'x']),
                           ('carve', ['--blasts', 'b.csv', '-o', 'x']),
                           ('walk', [*WALK, '--frames', '3', '-o', 'x']), ('draw', ['-o', 'x']), ('demo', ['-o', 'x'])]:
            for level in ['nothing.obj', 'folder.obj', 'empty.obj', '/dev/null', 'box.txt']:
                self.refuse(verb, level, *rest, says=level)
            self.refuse(verb, 'bad.obj', *rest, says='bad.obj:1')

    def test_the_same_words_for_a_level_of_no_format(self):
        for verb, rest in [('info', []), ('check', []), ('check', ['--pts', 'x']), ('draw', ['-o', 'x'])]:
            for level in 'box', 'box.txt', './box.d/level':
                self.refuse(verb, level, *rest, says=level + ': the name ends in none of .obj, .map, .bsp, .gltf, .glb, .firma\n')

    def outputs(self, out):
        yield ['cast', 'box.obj', '--queries', 'q.csv', '--out', out]
        yield ['carve', 'box.obj', '--blasts', 'b.csv', '-o', out]
        yield ['walk', 'box.obj', *WALK, '--frames', '3', '-o', out]
        yield ['draw', 'box.obj', '--out', out]
        yield ['demo', 'box.obj', '--casts', '10', '-o', out]

    def test_outputs_that_cannot_be_written(self):
        os.mkdir(self.path('folder'))
        os.symlink('nowhere/at/all', self.path('dangling'))
        for out in ['folder', 'folder/', '/dev/full', 'dangling', 'q.csv/x', 'x' * 300]:
            for call in self.outputs(out):
                self.refuse(*call)
                self.assertEqual(os.listdir(self.path('folder')), [])
        for call in list(self.outputs('missing/x'))[:4]:
            self.refuse(*call, says='missing/x')
        for call in self.outputs(''):
            if call[0] != 'demo':                                              # which takes its default then
                self.refuse(*call)

    def test_inputs_are_not_overwritten(self):
        for call in self.outputs('box.obj'):
            self.refuse(*call, says='box.obj')
        self.refuse('cast', 'box.obj', '--queries', 'q.csv', '--out', './q.csv', says='q.csv')

    def test_file_too_large(self):
        """As on a full disk: an error in the middle of the writing."""
        def limit():
            resource.setrlimit(resource.RLIMIT_FSIZE, (4096, 4096))
        self.write('x.csv', 'as it was')
        call = ['walk', 'box.obj', *WALK, '--frames', '20000', '-o', 'x.csv']
        self.refuse(*call, says='x.csv', preexec_fn=limit)
        self.refuse(*call[:-1], 'new.csv', says='new.csv', preexec_fn=limit)

    def test_signals(self):
        for number in [signal.SIGINT, signal.SIGTERM, signal.SIGHUP]:
            before = self.files()
            process = subprocess.Popen([FIRMA, 'walk', 'box.obj', *WALK, '--frames', '1000000000', '-o', 'long.csv'],
                                       cwd=self.folder, stdout=subprocess.PIPE, stderr=subprocess.PIPE)
            deadline = time.monotonic() + 60
            while self.files() == before and time.monotonic() < deadline:
                time.sleep(0.02)
            self.assertNotEqual(self.files(), before)
            time.sleep(0.2)
            process.send_signal(number)
            _, message = process.communicate(timeout=60)
            self.assertEqual(process.returncode, 2, message)
            self.assertEqual(self.files(), before)

    def test_closed_pipe(self):
        process = subprocess.Popen([FIRMA, 'walk', 'box.obj', *WALK, '--frames', '100000', '-o', '-'], cwd=self.folder,
                                   stdout=subprocess.PIPE, stderr=subprocess.PIPE)
        process.stdout.read(10)
        process.stdout.close()
        message = process.stderr.read().decode()
        process.stderr.close()
        self.assertEqual(process.wait(timeout=60), 2)
        self.assertRegex(message, r'^firma: -: .+\n$')

    def test_full_or_closed_standard_output(self):
        for verb in ['info', 'check']:
            with open('/dev/full', 'wb') as full:
                done = subprocess.run([FIRMA, verb, 'box.obj'], cwd=self.folder, stdout=full, stderr=subprocess.PIPE)
            self.assertEqual(done.returncode, 2)
            self.assertRegex(done.stderr.decode(), r'^firma: standard output: .+\n$')
        before = self.files()
        done = subprocess.run(['sh', '-c', '"$0" info box.obj >&-', FIRMA], cwd=self.folder, stderr=subprocess.PIPE)
        self.assertEqual(done.returncode, 2)
        self.assertEqual(self.files(), before)

    def test_little_memory(self):
        if SANITIZED: self.skipTest('sanitizers want all addresses')
        def limit():
            resource.setrlimit(resource.RLIMIT_AS, (150 << 20, 150 << 20))
        self.write('many.csv', 'px,py,pz,dx,dy,dz,radius\n' + '1,1,1,9,0,0,0.5\n' * 3000000)
        self.refuse('cast', 'box.obj', '--queries', 'many.csv', '--threads', '1', '-o', 'x.csv', preexec_fn=limit, says='memory')

    def test_standard_output(self):
        for call in self.outputs('-'):
            beside = [*call[:-1], '/dev/stdout']
            self.assertEqual(self.firma(*call), self.firma(*beside))
            self.refuse(*call, '--json', says='--json')
        self.firma('cast', 'box.obj', '--queries', 'q.csv', '-o', 'x.csv')
        self.assertEqual(self.firma('cast', 'box.obj', '--queries', 'q.csv', '-o', '-').encode(), self.read('x.csv'))
        subprocess.run(['sh', '-c', 'echo head > y; "$0" cast box.obj --queries q.csv -o /dev/stdout >> y', FIRMA],
                       cwd=self.folder, check=True)
        self.assertEqual(self.read('y'), b'head\n' + self.read('x.csv'))

    def test_existing_output(self):
        """It is replaced whole, keeps its permissions, and is written through a link."""
        self.write('old.csv', 'old')
        os.chmod(self.path('old.csv'), 0o640)
        os.symlink('old.csv', self.path('link.csv'))
        self.firma('cast', 'box.obj', '--queries', 'q.csv', '-o', 'link.csv')
        self.assertTrue(os.path.islink(self.path('link.csv')))
        self.assertTrue(self.read('old.csv').startswith(b'query,status'))
        self.assertEqual(os.stat(self.path('old.csv')).st_mode & 0o777, 0o640)


if __name__ == '__main__':
    unittest.main()
