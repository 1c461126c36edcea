#!/usr/bin/python3
"""The archive for a site without a network: whole, the same twice, and what it says is in it is."""
import hashlib
import json
import tarfile

from packaged import PACKAGES, ROOT, InFolder, main, needs


@needs('dpkg-deb')
class Bundle(InFolder):
    def bundle(self, name):
        code, _, wrong = self.run_command(ROOT / 'deploy/bundle', '--packages', PACKAGES, self.folder / name, seconds=300)
        self.assertEqual(code, 0, wrong)
        return self.folder / name

    def test_checksums_parts_and_licences_hold_and_a_second_one_is_the_same(self):
        made = self.bundle('a.tar')
        with tarfile.open(made) as archive:
            archive.extractall(self.folder)
        tree = self.folder / 'weft'
        self.every_file_is_summed(tree)
        self.parts_are_listed(tree)
        self.installer_works_there(tree)
        self.assertEqual(made.read_bytes(), self.bundle('b.tar').read_bytes())

    def every_file_is_summed(self, tree):
        rows = [line.split('  ', 1) for line in (tree / 'SHA256SUMS').read_text().splitlines()]
        files = {path.relative_to(tree).as_posix() for path in tree.rglob('*') if path.is_file()}
        self.assertEqual({path for _, path in rows}, files - {'SHA256SUMS'})
        for digest, path in rows:
            self.assertEqual(hashlib.sha256((tree / path).read_bytes()).hexdigest(), digest, path)
        for path in ('install', 'docs/operating.md', 'README.md', 'sbom.json'):
            self.assertIn(path, files)
        self.assertGreaterEqual(len(list((tree / 'packages').glob('weft-*.deb'))), 4)

    def parts_are_listed(self, tree):
        sbom = json.loads((tree / 'sbom.json').read_text())
        self.assertEqual((sbom['bomFormat'], sbom['specVersion']), ('CycloneDX', '1.4'))
        parts = {part['name']: part for part in sbom['components']}
        self.assertEqual(len(parts), len(sbom['components']))
        for package in (tree / 'packages').glob('weft-*.deb'):
            part = parts[package.name.split('_')[0]]
            self.assertEqual(part['hashes'], [{'alg': 'SHA-256', 'content': hashlib.sha256(package.read_bytes()).hexdigest()}])
        for library in ('libc6', 'libsqlite3-0', 'libcli11-dev'):
            self.assertTrue(parts[library]['version'])
        others = {name for name in parts if not name.startswith('weft-')}
        self.assertEqual({path.name for path in (tree / 'licences').iterdir()}, others)
        references = {part['bom-ref'] for part in sbom['components']}
        for row in sbom['dependencies']:
            self.assertLessEqual({row['ref'], *row['dependsOn']}, references)

    def installer_works_there(self, tree):
        tell = [tree / 'install', 'server', '--dry-run']
        code, said, wrong = self.run_command(*tell)
        self.assertEqual(code, 0, said + wrong)
        self.assertIn(f'{tree}/packages/weft-server_', said)
        with open(next(tree.glob('packages/weft-cli_*.deb')), 'ab') as package:
            package.write(b'x')
        self.refused(1, ['SHA256SUMS'], *tell)


if __name__ == '__main__':
    main()
