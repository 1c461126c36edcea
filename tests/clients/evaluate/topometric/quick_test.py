#!/usr/bin/python3
"""Runs `weft-evaluate topometric --quick` as a user calls it and holds it to its own bounds.

Usage: quick_test.py PROGRAM OUT. What is in OPEN is measured and not held: P1 is a time, which no test asserts.
"""
import json
import pathlib
import shutil
import subprocess
import sys

OPEN = {'processor time a view, median', 'processor time a view, 99 %'}


def main(program, out):
    shutil.rmtree(out, ignore_errors=True)
    run = subprocess.run([program, 'topometric', '--quick', '--out', out], capture_output=True, text=True)
    said = f'{run.stdout}\n{run.stderr}'
    if run.returncode not in (0, 1):
        sys.exit(f'it ended with {run.returncode}:\n{said}')
    for name in ('topometric.csv', 'topometric.json', 'topometric.png'):
        if not (pathlib.Path(out) / name).is_file():
            sys.exit(f'{out}: {name} is missing:\n{said}')
    bounds = [bound for bound in json.loads((pathlib.Path(out) / 'topometric.json').read_text())['bounds']
              if bound['verdict'] != 'not measured']
    rows = {bound['row'] for bound in bounds}
    if not {'O1', 'O2', 'O3', 'L1', 'L2', 'L3', 'D1', 'B1', 'M1', 'S1', 'P1'} <= rows:
        sys.exit(f'only these rows were measured: {sorted(rows)}:\n{said}')
    missed = [f"{bound['row']} {bound['measure']}: {bound['median']}, worst {bound['worst']}" for bound in bounds
              if bound['verdict'] != 'met' and bound['measure'] not in OPEN]
    if missed:
        sys.exit('not met: ' + '; '.join(missed) + f'\n{said}')
    shutil.rmtree(out)


if __name__ == '__main__':
    main(*sys.argv[1:])
