#!/usr/bin/python3
"""Keeps messages from being listed twice. Usage: check_messages_once.py [ROOT]

A message has a row in idl/bus/message_list.hpp, a structure in core/protocol/messages.hpp, one in idl/messages and one
visitor in idl/convert. No other source of idl/ spells its name, and no program knows the types that the IDL makes: what has
to know every message is folded from the list. The bus knows by name the greeting alone, which says who speaks which version."""
import pathlib
import re
import sys

LIST = 'idl/bus/message_list.hpp'
PROGRAMS = ['core', 'storage', 'agents', 'server', 'clients']
GREETING = 'Hello'


def messages(root):
    """Names in the order of the list; one that goes two ways is there twice."""
    return re.findall(r'^WEFT_TOPIC\(\s*\w+,\s*(\w+),', (root / LIST).read_text(), re.M)


def lines_of(root, folder):
    for path in sorted(p for p in (root / folder).rglob('*') if p.suffix in ('.hpp', '.cpp')):
        name = path.relative_to(root).as_posix()
        for number, line in enumerate(path.read_text().splitlines(), 1):
            yield name, number, line.split('//')[0]


def places_of(lines, pattern):
    return [f'{name}:{number}' for name, number, line in lines if re.search(pattern, line)]


def must_be_one(what, places):
    if len(places) != 1:
        yield f'{what} stands {len(places)} times, not once' + (': ' + ', '.join(places) if places else '')


def faults(root):
    bus = [line for line in lines_of(root, 'idl/bus') if line[0] != LIST]
    visitors = list(lines_of(root, 'idl/convert'))
    idl = [(path.relative_to(root).as_posix(), number, line.split('//')[0])
           for path in sorted((root / 'idl/messages').glob('*.idl'))
           for number, line in enumerate(path.read_text().splitlines(), 1)]
    programs = [line for folder in PROGRAMS for line in lines_of(root, folder)]
    for message in dict.fromkeys(messages(root)):
        yield from must_be_one(f'the structure of {message} in idl/messages', places_of(idl, rf'\bstruct {message}\b'))
        yield from must_be_one(f'the visitor of {message} in idl/convert', places_of(visitors, rf'\bidl::{message}\b'))
        by_name = rf'\bidl::{message}\b|\bweft_idl_{message}_desc\b'
        if message != GREETING:
            by_name += rf'|\bmsg::{message}\b'
        for place in places_of(bus, by_name):
            yield f'{place}: lists {message} by hand: fold {LIST}'
        for place in places_of(programs, rf'\bidl::{message}\b'):
            yield f'{place}: knows what the IDL makes of {message}: use the type of core/protocol/messages.hpp'


def main():
    root = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else pathlib.Path(__file__).resolve().parents[2])
    if not messages(root):
        sys.exit(f'{LIST} has no row: WEFT_TOPIC(id, Name, ...)')
    found = list(faults(root))
    print('\n'.join(found), end='\n' if found else '')
    return 1 if found else 0


if __name__ == '__main__':
    sys.exit(main())
