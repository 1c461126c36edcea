#!/usr/bin/python3
"""Each program of Weft, given what people get wrong: one clear line and an exit code. What weft-server does with wrong
flags, settings, stores and ports is in tests/server/process_test.cpp."""
import math
import pathlib
import re
import sqlite3
import struct
import tempfile
import zlib

from command import BIN, NOBODYS_DOMAIN, PROGRAMS_DOMAIN as DOMAIN, ROOT, Case, Running, main, simulated_agent

DEMO = ROOT / 'deploy/sites/demo.toml'


def png(path, width, height):
    rows = b''.join(b'\0' + bytes((17 * r * r + 31 * c * (r + c)) % 251 for c in range(width)) for r in range(height))

    def chunk(kind, data):
        return struct.pack('>I', len(data)) + kind + data + struct.pack('>I', zlib.crc32(kind + data))
    path.write_bytes(b'\x89PNG\r\n\x1a\n' + chunk(b'IHDR', struct.pack('>IIBBBBB', width, height, 8, 0, 0, 0, 0)) +
                     chunk(b'IDAT', zlib.compress(rows)) + chunk(b'IEND', b''))


def recording(folder, focal=460, size=(752, 480)):
    """Three images of 752 x 480 from a camera that looks ahead and down."""
    camera = pathlib.Path(folder) / 'recording/mav0/cam0'
    (camera / 'data').mkdir(parents=True)
    for name in 'abc':
        png(camera / f'data/{name}.png', 752, 480)
    (camera / 'data.csv').write_text('#timestamp [ns],filename\n1000000000,a.png\n1050000000,b.png\n1100000000,c.png\n')
    s, c = math.sin(0.735), math.cos(0.735)
    mount = [0, -s, c, 0.25, -1, 0, 0, 0, 0, -c, -s, 0.6, 0, 0, 0, 1]
    (camera / 'sensor.yaml').write_text(
        f'camera_model: pinhole\nresolution: [{size[0]}, {size[1]}]\nintrinsics: [{focal}, {focal}, 375.5, 239.5]\n'
        'distortion_model: radial-tangential\ndistortion_coefficients: [-0.08, 0.01, 0.0004, -0.0003]\n'
        f'T_BS:\n  cols: 4\n  rows: 4\n  data: [{", ".join(repr(float(v)) for v in mount)}]\n')
    return camera


class WithFolder(Case):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def simulated(self, site, *more):
        return simulated_agent('r1', self.folder / 'state', site, '--domain', DOMAIN, *more)

    def replay(self):
        return [BIN / 'weft-agent', '--name', 'r1', '--state', self.folder / 'state', '--domain', DOMAIN,
                '--recording', self.folder / 'recording', '--pace', '0']


class Flags(Case):
    def test_unknown_flags_are_named(self):
        for program in ('weft', 'weft-server', 'weft-agent', 'weft-agent-sim', 'weft-evaluate'):
            self.refused(2, [f'{program}: ', '--colour', '--help'], BIN / program, '--colour')
        self.refused(2, ['--colour'], BIN / 'weft', 'robots', '--colour')
        self.refused(2, ['--colour'], BIN / 'weft-evaluate', 'disturbances', '--colour')

    def test_values_out_of_bounds_are_named(self):
        self.refused(2, ['--domain', '201'], BIN / 'weft', 'robots', '--domain', '201')
        self.refused(2, ['domain', '201'], *simulated_agent('r1', '/tmp', DEMO, '--domain', '201'))
        self.refused(2, ['--seeds', '9..2'], BIN / 'weft-evaluate', 'disturbances', '--seeds', '9..2')


class Settings(WithFolder):
    """What is wrong with settings stays so: exit code 2, after which a service manager starts the program no more."""

    def refuses(self, text, words, *argv):
        file = self.folder / 'settings.toml'
        file.write_text(text)
        self.refused(2, [str(file), *words], *argv, '--config', file)

    def test_each_program_names_file_key_and_what_to_do(self):
        server = [BIN / 'weft-server', '--store', self.folder / 'store', '--domain', DOMAIN]
        agent = [BIN / 'weft-agent', '--state', self.folder / 'state', '--recording', self.folder]
        for program in (server, agent, self.simulated(DEMO)):
            self.refuses('name = "a"\ndomian = 3\n', [':2: domian: unknown key; there are ', ' domain, '], *program)
            self.refuses('name = "a"\nmetrics = 65536\n', [':2: metrics = 65536', '65535'], *program)
            self.refuses('name = "a\n', [':1: no TOML'], *program)
            for file in (self.folder / 'gone.toml', self.folder):
                self.refused(2, [f'{file}: cannot be read'], *program, '--config', file)

    def test_files_that_settings_name_are_named(self):
        site, camera = self.folder / 'site.toml', self.folder / 'camera.yaml'
        camera.write_text('resolution: [0, 0]\n')
        agent = [BIN / 'weft-agent-sim', '--state', self.folder / 'state']
        settings = self.folder / 'agent.toml'
        for text, words in ((f'site = "{site}"', [str(site), 'no such site']),
                            (f'site = "{DEMO}"\ncalibration = "{camera}.gone"', [f'{camera}.gone', 'no such camera file']),
                            (f'site = "{DEMO}"\ncalibration = "{camera}"', [str(camera)])):
            settings.write_text(f'name = "r1"\n{text}\n')
            self.refused(2, words, *agent, '--config', settings)


class WithoutSimulator(WithFolder):
    def test_flags_of_the_simulator_name_the_program_that_has_it(self):
        says = ['weft-agent: ', 'site', 'no body sim in this program; start weft-agent-sim, with the same words']
        self.refused(2, says, BIN / 'weft-agent', '--name', 'r1', '--state', self.folder / 'state', '--site', DEMO)
        line = self.folder / 'a.line'
        line.write_text('0 0\n5 0\n')
        self.refused(1, ['weft-agent: ', 'start weft-agent-sim'], BIN / 'weft', 'calibrate', 'mount', '--site', DEMO, '--name', 'r1',
                     '--along', line)


class Sites(WithFolder):
    def sites(self):
        """Wrong site files, with the words that must be said about them."""
        text = DEMO.read_text()
        unknown = self.folder / 'unknown.toml'
        unknown.write_text(text.replace('seed = 11', 'sead = 11'))
        out = self.folder / 'bounds.toml'
        out.write_text(text.replace('x_max = 20.0', 'x_max = 2e6'))
        both = self.folder / 'both.toml'
        both.write_text(text.replace('seed = 11', 'sead = 11').replace('x_max = 20.0', 'x_max = 2e6'))
        line = {word: next(i for i, row in enumerate(text.splitlines(), 1) if row.startswith(word)) for word in ('seed =', 'x_max')}
        wrong_key = f':{line["seed ="]}: floor.sead'
        wrong_value = f':{line["x_max"]}: floor.x_max'
        return [(unknown, ['unknown.toml' + wrong_key]), (out, ['bounds.toml' + wrong_value, '1000']),
                (both, [wrong_key, wrong_value]), (self.folder / 'missing.toml', ['missing.toml', 'no such site'])]

    def test_the_agent_names_file_line_and_key(self):
        for site, words in self.sites():
            self.refused(2, ['weft-agent-sim: ', *words], *self.simulated(site))

    def test_the_evaluation_names_file_line_and_key(self):
        for site, words in self.sites():
            self.refused(2, ['weft-evaluate: ', *words],
                         BIN / 'weft-evaluate', 'disturbances', '--site', site, '--out', self.folder / 'out')


class Interruption(WithFolder):
    def test_an_interrupted_study_says_how_to_go_on(self):
        with Running(self.folder / 'log', BIN / 'weft-evaluate', 'disturbances', '--site', DEMO, '--out', self.folder / 'out') as study:
            self.assertTrue(study.says('0 of them are there already'), study.text())
            self.assertEqual(study.stop(), 130, study.text())
            self.assertIn('the same command goes on from there', study.text())


class Recordings(WithFolder):
    def test_a_damaged_image_is_dropped_and_named(self):
        images = recording(self.folder) / 'data'
        whole = (images / 'b.png').read_bytes()
        (images / 'b.png').write_bytes(whole[:len(whole) // 2])
        with Running(self.folder / 'log', *self.replay()) as agent:
            self.assertTrue(agent.says('recording is over after 3 images'), agent.text())
            self.assertRegex(agent.text(), r'b\.png: .*the frame is dropped')
            self.assertNotRegex(agent.text(), r'[ac]\.png')
            self.assertEqual(agent.stop(), 1)
            self.assertIn('1 of them dropped', agent.text().splitlines()[-1])

    def test_images_that_do_not_match_the_calibration_are_dropped_and_named(self):
        recording(self.folder, size=(640, 480))
        with Running(self.folder / 'log', *self.replay()) as agent:
            self.assertTrue(agent.says('recording is over after 3 images'), agent.text())
            self.assertEqual(len(re.findall(r'\w\.png: is 752 x 480 pixels, its calibration says 640 x 480', agent.text())), 3)
            self.assertEqual(agent.stop(), 1)

    def test_a_calibration_without_focal_length_is_refused(self):
        recording(self.folder, focal=0)
        self.refused(2, ['weft-agent: ', 'sensor.yaml:', 'focal lengths must be'], *self.replay())


class Photographs(WithFolder):
    def test_a_damaged_photograph_of_a_floor_is_named(self):
        floors = self.folder / 'floors'
        floors.mkdir()
        (floors / 'hall.png').write_bytes(b'no picture')
        (floors / 'hall.png.toml').write_text('mm_per_pixel = 0.5\n')
        self.refused(1, ['weft-agent-sim: ', 'hall.png', 'begins as no picture'], *self.simulated(DEMO, '--floors', floors))

    def test_a_folder_without_photographs_is_named(self):
        self.refused(2, ['weft-agent-sim: ', str(self.folder), 'no .png or .jpg'], *self.simulated(DEMO, '--floors', self.folder))


class Peers(WithFolder):
    def test_an_unreachable_server_is_exit_three_with_advice(self):
        self.refused(3, ['no server', '--domain', 'weft-server'], BIN / 'weft', '--domain', NOBODYS_DOMAIN, '--timeout', '1', 'robots')

    def test_an_agent_without_server_says_so_and_goes_on(self):
        argv = self.simulated(DEMO, '--server', '127.0.0.1:7', '--pace', '1')
        with Running(self.folder / 'log', *argv) as agent:
            self.assertTrue(agent.says(f'no server is heard at 127.0.0.1:7, domain {DOMAIN}'), agent.text())
            self.assertEqual(agent.stop(), 0, agent.text())


class Stores(WithFolder):
    def test_a_store_from_a_newer_version_is_left_alone(self):
        server = [BIN / 'weft-server', '--store', self.folder / 'store', '--domain', DOMAIN]
        with Running(self.folder / 'log', *server) as running:
            self.assertTrue(running.says('ready'), running.text())
            self.assertEqual(running.stop(), 0)
        with sqlite3.connect(self.folder / 'store/map.sqlite') as database:
            ours = database.execute('PRAGMA user_version').fetchone()[0]
            database.execute('PRAGMA user_version = 77')
        self.refused(1, ['weft-server: ', 'map.sqlite', '77', f'up to {ours}'], *server)


if __name__ == '__main__':
    main()
