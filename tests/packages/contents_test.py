#!/usr/bin/python3
"""What the Debian packages have in them, and what they ask for."""
import re

from packaged import Case, main, needs, output, package

MUST_HAVE = {
    'weft-server': ['usr/bin/weft-server', 'etc/weft/server.toml', 'etc/weft/backup.conf', 'usr/lib/weft/backup',
                    'lib/systemd/system/weft-server.service', 'lib/systemd/system/weft-backup.service',
                    'lib/systemd/system/weft-backup.timer', 'usr/lib/sysusers.d/weft-server.conf', 'usr/lib/tmpfiles.d/weft-server.conf',
                    'usr/share/weft/monitoring/weft.rules.yml', 'usr/share/weft/monitoring/dashboard.json',
                    'usr/share/weft/monitoring/prometheus.yml', 'usr/share/weft/network/weft.nft',
                    'usr/share/doc/weft-server/headers.gz'],
    'weft-agent': ['usr/bin/weft-agent', 'etc/weft/agents/', 'lib/systemd/system/weft-agent@.service',
                   'usr/lib/sysusers.d/weft-agent.conf', 'usr/lib/tmpfiles.d/weft-agent.conf',
                   'usr/share/doc/weft-agent/examples/agent.toml', 'usr/share/doc/weft-agent/headers.gz'],
    'weft-agent-sim': ['usr/bin/weft-agent-sim', 'usr/share/weft/sites/demo.toml', 'usr/share/doc/weft-agent-sim/headers.gz'],
    'weft-health': ['usr/bin/weft-health', 'usr/share/doc/weft-health/headers.gz'],
    'weft-cli': ['usr/bin/weft', 'usr/share/doc/weft-cli/headers.gz'],
    'weft-doc': ['usr/share/doc/weft-doc/README.md', 'usr/share/doc/weft-doc/docs/operating.md'],
}


@needs('dpkg-deb')
class Contents(Case):
    def rows(self, name):
        """(mode, owner, path) of all that the package has."""
        for line in output('dpkg-deb', '-c', package(name)).splitlines():
            words = line.split(None, 5)
            yield words[0], words[1], words[5].removeprefix('./')

    def test_each_has_its_programs_units_settings_and_licences(self):
        for name, files in MUST_HAVE.items():
            paths = {path for _, _, path in self.rows(name)}
            for path in [*files, f'usr/share/doc/{name}/copyright', f'usr/share/doc/{name}/changelog.gz']:
                self.assertIn(path, paths, name)

    def test_no_file_is_in_two_packages(self):
        owner = {}
        for name in MUST_HAVE:
            for _, _, path in self.rows(name):
                if not path.endswith('/'):
                    self.assertNotIn(path, owner, name)
                    owner[path] = name

    def test_all_is_roots_and_nobody_else_may_write(self):
        for name in MUST_HAVE:
            for mode, owner, path in self.rows(name):
                self.assertEqual(owner, 'root/root', path)
                self.assertRegex(mode, r'^[-d]rw.r-.r-.$', path)

    def test_what_people_edit_is_theirs(self):
        said = output('dpkg-deb', '-I', package('weft-server'), 'conffiles').split()
        self.assertEqual(said, ['/etc/weft/server.toml', '/etc/weft/backup.conf'])

    def test_programs_ask_for_the_libraries_that_they_load(self):
        for name, libraries in (('weft-server', ('libc6', 'libsqlite3-0', 'libfastrtps', 'libprometheus-cpp-core', 'libcpp-httplib')),
                                ('weft-agent', ('libc6', 'libopencv-core', 'libprometheus-cpp-core', 'libcpp-httplib')),
                                ('weft-cli', ('libc6', 'libfastrtps', 'libpcl-filters1.13'))):
            depends = output('dpkg-deb', '-f', package(name), 'Depends')
            for library in libraries:
                self.assertRegex(depends, rf'\b{re.escape(library)}', name)

    def test_services_bring_the_commands_that_they_use_of_the_same_version(self):
        for name, brought in (('weft-server', 'weft-cli'), ('weft-server', 'weft-health'), ('weft-agent', 'weft-health')):
            version = output('dpkg-deb', '-f', package(name), 'Version').strip()
            self.assertIn(f'{brought} (= {version})', output('dpkg-deb', '-f', package(name), 'Depends'))

    def test_what_is_compiled_in_from_headers_has_its_licence_there(self):
        with_licences = output('sh', '-c', f'dpkg-deb --fsys-tarfile {package("weft-cli")} | tar xO ./usr/share/doc/weft-cli/headers.gz | zcat')
        for library in ('libcli11-dev', 'libeigen3-dev', 'nlohmann-json3-dev', 'libtomlplusplus-dev'):
            self.assertIn(f'==== {library}\n', with_licences)


@needs('lintian')
class Policy(Case):
    def test_lintian_knows_of_no_error(self):
        _, said, wrong = self.run_command('lintian', '--fail-on', 'none', package('weft-server'), seconds=300)
        self.assertNotIn('E: ', said + wrong)


if __name__ == '__main__':
    main()
