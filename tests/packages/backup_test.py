#!/usr/bin/python3
"""The daily backup, with a `weft` of our own: what it keeps, what it never removes, which settings it refuses."""
from packaged import ROOT, InFolder, main

BACKUP = ROOT / 'deploy/packages/backup'
GOOD = 'echo "a map" >"$3"'
NAMES = [f'map-202601{day:02d}T020000Z.sqlite' for day in range(1, 6)]


class Backup(InFolder):
    def setUp(self):
        super().setUp()
        self.kept = self.folder / 'kept'
        self.kept.mkdir()

    def fill(self, names=tuple(NAMES)):
        for name in names:
            (self.kept / name).write_text('older')

    def run_it(self, weft, **settings):
        env = {**self.tools(weft=weft), 'WEFT_BACKUP_DIRECTORY': str(self.kept), **settings}
        return self.run_command(BACKUP, env=env)

    def names(self):
        return sorted(path.name for path in self.kept.iterdir())

    def test_a_good_snapshot_is_verified_renamed_and_the_oldest_go(self):
        self.fill()
        code, said, wrong = self.run_it('[ "$1 $2 $4" = "map snapshot --verify" ] || exit 9; ' + GOOD, WEFT_BACKUP_KEEP='3')
        self.assertEqual((code, wrong), (0, ''))
        self.assertIn('is good', said)
        self.assertEqual(self.names()[:2], NAMES[3:])
        self.assertEqual(len(self.names()), 3)

    def test_nothing_is_removed_when_the_snapshot_fails(self):
        self.fill()
        for weft in ('exit 3', GOOD + '; exit 1', 'exit 0', ': >"$3"'):
            code, _, wrong = self.run_it(weft, WEFT_BACKUP_KEEP='1')
            self.assertEqual(code, 1, weft)
            self.assertIn('weft backup: ', wrong)
            self.assertEqual([name for name in self.names() if not name.endswith('.unverified')], NAMES)
            for file in self.kept.glob('*.unverified'):
                file.unlink()

    def test_the_one_just_made_stays_though_the_clock_went_back(self):
        self.fill(['map-20990101T020000Z.sqlite', 'map-20990102T020000Z.sqlite'])
        self.assertEqual(self.run_it(GOOD, WEFT_BACKUP_KEEP='1')[0], 0)
        self.assertEqual(len(self.names()), 2)
        self.assertEqual(self.names()[1], 'map-20990102T020000Z.sqlite')

    def test_files_of_other_names_links_and_folders_are_left_alone(self):
        others = ['map-2026.sqlite', 'site.sqlite', 'map-20260101T020000Z.sqlite.old', 'map-20260101T02000xZ.sqlite']
        self.fill(others)
        (self.kept / 'map-20250101T020000Z.sqlite').symlink_to(self.kept / 'site.sqlite')
        (self.kept / 'map-20250102T020000Z.sqlite').mkdir()
        self.fill()
        self.assertEqual(self.run_it(GOOD, WEFT_BACKUP_KEEP='1')[0], 0)
        left = self.names()
        for name in [*others, 'map-20250101T020000Z.sqlite', 'map-20250102T020000Z.sqlite']:
            self.assertIn(name, left)
        self.assertEqual(len(left), len(others) + 3)

    def test_of_those_that_were_not_good_three_are_left_though_all_fail(self):
        self.fill([name + '.unverified' for name in NAMES])
        self.assertEqual(self.run_it(GOOD + '; exit 1')[0], 1)
        self.assertEqual(self.names()[:2], [name + '.unverified' for name in NAMES[3:]])
        self.assertEqual(len(self.names()), 3)

    def test_wrong_settings_are_refused_before_anything_is_done(self):
        self.fill()
        link = self.folder / 'link'
        link.symlink_to(self.kept)
        for settings, word in (({'WEFT_BACKUP_KEEP': '0'}, 'WEFT_BACKUP_KEEP'), ({'WEFT_BACKUP_KEEP': '-1'}, 'WEFT_BACKUP_KEEP'),
                               ({'WEFT_BACKUP_KEEP': '1001'}, 'WEFT_BACKUP_KEEP'), ({'WEFT_BACKUP_KEEP': 'all'}, 'WEFT_BACKUP_KEEP'),
                               ({'WEFT_BACKUP_DIRECTORY': '/'}, 'DIRECTORY'), ({'WEFT_BACKUP_DIRECTORY': '/etc'}, 'DIRECTORY'),
                               ({'WEFT_BACKUP_DIRECTORY': 'kept'}, 'DIRECTORY'),
                               ({'WEFT_BACKUP_DIRECTORY': f'{self.kept}/../kept'}, 'DIRECTORY'),
                               ({'WEFT_BACKUP_DIRECTORY': f'{self.kept}/a b'}, 'DIRECTORY'),
                               ({'WEFT_BACKUP_DIRECTORY': f'{self.kept}/-rf'}, 'DIRECTORY'),
                               ({'WEFT_BACKUP_DIRECTORY': str(link)}, 'link')):
            code, _, wrong = self.run_it(GOOD, **settings)
            self.assertEqual((code, wrong.count('\n')), (2, 1), f'{settings}: {wrong}')
            self.assertIn(word, wrong)
        self.assertEqual(self.names(), NAMES)
        code, _, wrong = self.run_it(GOOD, WEFT_BACKUP_DIRECTORY=f'{self.kept}/none')
        self.assertEqual(code, 1)
        self.assertIn('no folder', wrong)


if __name__ == '__main__':
    main()
