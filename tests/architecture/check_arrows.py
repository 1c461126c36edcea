#!/usr/bin/python3
"""Fails on an include that runs against the arrows of arrows.txt. Usage: check_arrows.py [ROOT [ARROWS]]"""
import pathlib
import re
import sys

INCLUDE = re.compile(r'^\s*#\s*include\s*"([^"]+)"', re.M)


def read_arrows(path):
    arrows = {}
    for number, line in enumerate(path.read_text().splitlines(), 1):
        line = line.split('#')[0].strip()
        if not line:
            continue
        if ':' not in line:
            sys.exit(f'{path}:{number}: expected "room: rooms"')
        room, uses = line.split(':', 1)
        arrows[room.strip()] = set(uses.split())
    for room, uses in arrows.items():
        for unknown in sorted(uses - arrows.keys()):
            sys.exit(f'{path}: {room} may use {unknown}, which is no room')
    return arrows


def room_of(path, arrows):
    parts = path.split('/')
    for end in range(len(parts) - 1, 0, -1):
        if '/'.join(parts[:end]) in arrows:
            return '/'.join(parts[:end])
    return None


def is_listed_in_part(name, room, arrows):
    """Whether the file is in a folder of its room that is no room itself, although other folders of the room are."""
    folder = name.rpartition('/')[0]
    return folder != room and any(other.startswith(room + '/') for other in arrows)


def wrong_includes(root, arrows):
    tops = sorted({room.split('/')[0] for room in arrows})
    for path in sorted(p for top in tops for p in (root / top).rglob('*') if p.suffix in ('.hpp', '.cpp', '.h', '.c')):
        name = path.relative_to(root).as_posix()
        room = room_of(name, arrows)
        if room is None:
            yield name, 'stands in no room of arrows.txt'
            continue
        if is_listed_in_part(name, room, arrows):
            yield name, f'its folder is no room of arrows.txt, and other folders of {room} are: list it there'
            continue
        for target in INCLUDE.findall(path.read_text(errors='replace')):
            used = room_of(target, arrows)
            if used and used != room and used not in arrows[room]:
                yield name, f'{room} may not include {target} ({used})'


def main():
    here = pathlib.Path(__file__).resolve().parent
    root = pathlib.Path(sys.argv[1]) if len(sys.argv) > 1 else here.parent.parent
    arrows = read_arrows(pathlib.Path(sys.argv[2]) if len(sys.argv) > 2 else here / 'arrows.txt')
    wrong = list(wrong_includes(root, arrows))
    for name, why in wrong:
        print(f'{name}: {why}')
    sys.exit(1 if wrong else 0)


if __name__ == '__main__':
    main()
