#!/usr/bin/env python3
"""Finds types that one program defines twice.

Two definitions of a class in one namespace are undefined behaviour that no compiler or linker reports
while they stand in different files. Usage: definitions.py SOURCE_DIR [FOLDER...]
"""
import pathlib
import re
import sys

# Comments, raw strings, strings, characters (a digit before the quote makes it a separator).
BLANKED = re.compile(
    r'//[^\n]*|/\*.*?\*/|R"([^(\s]*)\(.*?\)\1"|"(?:\\.|[^"\\\n])*"|(?<![0-9A-Za-z_])\'(?:\\.|[^\'\\\n])*\'',
    re.S)
DIRECTIVE = re.compile(r'^[ \t]*#(?:\\\n|[^\n])*', re.M)
NAMESPACE = re.compile(r'(?:^|\s)(?:inline\s+)?namespace\b\s*([\w:]*)\s*$')
TYPE = re.compile(r'^(?:typedef\s+)?(?:class|struct|union|enum(?:\s+(?:class|struct))?)\s+'
                  r'(?:alignas\s*\([^)]*\)\s*)?([\w:]+(?:<.*?>)?)\s*(?:final\s*)?(?::[^:].*)?$', re.S)


def without_templates(head):
    """Returns a declaration's head without `template <...>`, attributes and access labels."""
    head = re.sub(r'\[\[.*?\]\]', '', head, flags=re.S).strip()
    head = re.sub(r'^(?:(?:public|private|protected)\s*:(?!:)\s*)+', '', head)
    while head.startswith('template'):
        depth, at = 0, head.find('<')
        for at in range(at, len(head)):
            depth += {'<': 1, '>': -1}.get(head[at], 0)
            if depth == 0:
                break
        head = head[at + 1:].strip()
        head = re.sub(r'^requires\s+[\w:]+(?:<[^<>]*>)?\s*', '', head)
    return head


def types_of(text):
    """Yields (qualified name, line) of each type defined in a namespace with a name, or in a class there."""
    keep_lines = lambda match: '\n' * match.group(0).count('\n') + ' '
    text = DIRECTIVE.sub(keep_lines, BLANKED.sub(keep_lines, text))
    scopes = []  # names; None: a block, or a namespace without a name
    begin = 0
    for match in re.finditer(r'[{};]', text):
        head, at = text[begin:match.start()], match.start()
        begin = match.end()
        if match.group() == '}':
            if scopes:
                scopes.pop()
        elif match.group() == '{':
            space = NAMESPACE.search(head)
            named = None if space else TYPE.match(without_templates(head))
            if space:
                scopes.append(space.group(1) or None)
            elif named:
                name = re.sub(r'\s+', ' ', named.group(1))
                scopes.append(name)
                if None not in scopes:
                    yield '::'.join(scopes), text.count('\n', 0, at) + 1
            else:
                scopes.append(None)


def program_of(path):
    """Returns the test program that a file is part of; empty for what all programs may be linked with."""
    parts = path.parts
    if parts[0] != 'tests' or parts[1] == 'support':
        return ''
    return '/'.join(parts[1:3] if parts[1] == 'renderer' else parts[1:2])


def main():
    root = pathlib.Path(sys.argv[1])
    folders = sys.argv[2:] or ['app', 'include', 'renderer', 'tests', 'ui']
    found = {}
    count = 0
    for folder in folders:
        for path in sorted((root / folder).rglob('*')):
            if path.suffix not in ('.h', '.cpp'):
                continue
            path = path.relative_to(root)
            for name, line in types_of((root / path).read_text()):
                count += 1
                found.setdefault(name, []).append((path, line))
    faults = 0
    for name, places in sorted(found.items()):
        for i, (path, line) in enumerate(places):
            for other, other_line in places[:i]:
                programs = {program_of(path), program_of(other)} - {''}
                if len(programs) < 2:
                    faults += 1
                    print(f'{path}:{line}: {name} is defined in {other}:{other_line}, too')
    print(f'{count} types, {faults} of them defined twice')
    return 1 if faults or count == 0 else 0


if __name__ == '__main__':
    sys.exit(main())
