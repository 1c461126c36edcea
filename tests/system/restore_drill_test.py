#!/usr/bin/python3
"""The restore drill of docs/operating.md with the real programs: the nightly backup is made, the map goes wrong, the server is
stopped, the backup is restored, and the map is that of the backup; what was there is kept aside. Then the same from the file
alone, into another folder, as on another machine."""
import json
import os
import pathlib
import shutil
import tempfile

from command import BIN, RESTORE_DOMAIN, ROOT, Fleet, Running, main

BACKUP = ROOT / 'deploy/packages/backup'
EDGES = 'EDGE_SE2 0 1 0.5 0 0 100 0 0 100 0 100\nEDGE_SE2 1 2 0.5 0 0 100 0 0 100 0 100\n'


class Drill(Fleet):
    domain = RESTORE_DOMAIN

    def setUp(self):
        self.folder = pathlib.Path(self.enterContext(tempfile.TemporaryDirectory()))
        (self.folder / 'run.g2o').write_text(EDGES)
        self.backups = self.folder / 'backups'
        self.backups.mkdir()

    def server(self, store):
        running = self.enterContext(Running(self.folder / f'server{len(list(self.folder.glob("*.log")))}.log', BIN / 'weft-server',
                                            '--store', store, '--domain', self.domain, '--dds', self.vendor))
        self.assertTrue(running.says('ready'), running.text())
        return running

    def runs(self):
        return {run['name']: (run['id'], run['places'], run['labels']) for run in json.loads(self.weft('map', 'list', '--json'))['experiences']}

    def restore(self, snapshot, store):
        code, said, wrong = self.run_command(BIN / 'weft', 'map', 'restore', snapshot, '--store', store, '--json')
        self.assertEqual(code, 0, said + wrong)
        return json.loads(said)

    def test_the_drill(self):
        store = self.folder / 'map'
        running = self.server(store)
        self.weft('map', 'import', self.folder / 'run.g2o', '--as', 'before')
        before = self.runs()
        first = before['before'][0]
        self.weft('map', 'label', f'{first}:0', 'dock')
        before = self.runs()
        code, said, wrong = self.run_command(BACKUP, env={
            'PATH': f'{BIN}:{os.environ["PATH"]}', 'WEFT_BACKUP_DIRECTORY': str(self.backups), 'WEFT_DOMAIN': str(self.domain),
            'WEFT_DDS': self.vendor})
        self.assertEqual(code, 0, said + wrong)
        backups = sorted(self.backups.glob('map-*.sqlite'))
        self.assertEqual(len(backups), 1, said)

        self.weft('map', 'import', self.folder / 'run.g2o', '--as', 'after')
        self.weft('map', 'unlabel', 'dock')
        self.assertNotEqual(self.runs(), before)
        self.assertEqual(running.stop(), 0, running.text())

        kept = pathlib.Path(self.restore(backups[0], store)['kept_aside'])
        self.assertTrue(kept.exists(), kept)
        again = self.server(store)
        self.assertEqual(self.runs(), before)
        _, said, wrong = self.run_command(BIN / 'weft', '--domain', self.domain, '--dds', self.vendor, 'doctor', '--json')
        store_is = [finding for finding in json.loads(said)['findings'] if finding['what'] == 'store']
        self.assertEqual([finding['good'] for finding in store_is], [True], said + wrong)
        self.weft('map', 'check')
        self.assertEqual(again.stop(), 0, again.text())

        # The way back: what was kept aside is a map, with what came after the backup.
        undone = self.folder / 'undone'
        self.restore(kept, undone)
        back = self.server(undone)
        self.assertEqual(set(self.runs()), {'before', 'after'})
        self.assertEqual(back.stop(), 0, back.text())

    def test_the_file_alone_is_enough(self):
        running = self.server(self.folder / 'map')
        self.weft('map', 'import', self.folder / 'run.g2o', '--as', 'before')
        before = self.runs()
        self.weft('map', 'snapshot', self.backups / 'site.sqlite', '--verify')
        self.assertEqual(running.stop(), 0, running.text())
        shutil.rmtree(self.folder / 'map')
        self.restore(self.backups / 'site.sqlite', self.folder / 'elsewhere')
        self.server(self.folder / 'elsewhere')
        self.assertEqual(self.runs(), before)


if __name__ == '__main__':
    main()
