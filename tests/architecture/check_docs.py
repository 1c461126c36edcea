#!/usr/bin/python3
"""What README.md and docs/ name exists. Usage: check_docs.py [ROOT]. Exit 1 and a line for each thing that does not.

Checked: paths in backticks that begin with a folder of the repository; bare ones that end like a file; the names of source
files anywhere; `file:function`, `function()`, `Class::member`, `snake_case` and `CamelCase` names; relative links."""
import pathlib
import re
import sys

LEFT_OUT = {'build', 'out', '.git', 'papers'}
SOURCE = ('.hpp', '.cpp', '.h', '.py', '.idl', '.cmake', '.txt', '.toml', '.yml', '')
FILE = r'[\w.-]+\.(?:hpp|cpp|py|md|toml|txt|idl|line|cmake)'


def walk(root):
    for path in sorted(root.iterdir()):
        if path.name in LEFT_OUT:
            continue
        yield path
        if path.is_dir():
            yield from walk(path)


class Tree:
    def __init__(self, root):
        self.root = root
        paths = list(walk(root))
        self.files = {path.relative_to(root).as_posix(): path for path in paths if path.is_file()}
        self.names = {path.name for path in paths}
        self.tops = {path.name for path in paths if path.parent == root and path.is_dir()}
        self.words = {}

    def text(self, name):
        if name not in self.words:
            self.words[name] = self.files[name].read_text(errors='replace')
        return self.words[name]

    def code(self):
        return (name for name in self.files if not name.endswith('.md') and pathlib.Path(name).suffix in SOURCE)

    def has_function(self, function, within=None):
        wanted = re.compile(r'\b' + re.escape(function) + r'\b\s*(?:<[^>\n]*>)?\(')
        return any(wanted.search(self.text(name)) for name in ([within] if within else self.code()))

    def has_member(self, owner, member):
        wanted = re.compile(r'\b' + re.escape(member) + r'\b')
        holds = re.compile(r'\b(?:class|struct|enum|namespace|class enum|concept)\s+(?:\w+\s+)*' + re.escape(owner) + r'\b|\b' +
                           re.escape(owner) + '::')
        return any(holds.search(self.text(name)) and wanted.search(self.text(name)) for name in self.code())

    def has_word(self, word):
        if not hasattr(self, 'all_words'):
            self.all_words = set()
            for name in self.code():
                self.all_words.update(re.findall(r'\w+', self.text(name)))
        return word in self.all_words

    def has_path(self, path):
        return (self.root / path.rstrip('/')).exists()


def wrong_in_backticks(tree, term):
    """Why this term is wrong; None if it is right or names nothing of ours."""
    path, _, function = term.partition(':')
    if re.fullmatch(r'[\w.-]+(/[\w.-]+)*/?', path) and path.split('/')[0] in tree.tops and '/' in path:
        if not tree.has_path(path):
            return f'{path} does not exist'
        if re.fullmatch(r'\w+(\(\))?', function) and path in tree.files and not tree.has_function(function.removesuffix('()'), path):
            return f'{path} has no {function}'
        return None
    if re.fullmatch(r'\w+\(\)', term) and not tree.has_function(term[:-2]):
        return f'no function {term} in the tree'
    member = re.fullmatch(r'(?:\w+::)*(\w+)::(\w+)(?:\(\))?', term)
    if member and member[1] != 'std' and not term.startswith('std::') and not tree.has_member(member[1], member[2]):
        return f'no {term} in the tree'
    if re.fullmatch(r'[a-z]\w*_\w+|[A-Z]+[a-z]\w*[A-Z]\w*', term) and not tree.has_word(term):
        return f'nothing is named {term} in the tree'
    return None


def wrong_on_line(tree, page, line):
    for term in re.findall(r'`([^`]+)`', line):
        fault = wrong_in_backticks(tree, term)
        if fault:
            yield fault
    tops = '|'.join(re.escape(top) for top in sorted(tree.tops))
    bare = re.sub(r'`[^`]*`|\]\([^)]*\)', ' ', line)
    for path in re.findall(rf'(?<![\w/.])((?:{tops})/(?:[\w.-]+/)*{FILE})\b', bare):
        if not tree.has_path(path):
            yield f'{path} does not exist'
    for name in re.findall(rf'(?<![\w/.*-])({FILE})\b(?!/)', line):
        if name.endswith(('.hpp', '.cpp', '.py')) and name not in tree.names:
            yield f'no file is named {name}'
    for target in re.findall(r'\]\(([^)#]+)(?:#[^)]*)?\)', line):
        if '://' not in target and not (page.parent / target).exists():
            yield f'link to {target}, which does not exist'


def pages(root):
    return [path for path in (root / 'README.md', *sorted((root / 'docs').rglob('*.md'))) if path.exists()]


def main():
    root = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else pathlib.Path(__file__).parents[2]).resolve()
    tree = Tree(root)
    faults = 0
    for page in pages(root):
        block = False
        for number, line in enumerate(page.read_text().splitlines(), 1):
            if line.startswith('```'):
                block = not block
            if block:
                continue
            for fault in wrong_on_line(tree, page, line):
                print(f'{page.relative_to(root)}:{number}: {fault}')
                faults += 1
    return 1 if faults else 0


if __name__ == '__main__':
    sys.exit(main())
