"""Plays six simulated minutes of 50 robots on the benchmark's own map, and holds what the planner does against the other
policies of the same run and against the bounds that long runs are held to. No time of the machine is looked at.

Usage: quick_test.py TRAFFIC_BENCH"""
import json
import subprocess
import sys
import unittest

BENCH = sys.argv.pop()
OLDEST_MIN = 15.0
OF_WHOLE, OF_BOUND = 1.4, {'one-way': 0.85, 'two-way': 0.65}     # goals an hour, at least so many times theirs


class Quick(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        run = subprocess.run([BENCH, '--robots', '50', '--hours', '0.1', '--policies', 'whole,ours,bound', '--json'],
                             capture_output=True, text=True, check=True, timeout=600)
        rows = [json.loads(line) for line in run.stdout.splitlines()]
        cls.rows = {(row['policy'], row['lanes']): row for row in rows}

    def test_more_goals_are_reached_than_by_whole_routes_and_nearly_as_many_as_there_can_be(self):
        for lanes, share in OF_BOUND.items():
            ours = self.rows['ours', lanes]['goals_per_hour']
            self.assertGreaterEqual(ours, OF_WHOLE * self.rows['whole', lanes]['goals_per_hour'], lanes)
            self.assertGreaterEqual(ours, share * self.rows['bound', lanes]['goals_per_hour'], lanes)

    def test_nobody_holds_what_another_one_does_and_nobody_stands_for_good(self):
        for lanes in OF_BOUND:
            ours = self.rows['ours', lanes]
            self.assertEqual((ours['overlaps'], ours['standstills_lasting']), (0, 0), lanes)
            self.assertLessEqual(ours['oldest_goal_min'], OLDEST_MIN, lanes)


if __name__ == '__main__':
    unittest.main()
