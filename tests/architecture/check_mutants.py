#!/usr/bin/python3
"""Keeps planted bugs in step with the code that they break. Usage: check_mutants.py [ROOT]

Each patch has to apply to the tree as it is; whether it is found is for tests/mutants/run (by the simulation) and
tests/containers/plant to show, which take too long for every change."""
import pathlib
import subprocess
import sys

FOLDERS = ("tests/mutants", "tests/containers/planted")


def faults(root):
    for patch in sorted(path for folder in FOLDERS for path in (root / folder).glob("*.patch")):
        tried = subprocess.run(["git", "apply", "--check", str(patch)], cwd=root, capture_output=True, text=True)
        if tried.returncode != 0:
            why = (tried.stderr.strip() or "git says nothing").splitlines()[0]
            yield f"{patch.relative_to(root)}: does not apply ({why}); plant the same bug in the code as it is now"


def main():
    root = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else pathlib.Path(__file__).resolve().parents[2])
    if not any((root / "tests" / "mutants").glob("*.patch")):
        sys.exit(f"{root}: no patch in tests/mutants")
    found = list(faults(root))
    print("\n".join(found), end="\n" if found else "")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
