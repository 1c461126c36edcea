#!/usr/bin/python3
"""Robots with a stereo pair, robots that look down, and robots with both, through the whole service: an aisle, a loop that meets
it and a lane seen from below are taught one after the other; a robot with both cameras, taught nothing, is sent over all three,
past a crate that was not there, while the server dies once. The simulation's truth says where it came to stand, and what it
touched."""
import json
import math
import pathlib
import tempfile

from command import BIN, ROOT, TOPOMETRIC_DOMAIN as DOMAIN, Fleet, Running, main, simulated_agent

SCENE = ROOT / 'deploy/sites/topometric'


class TopometricFleet(Fleet):
    domain = DOMAIN

    def agent(self, name, method, vendor, *more):
        return simulated_agent(name, self.folder / name, SCENE / 'fleet.toml', '--method', method, '--domain', DOMAIN,
                               '--dds', vendor, '--truth', self.truth(name), '--pace', '2', *more)

    def truth(self, name):
        return self.folder / f'{name}.jsonl'

    def server(self, run):
        return Running(self.folder / f'server{run}.log', BIN / 'weft-server', '--store', self.folder / 'map', '--domain', DOMAIN,
                       '--dds', 'cyclonedds')

    def stitches(self):
        return json.loads(self.weft('map', 'info', '--json'))['stitches']

    def is_taught(self, name, method, vendor, label=None):
        with Running(self.folder / f'{name}.log', *self.agent(name, method, vendor)) as robot:
            self.ready(robot, name)
            self.weft('teach', name, 'start', '--as', name, '--along', SCENE / f'fleet-{name}.line')
            self.poll(lambda said: 'hand_done' in said, 300, 'robots')
            if label:
                self.weft('map', 'label', 'here', '--robot', name, label)
            self.weft('teach', name, 'stop')
            self.assertEqual(robot.stop(), 0, robot.text()[-3000:])
        self.weft('robot', 'clear', name)
        return self.pose(self.truth(name))

    def touched(self, name):
        return [step['touch'] for step in map(json.loads, self.truth(name).read_text().splitlines()) if step.get('touch')]

    def test_over_what_three_robots_have_seen(self):
        with tempfile.TemporaryDirectory() as name:
            self.folder = pathlib.Path(name)
            with self.server(1) as server:
                dock = self.is_taught('r1', 'topometric', 'fastdds', label='dock')
                self.is_taught('r2', 'topometric', 'cyclonedds')
                self.assertGreater(self.stitches(), 0, 'the loop meets the aisle')
                self.is_taught('r5', 'floor', 'fastdds')
                self.is_taught('r3', 'floor,topometric', 'cyclonedds')
                with Running(self.folder / 'r4.log',
                             *self.agent('r4', 'floor,topometric', 'fastdds', '--day', '1')) as robot:
                    self.ready(robot, 'r4')
                    self.poll(lambda said: ':' in said.split('r4 ')[-1], 90, 'robots')
                    self.weft('goal', 'send', '--to', 'dock', '--robot', 'r4', '--no-return')
                    self.poll(lambda said: 'driving' in said, 60, 'robots')
                    server.child.kill()
                    server.child.wait()
                    with self.server(2):
                        self.poll(lambda said: 'succeeded' in said or 'failed' in said, 600, 'goal', 'list')
                        self.assertIn('succeeded', self.weft('goal', 'list'), robot.text()[-3000:])
                        self.assertEqual(robot.stop(), 0)
            x, y, heading = self.pose(self.truth('r4'))
            self.assertLess(math.hypot(x - dock[0], y - dock[1]), 0.2)
            self.assertEqual(self.touched('r4'), [])


if __name__ == '__main__':
    main()
