#!/usr/bin/python3
"""Each invariant of a fleet on a network holds for sound records, and a fault planted into them breaks it."""
import json
import pathlib
import sys
import tempfile
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
from judging import network  # noqa: E402

PEER, EXPERIENCE, ROUTE = 'aa' * 16, 'a' * 16, '01' * 16


def truth(robot, frame, x, y=0.0, speed=0.5, hand=False):
    return dict(robot=robot, frame=frame, t=frame / 10, x=x, y=y, heading=0.0, at=100 + frame / 10, speed_m_s=speed, hand=hand)


def order(frame, released, places=True):
    row = dict(robot='r1', frame=frame, goal='g', route=ROUTE, version=1, released=released)
    return dict(row, places=[f'{EXPERIENCE}:{i}' for i in range(11)]) if places else row


def motion(frame, mode):
    return dict(robot='r1', frame=frame, mode=mode, speed_m_s=0.0, route=ROUTE, version=1, at=0)


def sound():
    """r1 was led from 0 to 10 m, is at 0 again, is released to 5 m, drives there and stands. r2 stands 3 m aside."""
    rows = [truth('r1', f, f / 10, hand=True) for f in range(101)]
    rows += [truth('r1', 200 + f, min(f / 20, 5.0), speed=0.5 if f < 100 else 0.0) for f in range(161)]
    return {'truth-r1.jsonl': rows, 'truth-r2.jsonl': [truth('r2', f, 3.0, 3.0, speed=0.0) for f in range(0, 400, 20)],
            'orders.jsonl': [order(200, 3), order(240, 5, places=False)],
            'motion.jsonl': [motion(205, 'driving'), motion(310, 'idle'), motion(340, 'idle'), motion(360, 'idle')],
            'acks.jsonl': [dict(robot='r1', experience=EXPERIENCE, sequence=1, first=0, places=11)]}


NETWORK = {'places': [dict(id=f'{EXPERIENCE}:{i}', experience=EXPERIENCE, index=i, robot=PEER, frame=10 * i) for i in range(11)]}


def read(files, world=None):
    with tempfile.TemporaryDirectory() as folder:
        for name, rows in files.items():
            (pathlib.Path(folder) / name).write_text(''.join(json.dumps(row) + '\n' for row in rows))
        return network.Records(folder).update(world or NETWORK)


class Network(unittest.TestCase):
    def released(self, files):
        records = read(files)
        return network.released(records, records.true_places({PEER: 'r1'}))

    def test_sound_records_break_nothing(self):
        records = read(sound())
        self.assertEqual(network.acknowledged(records), [])
        broken, judged = self.released(sound())
        self.assertEqual(broken, [])
        self.assertGreater(judged, 100)
        broken, judged = network.stands(records)
        self.assertEqual(broken, [])
        self.assertGreater(judged, 10)
        broken, least = network.apart(records)
        self.assertEqual(broken, [])
        self.assertAlmostEqual(least, 3.0, places=1)

    def test_a_lost_place_is_seen(self):
        self.assertTrue(network.acknowledged(read(sound(), {'places': NETWORK['places'][:-1]})))

    def test_a_doubled_place_is_seen(self):
        self.assertTrue(network.acknowledged(read(sound(), {'places': NETWORK['places'] + NETWORK['places'][-1:]})))

    def test_a_robot_beyond_its_released_place_is_seen(self):
        files = sound()
        files['orders.jsonl'] = [order(200, 3)]
        self.assertIn('beyond its released place', self.released(files)[0][0])

    def test_who_moves_without_a_goal_is_seen(self):
        files = sound()
        files['truth-r1.jsonl'][-5] = truth('r1', 356, 5.0, speed=0.1)
        self.assertIn('moves at 0.10 m/s', network.stands(read(files))[0][0])

    def test_who_has_just_lost_its_goal_may_roll_out(self):
        files = sound()
        for row in files['truth-r1.jsonl']:
            if 310 < row['frame'] < 320:
                row['speed_m_s'] = 0.1
        self.assertEqual(network.stands(read(files))[0], [])

    def test_a_process_that_was_started_anew_says_nothing_of_the_one_before(self):
        files = sound()
        files['motion.jsonl'] += [motion(0, 'idle'), motion(361, 'idle')]
        files['truth-r1.jsonl'].append(truth('r1', 361, 5.0, speed=0.0))
        self.assertEqual(network.stands(read(files))[0], [])

    def test_bodies_that_touch_are_seen(self):
        files = sound()
        files['truth-r2.jsonl'] = [truth('r2', f, 3.0, 0.7, speed=0.0) for f in range(0, 400, 20)]
        self.assertTrue(network.apart(read(files))[0])
        self.assertEqual(network.apart(read(files), unknown={'r2'})[0], [], 'nobody can keep off one that is not known')

    def test_who_was_led_to_another_may_go_away_but_no_nearer(self):
        for goes_on_to, is_seen in ((0.9, False), (0.4, True)):
            led = [truth('r1', 100, 0.6, speed=0.5, hand=True), truth('r1', 101, goes_on_to, speed=0.5)]
            files = {'truth-r1.jsonl': led, 'truth-r2.jsonl': [truth('r2', 99, 0.0, speed=0.0)]}
            self.assertEqual(bool(network.apart(read(files))[0]), is_seen)

    def test_goals_that_vanish_change_or_stay_are_seen(self):
        listed = [dict(id='a', state='succeeded'), dict(id='b', state='executing')]
        self.assertEqual(network.goals(['a'], listed, {'a': 'succeeded'}), [])
        self.assertTrue(network.goals(['c'], listed, {}))
        self.assertTrue(network.goals(['b'], listed, {}))
        self.assertTrue(network.goals([], listed, {'a': 'failed'}))

    def test_a_torn_line_is_left_out(self):
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / 'acks.jsonl'
            path.write_text('{"robot":"r1"}\n{"rob')
            records = network.Records(folder).update()
            self.assertEqual(len(records.acks), 1)
            with open(path, 'a') as file:
                file.write('ot":"r1"}\n')
            self.assertEqual(len(records.update().acks), 2)


if __name__ == '__main__':
    unittest.main()
