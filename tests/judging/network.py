"""Invariants of a fleet on a network with faults, from records alone (docs/formats/records.md; truth with `at`, `speed_m_s` and
`hand`, as weft-light-agents writes it). Each function returns what breaks it, in words; empty: it holds."""
import bisect
import json
import math
import pathlib
import types
from dataclasses import dataclass, field

from judging.metrics import lost_acknowledged

OVER = ('succeeded', 'failed', 'cancelled', 'rejected')
NO_ROUTE = '0' * 32
BEYOND_M = 0.5              # of its released place: where it stops, and what it believes of where it is
STANDS_M_S = 0.02
STANDING = ('lost', 'stopped', 'idle', 'faulted')
STANDS_AFTER_S = 1.0        # of the body's time
FOOTPRINT_M = 0.4
NEARER_M = 0.05             # whoever turns on the spot to go away may come so much nearer


@dataclass
class Robot:
    frames: list = field(default_factory=list)
    rows: list = field(default_factory=list)         # (frame, at, x, y, speed, hand, t)
    orders: list = field(default_factory=list)
    motion: list = field(default_factory=list)

    def at_frame(self, frame):
        i = bisect.bisect_left(self.frames, frame)
        return self.rows[i] if i < len(self.frames) and self.frames[i] == frame else None

    def stood(self, frames):
        """Whether it stood in its last so many frames."""
        return all(abs(row[4]) < STANDS_M_S for row in self.rows[-frames:])

    def between(self, after, to):
        """The rows of the frames (after, to]."""
        return self.rows[bisect.bisect_right(self.frames, after):bisect.bisect_right(self.frames, to)]


class Records:
    """All records below a folder; `update` reads what has come since."""

    def __init__(self, folder):
        self.folder, self.read = pathlib.Path(folder), {}
        self.robots, self.acks, self.network = {}, [], {'places': []}

    def update(self, network=None):
        if network is not None:
            self.network = network
        for path in sorted(self.folder.rglob('*.jsonl')):
            for row in self.new_lines(path):
                self.take(path.name, row)
        return self

    def new_lines(self, path):
        with open(path, 'rb') as file:
            file.seek(self.read.get(path, 0))
            data = file.read()
        end = data.rfind(b'\n') + 1
        self.read[path] = self.read.get(path, 0) + end
        for line in data[:end].splitlines():
            try:
                yield json.loads(line)
            except json.JSONDecodeError:
                continue                             # a full disk cuts lines

    def take(self, name, row):
        if name == 'acks.jsonl':
            self.acks.append(row)
            return
        robot = self.robots.setdefault(row['robot'], Robot())
        if name.startswith('truth'):
            robot.frames.append(row['frame'])
            robot.rows.append((row['frame'], row['at'], row['x'], row['y'], row['speed_m_s'], row['hand'], row['t']))
        elif row['frame'] == 0:
            return                                   # of a process that was started anew and has not had a sample yet
        elif name == 'orders.jsonl':
            robot.orders.append(row)
        elif name == 'motion.jsonl':
            robot.motion.append(row)

    def ordered(self):
        """The goals for which robots have had a route."""
        return {order['goal'] for robot in self.robots.values() for order in robot.orders if order['route'] != NO_ROUTE}

    def true_places(self, names):
        """place -> (x, y) where the robot that taught it stood; `names`: peer -> robot."""
        found = {}
        for row in self.network['places']:
            robot = self.robots.get(names.get(row['robot'], row['robot']))
            pose = robot.at_frame(row['frame']) if robot else None
            if pose:
                found[row['id']] = pose[2:4]
        return found


def acknowledged(records):
    """A1: nothing acknowledged is lost or doubled."""
    ids = types.SimpleNamespace(acks=records.acks, network=records.network, places={row['id']: row for row in records.network['places']})
    count, lost = lost_acknowledged(ids)
    return [f'{lost} of {count} acknowledged batches are not in the map once'] if lost else []


def goals(accepted, listed, ended_before):
    """A2: each accepted goal is listed, what has ended stays so, and the rest has ended. `ended_before`: id -> state."""
    rows = {row['id']: row['state'] for row in listed}
    broken = [f'goal {goal} was accepted and is not listed' for goal in accepted if goal not in rows]
    broken += [f'goal {goal} ended as {state} and is {rows.get(goal)}' for goal, state in ended_before.items() if rows.get(goal) != state]
    return broken + [f'goal {goal} is still {rows[goal]}' for goal in accepted if goal in rows and rows[goal] not in OVER]


def along(point, line, reach):
    """(metres along the line, index of the segment) nearest to the point, of the segments in `reach`."""
    best = None
    total = line['cumulative']
    for i in range(max(0, reach[0]), min(reach[1], len(line['points']) - 1)):
        (ax, ay), (bx, by) = line['points'][i], line['points'][i + 1]
        length = total[i + 1] - total[i]
        share = 0.0 if length < 1e-9 else max(0.0, min(1.0, ((point[0] - ax) * (bx - ax) + (point[1] - ay) * (by - ay)) / length ** 2))
        away = math.hypot(ax + share * (bx - ax) - point[0], ay + share * (by - ay) - point[1])
        if best is None or away < best[0]:
            best = (away, total[i] + share * length, i)
    return best[1:] if best else (0.0, 0)


def polyline(points):
    cumulative = [0.0]
    for (ax, ay), (bx, by) in zip(points, points[1:]):
        cumulative.append(cumulative[-1] + math.hypot(bx - ax, by - ay))
    return dict(points=points, cumulative=cumulative)


def released(records, places, since=0.0):
    """A3: no robot is truly beyond the place that it was released to. Returns (broken, judged frames)."""
    broken, judged = [], 0
    for name, robot in records.robots.items():
        line, key, segment = None, None, 0
        for order, after in zip(robot.orders, [*robot.orders[1:], {'frame': float('inf')}]):
            if order.get('places'):
                known = [places.get(place) for place in order['places']]
                line = polyline(known) if all(known) and len(known) > 1 else None
                key, segment = (order['route'], order['version']), 0
            if order['route'] == NO_ROUTE or key != (order['route'], order['version']) or line is None:
                continue
            most = line['cumulative'][min(order['released'], len(line['points']) - 1)]
            for row in robot.between(order['frame'], after['frame']):
                reach = (segment - 2, segment + 8)
                metres, segment = along(row[2:4], line, reach)
                if row[1] < since or row[5]:
                    continue
                judged += 1
                if metres > most + BEYOND_M:
                    broken.append(f'{name} was {metres - most:.2f} m beyond its released place at frame {row[0]}')
                    break
    return broken, judged


def stands(records, since=0.0):
    """A4: who is lost, stopped or has no goal stands, from a second on. Returns (broken, judged frames)."""
    broken, judged = [], 0
    for name, robot in records.robots.items():
        begun = None
        for report, after in zip(robot.motion, robot.motion[1:]):
            if report['mode'] not in STANDING:
                begun = None
                continue
            here = robot.at_frame(report['frame'])
            if begun is None:
                begun = here[6] if here else None
            if after['mode'] not in STANDING or begun is None:
                continue
            for row in robot.between(report['frame'], after['frame']):
                if row[5] or row[6] < begun:         # it is led, or its process was started anew
                    begun = row[6]
                if row[1] < since or row[5] or row[6] - begun < STANDS_AFTER_S:
                    continue
                judged += 1
                if abs(row[4]) >= STANDS_M_S:
                    broken.append(f"{name} is {report['mode']} and moves at {row[4]:.2f} m/s at frame {row[0]}")
                    break
    return broken, judged


def apart(records, since=0.0, unknown=()):
    """A5: no two bodies touch while one of them drives by itself, but for those that the server cannot know of, and no further than a
    hand has led one to the other. Returns (broken, least distance in metres)."""
    rows = sorted((row[1], name, row) for name, robot in records.robots.items() if name not in unknown for row in robot.rows)
    now, least, broken, led = {}, math.inf, {}, {}
    for at, name, row in rows:
        now[name] = row
        if at < since or abs(row[4]) < STANDS_M_S:
            continue
        for other, theirs in now.items():
            if other == name:
                continue
            pair, away = frozenset((name, other)), math.hypot(row[2] - theirs[2], row[3] - theirs[3])
            if away >= 2 * FOOTPRINT_M:
                led.pop(pair, None)
            elif row[5]:
                led[pair] = away
            if row[5]:
                continue
            least = min(least, away)
            nearest = led[pair] - NEARER_M if pair in led else 2 * FOOTPRINT_M
            if away < nearest and (name, other) not in broken:
                broken[name, other] = f'{name} drives {away:.2f} m from {other} at frame {row[0]}'
    return list(broken.values()), least
