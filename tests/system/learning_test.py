#!/usr/bin/python3
"""Places that learn, through the whole service: a robot that drives by what it was taught hands in what it has seen anew,
the fleet's map takes it as a revision of its own, and an operator takes it back, of a server that has been restarted since."""
import json
import pathlib
import re
import tempfile

from command import BIN, LEARNING_DOMAIN as DOMAIN, ROOT, Fleet, Running, main, simulated_agent

SCENES = ROOT / 'deploy/sites/bearing'


class Learning(Fleet):
    domain = DOMAIN

    def server(self):
        return Running(self.folder / 'server.log', BIN / 'weft-server', '--store', self.folder / 'map', '--domain', DOMAIN,
                       '--dds', 'cyclonedds')

    def lessons(self):
        """Revisions by which places were known better, oldest first."""
        return sorted(row['revision'] for row in json.loads(self.weft('map', 'log', '--json'))['revisions'] if row['kind'] == 'learned')

    def newest(self):
        return max(row['revision'] for row in json.loads(self.weft('map', 'log', '--json'))['revisions'])

    def all_lessons(self, robot):
        """Of a robot that stands again: as many as it says that it has handed in."""
        self.poll(lambda said: 'idle' in said, 60, 'robots')
        handed_in = robot.text().count('places better: handed in')
        self.assertGreater(handed_in, 0, robot.text()[-3000:])
        self.poll(lambda said: sum(row['kind'] == 'learned' for row in json.loads(said)['revisions']) == handed_in, 60, 'map', 'log',
                  '--json')
        return self.lessons()

    def places_anew(self, since):
        found = re.search(r'places known anew: ([0-9]+)', self.weft('map', 'diff', str(since)))
        return int(found.group(1)) if found else 0

    def drives_to(self, label, robot):
        goal = json.loads(self.weft('goal', 'send', '--to', label, '--robot', 'r1', '--json'))['goal']

        def state(said):
            return next(row['state'] for row in json.loads(said)['goals'] if row['id'] == goal)

        self.poll(lambda said: state(said) in ('succeeded', 'failed'), 150, 'goal', 'list', '--json')
        self.assertEqual(state(self.weft('goal', 'list', '--json')), 'succeeded', robot.text()[-3000:])

    def test_what_a_drive_has_taught_is_a_revision_and_is_taken_back(self):
        with tempfile.TemporaryDirectory() as name:
            self.folder = pathlib.Path(name)
            agent = simulated_agent('r1', self.folder / 'r1', SCENES / 'oval.toml', '--method', 'bearing',
                                    '--domain', DOMAIN, '--dds', 'fastdds', '--pace', '3')
            with Running(self.folder / 'r1.log', *agent) as robot:
                with self.server():
                    self.ready(robot, 'r1')
                    self.weft('teach', 'r1', 'start', '--as', 'oval', '--along', SCENES / 'oval.line')
                    self.poll(lambda said: ':' in said.split('r1 ')[-1], 60, 'robots')
                    self.weft('map', 'label', 'here', '--robot', 'r1', 'first')
                    self.poll(lambda said: 'hand_done' in said, 120, 'robots')
                    self.weft('map', 'label', 'here', '--robot', 'r1', 'last')
                    self.weft('teach', 'r1', 'stop')
                    taught = self.newest()
                    self.assertEqual(self.lessons(), [], 'a hand leads: nothing is learned')
                    self.drives_to('first', robot)
                    self.drives_to('last', robot)
                    learned = self.all_lessons(robot)
                    known_anew = self.places_anew(taught)
                    self.assertGreater(known_anew, 0)
                with self.server():
                    self.ready(robot, 'r1')
                    self.assertEqual(self.places_anew(taught), known_anew, 'lessons outlive the server')
                    for revision in reversed(learned):
                        self.weft('map', 'undo', '--revision', str(revision))
                    self.assertEqual(self.places_anew(taught), 0, 'the places are what was taught')
                    self.assertEqual(self.lessons(), learned, 'and the log keeps what was')
                    self.drives_to('first', robot)
                    self.assertEqual(robot.stop(), 0, robot.text())
                    self.weft('map', 'check')


if __name__ == '__main__':
    main()
