#!/usr/bin/python3
"""Keeps words out of the code that the glossary rejects. Usage: check_words.py [ROOT [GLOSSARY]]

The table under "Words that are not used" names them in quotes. A word in small letters is no part of any identifier or
file name ("sway" finds keyframe_sway and SwayPrior); one with a capital is no name of a class or an enumeration."""
import pathlib
import re
import sys

PRODUCT = ['core', 'images', 'process', 'idl', 'storage', 'server', 'agents', 'clients']
NOT_CODE = re.compile(r'//.*|"(?:\\.|[^"\\])*"|\bstd::\w+')


def rejected(glossary):
    """(word, instead, where: a folder or everywhere) of each row."""
    rows = glossary.split('## Words that are not used', 1)[1].splitlines()
    for row in rows:
        cells = [cell.strip() for cell in row.strip('|').split('|')]
        if len(cells) == 3:
            yield from ((word, cells[1], cells[2]) for word in re.findall(r'"(\w+)"', cells[0]))


def pattern(word):
    if word[0].isupper():
        return re.compile(rf'\b(?:class|struct|enum)\s+{word}\b')
    snake = rf'(?<![A-Za-z0-9]){word}(?![A-Za-z0-9])'
    camel = ''.join(part.capitalize() for part in word.split('_'))
    return re.compile(rf'{snake}|(?<![A-Z]){camel}(?![a-z0-9])')


def faults(root, words):
    checks = [(word, instead, '' if where == 'everywhere' else f'{where}/', pattern(word)) for word, instead, where in words]
    for path in sorted(p for top in PRODUCT for p in (root / top).rglob('*') if p.suffix in ('.hpp', '.cpp', '.idl')):
        name = path.relative_to(root).as_posix()
        lines = [(0, path.stem)] + [(n, NOT_CODE.sub('', line)) for n, line in enumerate(path.read_text().splitlines(), 1)]
        for number, code in lines:
            for word, instead, where, found in checks:
                if name.startswith(where) and found.search(code):
                    yield f'{name}:{number}: "{word}" is rejected by docs/glossary.md; say {instead}'


def main():
    root = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else pathlib.Path(__file__).parents[2])
    glossary = pathlib.Path(sys.argv[2]) if len(sys.argv) > 2 else root / 'docs/glossary.md'
    words = list(rejected(glossary.read_text()))
    if not words:
        sys.exit(f'{glossary}: names no word under "Words that are not used"')
    found = list(faults(root, words))
    for fault in found:
        print(fault)
    sys.exit(1 if found else 0)


if __name__ == '__main__':
    main()
