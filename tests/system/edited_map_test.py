#!/usr/bin/python3
"""A real server whose map an operator edits in every way: after each edit a snapshot is verified and restores."""
import json
import pathlib
import sqlite3
import tempfile

from command import BIN, EDITED_MAP_DOMAIN, Fleet, Running, main

GRAPH = ''.join(f'VERTEX_SE2 {i} {0.5 * i} 0 0\n' for i in range(12)) + ''.join(
    f'EDGE_SE2 {i} {i + 1} 0.5 0 0 100 0 0 100 0 100\n' for i in range(11))


class EditedMap(Fleet):
    domain = EDITED_MAP_DOMAIN

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        (self.folder / 'one.g2o').write_text(GRAPH)
        (self.folder / 'two.g2o').write_text(GRAPH.replace('0.5 0 0 100', '0.6 0 0 100'))
        self.snapshots = 0

    def server(self):
        return Running(self.folder / 'log', BIN / 'weft-server', '--store', self.folder / 'store', '--domain', self.domain,
                       '--dds', self.vendor)

    def start_map(self):
        """Two runs of twelve places; the ids of their experiences."""
        for name in ('one', 'two'):
            self.weft('map', 'import', self.folder / f'{name}.g2o', '--as', name)
        self.weft('map', 'export', self.folder / 'map.json')
        runs = json.loads((self.folder / 'map.json').read_text())['experiences']
        return [run['id'] for run in runs]

    def revision(self):
        return json.loads(self.weft('map', 'info', '--json'))['revision']

    def snapshot_restores(self, what):
        self.snapshots += 1
        file = self.folder / f'snapshot{self.snapshots}'
        said = self.weft('map', 'snapshot', file, '--verify')
        self.assertIn('checked, and is the map', said, what)
        self.assertEqual(list(self.folder.glob('*.verifying')), [], what)
        ended, _, wrong = self.run_command(BIN / 'weft', 'map', 'restore', file, '--store', self.folder / f'back{self.snapshots}')
        self.assertEqual(ended, 0, f'{what}: {wrong}')

    def test_a_snapshot_restores_after_every_edit(self):
        with self.server() as server:
            self.assertTrue(server.says('ready'), server.text())
            one, two = self.start_map()
            self.snapshot_restores('nothing was edited')
            edits = (('quarantine', f'{one}:5'), ('undo', f'{two}:3..4'), ('undo', '--revision', self.revision),
                     ('label', f'{one}:2', 'dock'), ('apart', f'{one}:0..3', f'{two}:6..9'), ('undo', two),
                     ('rollback', self.revision()), ('prune', '--apply'), ('replace', one))
            for edit in edits:
                self.weft('map', *(word() if callable(word) else word for word in edit))
                self.snapshot_restores(f'{edit}')
            self.weft('map', 'compact', '--before', self.revision())
            self.snapshot_restores('compact')
            self.assertEqual(server.stop(), 0, server.text())

    def test_what_is_apart_survives_a_restart_and_can_be_undone(self):
        with self.server() as server:
            self.assertTrue(server.says('ready'), server.text())
            one, two = self.start_map()
            self.weft('map', 'apart', f'{one}:0..3', f'{two}:6..9')
            listed = self.weft('map', 'apart', '--list')
            self.assertIn(f'{one}:0..3', listed)
            self.assertIn(f'{two}:6..9', listed)
            revision = self.revision()
            self.assertIn('apart', self.weft('map', 'log', '--most', '1'))
            self.assertEqual(server.stop(), 0, server.text())
        with self.server() as server:
            self.assertTrue(server.says('ready'), server.text())
            self.assertEqual(self.weft('map', 'apart', '--list'), listed)
            self.weft('map', 'undo', '--revision', revision)
            self.assertIn('no stretches', self.weft('map', 'apart', '--list'))

    def test_what_cannot_be_is_refused_in_one_line(self):
        with self.server() as server:
            self.assertTrue(server.says('ready'), server.text())
            one, two = self.start_map()
            weft = [BIN / 'weft', '--domain', self.domain, '--dds', self.vendor, 'map']
            for code, words, *named in (
                    (2, ['two stretches', '--list'],), (2, ['STRETCHES'], f'{one}:0..3'),
                    (2, ['E:I..J'], f'{one}:0..x', f'{two}:6..9'), (2, ['first comes after'], f'{one}:3..0', f'{two}:6..9'),
                    (4, ['share the places 2 to 3'], f'{one}:0..3', f'{one}:2..5'),
                    (4, ['named twice'], f'{one}:0..3', f'{one}:0..3'),
                    (4, ['0000000000000bad'], '0000000000000bad:0..3', f'{two}:6..9'),
                    (4, ['last place', '11'], f'{one}:0..99', f'{two}:6..9')):
                self.refused(code, words, *weft, 'apart', *named)
            (self.folder / 'there').write_text('mine')
            for code, words, file in ((4, ['absolute path'], 'backup'), (4, ['exists'], self.folder / 'there'),
                                      (1, ['/nowhere/backup', 'No such file', 'name a folder'], '/nowhere/backup'),
                                      (1, ['/dev/null/backup', 'Not a directory'], '/dev/null/backup')):
                self.refused(code, words, *weft, 'snapshot', file, '--verify')
            self.assertEqual((self.folder / 'there').read_text(), 'mine')

    def test_a_snapshot_that_does_not_restore_is_said_so(self):
        """The store itself is damaged under the server: the snapshot copies the damage."""
        with self.server() as server:
            self.assertTrue(server.says('ready'), server.text())
            self.start_map()
            with sqlite3.connect(self.folder / 'store/map.sqlite', timeout=10) as database:
                database.execute('UPDATE place SET row = zeroblob(60) WHERE place = 4')
            file = self.folder / 'snapshot'
            ended, _, wrong = self.run_command(BIN / 'weft', '--domain', self.domain, '--dds', self.vendor, 'map', 'snapshot',
                                               file, '--verify')
            self.assertNotEqual(ended, 0)
            for word in (str(file), ':4', 'checksum differs', 'do not rely on it', 'weft map check'):
                self.assertIn(word, wrong)
            self.assertEqual(list(self.folder.glob('*.verifying')), [])


if __name__ == '__main__':
    main()
