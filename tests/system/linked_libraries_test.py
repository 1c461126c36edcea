#!/usr/bin/python3
"""What each program loads: what a robot, a server or an operator runs brings neither the simulator's libraries nor those that
OpenCV's readers of images need, a hundred and more. What they need is installed with them everywhere."""
import subprocess

from command import BIN, Case, main

READERS = ('gdal', 'opencv_imgcodecs', 'opencv_videoio', 'opencv_highgui')
SIMULATOR = ('embree',)


def libraries_of(program):
    said = subprocess.run(['ldd', str(BIN / program)], capture_output=True, text=True, timeout=60, check=True).stdout
    return [line.split()[0] for line in said.splitlines()]


def among(libraries, names):
    return [library for library in libraries if any(library.startswith(f'lib{name}') for name in names)]


class LinkedLibraries(Case):
    def test_what_is_installed_everywhere_brings_no_simulator(self):
        for program in ('weft', 'weft-server', 'weft-agent'):
            with self.subTest(program=program):
                self.assertEqual(among(libraries_of(program), READERS + SIMULATOR), [])

    def test_the_simulator_brings_only_its_own(self):
        libraries = libraries_of('weft-agent-sim')
        self.assertEqual(among(libraries, READERS), [])
        self.assertTrue(among(libraries, SIMULATOR), libraries)


if __name__ == '__main__':
    main()
