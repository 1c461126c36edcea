#!/usr/bin/python3
"""Fails on an include of another's library outside of the rooms that outside.txt gives it. Usage: check_outside.py [ROOT [TABLE]]"""
import pathlib
import re
import sys

INCLUDE = re.compile(r'^\s*#\s*include\s*[<"]([^>"]+)[>"]', re.M)
TOPS = ['core', 'images', 'drawing', 'process', 'idl', 'storage', 'agents', 'server', 'clients', 'tests']


def read_table(path):
    table = {}
    for number, line in enumerate(path.read_text().splitlines(), 1):
        line = line.split('#')[0].strip()
        if not line:
            continue
        start, colon, homes = line.partition(':')
        if not colon or not homes.split():
            sys.exit(f'{path}:{number}: expected "start of header: files or folders"')
        table[start.strip()] = homes.split()
    return table


def faults(root, table):
    for path in sorted(p for top in TOPS for p in (root / top).rglob('*') if p.suffix in ('.hpp', '.cpp', '.h', '.c')):
        name = path.relative_to(root).as_posix()
        for header in INCLUDE.findall(path.read_text(errors='replace')):
            for start, homes in table.items():
                if header.startswith(start) and not any(name.startswith(home) for home in homes):
                    yield f'{name}: may not include {header}; {" and ".join(homes)} alone may'


def main():
    here = pathlib.Path(__file__).resolve().parent
    root = pathlib.Path(sys.argv[1]) if len(sys.argv) > 1 else here.parent.parent
    found = list(faults(root, read_table(pathlib.Path(sys.argv[2]) if len(sys.argv) > 2 else here / 'outside.txt')))
    for fault in found:
        print(fault)
    sys.exit(1 if found else 0)


if __name__ == '__main__':
    main()
