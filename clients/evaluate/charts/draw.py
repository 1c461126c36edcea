#!/usr/bin/python3
"""Draws the pictures of a study from the CSV and JSON files in its folder. Usage: draw.py STUDY FOLDER

weft-evaluate runs it at the end of a study; it can be run again over any folder that a study has written. Prints a line
"drawn: FILE" a picture; ends with 1 and one line when something is missing."""
import importlib
import pathlib
import sys

MODULES = {'floor': 'floor', 'replay': 'replay', 'floor-attempts': 'floor_attempts', 'floor-relocalise': 'floor_relocalise',
           'bearing': 'bearing', 'bearing-relocalise': 'bearing_relocalise', 'disturbances': 'disturbances',
           'ceiling': 'ceiling', 'particles': 'particles', 'particles-global': 'particles',
           'stereo': 'stereo', 'topometric': 'topometric'}


def main(arguments):
    if len(arguments) != 2 or arguments[0] not in MODULES:
        return f'usage: draw.py STUDY FOLDER; STUDY is one of {", ".join(MODULES)}'
    study, folder = arguments[0], pathlib.Path(arguments[1])
    try:
        module = importlib.import_module(MODULES[study])
    except ImportError as problem:
        return f'{problem.name or problem} is missing; apt-get install python3-matplotlib'
    try:
        for name in module.draw(folder):
            print(f'drawn: {name}', flush=True)
    except OSError as problem:
        return f'{problem.filename}: {problem.strerror}'
    except (KeyError, TypeError, ValueError, IndexError, AttributeError) as problem:
        return f'{folder}: holds files that weft-evaluate did not write ({type(problem).__name__}: {problem})'
    return None


if __name__ == '__main__':
    sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
    sys.dont_write_bytecode = True
    failure = main(sys.argv[1:])
    if failure:
        print(f'draw.py: {failure}', file=sys.stderr)
    sys.exit(1 if failure else 0)
