#!/usr/bin/python3
"""Keeps files of a target from saying one name of their own with two meanings. Usage: check_own_names.py [ROOT]

Up to ten files of a target are compiled as one (docs/decisions/049-files-compiled-together.md), so that such names break
the build once a new file brings theirs together. What CMake compiles alone is left out: files with flags of their own."""
import pathlib
import re
import sys

from own_names import own_names

TARGET = re.compile(r"\b(?:weft_room|weft_program|weft_test|add_library|add_executable)\(\s*(\S+)([^)]*)\)")
OF_SOURCES = re.compile(r"\b(?:set_source_files_properties|set_property)\(([^)]*)\)")
ALONE = re.compile(r"\b(?:SKIP_UNITY_BUILD_INCLUSION|COMPILE_OPTIONS|COMPILE_DEFINITIONS|COMPILE_FLAGS|INCLUDE_DIRECTORIES)\b")


def sources(words):
    return [word for word in words.split() if word.endswith(".cpp")]


def targets(root):
    """(name, paths of what is compiled together) of each target of the tree."""
    tops = [top for top in root.iterdir() if top.is_dir() and top.name not in ("build", "out", ".git")]
    for listing in sorted(path for top in tops for path in top.rglob("CMakeLists.txt")):
        text = re.sub(r"#.*", "", listing.read_text())
        alone = {name for words in OF_SOURCES.findall(text) if ALONE.search(words) for name in sources(words)}
        for target, words in TARGET.findall(text):
            names = [name for name in sources(words) if name not in alone]
            yield target, [listing.parent / name.replace("${PROJECT_SOURCE_DIR}", str(root)) for name in names]


def faults(root, listed):
    for target, paths in listed:
        first = {}
        for path in paths:
            file = path.relative_to(root).as_posix()
            for own in own_names(path.read_text(), file):
                means, place = first.setdefault(own.name, (own.means, f"{file}:{own.line}"))
                if means != own.means:
                    yield (f"{file}:{own.line}: {own.name} is another thing in {place}, and {target} compiles them as one; "
                           "rename one, or write once what both mean")


def main():
    root = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else pathlib.Path(__file__).resolve().parents[2])
    listed = list(targets(root))
    if not listed:
        sys.exit(f"{root}: no CMakeLists.txt lists a target: weft_room(NAME SOURCES a.cpp ...)")
    found = list(faults(root, listed))
    print("\n".join(found), end="\n" if found else "")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
