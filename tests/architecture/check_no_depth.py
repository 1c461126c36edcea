#!/usr/bin/python3
"""Fails where a simulated body could tell an agent how far away something is. Usage: check_no_depth.py [ROOT]

Depth comes of matching images, or a study of it proves nothing. No function that a header of the room declares is named
after it but those listed here; what is there for judges is called by nobody in agents/; a view holds images alone."""
import pathlib
import re
import sys

ROOM = 'agents/bodies/sim'
VIEW = 'agents/perception/view.hpp'
TELLS = re.compile(r'\b(?!return\b)[\w>&*]+[\s&*]+(\w*(?:depth|disparit|distance|range|point_cloud|how_far)\w*)\s*\(', re.I)
ASKS = re.compile(r'(?:\.|->)\s*distance_m\s*\(')
HOLDS = re.compile(r'std::variant<([^>]*)>\s*data\s*;')
IMAGES = {'Image', 'StereoPair', 'Payload'}

# "header: function" of the room, with what it tells instead, or for whom it is.
LISTED = {
    f'{ROOM}/base.hpp: distance_to': 'of a point of the plan to what stands on the floor',
    f'{ROOM}/base.hpp: distance_to_rim': 'likewise',
    f'{ROOM}/scene.hpp: distance': 'along a ray whose colour is being made',
    f'{ROOM}/hall/ceiling_canvas.hpp: depth_m': "of a hall's ceiling, along y",
    f'{ROOM}/hall/quad_scene.hpp: distance_m': 'for judges',
    f'{ROOM}/hall/hall_camera.hpp: distance_m': 'for judges',
}
ANSWERS = {f'{ROOM}/hall/hall_camera.cpp'}  # asks the scene on a judge's behalf


def code_of(path):
    """The file without comments and strings; line breaks stay."""
    kept = re.compile(r'//[^\n]*|/\*.*?\*/|"(?:\\.|[^"\\\n])*"', re.S)
    return kept.sub(lambda found: '\n' * found[0].count('\n'), path.read_text())


def numbered(code, pattern):
    for found in pattern.finditer(code):
        yield code.count('\n', 0, found.start()) + 1, found


def faults(root):
    room = sorted((root / ROOM).rglob('*.hpp'))
    if not room or not (root / VIEW).exists():
        sys.exit(f'{root}: no headers in {ROOM}, or no {VIEW}: nothing is checked')
    told = set()
    for path in room:
        name = path.relative_to(root).as_posix()
        for line, found in numbered(code_of(path), TELLS):
            told.add(f'{name}: {found[1]}')
            if f'{name}: {found[1]}' not in LISTED:
                yield (f'{name}:{line}: {found[1]}() sounds as if it told how far away something is; no agent may be told. '
                       'Is it something else, list it in tests/architecture/check_no_depth.py')
    yield from (f'{listed}() is listed in tests/architecture/check_no_depth.py and not there' for listed in sorted(set(LISTED) - told))
    for path in sorted(p for p in (root / 'agents').rglob('*') if p.suffix in ('.hpp', '.cpp')):
        name = path.relative_to(root).as_posix()
        if name not in ANSWERS:
            for line, _ in numbered(code_of(path), ASKS):
                yield f'{name}:{line}: asks for a true distance, which is for judges alone'
    held = HOLDS.search(code_of(root / VIEW))
    others = {kind.strip() for kind in held[1].split(',')} - IMAGES if held else {'nothing that is known'}
    if others:
        yield f'{VIEW}: a view holds {", ".join(sorted(others))}; a body gives images, and depth comes of matching them'


def main():
    root = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else pathlib.Path(__file__).resolve().parents[2])
    found = list(faults(root))
    print('\n'.join(found), end='\n' if found else '')
    return 1 if found else 0


if __name__ == '__main__':
    sys.exit(main())
