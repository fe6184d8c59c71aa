#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Finds words that Firma does not use where the field has one: in docs, help, messages and public headers.

usage: check_words.py [ROOT]     exit 0: none; 1: some, each named; 2: a bad call

Looked through are the prose of *.md, the comments and names of public headers and of *.d.ts, and texts with a blank
in them of the programs, the library and the package: what people read. What programs read (columns, keys, options,
status words) has no blank, or stands in `code`, and is left alone.
"""
import glob
import os
import re
import sys

# (pattern, what to write). Prose: whatever people read, without code in it.
PROSE = [
    (r'\bskin\b', 'contact offset'),
    (r'\bbins?\b', 'node or leaf (bins are the article\'s alone)'),
    (r'\b(visits|visited|visiting|to visit)\b', 'traverse, or go through'),
    (r'\b(looked|looks) at\b|\b(casts|craters|cuts|edits) look at\b', 'candidate faces, or test, or read'),
    (r'\bvisit (a|an|the|all|each|every|any|no|some|its|their|only|more|fewer|nodes|leaves|faces|rooms)\b', 'traverse, or go through'),
    (r'\bgone\b', 'removed'),
    (r'\b(faces|portals|rooms) (that )?(come|came)\b(?! (from|to|out|in|back|before|after|by|with|down|of)\b)', 'added'),
    (r'\btouching\b', 'initial overlap, or touch'),
    (r'\bunsure\b', 'unclassified, or unknown'),
    (r'\b(most|largest|least|greatest|smallest)_\w+', 'max_ or min_'),
    (r'\bno ray t(old|ells)\b', 'unclassified'),
    (r'\b(shelf|shelves)\b', 'size class'),
    (r'\bdress(ed|es|ing)?\b', 'fill'),
    (r'\btwins?\b', 'reference oracle'),
    (r'\blarge numbers\b', 'soak tests'),
    (r'\bno good\b', 'non-finite or out of range'),
]
# Where the code is described as a building.
HOUSE = [(r'\b(wings?|floors|storeys?|roofs?|rooftop)\b', 'module or layer'), (r'\bthe (new |whole )?house\b', 'the code')]
HOUSE_FILES = ('architecture.md', 'CONTRIBUTING.md', 'README.md', 'STATUS.md', 'install.md')
# Names of public headers.
NAMES = [
    (r'\b[A-Za-z]*_?(most|largest|least|greatest|smallest)_\w+', 'max_ or min_'),
    (r'\bk(Most|Largest|Least|Greatest|Smallest)[A-Z]\w*', 'kMax or kMin'),
    (r'\b(most|largest|least)[A-Z]\w*', 'max or min'),
    (r'\b\w*looked_at\w*|\b\w*LookedAt\w*', 'candidate_faces'),
    (r'\b\w+_(gone|come)\b|\b\w+(Gone|Come)\b', 'removed, added'),
    (r'\b(\w+_)?skin(_\w+)?\b|\b[a-z]\w*Skin(?![a-z])\w*', 'contact_offset'),
    (r'\b(\w+_)?bins?(_\w+)?\b|\b[a-z]\w*Bins?(?![a-z])\w*', 'nodes, leaves'),
    (r'\bkTouching\b|\bFIRMA_TOUCHING\b', 'initial overlap'),
    (r'\bpart_of\b|\bpartOf\b', 'merged_into'),
    (r'\bkUnsure\b|\bFIRMA_UNSURE\b', 'unknown'),
    (r'\bvisit_\w+', 'each_'),
    (r'\btwin\w*', 'oracle'),
]
# Words that are right where they stand: (file's end, text on the line).
RIGHT = [
    ('benchmarks.md', "the article's"),  # its own words
    ('migration.md', '|'),               # what was called what
    ('index.d.ts', "'touching'"),        # status words, as programs read them
    ('verb_cast.cpp', 'miss, hit, or touching'),
    ('read_hits.cpp', 'neither miss, hit nor touching'),
    ('verb_info.cpp', 'greatest_shift'),  # a key
    ('plan_legend.cpp', 'class='),        # of the picture's style
    ('coming_from.md', '|'),             # other engines' words
]
# Fenced blocks, blocks indented by four blanks after an empty line, comments; the tables under those that say "table",
# which a program fills.
MARKDOWN_CODE = re.compile(r'^```.*?^```|(?<=\n\n)(?: {4}[^\n]*(?:\n|\Z))+|<!-- table [^\n]*-->\n(?:\|[^\n]*(?:\n|\Z))*|<!--.*?-->', re.S | re.M)
SPAN = re.compile(r'`[^`\n]*`|\]\([^)]*\)|https?:\S+')
STRING = re.compile(r'R"\((.*?)\)"|"((?:[^"\\\n]|\\.)*)"', re.S)
JS_STRING = re.compile(r"'((?:[^'\\\n]|\\.)*)'|`((?:[^`\\]|\\.)*)`|\"((?:[^\"\\\n]|\\.)*)\"", re.S)
COMMENT = re.compile(r'//[^\n]*|/\*.*?\*/', re.S)
# The end of firma_c.h: what programs of version 0.1 may still say.
OLD_NAMES = re.compile(r'/\* ---- names of version 0\.1 .*', re.S)


def blank(match):
    return re.sub(r'[^\n]', ' ', match.group(0))


def prose_of_markdown(text):
    return SPAN.sub(blank, MARKDOWN_CODE.sub(blank, text))


def only(pattern, text, keep=lambda found: True):
    """The text with all blanked that no match covers, lines as they are."""
    out, at = [], 0
    for match in pattern.finditer(text):
        out.append(re.sub(r'[^\n]', ' ', text[at:match.start()]))
        out.append(match.group(0) if keep(match.group(0)) else blank(match))
        at = match.end()
    return ''.join(out) + re.sub(r'[^\n]', ' ', text[at:])


def faults(path, text, rules):
    for pattern, instead in rules:
        for match in re.finditer(pattern, text, re.I if rules is not NAMES else 0):
            number = text.count('\n', 0, match.start()) + 1
            line = text.split('\n')[number - 1]
            if any(path.endswith(end) and part in line for end, part in RIGHT):
                continue
            yield number, f'{path}:{number}: "{match.group(0)}": {instead}'


def check(root):
    """Every fault, by file and line; None where there is nothing to check."""
    found, seen = [], []

    def files(*patterns):
        paths = {path for pattern in patterns for path in glob.glob(os.path.join(root, pattern), recursive=True)}
        seen.extend(paths)
        return sorted(path for path in paths if '/node_modules/' not in path)

    def judge(path, rules, prepare):
        with open(path, encoding='utf-8') as file:
            text = prepare(file.read())
        found.extend(sorted(faults(os.path.relpath(path, root), text, rules)))

    for path in files('*.md', 'docs/*.md', 'bindings/js/*.md', 'levels/*.md', 'tools/**/*.md'):
        judge(path, PROSE, prose_of_markdown)
        if path.endswith(HOUSE_FILES):
            judge(path, HOUSE, prose_of_markdown)
    for path in files('include/firma/*.h', 'bindings/js/*.d.ts'):
        judge(path, PROSE, lambda text: SPAN.sub(blank, only(COMMENT, OLD_NAMES.sub(blank, text))))
        judge(path, NAMES, lambda text: COMMENT.sub(blank, OLD_NAMES.sub(blank, text)))
    keys = re.compile(r'^--json:.*?(?:\n\n|\.\n|\)\")', re.S | re.M)  # of help: keys as programs read them
    for path in files('cli/*.cpp', 'src/*/*.cpp', 'gltf/*.cpp', 'bindings/*/*.cpp', 'draw/*.cpp'):
        judge(path, PROSE, lambda text: keys.sub(blank, only(STRING, COMMENT.sub(blank, text), lambda string: ' ' in string)))
    for path in files('bindings/js/src/*.js', 'playground/src/**/*.js', 'playground/*.html'):
        judge(path, PROSE, lambda text: only(JS_STRING, COMMENT.sub(blank, text), lambda string: ' ' in string))
    for path in files('test', 'play', '.ci/run'):
        judge(path, PROSE, lambda text: re.sub(r'\S*/\S*', blank, text))
    for path in files('tools/full.py'):
        judge(path, PROSE, lambda text: only(JS_STRING, text, lambda string: ' ' in string))
    return [text for _, text in found] if seen else None


def main():
    root = sys.argv[1] if len(sys.argv) > 1 else os.path.join(os.path.dirname(os.path.abspath(__file__)), '..')
    found = check(root)
    if found is None:
        print(f'{root}: no documents and no sources', file=sys.stderr)
        return 2
    print('\n'.join(found + [f'{len(found)} faults']))
    return 1 if found else 0


if __name__ == '__main__':
    sys.exit(main())
