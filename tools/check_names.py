#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Finds types of one name in one namespace that two files define. Where both are linked into one program that is an
undefined program that no compiler and no linker tells: of their inline functions and destructors, one is taken for both.

  tools/check_names.py [ROOT]     exit 0: none; 1: some, each named; 2: a bad call

Looked through are the library, what is built over it, and the tests and benchmarks beside them. Types in namespaces
without a name, within functions and within other types are left alone: they are another type in each file, or as unique
as what they are in. Each test and benchmark may be a program of its own: types of two of them are compared only where
they lie in one folder, and with all of the library.
"""
import os
import re
import sys
from collections import defaultdict

LIBRARY = ['include', 'src', 'scenes', 'gltf', 'draw', 'bindings', 'cli']
PROGRAMS = ['tests', 'bench']
# Never in one program.
ALONE = re.compile(r'_windows(?=\.\w+$)')

SPACE = re.compile(r"""
    //[^\n]* | /\*.*?\*/                                 # comments
  | ^[ \t]*\#(?:[^\n\\]|\\.|\\\n)*                       # the preprocessor's lines, with what continues them
  | R"(?P<mark>[^()\s\\]*)\(.*?\)(?P=mark)" | "(?:[^"\\\n]|\\.)*" | (?<![0-9A-Fa-f])'(?:[^'\\\n]|\\.)+'  # texts
""", re.S | re.M | re.X)
TOKEN = re.compile(r'[A-Za-z_]\w*|::|[^\s\w]|\d[\w.\']*')
NAME = re.compile(r'[A-Za-z_]\w*$')
MACRO = re.compile(r'[A-Z][A-Z0-9_]*$')


def tokens_of(text):
    """[(token, line)] of what the compiler reads, without texts and the preprocessor's lines."""
    def blank(match):
        return ('""' if match.group(0)[0] in '"R' else '') + re.sub(r'[^\n]', ' ', match.group(0))
    plain = SPACE.sub(blank, text)
    found, line, at = [], 1, 0
    for match in TOKEN.finditer(plain):
        line += plain.count('\n', at, match.start())
        at = match.start()
        found.append((match.group(0), line))
    return found


class Reader:
    """Goes through a file's tokens and keeps the types that it defines where others can see them."""

    PAIRS = {'(': ')', '{': '}', '[': ']'}

    def __init__(self, tokens):
        self.tokens = tokens
        self.at = 0
        self.types = []  # (name with namespace, line)
        self.whole = True  # whether all braces have their other half

    def token(self, ahead=0):
        k = self.at + ahead
        return self.tokens[k][0] if k < len(self.tokens) else ''

    def skip_pair(self):
        """Past what belongs to the bracket here."""
        close = []
        while self.at < len(self.tokens):
            token = self.token()
            if token in self.PAIRS:
                close.append(self.PAIRS[token])
            elif token in (')', '}', ']'):
                if token != close.pop():
                    self.whole = False
            self.at += 1
            if not close:
                return
        self.whole = False

    def skip_angles(self):
        """Past < and what belongs to it; the text between. At a < that is none of a template: past that alone."""
        depth, start = 0, self.at
        while self.at < len(self.tokens):
            token = self.token()
            if token in self.PAIRS:
                self.skip_pair()
                continue
            if token in (';', '}', ')'):
                break
            depth += (token == '<') - (token == '>')
            self.at += 1
            if depth == 0:
                return ' '.join(text for text, _ in self.tokens[start:self.at])
        self.at = start + 1
        return '<'

    def read(self):
        self.read_namespace('')
        if self.at < len(self.tokens):  # a brace that nothing opened
            self.whole = False
        return self.types if self.whole else None

    def read_namespace(self, path):
        """To the brace that closes it, or the end. @param path of the namespace; None in one without a name"""
        while self.at < len(self.tokens) and self.token() != '}':
            token = self.token()
            if token == 'namespace':
                self.enter(path)
            elif token == 'extern' and self.token(1) == '"' and self.token(3) == '{':
                self.at += 4
                self.read_namespace(path)
                self.close()
            elif token == 'template' and self.token(1) == '<':
                self.at += 1
                self.skip_angles()
            elif token in ('class', 'struct', 'union', 'enum'):
                self.read_type(path)
            elif token in self.PAIRS:
                self.skip_pair()
            else:
                self.at += 1

    def close(self):
        if self.token() != '}':
            self.whole = False
        self.at += 1

    def enter(self, path):
        self.at += 1
        names = []
        while NAME.match(self.token()) or self.token() == '::':
            if self.token() not in ('::', 'inline'):
                names.append(self.token())
            self.at += 1
            if self.token() == '[':
                self.skip_pair()
        if self.token() != '{':  # another name of one
            return
        self.at += 1
        inner = None if path is None or not names else '::'.join(([path] if path else []) + names)
        self.read_namespace(inner)
        self.close()

    def read_type(self, path):
        """From its keyword past its name and, where it is defined here, past its body."""
        line = self.tokens[self.at][1]
        self.at += 2 if self.token() == 'enum' and self.token(1) in ('class', 'struct') else 1
        name, names = '', 0
        while self.at < len(self.tokens):
            token = self.token()
            if token == '[' or (token in ('alignas', '__attribute__', '__declspec') and self.token(1) == '('):
                self.at += token != '['
                self.skip_pair()
            elif NAME.match(token):
                if token != 'final' and not (MACRO.match(token) and NAME.match(self.token(1))):
                    names += not name.endswith('::')
                    name = name + token if name.endswith('::') else token
                self.at += 1
            elif token == '::':
                name += '::'
                self.at += 1
            elif token == '<' and name:
                name += self.skip_angles()
            else:
                break
        if self.token() == ':':  # what it is derived from, or made of
            while self.token() not in ('{', ';', ''):
                if self.token() == '<':
                    self.skip_angles()
                elif self.token() in self.PAIRS:
                    self.skip_pair()
                else:
                    self.at += 1
        if self.token() != '{':
            return
        if names == 1 and path is not None:
            self.types.append(('::'.join(([path] if path else []) + [name]), line))
        self.skip_pair()


def sources_in(root, folder):
    """Named from the root, in order."""
    for place, folders, names in os.walk(os.path.join(root, folder)):
        folders[:] = sorted(name for name in folders if name != 'node_modules')
        for name in sorted(names):
            if name.endswith(('.h', '.cpp')):
                yield os.path.relpath(os.path.join(place, name), root)


def may_meet(one, other):
    """Whether two files can be in one program."""
    if one == other or ALONE.sub('', one) == ALONE.sub('', other):
        return False
    alone = [path for path in (one, other) if path.split(os.sep)[0] in PROGRAMS]
    return len(alone) < 2 or os.path.dirname(one) == os.path.dirname(other)


def check(root):
    """(types, files, faults as text)"""
    places, faults, count = defaultdict(list), [], 0
    for folder in LIBRARY + PROGRAMS:
        for path in sources_in(root, folder):
            count += 1
            with open(os.path.join(root, path), encoding='utf-8') as file:
                types = Reader(tokens_of(file.read())).read()
            if types is None:
                faults.append(f'{path}: its brackets do not close each other: tools/check_names.py cannot read it')
            for name, line in types or []:
                places[name].append((path, line))
    for name, found in sorted(places.items()):
        for k, (path, line) in enumerate(found):
            first = next((one for one in found[:k] if may_meet(one[0], path)), None)
            if first:
                faults.append(f'{path}:{line}: {name} is defined in {first[0]}:{first[1]} too: one of the two needs '
                              'another name, or a namespace without one')
    return sum(map(len, places.values())), count, faults


def main():
    if len(sys.argv) > 2:
        print(__doc__, file=sys.stderr)
        return 2
    root = sys.argv[1] if len(sys.argv) == 2 else os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
    types, files, faults = check(root)
    if not files:
        print(f'{root}: no sources here', file=sys.stderr)
        return 2
    print('\n'.join(faults + [f'{types} types in {files} files, {len(faults)} faults']))
    return 1 if faults else 0


if __name__ == '__main__':
    sys.exit(main())
