#!/usr/bin/python3
"""The units of systemd: they verify, and leave to their processes next to nothing but their own work."""
import re

from packaged import BIN, ROOT, InFolder, main, needs

UNITS = ROOT / 'deploy/systemd'
MOST_EXPOSED = 2.0


@needs('systemd-analyze')
class Units(InFolder):
    def copied(self):
        """All units, with the programs of this build instead of those that the packages install."""
        for unit in UNITS.glob('weft-*.*'):
            if unit.suffix in ('.service', '.timer'):
                text = unit.read_text().replace('/usr/bin/weft', f'{BIN.resolve()}/weft')
                (self.folder / unit.name).write_text(text.replace('/usr/lib/weft/backup', str(ROOT / 'deploy/packages/backup')))
        self.assertEqual(len(list(self.folder.glob('weft-*'))), 4)
        return self.folder

    def test_they_verify(self):
        folder = self.copied()
        units = [folder / unit for unit in ('weft-server.service', 'weft-agent@r1.service', 'weft-backup.service', 'weft-backup.timer')]
        code, said, wrong = self.run_command('systemd-analyze', 'verify', '--man=no', *units)
        self.assertEqual((code, said, wrong), (0, '', ''))

    def test_they_expose_little(self):
        folder = self.copied()
        for unit in ('weft-server.service', 'weft-agent@.service', 'weft-backup.service'):
            code, said, wrong = self.run_command('systemd-analyze', 'security', '--offline=yes', '--no-pager', folder / unit)
            level = re.search(r'Overall exposure level for \S+: ([\d.]+)', said)
            self.assertTrue(level, said + wrong)
            self.assertLessEqual(float(level[1]), MOST_EXPOSED, unit)


class Text(InFolder):
    def test_all_are_hardened_alike(self):
        """Each service has the same block, so that what one is denied the others are."""
        blocks = {re.search(r'NoNewPrivileges=yes\n(?:\S.*\n)+', (UNITS / unit).read_text())[0]
                  for unit in ('weft-server.service', 'weft-agent@.service', 'weft-backup.service')}
        self.assertEqual(len(blocks), 1)

    def test_a_hung_process_is_noticed_and_a_wrong_setting_not_tried_for_ever(self):
        for unit in ('weft-server.service', 'weft-agent@.service'):
            text = (UNITS / unit).read_text()
            for line in ('Type=notify', 'Restart=always', 'RestartPreventExitStatus=2'):
                self.assertIn(f'\n{line}\n', text)
            self.assertRegex(text, r'\nWatchdogSec=\d+\n')


if __name__ == '__main__':
    main()
