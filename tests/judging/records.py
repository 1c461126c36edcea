"""Reads the raw records that a demo leaves (docs/formats/records.md). A missing or damaged one ends with one line."""
import json
import pathlib
import sys
from dataclasses import dataclass, field


def end(message):
    print(f'judge: {message}', file=sys.stderr)
    sys.exit(1)


def lines(path):
    if not path.exists():
        end(f'{path} is missing; was the demo run to its end?')
    rows = []
    for number, line in enumerate(path.read_text().splitlines(), 1):
        try:
            rows.append(json.loads(line))
        except json.JSONDecodeError as fault:
            end(f'{path}:{number}: {fault}')
    return rows


def document(path):
    try:
        return json.loads(path.read_text())
    except (OSError, json.JSONDecodeError) as fault:
        end(f'{path.name}: {fault}')


def pose(row):
    return (row['x'], row['y'], row['heading'])


@dataclass
class Records:
    truth: dict = field(default_factory=dict)        # robot -> frame -> (x, y, heading)
    times: dict = field(default_factory=dict)        # robot -> frame -> seconds of its own true time
    order: list = field(default_factory=list)        # (robot, frame) as the truth was written
    fixes: list = field(default_factory=list)        # robot, frame, place, place_from_robot
    drives: list = field(default_factory=list)       # robot, frame, goal, phase
    acks: list = field(default_factory=list)         # robot, experience, sequence, first, places
    goals: list = field(default_factory=list)
    processes: list = field(default_factory=list)
    names: dict = field(default_factory=dict)        # experience -> the name that it was taught as
    network: dict = field(default_factory=dict)
    places: dict = field(default_factory=dict)       # id -> row, robot by name
    whys: list = field(default_factory=list)         # goal, answer; of a demo with --traffic, as is what follows
    traffic: dict = None
    site: pathlib.Path = None
    floor: pathlib.Path = None                       # a picture of it

    def true_pose(self, robot, frame):
        try:
            return self.truth[robot][frame]
        except KeyError:
            end(f'truth.jsonl has no frame {frame} of {robot}')

    def true_place(self, place):
        row = self.places.get(place)
        if row is None:
            end(f'network.json has no place {place}')
        return self.true_pose(row['robot'], row['frame'])


def read(folder):
    folder = pathlib.Path(folder)
    records = Records(site=folder / 'site.toml', floor=folder / 'floor.pgm')
    for row in lines(folder / 'truth.jsonl'):
        records.truth.setdefault(row['robot'], {})[row['frame']] = pose(row)
        records.times.setdefault(row['robot'], {})[row['frame']] = row['t']
        records.order.append((row['robot'], row['frame']))
    records.fixes = lines(folder / 'fixes.jsonl')
    records.drives = lines(folder / 'drives.jsonl')
    records.acks = lines(folder / 'acks.jsonl')
    records.goals = lines(folder / 'goals.jsonl')
    records.processes = lines(folder / 'processes.jsonl')
    if (folder / 'experiences.jsonl').exists():
        records.names = {row['experience']: row['name'] for row in lines(folder / 'experiences.jsonl')}
    records.network = document(folder / 'network.json')
    if (folder / 'traffic.json').exists():
        records.traffic, records.whys = document(folder / 'traffic.json'), lines(folder / 'whys.jsonl')
    names = {row['peer']: row['name'] for row in records.processes if row.get('peer')}
    for row in records.network['places']:
        records.places[row['id']] = dict(row, robot=names.get(row['robot'], row['robot']))
    return records
