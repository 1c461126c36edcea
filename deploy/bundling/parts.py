#!/usr/bin/python3
"""What Weft's packages consist of: lists the packages that they depend on, their copyright files, and all as an SBOM.

Usage: parts.py [--list FILE] [--sbom FILE --licences DIR] PACKAGE.deb...
Versions are those of the files for packages that are given as such, ours or not, and for all others those that are installed on this
machine, as the programs were linked with them. Exit 1: one line says what is missing."""
import argparse
import hashlib
import json
import pathlib
import re
import shutil
import subprocess
import sys

# Compiled into the programs from headers alone; nothing depends on these packages (cmake/packages.cmake has the same).
HEADERS = ('libboost1.74-dev', 'libcli11-dev', 'libeigen3-dev', 'libexpected-dev', 'libfastcdr-dev', 'libspdlog-dev',
           'libtomlplusplus-dev', 'nlohmann-json3-dev')
OURS = 'weft-'
FORMAT = '${Package}\t${Version}\t${Architecture}\t${db:Status-Status}\t${Depends}, ${Pre-Depends}\t${Provides}\n'


def fail(words):
    print(f'parts.py: {words}', file=sys.stderr)
    sys.exit(1)


def output(*argv):
    return subprocess.run(argv, capture_output=True, text=True, check=True).stdout


def names_in(depends):
    """Each dependency as the list of names that satisfy it."""
    for clause in depends.split(','):
        names = [re.sub(r'[\s(:].*', '', name.strip()) for name in clause.split('|')]
        if any(names):
            yield [name for name in names if name]


class Installed:
    """The packages of this machine, and what provides a name that is none of theirs."""

    def __init__(self, text):
        self.packages, self.providers = {}, {}
        for line in text.splitlines():
            name, version, architecture, status, depends, provides = line.split('\t')
            if status == 'installed':
                self.packages[name] = dict(name=name, version=version, architecture=architecture, depends=list(names_in(depends)))
                for provided in names_in(provides):
                    self.providers.setdefault(provided[0], name)

    def one_of(self, names):
        for name in names:
            found = name if name in self.packages else self.providers.get(name)
            if found:
                return found
        return None


def closure(installed, wanted, own):
    """Names of all packages that these dependencies lead to, sorted; our own are left out."""
    found, open_clauses = set(), list(wanted)
    while open_clauses:
        names = open_clauses.pop()
        if own.intersection(names):
            continue
        name = installed.one_of(names)
        if name is None:
            fail(f'{" or ".join(names)} is not installed on this machine: build the packages where they are bundled')
        if name not in found:
            found.add(name)
            open_clauses += installed.packages[name]['depends']
    return sorted(found)


def read_package(path):
    fields = output('dpkg-deb', '-f', str(path), 'Package', 'Version', 'Architecture', 'Depends')
    values = dict(line.split(': ', 1) for line in fields.splitlines() if ': ' in line)
    return dict(name=values['Package'], version=values['Version'], architecture=values['Architecture'],
                depends=list(names_in(values.get('Depends', ''))), sha256=hashlib.sha256(path.read_bytes()).hexdigest())


def licences_of(text):
    """The short names that a machine-readable copyright file has; none of another one."""
    names = {name.strip() for name in re.findall(r'^License: *(\S.*)$', text, re.M)}
    return sorted(name for name in names if len(name) < 80) if text.startswith('Format:') else []


def component(part, licences=()):
    purl = f'pkg:deb/debian/{part["name"].replace("+", "%2B")}@{part["version"].replace("+", "%2B").replace(":", "%3A")}?arch={part["architecture"]}'
    made = {'type': 'library', 'bom-ref': purl, 'name': part['name'], 'version': part['version'], 'purl': purl, 'scope': 'required'}
    if part['name'].startswith(OURS):
        made['type'] = 'application'
    if 'sha256' in part:
        made['hashes'] = [{'alg': 'SHA-256', 'content': part['sha256']}]
    if licences:
        made['licenses'] = [{'license': {'name': name}} for name in licences]
    return made


def sbom(own, components, references):
    everything = [component(part) for part in own] + components
    by_name = {entry['name']: entry['bom-ref'] for entry in everything}
    return {'bomFormat': 'CycloneDX', 'specVersion': '1.4', 'version': 1,
            'metadata': {'component': {'type': 'application', 'bom-ref': 'weft', 'name': 'weft', 'version': own[0]['version']}},
            'components': everything,
            'dependencies': [{'ref': by_name[name], 'dependsOn': sorted({by_name[n] for n in needs if n in by_name})}
                             for name, needs in references.items()]}


def copy_licence(name, folder):
    source = pathlib.Path('/usr/share/doc') / name / 'copyright'
    if not source.is_file():
        fail(f'{source} is missing: this machine was installed without documentation, so licences cannot be collected')
    shutil.copyfile(source, folder / name)
    return licences_of(source.read_text(errors='replace'))


def main():
    parser = argparse.ArgumentParser(prog='parts.py')
    for flag in ('--list', '--sbom', '--licences'):
        parser.add_argument(flag, type=pathlib.Path)
    parser.add_argument('packages', nargs='+', type=pathlib.Path)
    options = parser.parse_args()

    installed = Installed(output('dpkg-query', '-W', '-f', FORMAT))
    given = [read_package(path) for path in options.packages]
    own = [part for part in given if part['name'].startswith(OURS)]
    depended = closure(installed, [clause for part in own for clause in part['depends']], {part['name'] for part in own})
    if options.list:
        options.list.write_text(''.join(f'{name}\n' for name in depended))
    if not options.sbom:
        return
    parts = installed.packages | {part['name']: part for part in given}
    headers = [name for name in HEADERS if name in installed.packages and name not in depended]
    components = [component(parts[name], copy_licence(name, options.licences)) for name in depended + headers]
    references = {name: [installed.one_of(clause) or clause[0] for clause in parts[name]['depends']]
                  for name in [part['name'] for part in own] + depended}
    options.sbom.write_text(json.dumps(sbom(own, components, references), indent=1) + '\n')


if __name__ == '__main__':
    main()
