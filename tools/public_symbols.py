#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Public functions of the C++ headers, as clang reads them: each that is not inline must be marked FIRMA_EXPORT.

  tools/public_symbols.py            names those that are not marked; exit 1 when there are any
  tools/public_symbols.py --mark     marks them (then tools/format.sh)
  tools/public_symbols.py --list     their symbols, one a line
  tools/public_symbols.py --compare LIBRARY   what the shared library exports must be exactly these
"""
import glob
import json
import os
import re
import subprocess
import sys

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
FUNCTIONS = ('FunctionDecl', 'CXXMethodDecl', 'CXXConstructorDecl', 'CXXDestructorDecl', 'CXXConversionDecl')


class Header:
    """Follows the places in clang's output, which names a file only where it changes."""
    file = None

    def begin_of(self, node):
        begin = None
        for key, place in (('loc', node.get('loc', {})), ('begin', node.get('range', {}).get('begin', {})), ('end', node.get('range', {}).get('end', {}))):
            for part in (place.get('spellingLoc', {}), place.get('expansionLoc', {}), place):
                self.file = part.get('file', self.file)
            if key == 'begin':
                begin = place.get('expansionLoc', place).get('offset')
        return self.file, begin


def documents():
    """What clang prints of namespace firma: JSON values one after the other."""
    headers = sorted(os.path.relpath(path, f'{ROOT}/include') for path in glob.glob(f'{ROOT}/include/firma/*.h'))
    program = ''.join(f'#include "{name}"\n' for name in headers if name != 'firma/firma_c.h')
    text = subprocess.run(['clang++-19', '-std=c++20', f'-I{ROOT}/include', '-fsyntax-only', '-x', 'c++', '-', '-Xclang', '-ast-dump=json',
                           '-Xclang', '-ast-dump-filter=firma'], input=program, capture_output=True, text=True, check=True).stdout
    decoder, at = json.JSONDecoder(), 0
    while (match := re.compile(r'\{').search(text, at)):
        value, at = decoder.raw_decode(text, match.start())
        yield value


def is_exported(node):
    """Whether the library has its body: not inline, not defaulted, not deleted."""
    if node.get('isImplicit') or node.get('inline') or node.get('constexpr'):
        return False
    if node.get('explicitlyDefaulted') or node.get('explicitlyDeleted'):
        return False
    return not any(child.get('kind') == 'CompoundStmt' for child in node.get('inner', []))


def functions_in(node, header, open_to_all=True):
    """(file, offset, symbol, marked) of each public function."""
    file, begin = header.begin_of(node)
    kind = node.get('kind')
    if kind in ('ClassTemplateDecl', 'FunctionTemplateDecl'):  # users compile them; but their places are followed
        open_to_all = False
    if kind in FUNCTIONS and open_to_all and is_exported(node):
        marked = any(child.get('kind') == 'VisibilityAttr' for child in node.get('inner', []))
        yield file, begin, node['mangledName'], marked
    is_open = open_to_all and node.get('tagUsed') != 'class'
    for child in node.get('inner', []):
        if child.get('kind') == 'AccessSpecDecl':
            is_open = open_to_all and child['access'] == 'public'
        yield from functions_in(child, header, is_open)


def public_functions():
    header, seen = Header(), {}
    for document in documents():
        for file, begin, symbol, marked in functions_in(document, header):
            if file and '/include/firma/' in f'/{os.path.abspath(file)}':
                seen.setdefault(symbol, (os.path.abspath(file), begin, marked))
    return seen


def mark(path, offsets):
    """Puts the word before each, and the include that it needs."""
    with open(path, 'rb') as file:
        text = file.read()
    for offset in sorted(offsets, reverse=True):
        text = text[:offset] + b'FIRMA_EXPORT ' + text[offset:]
    if b'#include "firma/export.h"' not in text:
        ours, last = text.find(b'#include "'), text.rfind(b'#include ')
        if ours >= 0:
            text = text[:ours] + b'#include "firma/export.h"\n' + text[ours:]
        else:
            end = text.index(b'\n', last) + 1 if last >= 0 else text.index(b'#pragma once\n') + len(b'#pragma once\n')
            text = text[:end] + b'\n#include "firma/export.h"\n' + text[end:]
    with open(path, 'wb') as file:
        file.write(text)


def plain(symbols):
    """Demangled; constructors and destructors, of which each has several symbols, are one so."""
    text = subprocess.run(['c++filt'], input='\n'.join(symbols), capture_output=True, text=True, check=True).stdout
    return set(text.splitlines())


def compare(library, symbols):
    lines = subprocess.run(['nm', '-D', '--defined-only', library], capture_output=True, text=True, check=True).stdout.splitlines()
    exported, public = plain(line.split()[-1] for line in lines), plain(symbols)
    for name in sorted(public - exported):
        print(f'{library} lacks {name}')
    for name in sorted(exported - public):
        print(f'{library} exports {name}, which no public header has')
    print(f'{len(exported)} symbols exported, {len(public)} public functions')
    return 0 if exported == public else 1


def main(arguments):
    functions = public_functions()
    if arguments == ['--list']:
        print('\n'.join(sorted(functions)))
        return 0
    if len(arguments) == 2 and arguments[0] == '--compare':
        return compare(arguments[1], functions)
    if arguments not in ([], ['--mark']):
        print(__doc__, file=sys.stderr)
        return 2
    unmarked = {symbol: place for symbol, place in functions.items() if not place[2]}
    if arguments:
        for path in {place[0] for place in unmarked.values()}:
            mark(path, [place[1] for place in unmarked.values() if place[0] == path])
        return 0
    for symbol, (path, _, _) in sorted(unmarked.items(), key=lambda item: item[1]):
        print(f'{os.path.relpath(path, ROOT)}: not marked FIRMA_EXPORT: {plain([symbol]).pop()}')
    print(f'{len(functions)} public functions, {len(unmarked)} not marked')
    return 1 if unmarked else 0


if __name__ == '__main__':
    sys.exit(main(sys.argv[1:]))
