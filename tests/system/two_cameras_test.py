#!/usr/bin/python3
"""A fleet of robots that look down, ahead, and both ways, through the whole service: a part of the hall is taught to each
kind, a robot with both cameras joins the parts, and another one, which was taught nothing, is sent from one to the other."""
import math
import pathlib
import tempfile

from command import BIN, ROOT, TWO_CAMERAS_DOMAIN as DOMAIN, Fleet, Running, main, method_that_looks, simulated_agent

SCENE = ROOT / 'deploy/sites/two-cameras'


class TwoCameras(Fleet):
    domain = DOMAIN

    def agent(self, name, method, vendor):
        return simulated_agent(name, self.folder / name, SCENE / 'hall.toml', '--method', method,
                               '--domain', DOMAIN, '--dds', vendor, '--truth', self.folder / f'{name}.jsonl', '--pace', '3')

    def is_taught(self, name, method, vendor, run, label=None):
        with Running(self.folder / f'{name}.log', *self.agent(name, method, vendor)) as robot:
            self.ready(robot, name)
            if ',' in method:
                self.poll(lambda said: name in said and 'PLACE' in said and ':' in said.split(name)[1], 60, 'robots')
            self.weft('teach', name, 'start', '--as', run, '--along', SCENE / f'{run}.line')
            self.poll(lambda said: 'hand_done' in said, 120, 'robots')
            if label:
                self.weft('map', 'label', 'here', '--robot', name, label)
            self.weft('teach', name, 'stop')
            self.assertEqual(robot.stop(), 0, robot.text())
        self.weft('robot', 'clear', name)
        return self.pose(self.folder / f'{name}.jsonl')

    def test_a_route_by_one_method_and_then_by_the_other(self):
        down, ahead = method_that_looks('down'), method_that_looks('ahead')
        if not (down and ahead):
            self.skipTest('no method looks ahead, or none down')
        both = f'{down},{ahead}'
        with tempfile.TemporaryDirectory() as name:
            self.folder = pathlib.Path(name)
            server = [BIN / 'weft-server', '--store', self.folder / 'map', '--domain', DOMAIN, '--dds', 'cyclonedds']
            with Running(self.folder / 'server.log', *server):
                self.is_taught('r1', down, 'fastdds', 'first')
                goal = self.is_taught('r2', ahead, 'cyclonedds', 'second', label='far-end')
                self.is_taught('r3', both, 'fastdds', 'crossing')
                self.assertRegex(self.weft('map', 'info'), r'experiences +4\b')
                with Running(self.folder / 'r4.log', *self.agent('r4', both, 'cyclonedds')) as robot:
                    self.ready(robot, 'r4')
                    self.poll(lambda said: ':' in said.split('r4 ')[-1], 60, 'robots')
                    self.weft('goal', 'send', '--to', 'far-end', '--robot', 'r4', '--no-return')
                    self.poll(lambda said: 'succeeded' in said or 'failed' in said, 150, 'goal', 'list')
                    self.assertIn('succeeded', self.weft('goal', 'list'), robot.text()[-3000:])
                    x, y, heading = self.pose(self.folder / 'r4.jsonl')
                    self.assertLess(math.hypot(x - goal[0], y - goal[1]), 0.2)
                    self.assertLess(abs(math.remainder(heading - goal[2], 2 * math.pi)), 0.2)
                    self.assertEqual(robot.stop(), 0)


if __name__ == '__main__':
    main()
