#!/usr/bin/python3
"""Keeps effects out of deciding code. Usage: lint_deciding.py [ROOT [FOLDERS_FILE]]"""
import pathlib
import re
import sys

FORBIDDEN = [
    (r'\b(steady_clock|system_clock|high_resolution_clock)\b|\b(clock_gettime|gettimeofday)\s*\(|\btime\s*\(\s*(NULL|nullptr|0)\s*\)', 'a clock: take the time as an argument'),
    (r'\bstd::(thread|jthread|async|mutex|shared_mutex|condition_variable|atomic)\b|\bthread_local\b|\bsleep_(for|until)\b', 'a thread or lock: belongs to the edge'),
    (r'\b(mt19937(_64)?|random_device|default_random_engine|minstd_rand0?|random_shuffle)\b|\bs?rand\s*\(|\b(theRNG|randu|randn)\b', 'a random source: take a weft::Random'),
    (r'\bunordered_(multi)?(map|set)\b', 'an unordered container: its order is not the same on each run'),
    (r'\bstd::(i|o)?fstream\b|\bfopen\s*\(|\bstd::filesystem\b(?!::path\b)|\bgetenv\s*\(', 'a file or the environment: edges read them'),
    (r'::(socket|bind|connect|sendto|recvfrom)\s*\(', 'a socket: belongs to the edge'),
]


def folders(path):
    within, without = [], []
    for line in path.read_text().splitlines():
        line = line.split('#')[0].strip()
        if line:
            (without if line.startswith('-') else within).append(line.lstrip('-') + '/')
    return within, without


def strip_comments(text):
    text = re.sub(r'/\*.*?\*/', lambda m: '\n' * m.group().count('\n'), text, flags=re.S)
    return re.sub(r'//[^\n]*', '', text)


def faults(root, within, without):
    for path in sorted(p for top in within for p in (root / top).rglob('*') if p.suffix in ('.hpp', '.cpp')):
        name = path.relative_to(root).as_posix()
        if any(name.startswith(edge) for edge in without):
            continue
        for number, line in enumerate(strip_comments(path.read_text()).splitlines(), 1):
            for pattern, why in FORBIDDEN:
                if re.search(pattern, line):
                    yield f'{name}:{number}: {why}: {line.strip()}'


def main():
    here = pathlib.Path(__file__).resolve().parent
    root = pathlib.Path(sys.argv[1]) if len(sys.argv) > 1 else here.parent.parent
    found = list(faults(root, *folders(pathlib.Path(sys.argv[2]) if len(sys.argv) > 2 else here / 'deciding.txt')))
    print('\n'.join(found), end='\n' if found else '')
    sys.exit(1 if found else 0)


if __name__ == '__main__':
    main()
