# SPDX-License-Identifier: MIT
"""The verb `serve`: what it hands out, what it keeps, how it ends."""
import http.client
import json
import os
import signal
import socket
import subprocess
import time
import unittest

from harness import FIRMA, CliTest


class Serve(CliTest):
    def setUp(self):
        super().setUp()
        os.makedirs(self.path('site/sub'))
        os.mkdir(self.path('site-beside'))
        self.write('site/index.html', '<p>hello</p>')
        self.write('site/a b.txt', 'spaces')
        self.write('site/firma.wasm', b'\0asm\1\0\0\0' + bytes(range(256)) * 400)
        self.write('site/empty.js', '')
        self.write('site/sub/level.obj', 'v 0 0 0\n')
        self.write('site/.hidden', 'hidden')
        self.write('secret.txt', 'secret')
        self.write('site-beside/secret.txt', 'secret')
        os.symlink('../secret.txt', self.path('site/link.txt'))
        os.symlink('..', self.path('site/up'))
        os.symlink('../site-beside', self.path('site/beside'))
        os.symlink('sub/level.obj', self.path('site/inside.obj'))
        os.mkfifo(self.path('site/pipe'))

    def start(self, *arguments):
        """Starts firma; it is ended with the test, whatever happens."""
        process = subprocess.Popen([FIRMA, *arguments], cwd=self.folder, stdout=subprocess.PIPE, stderr=subprocess.PIPE)
        def end():
            if process.returncode is not None: return
            process.kill()
            process.communicate()
        self.addCleanup(end)
        return process

    def serve(self, folder='site'):
        """Serves on a free port; returns the process and the port."""
        process = self.start('serve', folder, '--port', '0', '--json')
        said = self.read_object(process.stdout)
        self.assertEqual(said['url'], 'http://127.0.0.1:%d' % said['port'])
        self.assertEqual(said['folder'], folder)
        return process, said['port']

    def read_object(self, stream):
        text = b''
        while True:
            line = stream.readline()
            self.assertTrue(line, text)
            text += line
            try: return json.loads(text)
            except ValueError: pass

    def ask(self, port, path, method='GET', body=None, **headers):
        connection = http.client.HTTPConnection('127.0.0.1', port, timeout=20)
        try:
            connection.putrequest(method, path, skip_host='Host' in headers)
            for name, value in headers.items(): connection.putheader(name, value)
            if body is not None: connection.putheader('Content-Length', str(len(body)))
            connection.endheaders(body)
            answer = connection.getresponse()
            return answer.status, answer.read(), answer.headers
        finally:
            connection.close()

    def raw(self, port, request):
        """What comes back for bytes that no client would send."""
        with socket.create_connection(('127.0.0.1', port), timeout=20) as line:
            line.sendall(request)
            line.shutdown(socket.SHUT_WR)
            answer = b''
            while part := line.recv(65536): answer += part
            return answer

    def test_files_and_their_types(self):
        _, port = self.serve()
        for path, name, kind in [('/', 'index.html', 'text/html'), ('/index.html?x=1', 'index.html', 'text/html'),
                                 ('/firma.wasm', 'firma.wasm', 'application/wasm'), ('/empty.js', 'empty.js', 'text/javascript'),
                                 ('/sub/level.obj', 'sub/level.obj', 'model/obj'), ('/inside.obj', 'sub/level.obj', 'model/obj'),
                                 ('/a%20b.txt', 'a b.txt', 'text/plain')]:
            status, body, headers = self.ask(port, path)
            self.assertEqual((status, body), (200, self.read('site/' + name)), path)
            self.assertEqual(headers['Content-Type'].split(';')[0], kind, path)
            self.assertEqual(headers['X-Content-Type-Options'], 'nosniff')
            self.assertEqual(headers['Cross-Origin-Opener-Policy'], 'same-origin')
            status, body, headers = self.ask(port, path, 'HEAD')
            self.assertEqual((status, body), (200, b''), path)
            self.assertEqual(headers['Content-Type'].split(';')[0], kind, path)
        self.assertEqual(self.ask(port, '/firma.wasm', 'HEAD')[2]['Content-Length'], str(os.path.getsize(self.path('site/firma.wasm'))))

    def test_no_compression_and_no_parts(self):
        _, port = self.serve()
        self.write('site/big.js', '// the same again and again\n' * 100000)
        status, body, headers = self.ask(port, '/big.js', **{'Accept-Encoding': 'gzip, deflate, br'})
        self.assertEqual((status, body), (200, self.read('site/big.js')))
        self.assertNotIn('Content-Encoding', headers)
        whole = self.read('site/firma.wasm')
        for part in ['0-9', '100-100', '-7', '5-', '999999999-', '5-999999999', '9-3', 'x', '0-1,2-3,4-5', '9223372036854775807-', '0-0' + ',0-' * 500]:
            for path in ['/firma.wasm', '/empty.js', '/nothing']:              # no parts: all of it, or an error
                status, body, _ = self.ask(port, path, Range='bytes=' + part)
                self.assertIn(status, [200, 400, 404, 416], part)
                if status == 200: self.assertEqual(body, self.read('site' + path), part)
        self.assertEqual(self.ask(port, '/firma.wasm')[1], whole)

    def test_nothing_else(self):
        _, port = self.serve()
        for path in ['/nothing', '/sub', '/sub/', '/.hidden', '/sub/../.hidden', '/../secret.txt', '/%2e%2e/secret.txt',
                     '/sub/..%2f..%2fsecret.txt', '/..', '/sub/..', '/../site-beside/secret.txt', '/link.txt', '/up/secret.txt',
                     '/up/', '/beside/secret.txt', '/pipe', '//etc/passwd', '/%2fetc/passwd', '/etc/passwd',
                     '/index.html/', '/index.html%00.txt', '/sub/./level.obj', '/' + 'x' * 3000, '/firma.wasm%2f..%2f..%2fsecret.txt']:
            status, body, _ = self.ask(port, path)
            self.assertIn(status, [404, 414] if len(path) > 1000 else [404], path)
            self.assertNotIn(b'secret', body)
            self.assertNotIn(b'level.obj', body)
        for request in [b'GET http://127.0.0.1/../secret.txt HTTP/1.1\r\nHost: 127.0.0.1\r\nConnection: close\r\n\r\n',
                        b'GET secret.txt HTTP/1.1\r\nHost: 127.0.0.1\r\nConnection: close\r\n\r\n', b'\0\1\2\r\n\r\n', b'GET\r\n\r\n']:
            answer = self.raw(port, request)
            self.assertNotIn(b' 200 ', answer, request)
            self.assertNotIn(b'secret', answer)
        self.assertEqual(self.ask(port, '/')[0], 200)

    def test_other_methods(self):
        _, port = self.serve()
        before = self.read('site/index.html')
        for method in ['POST', 'PUT', 'DELETE', 'PATCH', 'OPTIONS']:
            status, _, headers = self.ask(port, '/index.html', method)
            self.assertEqual((method, status), (method, 405))
            self.assertEqual(headers['Allow'], 'GET, HEAD')
        self.assertEqual(self.read('site/index.html'), before)
        self.assertNotIn(self.ask(port, '/index.html', 'POST', b'x' * 100)[0], [200, 201, 204])

    def test_only_this_machine(self):
        process, port = self.serve()
        for host, status in [('127.0.0.1:%d' % port, 200), ('localhost:9999', 200), ('localhost', 200), ('example.com', 403),
                             ('example.com:%d' % port, 403), ('127.0.0.1.example.com', 403), ('', 403)]:
            self.assertEqual(self.ask(port, '/', Host=host)[0], status, host)
        with open('/proc/%d/net/tcp' % process.pid) as file: rows = [row.split() for row in file][1:]
        listening = [row[1] for row in rows if row[3] == '0A' and int(row[1].split(':')[1], 16) == port]
        self.assertEqual(listening, ['0100007F:%04X' % port])
        with open('/proc/%d/net/tcp6' % process.pid) as file: rows = [row.split() for row in file][1:]
        self.assertEqual([row[1] for row in rows if row[3] == '0A' and int(row[1].split(':')[1], 16) == port], [])

    def test_port_that_is_taken(self):
        _, port = self.serve()
        self.refuse('serve', 'site', '--port', port, says=['--port', str(port)])
        self.assertEqual(self.ask(port, '/')[0], 200)

    def test_bad_calls(self):
        for number in ['-1', '65536', 'x', '', '80.5', '1e3']:
            self.refuse('serve', 'site', '--port=' + number, says='--port')
        self.refuse('serve', 'nothing', '--port', '0', says='nothing')
        self.refuse('serve', 'secret.txt', '--port', '0', says='secret.txt')

    def test_words_and_the_end(self):
        for number in [signal.SIGINT, signal.SIGTERM, signal.SIGHUP]:
            process = self.start('serve', 'site', '--port', '0')
            said = process.stdout.readline().decode()
            self.assertRegex(said, r'^serving site on http://127\.0\.0\.1:\d+ \(Ctrl-C ends\)\n$')
            port = int(said.split(':')[2].split()[0])
            open_line = socket.create_connection(('127.0.0.1', port), timeout=20)  # an idle client holds up nothing
            self.assertEqual(self.ask(port, '/')[0], 200)
            started = time.monotonic()
            process.send_signal(number)
            rest, message = process.communicate(timeout=60)
            self.assertEqual((process.returncode, rest, message), (0, b'', b''))
            self.assertLess(time.monotonic() - started, 20)
            open_line.close()
            with self.assertRaises(OSError): socket.create_connection(('127.0.0.1', port), timeout=5).close()
            again = self.start('serve', 'site', '--port', str(port))
            self.assertIn(str(port).encode(), again.stdout.readline())             # the port is free at once
            again.send_signal(signal.SIGTERM)
            again.communicate(timeout=60)                                          # a signal right after its first line is not lost
            self.assertEqual(again.returncode, 0)

    def test_many_at_once(self):
        _, port = self.serve()
        lines = [http.client.HTTPConnection('127.0.0.1', port, timeout=60) for _ in range(40)]
        for line in lines: line.request('GET', '/firma.wasm')
        for line in lines:
            self.assertEqual(line.getresponse().read(), self.read('site/firma.wasm'))
            line.close()

    def test_a_connection_serves_one_request_and_may_wait_for_it(self):
        _, port = self.serve()
        with socket.create_connection(('127.0.0.1', port), timeout=20) as line:
            time.sleep(2)
            line.sendall(b'GET / HTTP/1.1\r\nHost: 127.0.0.1\r\n\r\n')
            answer = b''
            while part := line.recv(65536): answer += part
        self.assertIn(b'200 OK', answer)
        self.assertIn(b'Connection: close', answer)
        self.assertTrue(answer.endswith(b'<p>hello</p>'))

    # Finding 11 (F11).
    def test_silent_connections_hold_up_nobody(self):
        _, port = self.serve()
        for said in [b'', b'G', b'GET / HTTP/1.1\r\n', b'GET / HTTP/1.1\r\nHost: 127.0.0.1\r\nX-Unfinished: ']:
            started = time.monotonic()
            lines = [socket.create_connection(('127.0.0.1', port), timeout=20) for _ in range(100)]
            for line in lines: line.sendall(said)
            for _ in range(5): self.assertEqual(self.ask(port, '/firma.wasm')[0], 200)
            took = time.monotonic() - started
            for line in lines: line.close()
            self.assertLess(took, 0.9, said)                                   # less than any of the time limits

    def test_more_silent_connections_than_threads(self):
        process, port = self.serve()
        lines = [socket.create_connection(('127.0.0.1', port), timeout=20) for _ in range(700)]
        self.assertEqual(self.ask(port, '/')[0], 200)                          # later, but it comes
        with open('/proc/%d/status' % process.pid) as file: status = file.read()
        self.assertLess(int(status.split('Threads:')[1].split()[0]), 600)
        for line in lines: line.close()


if __name__ == '__main__':
    unittest.main()
