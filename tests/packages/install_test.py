#!/usr/bin/python3
"""deploy/install: what it writes, leaves alone, and asks of the machine."""
import tomllib

from packaged import BIN, ROOT, InFolder, main, needs

INSTALL = ROOT / 'deploy/install'


class Settings(InFolder):
    def install(self, *argv, code=0):
        ended, said, wrong = self.run_command(INSTALL, *argv, '--root', self.folder)
        self.assertEqual(ended, code, said + wrong)
        return said + wrong

    def text(self, path):
        return (self.folder / path).read_text()

    def test_a_server_and_its_backup(self):
        self.install('server', '--listen', '10.0.0.5', '--domain', '3', '--dds', 'cyclonedds', '--keep', '30')
        self.assertEqual(tomllib.loads(self.text('etc/weft/server.toml')), {'listen': '10.0.0.5', 'domain': 3, 'dds': 'cyclonedds'})
        for line in ('WEFT_SERVER=10.0.0.5', 'WEFT_LISTEN=10.0.0.5', 'WEFT_DOMAIN=3', 'WEFT_BACKUP_KEEP=30'):
            self.assertIn(f'\n{line}\n', self.text('etc/weft/backup.conf'))

    def test_robots_each_with_a_file(self):
        camera = self.folder / 'mine.yaml'
        camera.write_text('camera')
        self.install('robot', '--name', 'r1', '--server', 'a', '--server', 'b:1', '--listen', 'wlan0', '--method', 'floor,bearing',
                     '--calibration', camera)
        self.install('robot', '--name', 'süd', '--instance', 'sued', '--server', 'a')
        self.assertEqual(tomllib.loads(self.text('etc/weft/agents/r1.toml')),
                         {'name': 'r1', 'server': ['a', 'b:1'], 'listen': 'wlan0', 'method': 'floor,bearing',
                          'calibration': '/etc/weft/agents/r1.camera.yaml'})
        self.assertEqual(self.text('etc/weft/agents/r1.camera.yaml'), 'camera')
        self.assertEqual(tomllib.loads(self.text('etc/weft/agents/sued.toml')), {'name': 'süd', 'server': ['a']})

    def test_an_operator(self):
        self.install('operator', '--server', 'a', '--server', 'b', '--listen', 'eth0', '--dds', 'fastdds')
        code, said, _ = self.run_command('sh', '-c', f'. {self.folder}/etc/profile.d/weft.sh; env')
        self.assertEqual(code, 0)
        for line in ('WEFT_SERVER=a,b', 'WEFT_LISTEN=eth0', 'WEFT_DDS=fastdds'):
            self.assertIn(f'\n{line}\n', f'\n{said}')

    def test_twice_is_once_and_other_flags_change_it(self):
        self.install('server', '--listen', '10.0.0.5')
        before = self.text('etc/weft/server.toml')
        said = self.install('server', '--listen', '10.0.0.5')
        self.assertNotIn('write', said)
        self.assertEqual(self.text('etc/weft/server.toml'), before)
        self.install('server', '--listen', '10.0.0.6')
        self.assertIn('10.0.0.6', self.text('etc/weft/server.toml'))
        self.assertFalse((self.folder / 'etc/weft/server.toml.old').exists())

    def test_what_people_edited_stays_unless_they_say_so(self):
        self.install('server', '--listen', '10.0.0.5')
        file = self.folder / 'etc/weft/server.toml'
        file.write_text(file.read_text() + 'unjoined = "one_drives"\n')
        edited = file.read_text()
        self.assertIn('--replace', self.install('server', '--listen', '10.0.0.6', code=1))
        self.assertEqual(file.read_text(), edited)
        self.install('server', '--listen', '10.0.0.6', '--replace')
        self.assertIn('10.0.0.6', file.read_text())
        self.assertEqual(self.text('etc/weft/server.toml.old'), edited)

    def test_the_packages_own_file_has_no_settings_and_is_replaced(self):
        (self.folder / 'etc/weft').mkdir(parents=True)
        for name in ('server.toml', 'backup.conf'):
            (self.folder / 'etc/weft' / name).write_text((ROOT / 'deploy/packages' / name).read_text())
        self.install('server', '--listen', '10.0.0.5')
        self.assertIn('10.0.0.5', self.text('etc/weft/server.toml'))

    def test_dry_run_and_check_change_nothing(self):
        self.assertIn('would: write', self.install('server', '--dry-run'))
        self.assertIn('not so yet', self.install('server', '--check', code=1))
        self.assertEqual(list(self.folder.iterdir()), [])
        self.install('server')
        self.install('server', '--check')

    def test_the_programs_understand_what_is_written(self):
        """They get as far as the body, or the address, which no machine of ours has."""
        self.install('server', '--listen', '203.0.113.1', '--name', 'hall')
        self.install('robot', '--name', 'r1', '--server', 'a', '--method', 'floor', '--body', 'replay')
        self.install('robot', '--name', 'r2', '--server', 'a', '--body', 'bicycle')
        self.refused(1, ['203.0.113.1'], BIN / 'weft-server', '--config', self.folder / 'etc/weft/server.toml', '--store', self.folder / 's')
        agents = self.folder / 'etc/weft/agents'
        for file, word in (('r1.toml', 'recording'), ('r2.toml', 'bicycle')):
            code, _, wrong = self.run_command(BIN / 'weft-agent', '--config', agents / file, '--state', self.folder / 'a')
            self.assertIn(code, (1, 2))
            self.assertIn(word, wrong)


@needs('dpkg-deb')
class Machine(InFolder):
    """With an apt-get, a dpkg-query and an `id` of our own; nothing is installed."""

    def setUp(self):
        super().setUp()
        self.packages = self.folder / 'bundle/packages'
        self.packages.mkdir(parents=True)
        for name in ('weft-server', 'weft-cli', 'weft-agent', 'weft-health'):
            control = self.folder / 'made' / name / 'DEBIAN/control'
            control.parent.mkdir(parents=True)
            control.write_text(f'Package: {name}\nVersion: 0.1.0\nArchitecture: all\nMaintainer: x <x@y>\nDescription: x\n')
            self.assertEqual(self.run_command('dpkg-deb', '-b', control.parent.parent, self.packages / f'{name}_0.1.0_all.deb')[0], 0)

    def check(self, *argv, **tools):
        env = self.tools(**{'id': 'echo 0', 'apt_get': 'exit 100', 'dpkg_query': 'exit 1', **tools})
        return self.run_command(INSTALL, *argv, '--packages', self.packages, env=env)

    def test_packages_that_are_missing_are_named(self):
        code, said, _ = self.check('server', '--check')
        self.assertEqual(code, 1)
        for name in ('weft-server_0.1.0', 'weft-cli_0.1.0', 'weft-health_0.1.0'):
            self.assertRegex(said, f'not so yet: install .*{name}')

    def test_those_that_are_there_are_left_alone(self):
        _, said, _ = self.check('robot', '--name', 'r1', '--server', 'a', '--dry-run', dpkg_query='printf "installed 0.1.0"')
        self.assertIn('weft-agent is installed', said)

    def test_apts_words_are_passed_on(self):
        code, _, wrong = self.check('operator', apt_get='echo "E: Unmet dependencies"; exit 100')
        self.assertEqual(code, 1)
        self.assertIn('apt-get failed: E: Unmet dependencies', wrong)

    def test_a_damaged_archive_is_not_installed(self):
        sums = self.packages.parent / 'SHA256SUMS'
        sums.write_text(f'{"0" * 64}  packages/weft-cli_0.1.0_all.deb\n')
        code, _, wrong = self.check('operator', '--dry-run')
        self.assertEqual((code, wrong.count('\n')), (1, 1))
        self.assertIn('SHA256SUMS', wrong)


if __name__ == '__main__':
    main()
