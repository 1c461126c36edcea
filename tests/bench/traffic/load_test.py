"""Loads a server with few robots for half a minute of simulated time, and holds that everything which is to be told is
told, in numbers. No time of the machine is looked at.

Usage: load_test.py TRAFFIC_BENCH"""
import json
import math
import subprocess
import sys
import unittest

BENCH = sys.argv.pop()
ROBOTS, SECONDS = (3, 10), 36.0
COMMAND = [BENCH, '--load', ','.join(map(str, ROBOTS)), '--ring', '100,5', '--hours', str(SECONDS / 3600.0)]
OF_LOAD = ('seed', 'seconds', 'driving', 'goals_per_hour', 'commits_per_s', 'orders_per_s', 'refused',
           'warm_up_longest_ms')
OF_WORK = ('per_s', 'share', 'median_ms', 'p99_ms', 'longest_ms', 'wall_p99_ms', 'wall_longest_ms')
WORKS = ('state', 'progress', 'request', 'other', 'tick', 'handle', 'all')
STATES_PER_S = 5.0


def run(*options):
    return subprocess.run([*COMMAND, *options], capture_output=True, text=True, check=True, timeout=600).stdout


class Load(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.loads = [json.loads(line) for line in run('--json').splitlines()]

    def test_each_number_of_robots_is_loaded_without_goals_and_with_them(self):
        told = [(load['robots'], load['has_goals']) for load in self.loads]
        self.assertEqual(told, [(robots, has_goals) for robots in ROBOTS for has_goals in (False, True)])

    def test_all_is_told_in_finite_numbers(self):
        for load in self.loads:
            numbers = [load[name] for name in OF_LOAD] + [load[work][name] for work in WORKS for name in OF_WORK]
            for number in numbers:
                self.assertTrue(math.isfinite(number) and number >= 0, load)

    def test_robots_report_five_times_a_second_and_drive_when_they_have_goals(self):
        for load in self.loads:
            self.assertAlmostEqual(load['state']['per_s'], STATES_PER_S * load['robots'], delta=0.1 * load['robots'])
            self.assertEqual(load['driving'] > 0.5, load['has_goals'], load)
            self.assertEqual(load['progress']['per_s'] > 0, load['has_goals'], load)
            self.assertEqual(load['refused'], 0, load)

    def test_the_table_has_what_happened_of_each_load(self):
        rows = [line.split() for line in run().splitlines()]
        for robots in ROBOTS:
            for goals, works in (('none', ('state', 'tick', 'handle', 'all')), ('yes', WORKS)):
                for work in works:
                    head = [str(robots), 'ring', goals, work]
                    self.assertTrue(any(row[:4] == head for row in rows), head)


if __name__ == '__main__':
    unittest.main()
