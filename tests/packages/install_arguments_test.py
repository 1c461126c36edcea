#!/usr/bin/python3
"""deploy/install, deploy/package and deploy/bundle, given what people get wrong: one line, before anything is done."""
from packaged import ROOT, InFolder, main

INSTALL = ROOT / 'deploy/install'


class Refused(InFolder):
    def test_wrong_usage_is_told_in_one_line_before_anything_is_done(self):
        robot = ['robot', '--name', 'r1', '--server', 'a']
        for argv, words in (([], ['server', 'robot', 'operator']), (['fleet'], ['fleet']), (['server', '--colour'], ['--colour']),
                            (['server', '--listen'], ['--listen', 'value']), (['server', '--listen', '../x'], ['--listen']),
                            (['server', '--listen', 'a b'], ['--listen']), (['server', '--listen', 'a"'], ['--listen']),
                            (['server', '--domain', '201'], ['--domain', '200']), (['server', '--domain', '-1'], ['--domain']),
                            (['server', '--domain', '007'], ['--domain']), (['server', '--dds', 'rti'], ['--dds', 'cyclonedds']),
                            (['server', '--keep', '0'], ['--keep', '1000']), (['operator', '--keep', '3'], ['--keep', 'server']),
                            (['server', '--server', 'a'], ['--server', 'robot']), (['operator', '--name', 'x'], ['--name']),
                            (['robot', '--name', 'r1'], ['--server']), (['robot', '--server', 'a'], ['--name']),
                            (['robot', '--name', 'a/b', '--server', 'a'], ['--name']),
                            (['robot', '--name', '.r', '--server', 'a'], ['--name']),
                            (['robot', '--name', 'r' * 65, '--server', 'a'], ['--name', '65']),
                            (['robot', '--name', 'süd', '--server', 'a'], ['--instance']),
                            ([*robot, '--instance', '../r'], ['--instance']), ([*robot, '--method', 'floor;x'], ['--method']),
                            ([*robot, '--calibration', '/nowhere.yaml'], ['--calibration', '/nowhere.yaml']),
                            ([*robot, '--packages', '/nowhere'], ['--packages', '/nowhere']),
                            ([*robot, '--root', '/nowhere'], ['--root', '/nowhere'])):
            self.refused(2, ['install: ', *words, 'see install --help'], INSTALL, *argv)

    def test_the_builders_too(self):
        self.refused(2, ['deploy/package: ', '--colour', 'usage'], ROOT / 'deploy/package', '--colour')
        self.refused(2, ['deploy/bundle: ', '--colour', 'usage'], ROOT / 'deploy/bundle', '--colour')
        self.refused(2, ['deploy/bundle: ', '.tar'], ROOT / 'deploy/bundle', 'out.zip')
        self.refused(1, ['deploy/package: ', '/nowhere', 'CPackConfig'], ROOT / 'deploy/package', '--build', '/nowhere')
        self.refused(1, ['deploy/bundle: ', 'weft-*.deb'], ROOT / 'deploy/bundle', '--packages', self.folder, self.folder / 'out.tar')

    def test_who_is_not_root_is_told(self):
        self.refused(1, ['root'], INSTALL, 'server', env=self.tools(id='echo 1000'))

    def test_a_folder_without_packages_is_named(self):
        self.refused(1, [str(self.folder), 'weft-agent_'], INSTALL, 'robot', '--name', 'r1', '--server', 'a', '--packages', self.folder,
                     env=self.tools(id='echo 0'))


if __name__ == '__main__':
    main()
