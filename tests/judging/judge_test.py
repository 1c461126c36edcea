#!/usr/bin/python3
"""The judge counts what it says it counts, and each planted fault changes its verdict. Records are made by hand: a
robot r1 taught the x axis from 0 to 10 m, r2 taught 5 to 15 m beside it, and r1 was then sent from 0 to 15 m."""
import json
import pathlib
import subprocess
import sys
import tempfile
import unittest

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent))
import numpy  # noqa: E402
from judging import geometry, metrics, records, repeats, verdict  # noqa: E402

R1, R2 = 'aa' * 16, 'bb' * 16
A, B = 'a' * 16, 'b' * 16


def pose(x, y=0.0, heading=0.0):
    return dict(x=x, y=y, heading=heading)


def made():
    truth = [dict(robot='r1', frame=f, t=f / 10, **pose(f / 10)) for f in range(0, 101)]
    truth += [dict(robot='r2', frame=f, t=f / 10, **pose(5 + f / 10, 0.1)) for f in range(0, 101)]
    truth += [dict(robot='r2', frame=101, t=10.1, **pose(20, 5))]
    truth += [dict(robot='r1', frame=200 + f, t=20 + f / 10, **pose(f / 10, 0.1 if f > 60 else 0.0)) for f in range(0, 151)]
    places = [dict(id=f'{A}:{i}', experience=A, index=i, robot=R1, frame=2 * i) for i in range(51)]
    places += [dict(id=f'{B}:{i}', experience=B, index=i, robot=R2, frame=2 * i) for i in range(51)]
    edges = [dict(a=f'{A}:{25 + i}', b=f'{B}:{i}', a_from_b=pose(0.0, 0.1), origin='stitch') for i in range(0, 26)]
    route = [f'{A}:{i}' for i in range(31)] + [f'{B}:{i}' for i in range(5, 51)]
    goal = dict(id='g1', robot='r1', wanted='r1', to='end', state='succeeded', place=f'{B}:50', route=route, duration_s=15.0)
    return {
        'truth.jsonl': truth, 'goals.jsonl': [goal, dict(goal, id='g2')],
        'fixes.jsonl': [dict(robot='r1', frame=200 + f, place=f'{A}:0', place_from_robot=pose(f / 10, 0.1 if f > 60 else 0.0))
                        for f in range(0, 151, 5)],
        'drives.jsonl': [dict(robot='r1', frame=f, goal=g, phase=p) for g in ('g1', 'g2')
                         for f, p in ((200, 'accepted'), (350, 'arrived'))],
        'acks.jsonl': [dict(robot='r1', experience=A, sequence=i + 1, first=5 * i, places=5) for i in range(10)],
        'processes.jsonl': [dict(name='server', vendor='fastdds', peak_memory_mb=50.0),
                            dict(name='r1', vendor='cyclonedds', peak_memory_mb=90.0, peer=R1),
                            dict(name='r2', vendor='fastdds', peak_memory_mb=80.0, peer=R2)],
        'network.json': dict(places=places, edges=edges, labels=dict(end=f'{B}:50'), experiences=[]),
    }


def floor(width=640, height=320, seed=1):
    """Grains of some centimetres: no floor in particular, and nowhere twice."""
    grains = numpy.random.default_rng(seed).normal(size=(height + 2, width + 2))
    return 125 + 30 * sum(grains[j:j + height, i:i + width] for j in range(3) for i in range(3)) / 3


def tiled(period_x, period_y, width=640, height=320):
    """One photograph laid again and again, with dirt of its own on it."""
    photograph = floor(period_x, period_y)
    laid = numpy.tile(photograph, (height // period_y + 1, width // period_x + 1))[:height, :width]
    return laid + numpy.random.default_rng(2).normal(0, 8, laid.shape)


def write_floor(path, grey):
    rows, columns = grey.shape
    path.write_bytes(b'P5\n%d %d\n255\n' % (columns, rows) + numpy.clip(grey, 0, 255).astype(numpy.uint8).tobytes())


def written(folder, content):
    write_floor(pathlib.Path(folder) / 'floor.pgm', floor())
    for name, rows in content.items():
        text = json.dumps(rows) if name.endswith('.json') else ''.join(json.dumps(row) + '\n' for row in rows)
        (pathlib.Path(folder) / name).write_text(text)
    return folder


def judged(content):
    with tempfile.TemporaryDirectory() as folder:
        return metrics.summarise(records.read(written(folder, content)))


class Judge(unittest.TestCase):
    def test_a_good_demo_has_no_faults(self):
        summary = judged(made())
        self.assertEqual(verdict.faults(summary), [])
        goal = summary['goals'][0]
        self.assertEqual(goal['route_experiences'], [A, B])
        self.assertFalse(goal['taught_whole'])
        self.assertAlmostEqual(goal['final_error_m'], 0.0, places=9)
        self.assertAlmostEqual(goal['max_blind_m'], 0.5, delta=0.06)
        self.assertEqual(summary['stitched_metres'], 6)
        self.assertEqual((summary['acknowledged'], summary['lost_acknowledged']), (10, 0))

    def broken(self, change):
        content = made()
        change(content)
        return ' | '.join(verdict.faults(judged(content)))

    def test_a_wrong_stitch_is_seen(self):
        self.assertIn('1 wrong stitches', self.broken(lambda c: c['network.json']['edges'][3].update(a_from_b=pose(0.11, 0.1))))
        self.assertIn('1 wrong stitches', self.broken(lambda c: c['network.json']['edges'][3].update(a_from_b=pose(0, 0.1, 0.06))))

    def test_a_lost_or_doubled_place_is_seen(self):
        self.assertIn('1 lost of 10', self.broken(lambda c: c['acks.jsonl'].append(
            dict(robot='r1', experience=A, sequence=10, first=49, places=5))))
        self.assertIn('lost of 10', self.broken(lambda c: c['network.json']['places'].append(c['network.json']['places'][4])))

    def test_the_end_is_judged_by_the_truth(self):
        def off(content):
            content['truth.jsonl'][-1]['x'] += 0.06
        self.assertIn('final_error_m', self.broken(off))

    def test_a_stitch_within_one_experience_is_a_join(self):
        content = made()
        route = [f'{A}:{i}' for i in range(10)] + [f'{A}:{i}' for i in range(30, 51)]
        with tempfile.TemporaryDirectory() as folder:
            pieces, joins = metrics.taught_polyline(records.read(written(folder, content)), route)
        self.assertEqual([len(piece) for piece in pieces], [19, 41])
        self.assertEqual(len(joins), 3)

    def test_touching_bodies_are_seen_when_one_drives_by_itself(self):
        def beside(y):
            return lambda c: [row for row in c['truth.jsonl'] if row['frame'] == 101][0].update(pose(8, y))
        self.assertIn('r1 drove into r2: gap -0.460 m < 0.0', self.broken(beside(0.2)))
        self.assertNotIn('drove into', self.broken(beside(0.67)))
        self.assertAlmostEqual(judged(made())['nearest']['gap_m'], 5 * 2 ** 0.5 - 0.56, delta=0.2)

    def test_one_that_stands_or_is_led_touches_nobody(self):
        def led(content):    # the drive is nobody's; r1 is led into r2
            content['drives.jsonl'] = []
            beside = [row for row in content['truth.jsonl'] if row['frame'] == 101][0]
            beside.update(pose(8, 0.2))
        self.assertNotIn('drove into', self.broken(led))

    def test_the_radius_is_the_sites(self):
        with tempfile.TemporaryDirectory() as folder:
            content = made()
            [row for row in content['truth.jsonl'] if row['frame'] == 101][0].update(pose(8, 0.6))
            (pathlib.Path(folder) / 'site.toml').write_text('[base]\nradius_m = 0.2\n')
            self.assertAlmostEqual(metrics.summarise(records.read(written(folder, content)))['nearest']['gap_m'], 0.1, places=6)

    def test_driving_beside_the_taught_path_is_seen(self):
        def off(content):
            for row in content['truth.jsonl']:
                if row['frame'] in range(210, 240):
                    row['y'] += 0.2
        self.assertIn('lateral_rmse_m', self.broken(off))

    def test_wrong_fixes_count_as_blind(self):
        content = made()
        for row in content['fixes.jsonl'][4:10]:
            row['place_from_robot']['y'] += 0.06
        self.assertAlmostEqual(judged(content)['goals'][0]['max_blind_m'], 3.5, delta=0.06)

    def test_a_route_of_one_experience_is_no_success(self):
        def whole(content):
            content['goals.jsonl'][0]['route'] = [f'{A}:{i}' for i in range(31)]
        self.assertIn('1 experiences', self.broken(whole))

    def test_a_failed_goal_is_seen(self):
        self.assertIn('failed', self.broken(lambda c: c['goals.jsonl'][1].update(state='failed')))


class Misplaced(unittest.TestCase):
    """Who served which goal, and over which vendor."""

    def found(self, change):
        content = made()
        content['goals.jsonl'][1].update(robot='r3', wanted=None)
        for row in content['processes.jsonl']:
            row['asked'] = row['vendor']
        change(content)
        with tempfile.TemporaryDirectory() as folder:
            return ' | '.join(verdict.misplaced(records.read(written(folder, content))))

    def test_a_demo_as_asked_for_has_none(self):
        self.assertEqual(self.found(lambda content: None), '')

    def test_another_robot_than_the_one_asked_for_is_seen(self):
        self.assertIn('asked of r1, served by r2', self.found(lambda content: content['goals.jsonl'][0].update(robot='r2')))

    def test_a_teacher_in_place_of_a_third_robot_is_seen(self):
        self.assertIn('served by r2, which taught', self.found(lambda content: content['goals.jsonl'][1].update(robot='r2')))

    def test_another_vendor_than_the_one_asked_for_is_seen(self):
        self.assertIn('r1 speaks cyclonedds, fastdds was asked for',
                      self.found(lambda content: content['processes.jsonl'][1].update(asked='fastdds')))


class Repeats(unittest.TestCase):
    """Whether a floor repeats is seen in the floor."""

    def test_a_floor_without_a_pattern_does_not(self):
        self.assertLess(repeats.most_alike(floor())[0], 0.4)

    def test_a_photograph_laid_again_and_again_does(self):
        for periods in ((30, 30), (73, 51), (100, 140), (250, 200)):
            score, here, there = repeats.most_alike(tiled(*periods))
            self.assertGreater(score, repeats.ALIKE, periods)
            for axis in (0, 1):
                apart = (there[axis] - here[axis]) / repeats.METRES_PER_PIXEL
                self.assertAlmostEqual(apart / periods[axis], round(apart / periods[axis]), places=6, msg=periods)

    def test_pieces_of_one_photograph_turned_by_quarters_do(self):
        piece = floor(80, 80)
        random = numpy.random.default_rng(3)
        laid = numpy.block([[numpy.rot90(piece, random.integers(4)) for _ in range(8)] for _ in range(4)])
        self.assertGreater(repeats.most_alike(laid)[0], repeats.ALIKE)

    def test_straight_grain_alone_does_not(self):
        grain = numpy.repeat(floor(13, 320), 50, axis=1)
        self.assertLess(repeats.most_alike(grain + floor(650, 320, seed=4) / 3)[0], repeats.ALIKE)

    def verdict_on(self, grey, site):
        with tempfile.TemporaryDirectory() as folder:
            written(folder, made())
            if grey is not None:
                write_floor(pathlib.Path(folder) / 'floor.pgm', grey)
            else:
                (pathlib.Path(folder) / 'floor.pgm').unlink()
            (pathlib.Path(folder) / 'site.toml').write_text(f'[floor]\nmaterial = "{site}"\n')
            return ' | '.join(verdict.repeating(records.read(folder)))

    def test_the_verdict_names_where_and_lets_tiles_be(self):
        self.assertEqual(self.verdict_on(floor(), 'concrete'), '')
        self.assertIn('the floor repeats', self.verdict_on(tiled(73, 51), 'concrete'))
        self.assertEqual(self.verdict_on(tiled(73, 51), 'tiles'), '')

    def test_a_floor_that_nobody_can_judge_is_a_fault(self):
        self.assertIn('not known', self.verdict_on(None, 'concrete'))
        self.assertIn('too few', self.verdict_on(floor(200, 90), 'concrete'))


class Command(unittest.TestCase):
    def run_judge(self, *arguments):
        return subprocess.run([sys.executable, HERE.parent / 'judge', *arguments], capture_output=True, text=True)

    def test_it_writes_summary_and_picture(self):
        with tempfile.TemporaryDirectory() as folder:
            done = self.run_judge(written(folder, made()))
            self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
            self.assertIn('every bound holds', done.stdout)
            self.assertGreater((pathlib.Path(folder) / 'network.png').stat().st_size, 10000)
            self.assertEqual(json.loads((pathlib.Path(folder) / 'summary.json').read_text())['wrong_stitches'], 0)

    def test_a_missing_or_damaged_record_is_one_clear_line(self):
        content = made()
        del content['truth.jsonl']
        with tempfile.TemporaryDirectory() as folder:
            done = self.run_judge(written(folder, content))
            self.assertEqual((done.returncode, done.stderr.count('\n')), (1, 1))
            self.assertIn('truth.jsonl is missing', done.stderr)
        with tempfile.TemporaryDirectory() as folder:
            written(folder, made())
            with open(pathlib.Path(folder) / 'acks.jsonl', 'a') as file:
                file.write('{"robot":')
            done = self.run_judge(folder)
            self.assertIn('acks.jsonl:11', done.stderr)
        self.assertEqual(self.run_judge().returncode, 2)


class Geometry(unittest.TestCase):
    def test_inverse_undoes(self):
        pose_ = (1.0, -2.0, 2.5)
        self.assertAlmostEqual(geometry.distance(geometry.compose(pose_, geometry.inverse(pose_)), (0, 0)), 0.0)

    def test_polyline_distance_is_to_the_segment(self):
        self.assertAlmostEqual(geometry.to_polyline((0.5, 0.3), [(0, 0), (1, 0)]), 0.3)
        self.assertAlmostEqual(geometry.to_polyline((2.0, 0.0), [(0, 0), (1, 0)]), 1.0)


if __name__ == '__main__':
    unittest.main()
