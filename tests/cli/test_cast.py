# SPDX-License-Identifier: MIT
"""firma cast: columns, malformed rows of all sorts, the same bytes for any number of threads."""
import csv
import io
import random
import unittest

from harness import FIRST, CliTest, box
from test_rooms import DEPOT, brush

HEADER = 'px,py,pz,dx,dy,dz,radius\n'
COLUMNS = 'query,status,fraction,safe_fraction,cx,cy,cz,px,py,pz,nx,ny,nz,fnx,fny,fnz,face,feature,room'
ROW = '1,1,1,9,0,0,0.5\n'


class Cast(CliTest):
    def setUp(self):
        super().setUp()
        self.write('box.obj', box(4, 4, 4))

    def cast(self, queries, *more, header=HEADER):
        self.write('q.csv', header + queries)
        self.firma('cast', 'box.obj', '--queries', 'q.csv', '--out', 'h.csv', *more)
        return list(csv.DictReader(io.StringIO(self.read('h.csv').decode())))

    def test_columns_and_values(self):
        hit, miss, touch = self.cast('1,1,1,8,0,0,0.5\n1,1,1,1,0,0,0\n1,1,0.5,0,0,-1,0.5\n')
        self.assertEqual(self.read('h.csv').decode().splitlines()[0], COLUMNS)
        self.assertEqual(hit['query'], '0')
        self.assertEqual((hit['status'], hit['fraction'], hit['cx'], hit['px']), ('hit', '0.3125', '3.5', '4'))
        self.assertEqual((hit['nx'], hit['fnx'], hit['face'], hit['feature'], hit['room']), ('-1', '-1', '5', 'face', '0'))
        self.assertAlmostEqual(float(hit['safe_fraction']), 0.3125 - 0.001 / 8, 15)
        self.assertEqual((miss['query'], miss['status']), ('1', 'miss'))
        self.assertTrue(all(value == '' for key, value in miss.items() if key not in ('query', 'status')))
        self.assertEqual((touch['status'], touch['fraction'], touch['safe_fraction']), ('touching', '0', '0'))
        self.assertEqual(self.read('h.csv').decode().splitlines()[2].count(','), COLUMNS.count(','))

    def test_17_digits(self):
        hit, = self.cast('1,1,1,0.1,0.2,-3,0.3\n')
        for name in ['fraction', 'cx', 'cy', 'cz', 'px']:
            self.assertEqual(hit[name], '%.17g' % float(hit[name]))

    def test_two_sided(self):
        outside = '-1,2,2,2,0,0,0\n'
        self.assertEqual(self.cast(outside)[0]['status'], 'miss')
        row, = self.cast(outside, '--two-sided')
        self.assertEqual((row['status'], row['nx'], row['fnx'], row['fraction']), ('hit', '-1', '1', '0.5'))

    def test_skin(self):
        for skin, safe in [('0', 0.3125), ('0.01', 0.3125 - 0.01 / 8), ('100', 0)]:
            self.assertAlmostEqual(float(self.cast('1,1,1,8,0,0,0.5\n', '--skin', skin)[0]['safe_fraction']), safe, 15)
        self.write('q.csv', HEADER + ROW)
        for bad in ['-0.001', 'nan', 'inf', 'x', '']:
            self.refuse('cast', 'box.obj', '--queries', 'q.csv', '-o', 'x.csv', '--skin=' + bad, says='--skin')

    def test_meets(self):
        self.write('q.csv', HEADER + '19,-6,1,0,0,-5,0\n')                      # into the depot's cistern

        def meet(level, *words):
            self.firma('cast', level, '--queries', 'q.csv', '-o', 'h.csv', *(['--meets', ','.join(words)] if words else []))
            hit, = csv.DictReader(io.StringIO(self.read('h.csv').decode()))
            return hit['status'], hit['cz'] and float(hit['cz'])
        water = ('hit', -0.5)
        for words in [], ['liquid'], ['walk', 'liquid'], ['liquid', 'sight', 'shots', 'walk']:
            self.assertEqual(meet(DEPOT, *words), water, words)
        bottom = meet(DEPOT, 'walk')
        self.assertEqual(bottom[0], 'hit')
        self.assertLess(bottom[1], -1)
        for words in ['shots'], ['sight'], ['walk', 'walk']: self.assertEqual(meet(DEPOT, *words), bottom, words)
        self.write('q.csv', HEADER + ROW)
        for word in 'walk', 'shots', 'sight', 'liquid':                        # faces of an .obj stop everything
            self.assertEqual(meet('box.obj', word)[0], 'hit')
        for bad in ['water', 'Walk', 'walk,', ',walk', 'walk, liquid', 'walk;sight']:
            self.refuse('cast', 'box.obj', '--queries', 'q.csv', '-o', 'x.csv', '--meets', bad,
                        says=['--meets: ', ' is none of walk, shots, sight, liquid'])
        text = self.firma('cast', '--help')
        for word in 'walk', 'shots', 'sight', 'liquid': self.assertRegex(text, r'(?m)^  %s  +\S' % word)

    def test_glass_and_clips(self):
        walls = {'glass': ['walk', 'shots'], 'clip': ['walk'], 'weapclip': ['shots'], 'sky1': ['walk', 'shots', 'sight']}
        self.write('q.csv', HEADER + '0,0.5,0.5,5,0,0,0\n')
        for texture, stopped in walls.items():
            self.write('wall.map', '{\n"classname" "worldspawn"\n' + brush((64, 0, 0), (80, 32, 32), texture) + '}\n')
            for word in 'walk', 'shots', 'sight', 'liquid':
                report = self.firma_json('cast', 'wall.map', '--queries', 'q.csv', '-o', 'h.csv', '--meets', word)
                self.assertEqual(report['hit'], int(word in stopped), (texture, word))

    def test_face_of_a_brush_is_its_side(self):
        """Counted through the file; a box has six."""
        self.write('two.map', '{\n"classname" "worldspawn"\n' + brush((64, 0, 0), (80, 32, 32)) + brush((96, 0, 0), (112, 32, 32)) + '}\n')
        self.write('q.csv', HEADER + '0,0.5,0.5,5,0,0,0\n2.7,0.5,0.5,5,0,0,0\n')
        self.firma('cast', 'two.map', '--queries', 'q.csv', '-o', 'h.csv')
        faces = [row['face'] for row in csv.DictReader(io.StringIO(self.read('h.csv').decode()))]
        self.assertEqual(faces, ['0', '6'])                                    # brush() puts the side at low x first

    def test_threads(self):
        number = random.Random(3)
        rows = ''.join(','.join('%r' % number.uniform(-9, 60) for _ in range(6)) + ',%r\n' % number.choice([0, 0.3, 5])
                       for _ in range(20000))
        self.write('q.csv', HEADER + rows)
        outputs = set()
        for threads in ['1', '2', '3', '16']:
            self.firma('cast', FIRST, '--queries', 'q.csv', '-o', 'h.csv', '--threads', threads)
            outputs.add(self.read('h.csv'))
        self.assertEqual(len(outputs), 1)
        self.assertEqual(outputs.pop().count(b'\n'), 20001)
        for bad in ['0', '-1', '1.5', '257', 'all', '']:
            self.refuse('cast', 'box.obj', '--queries', 'q.csv', '-o', 'x.csv', '--threads=' + bad, says='--threads')

    def test_json(self):
        self.write('q.csv', HEADER + '1,1,1,8,0,0,0.5\n1,1,1,1,0,0,0\n1,1,0.5,0,0,-1,0.5\n')
        report = self.firma_json('cast', 'box.obj', '--queries', 'q.csv', '--out', 'h.csv', '--threads', '2')
        self.assertEqual([report[k] for k in ['queries', 'hit', 'touching', 'miss', 'threads', 'out']], [3, 1, 1, 1, 2, 'h.csv'])

    def test_forms_that_are_fine(self):
        plain = self.cast('1,1,1,9,0,0,0.5\n')
        self.assertEqual(plain, self.cast('1,1,1,9,0,0,0.5'))                           # no line feed at the end
        self.assertEqual(plain, self.cast('1,1,1,9,0,0,0.5\r\n', header=HEADER.replace('\n', '\r\n')))
        self.assertEqual(plain, self.cast(' 1 ,1,\t1,+9e0,0.0,-0,5E-1\n'))
        self.assertEqual(plain, self.cast('0.5,9,1,1,1,0,0\n', header='radius,dx,px,py,pz,dy,dz\n'))
        self.assertEqual(plain, self.cast('1,1,1,9,0,0,0.5\n', header='\ufeff' + HEADER))
        self.assertEqual(self.cast(''), [])                                             # a header alone
        self.assertEqual(self.read('h.csv').decode(), COLUMNS + '\n')
        self.write('q.csv', HEADER + ROW)
        with open(self.path('q.csv')) as queries:
            done = self.run_firma('cast', 'box.obj', '--queries', '-', '-o', '-', stdin=queries)
        self.assertEqual((done.returncode, done.stdout.count(b'\n')), (0, 2))

    def test_malformed_rows(self):
        bad = ['nan,1,1,9,0,0,0.5', '1,NaN,1,9,0,0,0.5', '1,1,inf,9,0,0,0.5', '1,1,1,-inf,0,0,0.5', '1,1,1,9,infinity,0,0.5',
               '1,1,1,9,0,0x10,0.5', '1,1,1,9,0,0,', ',1,1,9,0,0,0.5', '1,1,,9,0,0,0.5', '1,1,1,9,0,0', '1,1,1,9,0,0,0.5,',
               '1,1,1,9,0,0,0.5,7', '', ' ', ',', ',,,,,,', '1,1,1,9,0,0,-0.5', '1,1,1,9,0,0,-1e-300', 'a,1,1,9,0,0,0.5',
               '1 2,1,1,9,0,0,0.5', '1.2.3,1,1,9,0,0,0.5', '1e,1,1,9,0,0,0.5', '--1,1,1,9,0,0,0.5', '+-1,1,1,9,0,0,0.5',
               '++1,1,1,9,0,0,0.5', '1e999,1,1,9,0,0,0.5', '1,1,1,9,0,0,1e999', '"1",1,1,9,0,0,0.5', '1;1;1;9;0;0;0.5',
               '1,1,1,9,0,0,0.5 # remark', '1,1,1,9,0,0,1d0', '1,1,1,9,0,0,0.5\r\r', '1,1,1,9,0,0,0.5\0', '1e100,1,1,9,0,0,0.5',
               '1,1,1,1e300,0,0,0.5', '1,1,1,9,0,0,1e300', '1,5,1,1,9,0,0,0,5', '\u0661,1,1,9,0,0,0.5', 'px,py,pz,dx,dy,dz,radius']
        self.write('old.csv', 'as it was')
        for row in bad:
            for rows, line in [(row + '\n', 2), (ROW * 2000 + row + '\n' + ROW, 2002), (ROW + row + '\n' + ROW, 3)]:
                self.write('q.csv', HEADER + rows)
                for out in ['new.csv', 'old.csv', '-']:
                    self.refuse('cast', 'box.obj', '--queries', 'q.csv', '--out', out, says='q.csv:%d: ' % line)

    def test_malformed_headers(self):
        for header in ['', '\n', ROW, HEADER[3:], HEADER.replace('radius', 'r'), HEADER.replace('\n', ',time\n'), 'px,' + HEADER,
                       HEADER.upper(), HEADER.replace('py', 'px'), HEADER.replace(',', ';'), '\0' * 50]:
            self.write('q.csv', header)
            self.refuse('cast', 'box.obj', '--queries', 'q.csv', '--out', 'x.csv', says='q.csv:1: ')
            self.write('q.csv', header + ROW)
            self.refuse('cast', 'box.obj', '--queries', 'q.csv', '--out', 'x.csv', says='q.csv:')

    def test_face_counts_what_is_dropped(self):
        self.write('box.obj', 'v 9 9 9\nf 1 1 1\n' + ''.join(
            line if line[0] == 'v' else 'f ' + ' '.join(str(int(k) + 1) for k in line.split()[1:]) + '\n'
            for line in box(4, 4, 4).splitlines(True)))
        self.write('q.csv', HEADER + '1,1,1,8,0,0,0.5\n')
        done = self.run_firma('cast', 'box.obj', '--queries', 'q.csv', '--out', 'h.csv')
        self.assertEqual(done.returncode, 0)
        self.assertIn('warning: box.obj: left out: faces without area: 1', done.stderr.decode())
        [hit] = csv.DictReader(io.StringIO(self.read('h.csv').decode()))
        self.assertEqual(hit['face'], '6')


if __name__ == '__main__':
    unittest.main()
