"""Runs a command as a person would, and holds its mistakes to one line."""
import json
import os
import pathlib
import re
import signal
import subprocess
import sys
import time
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
BIN = pathlib.Path(sys.argv[1]) if len(sys.argv) > 1 else ROOT / 'build/release/bin'
# A DDS domain for each suite, since suites run side by side; 100 to 149 are the unit and contract tests' own.
PROGRAMS_DOMAIN, NOBODYS_DOMAIN, BEARING_DOMAIN, SCRIPTS_DOMAIN, TWO_CAMERAS_DOMAIN = 151, 154, 152, 153, 155
LEARNING_DOMAIN, EDITED_MAP_DOMAIN, JSON_DOMAIN = 156, 157, 158
STAND_STILL_DOMAINS = 160, 161
CEILING_DOMAIN = 159
HEALTH_DOMAIN = 162
WATCHED_DOMAIN = 163
TOPOMETRIC_DOMAIN = 164
MONITORING_DOMAIN, RESTORE_DOMAIN = 165, 166
SIMULATE = pathlib.Path(sys.argv[2]) if len(sys.argv) > 2 else ROOT / 'build/release/tests/weft-simulate'


def simulated_agent(name, state, site, *more):
    """Returns the words that start the agent of a robot of a simulated site."""
    return [BIN / 'weft-agent-sim', '--name', name, '--state', state, '--site', site, *more]


class Case(unittest.TestCase):
    def run_command(self, *argv, seconds=60, env=None):
        done = subprocess.run([str(a) for a in argv], cwd=ROOT, capture_output=True, text=True, timeout=seconds,
                              stdin=subprocess.DEVNULL, env={**os.environ, **(env or {})})
        return done.returncode, done.stdout, done.stderr

    def refused(self, code, words, *argv, **more):
        """It ends with this code and one line on standard error that has all the words."""
        ended, _, said = self.run_command(*argv, **more)
        self.assertEqual(ended, code, f'{argv}: {said}')
        self.assertEqual(said.count('\n'), 1, f'{argv} said:\n{said}')
        for word in words:
            self.assertIn(word, said)


class Running:
    """A program that goes on, its words in a file, until it is left."""

    def __init__(self, log, *argv):
        self.log = pathlib.Path(log)
        with open(self.log, 'wb') as out:
            self.child = subprocess.Popen([str(a) for a in argv], stdout=out, stderr=subprocess.STDOUT,
                                          stdin=subprocess.DEVNULL, cwd=ROOT)

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.child.kill()
        self.child.wait()

    def text(self):
        return self.log.read_text(errors='replace')

    def says(self, words, seconds=60):
        end = time.monotonic() + seconds
        while words not in self.text():
            if time.monotonic() > end or (self.child.poll() is not None and words not in self.text()):
                return False
            time.sleep(0.05)
        return True

    def stop(self):
        self.child.send_signal(signal.SIGTERM)
        return self.child.wait(30)


class Fleet(Case):
    """Asks a server of that domain as an operator would, and the simulation for the truth."""
    domain = None
    vendor = 'cyclonedds'

    def weft(self, *words, seconds=90):
        ended, said, wrong = self.run_command(BIN / 'weft', '--domain', self.domain, '--dds', self.vendor, *words,
                                              seconds=seconds)
        self.assertEqual(ended, 0, f'{words}: {said}{wrong}')
        return said

    def poll(self, holds, seconds, *words):
        """Asks until the answer is as it should be."""
        end = time.monotonic() + seconds
        while not holds(said := self.weft(*words)):
            self.assertLess(time.monotonic(), end, f'not in {seconds} s; at last:\n{said}')
            time.sleep(0.1)

    def ready(self, robot, name):
        """The agent has found the server, and the server has heard of the robot."""
        self.assertTrue(robot.says('server: epoch', 60), robot.text())
        self.poll(lambda said: f'\n{name} ' in said, 60, 'robots')

    def pose(self, truth):
        last = json.loads(truth.read_text().splitlines()[-1])
        return last['x'], last['y'], last['heading']


def method_that_looks(gaze):
    """The first method that navigates by one camera which looks there, as the agent's help says; None: there is none."""
    said = subprocess.run([str(BIN / 'weft-agent'), '--help'], capture_output=True, text=True, timeout=60, check=True).stdout
    found = re.search(rf'(\S+)\s+\(camera\s+that\s+looks\s+{gaze}\)', said)
    return found and found.group(1)


def main():
    unittest.main(argv=sys.argv[:1])
