#!/usr/bin/python3
"""Fails on a class with too many data members, and on a file with too many lines. Usage: check_sizes.py [ROOT [SIZES]]"""
import pathlib
import re
import sys

CLASS = re.compile(r'\b(?:class|struct)\s+(?:\[\[.*?\]\]\s*)?(\w+)[^;(]*$')
NO_MEMBER = re.compile(r'^(using|typedef|friend|static|template|enum|class|struct|union|operator)\b')


def read_sizes(path):
    sizes, without = {}, []
    for number, line in enumerate(path.read_text().splitlines(), 1):
        line = line.split('#')[0].strip()
        if not line:
            continue
        if line.startswith('-'):
            without.append(line[1:] + '/')
            continue
        found = re.fullmatch(r'(\S+):\s*(\d+)\s+(\d+)', line)
        if not found:
            sys.exit(f'{path}:{number}: expected "folder: members lines"')
        sizes[found[1]] = (int(found[2]), int(found[3]))
    return sizes, without


def without_text(source):
    """The source without comments, preprocessor lines, strings and characters; line breaks stay."""
    kept = re.compile(r'//[^\n]*|/\*.*?\*/|^[ \t]*#(?:\\\n|[^\n])*|"(?:\\.|[^"\\\n])*"|(?<!\d)\'(?:\\.|[^\'\\\n])\'', re.S | re.M)
    return kept.sub(lambda m: '\n' * m.group().count('\n'), source)


def without_brackets(text, opening, closing):
    """The text without what stands between the brackets, and without these."""
    depth, kept = 0, []
    for char in text:
        if char == closing and depth > 0:
            depth -= 1
        elif char == opening:
            depth += 1
        elif depth == 0:
            kept.append(char)
    return ''.join(kept)


def members_in(statement):
    """How many data members a statement of a class declares."""
    text = re.sub(r'^((public|protected|private)\s*:\s*)+', '', statement.strip()).strip()
    text = re.sub(r'^(\[\[.*?\]\]\s*)+', '', text)
    if not text or NO_MEMBER.match(text):
        return 0
    text = without_brackets(text, '<', '>')
    initialised = text.find('=')
    if '(' in (text if initialised < 0 else text[:initialised]) or re.search(r'\boperator\b', text):
        return 0
    return 1 + without_brackets(without_brackets(text, '(', ')'), '{', '}').count(',')


def classes_of(source):
    """Each class of the source: its line, name and number of data members."""
    text = without_text(source)
    open_braces = []  # of each: [name of its class or None, line, members, the statement that goes on after it or None]
    statement, line, found = '', 1, []
    for char in text:
        line += char == '\n'
        within_class = not open_braces or open_braces[-1][0] is not None
        if char == '{':
            head = CLASS.search(statement) if not re.search(r'\benum\b|=', statement) else None
            is_initialiser = '(' not in without_brackets(statement.split('=')[0], '<', '>')
            goes_on = statement if within_class and not head and is_initialiser else None
            open_braces.append([head[1] if head else None, line, 0, goes_on])
            statement = ''
        elif char == '}' and open_braces:
            name, begins, members, goes_on = open_braces.pop()
            if name:
                found.append((begins, name, members))
            statement = goes_on if goes_on is not None else ''
        elif char == ';':
            if open_braces and open_braces[-1][0]:
                open_braces[-1][2] += members_in(statement)
            statement = ''
        else:
            statement += char
    return sorted(found)


def faults(root, sizes, without):
    for folder, (most_members, most_lines) in sizes.items():
        for path in sorted(p for p in (root / folder).rglob('*') if p.suffix in ('.hpp', '.cpp')):
            name, source = path.relative_to(root).as_posix(), path.read_text()
            if any(name.startswith(folder) for folder in without):
                continue
            lines = source.count('\n')
            if lines > most_lines:
                yield f'{name}: {lines} lines, more than {most_lines}: split what it does'
            for line, class_name, members in classes_of(source):
                if members > most_members:
                    yield f'{name}:{line}: {class_name} has {members} data members, more than {most_members}: give parts of it a class'


def main():
    here = pathlib.Path(__file__).resolve().parent
    root = pathlib.Path(sys.argv[1]) if len(sys.argv) > 1 else here.parent.parent
    found = list(faults(root, *read_sizes(pathlib.Path(sys.argv[2]) if len(sys.argv) > 2 else here / 'sizes.txt')))
    print('\n'.join(found), end='\n' if found else '')
    sys.exit(1 if found else 0)


if __name__ == '__main__':
    main()
