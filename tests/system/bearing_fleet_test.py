#!/usr/bin/python3
"""One uncalibrated camera that looks ahead, through the whole service: a robot is taught a loop over DDS, a spot of it is
labelled, the robot is sent there, and the simulation's truth says where it came to stand. Each program of another DDS
vendor; nobody but this test knows the truth."""
import math
import pathlib
import re
import tempfile

from command import BEARING_DOMAIN as DOMAIN, BIN, ROOT, Fleet, Running, main, simulated_agent

SCENES = ROOT / 'deploy/sites/bearing'


def is_some_way_on(robots):
    """The robot has kept a dozen places at least: EXPERIENCE:INDEX."""
    place = re.search(r'r1 .*:([0-9]+) ', robots)
    return place is not None and int(place.group(1)) >= 12


class BearingFleet(Fleet):
    domain = DOMAIN
    vendor = 'fastdds'

    def test_taught_labelled_sent(self):
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name)
            truth = folder / 'truth.jsonl'
            server = [BIN / 'weft-server', '--store', folder / 'map', '--domain', DOMAIN, '--dds', 'fastdds']
            agent = simulated_agent('r1', folder / 'r1', SCENES / 'oval.toml', '--method', 'bearing', '--domain', DOMAIN,
                                    '--dds', 'cyclonedds', '--truth', truth, '--pace', '2')
            with Running(folder / 'server.log', *server), Running(folder / 'agent.log', *agent) as robot:
                self.ready(robot, 'r1')
                self.weft('teach', 'r1', 'start', '--as', 'oval', '--along', SCENES / 'oval.line')
                self.poll(is_some_way_on, 60, 'robots')
                self.weft('map', 'label', 'here', '--robot', 'r1', 'shelf')
                shelf = self.pose(truth)
                self.poll(lambda said: 'hand_done' in said, 120, 'robots')
                self.weft('teach', 'r1', 'stop')
                info = self.weft('map', 'info')
                self.assertRegex(info, r'stitches +1\b', 'the loop is closed')
                self.weft('goal', 'send', '--to', 'shelf', '--robot', 'r1')
                self.poll(lambda said: 'succeeded' in said, 120, 'goal', 'list')
                x, y, heading = self.pose(truth)
                # The robot was rolling when the place was kept: up to a spacing on.
                self.assertLess(math.hypot(x - shelf[0], y - shelf[1]), 0.3)
                turned = math.remainder(heading - shelf[2], 2 * math.pi)
                self.assertLess(abs(turned), 0.3)
                self.assertEqual(robot.stop(), 0)


if __name__ == '__main__':
    main()
