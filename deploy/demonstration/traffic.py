"""Plays a demo with --traffic, in the operator's order: six robots on one way round, with an aisle that is
driven both ways and a dead end. Nothing here knows where a robot truly is."""
import json

from gather import write_lines
from goal_watch import GoalWatch
from scenario import teach, wait_for_map

SITE, PACE = 'traffic', 1.0
# six agents on two cores may not be heard for a while
FLAGS = dict(server_flags=('--robot-silent-after-s', 10), agent_flags=('--config', 'deploy/sites/traffic/agents.toml'))
ROBOTS = ('r1', 'r2', 'r3', 'r4', 'r5', 'r6')
TEACH = {'r1': 'hall', 'r3': 'crossing'}
CLOSED_AFTER = ('dock-1', 5)     # the edge that is closed: so many places beyond the label; r1 has no other way to dock-2
# (where, who): in each part all are sent at once
CLOSED = (('dock-2', 'r1'), ('packing', 'r6'), ('aisle', 'r2'), ('press', 'r3'), ('bay', None), ('bay', None))
OPENED = (('shelf', 'r6'), ('dock-1', None), ('packing', 'r2'))
KILLED = (('dock-1', 'r3'), ('bay', None), ('dock-2', None))
VICTIM, DIES_PLACES_BEFORE = 'r6', 16    # on its way to the first goal of OPENED


def spots():
    """The labels that the lines have to name."""
    return {CLOSED_AFTER[0], *(label for label, _ in CLOSED + OPENED + KILLED)}


def find_themselves(fleet, say):
    """All at once: each finds its place on what r1 taught."""
    others = [name for name in ROBOTS if name != 'r1']
    for name in others:
        fleet.weft('localise', name)
    for name in others:
        fleet.wait_robot(name, 'to find itself', lambda row: row['localised'], 60)
    say(f"{', '.join(others)} have found themselves without a seed")


def places(fleet):
    """label -> (experience, index) of its place."""
    network = fleet.out / 'network.json'
    fleet.weft('map', 'export', network)
    found = {}
    for label, place in json.loads(network.read_text())['labels'].items():
        experience, index = place.split(':')
        found[label] = (experience, int(index))
    return found


def frames(fleet):
    return {row['name']: row['frame'] for row in fleet.weft('robots')['robots']}


def places_before(label):
    """The last places before the label's, where the aisle is for one robot."""
    experience, index = label
    return [f'{experience}:{number}' for number in range(index - DIES_PLACES_BEFORE, index - 4)]


def play(fleet, watch, at, record, say):
    experience, index = at[CLOSED_AFTER[0]][0], at[CLOSED_AFTER[0]][1] + CLOSED_AFTER[1]
    edge = (f'{experience}:{index}', f'{experience}:{index + 1}')
    fleet.weft('edge', 'close', *edge)
    say(f'the edge between {CLOSED_AFTER[0]} and dock-2 is closed')
    record['closed'] = dict(a=edge[0], b=edge[1], closed=frames(fleet))
    first = [watch.send(*goal) for goal in CLOSED]
    watch.until('all that can be reached meanwhile', lambda: watch.have_ended(first[1:]), 100)
    record['closed']['opened'] = frames(fleet)
    fleet.weft('edge', 'open', *edge)
    say('the edge is open again')
    second = [watch.send(*goal) for goal in OPENED]
    aisle = places_before(at[OPENED[0][0]])
    seen = watch.until(f'{VICTIM} to come near the {OPENED[0][0]}', lambda: fleet.robot(VICTIM)['place'] in aisle, 120)
    fleet.kill_robot(VICTIM)
    record['killed'] = dict(robot=VICTIM, goal=second[0], aisle=aisle)
    say(f"{VICTIM}'s agent is killed with -9, {'in the aisle' if seen else 'wherever it is'}")
    third = [watch.send(*goal) for goal in KILLED]
    watch.until('all other goals', lambda: watch.have_ended(first + second[1:] + third), 150)
    record['killed']['holds'] = fleet.robot(VICTIM)['occupies']
    watch.explain()


def run(fleet, site_lines, say):
    """Whether it could be played; how it went is the judge's to say."""
    teach(fleet, 'r1', site_lines['r1'], say, TEACH['r1'])
    wait_for_map(fleet, 1, say)
    find_themselves(fleet, say)
    teach(fleet, 'r3', site_lines['r3'], say, TEACH['r3'])
    wait_for_map(fleet, 2, say)
    record = dict(taught=frames(fleet))
    watch = GoalWatch(fleet, say)
    try:
        play(fleet, watch, places(fleet), record, say)
    finally:
        write_lines(fleet.out / 'whys.jsonl', watch.whys)
        (fleet.out / 'traffic.json').write_text(json.dumps(record, indent=2) + '\n')
    return True
