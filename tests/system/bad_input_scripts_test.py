#!/usr/bin/python3
"""The commands of deploy/ and tests/, given what people get wrong: one clear line and an exit code, before any work."""
import os
import pathlib
import tempfile

from command import ROOT, SCRIPTS_DOMAIN, SIMULATE, Case, main

RUN = ['/usr/bin/python3', ROOT / 'deploy/demonstration/run.py']   # deploy/demo without installing and building


class Flags(Case):
    def test_the_demo_names_what_it_does_not_know(self):
        for argv, words in ((['--colour'], ['--colour']), (['--dds', 'rti'], ['--dds', 'rti']), (['--seed', 'x'], ['--seed', 'x']),
                            (['--domain', '201'], ['--domain', '201']), (['--pace', '-1'], ['--pace', '-1']),
                            (['--site', 'mars'], ['--site', 'mars', 'demo']), (['--floors', '/nowhere'], ['--floors', '/nowhere'])):
            self.refused(2, ['deploy/demo: ', *words], ROOT / 'deploy/demo', *argv)

    def test_judge_and_simulation_too(self):
        self.refused(2, ['judge: ', '--colour', '--help'], ROOT / 'tests/judge', '--colour')
        self.refused(2, ['judge: '], ROOT / 'tests/judge')
        self.refused(1, ['judge: ', '/nowhere'], ROOT / 'tests/judge', '/nowhere')
        self.refused(2, ['floor-textures: '], ROOT / 'tests/floor-textures')
        self.refused(2, ['simulate: ', '--colour', '--help'], SIMULATE, '--colour')
        self.refused(2, ['simulate: ', '--seeds', '3..1'], SIMULATE, '--seeds', '3..1')
        self.refused(2, ['simulate: ', '--robots', '201'], SIMULATE, '--robots', '201')
        self.refused(2, ['simulate: ', '--site', 'moon', 'ring', 'aisles'], SIMULATE, '--site', 'moon')

    def test_test_runner_and_installer_too(self):
        self.refused(2, ['--colour', 'usage'], ROOT / 'tests/run', '--colour')
        self.refused(2, ['--colour', 'usage'], ROOT / 'deploy/install-dependencies', '--colour')


class Site(Case):
    def test_a_demo_on_a_wrong_site_names_file_line_and_key(self):
        demo = ROOT / 'deploy/sites/demo'
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name)
            text = demo.with_suffix('.toml').read_text()
            (folder / 'wrong.toml').write_text(text.replace('seed = 11', 'sead = 11'))
            self.refused(2, ['wrong/r1.line'], *RUN, '--site', folder / 'wrong.toml', '--out', folder / 'out')
            (folder / 'wrong').mkdir()
            for line in ('r1.line', 'r2.line'):
                (folder / 'wrong' / line).write_text((demo / line).read_text())
            number = text.splitlines().index('seed = 11') + 1
            self.refused(1, ['deploy/demo: ', f'wrong.toml:{number}: floor.sead', 'logs are in'],
                         *RUN, '--site', folder / 'wrong.toml', '--out', folder / 'out', '--domain', SCRIPTS_DOMAIN)


class Packages(Case):
    """install-dependencies with an apt-get, dpkg-query, id of our own before the system's."""

    def with_tools(self, folder, **scripts):
        for name, script in scripts.items():
            tool = pathlib.Path(folder) / name.replace('_', '-')
            tool.write_text('#!/bin/sh\n' + script + '\n')
            tool.chmod(0o755)
        return dict(PATH=f'{folder}:{os.environ["PATH"]}', TMPDIR=str(folder))

    def test_a_package_that_cannot_be_had_is_named(self):
        with tempfile.TemporaryDirectory() as folder:
            env = self.with_tools(folder, id='echo 0', dpkg_query='[ "$4" = libembree-dev ] || printf installed',
                                  apt_get='[ "$1" = update ] || { echo reading; echo "E: Unable to locate package $4"; exit 100; }')
            self.refused(1, ['apt-get failed: E: Unable to locate package libembree-dev'],
                         ROOT / 'deploy/install-dependencies', env=env)

    def test_no_network_is_said_in_apts_words(self):
        with tempfile.TemporaryDirectory() as folder:
            env = self.with_tools(folder, id='echo 0', dpkg_query='exit 1',
                                  apt_get='echo "W: some"; echo "E: Failed to fetch http://deb"; exit 100')
            self.refused(1, ['apt-get failed: E: Failed to fetch'], ROOT / 'deploy/install-dependencies', env=env)

    def test_without_root_and_sudo_it_says_which_is_needed(self):
        with tempfile.TemporaryDirectory() as folder:
            env = self.with_tools(folder, id='echo 1000', dpkg_query='exit 1')
            for tool in ('bash', 'env', 'mktemp', 'dirname'):
                os.symlink(f'/usr/bin/{tool}', pathlib.Path(folder) / tool)
            env['PATH'] = folder
            self.refused(1, ['root', 'sudo'], ROOT / 'deploy/install-dependencies', env=env)

    def test_what_is_installed_is_left_alone(self):
        with tempfile.TemporaryDirectory() as folder:
            env = self.with_tools(folder, dpkg_query='printf installed', apt_get='exit 100')
            code, said, wrong = self.run_command(ROOT / 'deploy/install-dependencies', env=env)
            self.assertEqual((code, wrong), (0, ''))
            self.assertIn('all', said)


if __name__ == '__main__':
    main()
