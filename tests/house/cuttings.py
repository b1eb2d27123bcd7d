#!/usr/bin/env python3
"""Finds headers that are a part of the one file that includes them.

A header and the source of its name are one unit, and so are the files that include it. A small unit
without a test of its own, with one including unit in its folder, is a cutting: it belongs into that unit.
It may stay where the joined file would be too long, or where the list of exceptions has it with a reason.
Usage: cuttings.py SOURCE_DIR EXCEPTIONS
"""
import pathlib
import re
import sys

FOLDERS = ('renderer', 'app')
# Lines of code, without blank lines, comments and includes, below which a unit is too small to stand alone.
FEWEST_LINES = 80
# Lines that a file may have (CONTRIBUTING.md).
MOST_LINES = 400
INCLUDE = re.compile(r'^[ \t]*#[ \t]*include[ \t]*"([^"]+)"', re.M)


def code_lines(text):
    return sum(1 for line in map(str.strip, text.splitlines())
               if line and not line.startswith(('//', '#')))


def unit_of(path):
    return path.rsplit('.', 1)[0]


def cuttings(root):
    """Yields (header, including unit) of each."""
    texts = {}
    for folder in FOLDERS + ('ui', 'tests'):
        for path in sorted((root / folder).rglob('*')):
            if path.suffix in ('.h', '.cpp'):
                texts[path.relative_to(root).as_posix()] = path.read_text()
    includers = {}
    for path, text in texts.items():
        for header in INCLUDE.findall(text):
            if unit_of(header) != unit_of(path):
                includers.setdefault(header, set()).add(unit_of(path))
    tests = {pathlib.PurePath(path).name for path in texts if path.endswith('_test.cpp')}
    for header in sorted(texts):
        folder = header.rsplit('/', 1)[0]
        if not header.endswith('.h') or header.split('/')[0] not in FOLDERS:
            continue
        unit = unit_of(header)
        users = includers.get(header, set())
        if len(users) != 1 or pathlib.PurePath(unit).name + '_test.cpp' in tests:
            continue
        user = next(iter(users))
        if user.rsplit('/', 1)[0] != folder:
            continue
        own = [texts.get(unit + suffix, '') for suffix in ('.h', '.cpp')]
        theirs = [texts.get(user + suffix, '') for suffix in ('.h', '.cpp')]
        if sum(map(code_lines, own)) >= FEWEST_LINES:
            continue
        # A header that only the source includes goes into the source with all that it has.
        if header in INCLUDE.findall(theirs[0]):
            joined = [a.count('\n') + b.count('\n') for a, b in zip(own, theirs)]
        else:
            joined = [theirs[0].count('\n'), theirs[1].count('\n') + sum(t.count('\n') for t in own)]
        if max(joined) <= MOST_LINES:
            yield header, user


def main():
    root, exceptions = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])
    reasons = {}
    status = 0
    for line in exceptions.read_text().splitlines():
        if line and not line.startswith('#'):
            header, _, reason = line.partition(' ')
            reasons[header] = reason.strip()
            if not reasons[header]:
                print(f'{exceptions.name}: {header} has no reason')
                status = 1
    found = dict(cuttings(root))
    for header, user in found.items():
        if header not in reasons:
            print(f'{header} is small and only {user} includes it: join them, test it, or give a reason')
            status = 1
    for header in reasons:
        if header not in found:
            print(f'{exceptions.name}: {header} is no exception any more')
            status = 1
    return status


if __name__ == '__main__':
    sys.exit(main())
