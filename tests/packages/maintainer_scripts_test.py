#!/usr/bin/python3
"""What the packages do when they are installed and removed: in a folder instead of a machine."""

from packaged import InFolder, main, needs, output, package

WITH_SCRIPTS = 'weft-server', 'weft-agent'


@needs('dpkg-deb')
class Scripts(InFolder):
    def unpack(self, name):
        if not (self.folder / name).exists():
            output('dpkg-deb', '-R', package(name), self.folder / name)
        return self.folder / name

    def test_they_are_sound_shell(self):
        for name in WITH_SCRIPTS:
            for script in ('postinst', 'prerm', 'postrm'):
                self.assertEqual(self.run_command('sh', '-n', self.unpack(name) / 'DEBIAN' / script)[0], 0)
                self.assertNotIn('@', (self.folder / name / 'DEBIAN' / script).read_text().replace('weft-agent@', ''))

    def test_purging_keeps_the_map_and_says_so(self):
        for name in WITH_SCRIPTS:
            root = self.folder / f'{name}.root'
            kept = root / 'var/lib/weft/map/map.sqlite'
            kept.parent.mkdir(parents=True)
            kept.write_text('a map')
            wants = root / 'etc/systemd/system/multi-user.target.wants'
            wants.mkdir(parents=True)
            for unit in ('weft-server.service', 'weft-agent@r1.service', 'weft-agent@r 2.service', 'ssh.service'):
                (wants / unit).symlink_to('/lib/systemd/system/any')
            script = self.unpack(name) / 'DEBIAN/postrm'
            for way in ('remove', 'purge'):
                code, said, wrong = self.run_command(script, way, env={'DPKG_ROOT': str(root)})
                self.assertEqual((code, wrong), (0, ''))
                self.assertIn(f'{root}/var/lib/weft stays', said)
                self.assertEqual(kept.read_text(), 'a map')
            left = sorted(path.name for path in wants.iterdir())
            others = ['weft-agent@r 2.service', 'weft-agent@r1.service'] if name == 'weft-server' else ['weft-server.service']
            self.assertEqual(left, ['ssh.service', *others])

    def test_nothing_in_any_script_removes_state(self):
        for name in WITH_SCRIPTS:
            for script in ('postinst', 'prerm', 'postrm'):
                for line in (self.unpack(name) / 'DEBIAN' / script).read_text().splitlines():
                    if ' rm ' in f' {line} ':
                        self.assertNotIn('var/lib', line)
                        self.assertNotIn('-r', line.split())

    def test_installing_makes_user_and_folders(self):
        for name in WITH_SCRIPTS:
            env = self.tools(systemd_sysusers=f'echo users "$@" >>{self.folder}/did', systemd_tmpfiles=f'echo folders "$@" >>{self.folder}/did')
            (self.folder / 'did').unlink(missing_ok=True)
            self.assertEqual(self.run_command(self.unpack(name) / 'DEBIAN/postinst', 'configure', '', env=env)[0], 0)
            self.assertEqual((self.folder / 'did').read_text(), f'users {name}.conf\nfolders --create {name}.conf\n')

    @needs('systemd-sysusers')
    def test_the_user_is_made_by_the_systems_own_tool(self):
        tree = self.unpack('weft-server')
        (tree / 'etc').mkdir(exist_ok=True)
        self.assertEqual(self.run_command('systemd-sysusers', f'--root={tree}', 'weft-server.conf')[0], 0)
        self.assertRegex((tree / 'etc/passwd').read_text(), r'(?m)^weft:x:\d+:\d+:Weft:/var/lib/weft:/usr/sbin/nologin$')

    @needs('fakeroot')
    def test_a_whole_life_in_dpkgs_own_hands(self):
        """Installed, removed, purged by dpkg in a folder; only what the packages depend on is not asked for."""
        root = self.folder / 'root'
        (root / 'var/lib/dpkg').mkdir(parents=True)
        for file in ('status', 'available'):
            (root / 'var/lib/dpkg' / file).touch()
        env = self.tools(systemd_sysusers='', systemd_tmpfiles='mkdir -p "$DPKG_ROOT/var/lib/weft"; echo map >"$DPKG_ROOT/var/lib/weft/map"')

        def dpkg(*words):
            code, said, wrong = self.run_command('fakeroot', 'dpkg', f'--root={root}', '--log=/dev/null', '--force-script-chrootless',
                                                 '--force-depends', '--force-not-root', *words, env=env, seconds=120)
            self.assertEqual(code, 0, said + wrong)
            return said

        dpkg('--install', package('weft-server'))
        self.assertTrue((root / 'usr/bin/weft-server').is_file())
        (root / 'etc/weft/server.toml').write_text('listen = "10.0.0.5"\n')
        dpkg('--remove', 'weft-server')
        self.assertFalse((root / 'usr/bin/weft-server').exists())
        self.assertTrue((root / 'etc/weft/server.toml').is_file())
        self.assertIn('var/lib/weft stays', dpkg('--purge', 'weft-server'))
        self.assertFalse((root / 'etc/weft/server.toml').exists())
        self.assertEqual((root / 'var/lib/weft/map').read_text(), 'map\n')


if __name__ == '__main__':
    main()
