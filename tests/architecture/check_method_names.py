#!/usr/bin/python3
"""Keeps methods' names out of what is written for all of them. Usage: check_method_names.py [ROOT]

Core, the server, navigation and the agent know methods by agents/methods/all.hpp alone: no file there includes a
method's folder, spells its name or its class."""
import pathlib
import re
import sys

GENERIC = ['core', 'server', 'agents/navigation', 'agents/agent']
# `weft-agent calibrate mount` is a tool of two methods: those that look at a plane.
OF_SOME_METHODS = ['agents/agent/process/calibrate/']


def methods(root):
    """Folders of agents/methods that hold a method: each has a class of its name."""
    for folder in sorted(p for p in (root / 'agents/methods').iterdir() if p.is_dir()):
        if (folder / f'{folder.name}.hpp').exists():
            yield folder.name


def patterns(name):
    title = ''.join(part.capitalize() for part in name.split('_'))
    yield rf'"agents/methods/{name}/', f'includes the folder of method {name}'
    yield rf'"(?:[a-z,+]+[,+])?{name}(?:[,+][a-z,+]+)?"', f'spells the name of method {name}'
    yield rf'\b{title}(?:Config|Content)?\b(?=::|\s*[({{&>])', f'names the class of method {name}'


def faults(root):
    checks = [check for name in methods(root) for check in patterns(name)]
    for path in sorted(p for top in GENERIC for p in (root / top).rglob('*') if p.suffix in ('.hpp', '.cpp')):
        name = path.relative_to(root).as_posix()
        if any(name.startswith(tool) for tool in OF_SOME_METHODS):
            continue
        for number, line in enumerate(path.read_text().splitlines(), 1):
            code = line.split('//')[0]
            for pattern, why in checks:
                if re.search(pattern, code):
                    yield f'{name}:{number}: {why}; agents/methods/all.hpp is the only list: {line.strip()}'


def main():
    root = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else pathlib.Path(__file__).resolve().parents[2])
    found = list(faults(root))
    print('\n'.join(found), end='\n' if found else '')
    return 1 if found else 0


if __name__ == '__main__':
    sys.exit(main())
