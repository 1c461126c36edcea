#!/usr/bin/python3
"""The judge of a demo with --traffic counts what it says it counts. Records are made by hand: r1 was led along the x axis
from 0 to 20 m; r2 then drove from 0 to 10 m by itself; r3 was killed at 14 m; r4 has waited 6 m before it for r3."""
import json
import pathlib
import sys
import tempfile
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
from judging import records, traffic, traffic_picture  # noqa: E402

A, HZ = 'a' * 16, 10
IDS = {f'r{i}': f'{i}{i}' * 16 for i in range(1, 5)}


def line(robot, frame, x, y=0.0):
    return dict(robot=robot, frame=frame, t=frame / HZ, x=x, y=y, heading=0.0)


def goal(name, robot, to, place, state, cause=''):
    return dict(id=name, robot=robot, wanted=robot, to=to, place=f'{A}:{place}', state=state, kind='goal', route=[], duration_s=30.0,
                history=[dict(state=state, cause=cause)])


def why(of, waits=(), heard=True, frame=300, **robot):
    return dict(goal=of['id'], answer=json.dumps(dict(
        goal=of, waits=list(waits), events=[], robot=dict(frame=frame, heard=heard, reason='', standstill=None, **robot))))


def link(robot, held_by=(), rule=None):
    return dict(robot=robot, at=f'{A}:1', needs=f'{A}:2', held_by=list(held_by), rule=rule, since='')


def made():
    truth = [line('r3', f, 14.0) for f in range(0, 201)] + [line('r4', f, 8.0, 3.0) for f in range(0, 301)]
    truth += [line('r1', f, f / 10, 5.0 if f == 200 else 0.0) for f in range(0, 201)]
    truth += [line('r2', f, (f - 200) / 10) for f in range(200, 301)] + [line('r2', 301, 10.0)]
    done, dead, held = (goal('g1', 'r2', 'end', 100, 'succeeded'), goal('g2', 'r3', 'far', 150, 'executing'),
                        goal('g3', 'r4', 'far', 150, 'executing'))
    return {
        'truth.jsonl': truth, 'goals.jsonl': [done, dead, held, dict(goal('g4', 'r4', 'make-way', 3, 'succeeded'), kind='yield')],
        'fixes.jsonl': [], 'acks.jsonl': [dict(robot='r1', experience=A, sequence=1, first=0, places=5)],
        'drives.jsonl': [dict(robot='r2', frame=f, goal='g1', phase=p) for f, p in ((200, 'accepted'), (300, 'arrived'))],
        'whys.jsonl': [why(dead, heard=False, frame=200), why(held, frame=150), why(held, [link('r4', ['r3'])])],
        'processes.jsonl': [dict(name=name, vendor='fastdds', peak_memory_mb=1.0, peer=peer) for name, peer in IDS.items()],
        'network.json': dict(places=[dict(id=f'{A}:{i}', experience=A, index=i, robot=IDS['r1'], frame=i) for i in range(200)],
                             edges=[], labels=dict(end=f'{A}:100', far=f'{A}:150')),
        'traffic.json': dict(taught=dict(r1=199, r2=-1, r3=-1, r4=-1), killed=dict(robot='r3', goal='g2', holds=f'{A}:139..141',
                                                                        aisle=[f'{A}:{i}' for i in range(135, 145)]),
                             closed=dict(a=f'{A}:120', b=f'{A}:122', closed=dict(r2=200), opened=dict(r2=290))),
    }


def read(content, folder):
    for name, rows in content.items():
        text = json.dumps(rows) if name.endswith('.json') else ''.join(json.dumps(row) + '\n' for row in rows)
        (pathlib.Path(folder) / name).write_text(text)
    return records.read(folder)


def judged(content):
    with tempfile.TemporaryDirectory() as folder:
        return traffic.summarise(read(content, folder))


class Traffic(unittest.TestCase):
    def broken(self, change):
        content = made()
        change(content)
        least, traffic.LEAST_SUCCEEDED = traffic.LEAST_SUCCEEDED, 1
        try:
            return ' | '.join(traffic.faults(judged(content), wanted_goals=3))
        finally:
            traffic.LEAST_SUCCEEDED = least

    def test_a_good_demo_has_no_faults(self):
        self.assertEqual(self.broken(lambda c: None), '')
        summary = judged(made())
        self.assertEqual([g['named'] for g in summary['goals']], [None, 'r3 is not heard', 'r4 waits for r3'])
        self.assertEqual([g['waited'] for g in summary['goals']], [0, 1, 1])
        self.assertEqual(summary['yields'], 1)
        self.assertIn('1 times a robot made way', '\n'.join(traffic.table(summary)))

    def test_few_goals_and_few_that_succeed_are_seen(self):
        found = ' | '.join(traffic.faults(judged(made())))
        self.assertIn('3 goals, 12 wanted', found)
        self.assertIn('1 goals succeeded, 7 wanted', found)

    def test_bodies_that_touch_are_seen_but_not_while_one_is_led(self):
        self.assertIn('r2 drove into r4', self.broken(lambda c: [row.update(x=5.0, y=0.5) for row in c['truth.jsonl'] if row['robot'] == 'r4']))
        led = made()      # r1 was led by r3 at 14 m, nearer than two radii
        self.assertGreater(judged(led)['nearest']['gap_m'], 0.0)
        led['traffic.json']['taught']['r1'] = 100
        self.assertLess(judged(led)['nearest']['gap_m'], 0.0)

    def test_a_goal_that_waits_for_one_that_lives_is_seen(self):
        found = self.broken(lambda c: c['whys.jsonl'].__setitem__(2, why(c['goals.jsonl'][2], [link('r4', ['r2'])])))
        self.assertIn('goal far (r4): still executing, and not for r3: r4 waits for r2', found)

    def test_who_stands_and_is_not_named_is_seen(self):
        self.assertIn('nothing says why', self.broken(lambda c: c['whys.jsonl'].__setitem__(2, why(c['goals.jsonl'][2]))))
        self.assertIn('nothing says why', self.broken(lambda c: c['whys.jsonl'].__setitem__(2, why(c['goals.jsonl'][2], [link('r4')]))))
        self.assertIn('nothing says why', self.broken(lambda c: c['whys.jsonl'].pop(0)))

    def test_who_drives_need_not_be_named(self):
        driving = why(made()['goals.jsonl'][0] | dict(state='executing'), frame=280)
        self.assertEqual(self.broken(lambda c: c['whys.jsonl'].append(driving)), '')

    def test_who_has_just_been_let_go_on_need_not_be_named(self):
        def sets_off(content):
            content['truth.jsonl'] += [line('r4', 301 + f, 8.0 + f / 10, 3.0) for f in range(10)]
            content['whys.jsonl'].insert(2, why(content['goals.jsonl'][2]))
        self.assertEqual(self.broken(sets_off), '')

    def test_a_goal_that_no_robot_has_is_named_by_its_history(self):
        def pending(cause):
            row = goal('g1', None, 'end', 100, 'pending', cause)
            return dict(goal='g1', answer=json.dumps(dict(goal=row, waits=[], events=[])))
        self.assertEqual(self.broken(lambda c: c['whys.jsonl'].append(pending('no robot is free'))), '')
        self.assertIn('1 of 1 times nothing said why', self.broken(lambda c: c['whys.jsonl'].append(pending(''))))

    def test_a_rule_is_a_cause(self):
        content = made()
        content['whys.jsonl'][2] = why(content['goals.jsonl'][2], [link('r4', rule='edge')])
        self.assertEqual(judged(content)['goals'][2]['named'], 'r4 waits for rule edge')

    def test_an_answer_that_cannot_be_read_is_seen(self):
        self.assertIn('cannot be read: JSONDecodeError', self.broken(lambda c: c['whys.jsonl'].insert(0, dict(goal='g3', answer='{"goal":'))))
        self.assertIn('cannot be read: KeyError', self.broken(lambda c: c['whys.jsonl'].insert(0, dict(goal='g3', answer='{}'))))

    def test_a_failure_without_a_reason_is_seen(self):
        self.assertIn('failed without a reason', self.broken(lambda c: c['goals.jsonl'].append(goal('g5', 'r2', 'end', 100, 'failed'))))
        self.assertEqual(self.broken(lambda c: c['goals.jsonl'].append(goal('g5', 'r2', 'end', 100, 'failed', 'cleared'))), '')

    def test_the_end_is_judged_by_the_truth(self):
        self.assertIn('final_error_m', self.broken(lambda c: [row.update(y=0.06) for row in c['truth.jsonl'] if row['robot'] == 'r2']))

    def test_who_drives_over_the_closed_edge_is_seen(self):
        def at(metres):
            return lambda c: c['traffic.json']['closed'].update(a=f'{A}:{metres * 10 - 1}', b=f'{A}:{metres * 10 + 1}')
        self.assertIn('r2 drove over the edge', self.broken(at(5)))
        self.assertEqual(self.broken(lambda c: (at(5)(c), c['traffic.json']['closed'].update(opened=dict(r2=240)))), '')

    def test_a_killed_robot_that_holds_nothing_is_seen(self):
        self.assertIn('r3 was killed and holds nothing', self.broken(lambda c: c['traffic.json']['killed'].update(holds='')))
        self.assertIn('r3 was killed 4.0 m from the aisle', self.broken(
            lambda c: c['traffic.json']['killed'].update(aisle=[f'{A}:180', f'{A}:181'])))
        self.assertIn('no truth says where r3 was killed', self.broken(
            lambda c: c.update({'truth.jsonl': [row for row in c['truth.jsonl'] if row['robot'] != 'r3']})))
        self.assertIn('nobody was killed', self.broken(lambda c: c['traffic.json'].pop('killed')))

    def test_the_picture_is_drawn(self):
        with tempfile.TemporaryDirectory() as folder:
            found = read(made(), folder)
            traffic_picture.draw(found, traffic.by_itself(found), traffic.summarise(found)['goals'], pathlib.Path(folder) / 'network.png')
            self.assertEqual((pathlib.Path(folder) / 'network.png').read_bytes()[:4], b'\x89PNG')


if __name__ == '__main__':
    unittest.main()
