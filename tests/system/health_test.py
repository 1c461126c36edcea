#!/usr/bin/python3
"""Whether a real server and a real agent are healthy, as a container's health check or a supervisor asks: while they work,
while they hang, when they are killed, and when their file holds garbage. Then what they tell systemd."""
import json
import os
import pathlib
import signal
import socket
import tempfile
import time

from command import BIN, HEALTH_DOMAIN, ROOT, Case, Running, main, simulated_agent

HUNG_S = 10  # kHungAfter of process/health.hpp
AGAIN_S = 30
TIME = r'\d{4}-\d\d-\d\dT\d\d:\d\d:\d\d\.\d{3}Z'


class Programs(Case):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def start(self, program, *more):
        """The program, when it is ready, and its directory."""
        directory = self.folder / program
        argv = {'weft-server': [BIN / 'weft-server', '--store', directory],
                'weft-agent-sim': simulated_agent('r1', directory, ROOT / 'deploy/sites/demo.toml')}[program]
        running = Running(self.folder / f'{program}.log', *argv, '--domain', HEALTH_DOMAIN, *more)
        self.addCleanup(running.__exit__)
        self.assertTrue(running.says('ready'), running.text())
        return running, directory

    def ways_to_ask(self, program, directory):
        flag = '--store' if program == 'weft-server' else '--state'
        return [BIN / program, '--health', flag, directory], [BIN / 'weft-health', directory]

    def healthy(self, program, directory):
        for argv in self.ways_to_ask(program, directory):
            code, said, wrong = self.run_command(*argv)
            self.assertEqual((code, wrong), (0, ''), argv)
            self.assertRegex(said, r'^[\w-]+: healthy: [\w-]+, process \d+: .*\n$')

    def becomes_healthy(self, directory):
        end = time.monotonic() + AGAIN_S
        while self.run_command(BIN / 'weft-health', directory)[0] != 0:
            self.assertLess(time.monotonic(), end, f'not in {AGAIN_S} s')
            time.sleep(0.2)

    def sick(self, words, program, directory):
        for argv in self.ways_to_ask(program, directory):
            self.refused(1, [': not healthy: ', *words], *argv)


class Health(Programs):
    def test_wrong_use_is_exit_two(self):
        self.refused(2, ['--store'], BIN / 'weft-server', '--health')
        self.refused(2, ['--state'], BIN / 'weft-agent-sim', '--health')
        self.refused(2, ['weft-health DIR'], BIN / 'weft-health')
        for program in ('weft-server', 'weft-agent-sim'):
            _, said, _ = self.run_command(BIN / program, '--help')
            self.assertIn('--health', said)
            self.assertIn('--log-format', said)

    def test_a_process_that_hangs_or_was_killed_is_not_healthy(self):
        for program in ('weft-server', 'weft-agent-sim'):
            with self.subTest(program):
                self.sick(['not running'], program, self.folder / program)
                running, directory = self.start(program)
                self.healthy(program, directory)
                running.child.send_signal(signal.SIGSTOP)
                time.sleep(HUNG_S + 1)
                self.sick(['hung for 1', 'main loop'], program, directory)
                (directory / 'health').write_text('garbage\n')
                self.sick([str(directory / 'health'), 'holds no health record', 'garbage'], program, directory)
                running.child.send_signal(signal.SIGCONT)
                self.becomes_healthy(directory)
                running.child.kill()
                running.child.wait()
                self.sick(['not running'], program, directory)
                (directory / 'health').write_text('garbage\n')
                self.sick(['not running'], program, directory)
                again, _ = self.start(program)
                self.healthy(program, directory)
                self.assertEqual(again.stop(), 0, again.text())
                self.sick(['not running'], program, directory)

    def test_a_directory_that_can_only_be_read_is_enough(self):
        _, directory = self.start('weft-server')
        asked = [BIN / 'weft-health', directory]
        if os.geteuid() == 0:  # as another user, who may read it alone
            self.folder.chmod(0o755)
            asked = ['setpriv', '--reuid', '65534', '--regid', '65534', '--clear-groups', *asked]
        code, said, wrong = self.run_command(*asked)
        if 'setpriv' in wrong or 'denied' in wrong:
            self.skipTest(f'another user cannot run the programs here: {wrong}')
        self.assertEqual(code, 0, said + wrong)


class Logs(Programs):
    def test_each_line_has_time_level_and_message(self):
        for program in ('weft-server', 'weft-agent-sim'):
            running, _ = self.start(program)
            self.assertEqual(running.stop(), 0, running.text())
            for line in running.text().splitlines():
                self.assertRegex(line, rf'^{TIME} (info|warning|error) {program}: \S')

    def test_json_is_one_object_a_line(self):
        for program in ('weft-server', 'weft-agent-sim'):
            running, _ = self.start(program, '--log-format', 'json')
            self.assertEqual(running.stop(), 0, running.text())
            lines = [json.loads(line) for line in running.text().splitlines()]
            for line in lines:
                self.assertRegex(line['time'], f'^{TIME}$')
                self.assertIn(line['level'], ('info', 'warning', 'error'))
                self.assertEqual(line['program'], program)
                self.assertTrue(line['message'])
                self.assertEqual(line.get('robot'), 'r1' if program == 'weft-agent-sim' else None, line)
            if program == 'weft-server':
                self.assertIn('server.started', [line.get('event') for line in lines])


class Systemd(Programs):
    def test_both_tell_that_they_are_ready_alive_and_stopping(self):
        for program in ('weft-server', 'weft-agent-sim'):
            with self.subTest(program), socket.socket(socket.AF_UNIX, socket.SOCK_DGRAM) as manager:
                path = self.folder / f'{program}.notify'
                manager.bind(str(path))
                manager.settimeout(60)
                os.environ.update(NOTIFY_SOCKET=str(path), WATCHDOG_USEC='1000000')
                try:
                    running, _ = self.start(program)
                finally:
                    del os.environ['NOTIFY_SOCKET'], os.environ['WATCHDOG_USEC']
                heard = []
                while len([words for words in heard if 'WATCHDOG=1' in words]) < 4:
                    heard.append(manager.recv(4096).decode())
                before_ready = heard[:heard.index('READY=1')]
                self.assertTrue(before_ready and all('STATUS=' in words for words in before_ready), heard)
                self.assertEqual(running.stop(), 0, running.text())
                while heard[-1] != 'STOPPING=1':
                    heard.append(manager.recv(4096).decode())


if __name__ == '__main__':
    main()
