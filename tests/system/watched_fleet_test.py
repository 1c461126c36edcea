#!/usr/bin/python3
"""What an operator sees of a real server and a real agent whose machine dies and comes back: events as they happen, alarms
with cause and cure, and one archive of everything."""
import io
import json
import pathlib
import signal
import tarfile
import tempfile
import time

from command import BIN, ROOT, WATCHED_DOMAIN, Fleet, Running, main, simulated_agent

SILENT_S = 60


class WatchedFleet(Fleet):
    domain = WATCHED_DOMAIN

    def setUp(self):
        self.folder = pathlib.Path(self.enterContext(tempfile.TemporaryDirectory()))
        self.common = ('--domain', self.domain, '--dds', self.vendor)
        server = self.start('server', BIN / 'weft-server', '--store', self.folder / 'map', *self.common)
        self.assertTrue(server.says('ready'), server.text())

    def start(self, name, *argv):
        return self.enterContext(Running(self.folder / f'{name}.log', *argv))

    def robot(self, name):
        running = self.start(name, *simulated_agent('r1', self.folder / 'r1', ROOT / 'deploy/sites/demo.toml', *self.common))
        self.ready(running, 'r1')
        return running

    def events(self, running):
        """What a follower has printed until now."""
        lines = running.text().splitlines()
        return [json.loads(line) for line in lines if line.startswith('{') and line.endswith('}')]

    def sees(self, running, kind):
        end = time.monotonic() + SILENT_S
        while not any(event['kind'] == kind for event in self.events(running)):
            self.assertLess(time.monotonic(), end, f'no {kind} in {SILENT_S} s:\n{running.text()}')
            time.sleep(0.1)

    def alarms(self):
        """The kinds of r1's alarms, and all as documents; the machine's disk is not this test's."""
        ended, said, wrong = self.run_command(BIN / 'weft', *self.common, 'alarms', '--json')
        self.assertEqual(wrong, '')
        alarms = json.loads(said)['alarms']
        self.assertEqual(ended, 1 if alarms else 0, said)
        return [alarm for alarm in alarms if alarm['robot'] == 'r1']

    def until_alarms(self, kinds):
        end = time.monotonic() + SILENT_S
        while [alarm['kind'] for alarm in self.alarms()] != kinds:
            self.assertLess(time.monotonic(), end, f'not in {SILENT_S} s: {self.alarms()}')
            time.sleep(0.2)
        return self.alarms()

    def test_a_robot_that_dies_and_comes_back(self):
        follower = self.start('follower', BIN / 'weft', *self.common, 'events', '--follow', '--json')
        self.sees(follower, 'server.started')
        agent = self.robot('agent')
        self.assertEqual(self.alarms(), [])

        agent.child.kill()
        agent.child.wait()
        self.sees(follower, 'robot.silent')
        alarm, = self.until_alarms(['silent'])
        self.assertTrue(alarm['cause'] and alarm['cure'] and alarm['since'], alarm)
        ended, said, _ = self.run_command(BIN / 'weft', *self.common, 'alarms')
        self.assertEqual(ended, 1, said)
        for words in ('silent: r1, since ', 'cause: the server hears nothing', 'cure: look whether its agent runs'):
            self.assertIn(words, said)

        self.robot('agent2')
        self.sees(follower, 'robot.heard')
        self.until_alarms([])

        kept = [json.loads(line) for line in self.weft('events', '--json').splitlines()]
        self.assertEqual([event['number'] for event in kept], list(range(1, len(kept) + 1)))
        end = time.monotonic() + SILENT_S
        while len(self.events(follower)) < len(kept):
            self.assertLess(time.monotonic(), end, follower.text())
            time.sleep(0.1)
        follower.child.send_signal(signal.SIGINT)
        self.assertEqual(follower.child.wait(30), 0, follower.text())
        followed = [(event['number'], event['kind']) for event in self.events(follower)]
        self.assertEqual(followed[:len(kept)], [(event['number'], event['kind']) for event in kept], 'each once, in order')
        only = [json.loads(line) for line in self.weft('events', '--robot', 'r1', '--kind', 'robot.silent', '--json').splitlines()]
        self.assertEqual({event['kind'] for event in only}, {'robot.silent'})

    def test_one_archive_of_everything(self):
        self.robot('agent')
        secret = self.folder / 'robot.toml'
        secret.write_text('name = "r1"\nbroker_password = "hunter2"\n')
        archive = self.folder / 'report.tar.gz'
        words = ('bundle', archive, '--settings', secret, '--log', self.folder / 'agent.log')
        self.weft(*words)
        with tarfile.open(archive) as packed:
            files = {member.name.removeprefix('weft-report/'): packed.extractfile(member).read().decode() for member in packed}
        for name in ('doctor', 'robots', 'alarms', 'goals', 'map-info', 'map-stats', 'versions'):
            json.loads(files[f'{name}.json'])
        self.assertEqual([robot['name'] for robot in json.loads(files['robots.json'])['robots']], ['r1'])
        for line in io.StringIO(files['events.jsonl']):
            json.loads(line)
        self.assertIn('r1', json.loads(files['versions.json'])['weft-agent'])
        self.assertFalse([name for name, text in files.items() if 'hunter2' in text])
        self.assertTrue([name for name in files if name.startswith('logs/') and name.endswith('agent.log')], list(files))
        self.assertTrue([text for name, text in files.items() if name.startswith('settings/') and 'broker_password = (left out)' in text])
        before = archive.read_bytes()
        self.refused(2, ['is there already'], BIN / 'weft', *self.common, *words)
        self.assertEqual(archive.read_bytes(), before)
        self.assertEqual([path.name for path in self.folder.glob('report*')], ['report.tar.gz'])


if __name__ == '__main__':
    main()
