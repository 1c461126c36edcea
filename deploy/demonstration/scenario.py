"""Plays a demo, in the operator's order. Nothing here knows where a robot truly is."""
import lines
from processes import wait_until

SITE, PACE, FLAGS = 'demo', 1.5, {}
ROBOTS = ('r1', 'r2', 'r3')
TEACH = {'r1': 'loop-1', 'r2': 'loop-2'}
R2_SEED = 'handover'          # a label of r1's, near which r2 starts
GOALS = (('packing-3', 'r1'), ('dock-2', None))
OVER = ('succeeded', 'failed', 'cancelled', 'rejected')
CROSSING = (('handover', 'r3'), ('yard', 'r2'))      # sent at once, on ways that cross


def spots():
    """The labels that the lines have to name."""
    return {R2_SEED, *(label for label, _ in GOALS + CROSSING)}


def teach(fleet, robot, line, say, name):
    """The operator drives along the line; where it names a spot, the place under the robot gets that label."""
    pieces = lines.parts(line)
    total = sum(lines.length_m(points) for points, _ in pieces)
    say(f'teach {robot}: {total:.0f} m as "{name}"')
    done = 0.0

    def begin(*more):
        reply = fleet.weft('teach', robot, 'start', '--as', name, *more)
        fleet.experiences[reply['experience']] = name

    for number, (points, label) in enumerate(pieces):
        if len(points) > 1:
            part = lines.write(points, fleet.work / f'{robot}-{number}.line')
            before = fleet.robot(robot)['frame']
            begin('--along', part)
            # what the server knew before the hand began to drive may still say that it has ended
            fleet.wait_robot(robot, 'to reach the end of its line',
                             lambda row: row['reason'] == 'hand_done' and row['frame'] > before + 10, 240)
            done += lines.length_m(points)
        elif number == 0:
            begin()
        if label:
            fleet.weft('map', 'label', 'here', '--robot', robot, label)
        say(f'teach {robot}: {done:.0f} of {total:.0f} m' + (f', this spot is "{label}"' if label else ''))
    fleet.weft('teach', robot, 'stop')


def wait_for_map(fleet, experiences, say):
    """Until the server holds what was taught; `teach stop` has been answered only then, so this is quick."""
    info = wait_until(f'{experiences} experiences to be on the map',
                      lambda: (lambda row: row if row['experiences'] >= experiences else None)(fleet.weft('map', 'info')),
                      60, fleet.all(), every=0.5)
    say(f"map: {info['places']} places, {info['stitches']} stitches, revision {info['revision']}")


def goal(fleet, goal_id):
    found = [row for row in fleet.weft('goal', 'list')['goals'] if row['id'] == goal_id]
    if not found:
        raise RuntimeError(f'the server knows no goal {goal_id} any more')
    return found[0]


def send(fleet, label, robot, say):
    sent = fleet.weft('goal', 'send', '--to', label, *(['--robot', robot] if robot else []))
    say(f"goal: {robot or 'any robot'} to {label}")
    return sent['goal']


def goal_words(row):
    """How a goal stands, for people."""
    return f"goal {row['to']}: {row['state']}" + (f" ({row['robot']})" if row.get('robot') else '')


def watch(fleet, goal_id, say, meanwhile=None, seconds=240):
    """Follows a goal to its end, saying each change once."""
    seen = [None]

    def over():
        row = goal(fleet, goal_id)
        told = (row['state'], row.get('robot'))
        if told != seen[0]:
            seen[0] = told
            say(goal_words(row))
        if meanwhile and meanwhile(row):
            say('the server is killed with -9 and started again')
            fleet.kill_and_restart_server()
        return row if row['state'] in OVER else None
    return wait_until(f'goal {goal_id} to end', over, seconds, fleet.robots.values(), every=0.5)


def cross(fleet, say):
    """Both drive at once; who comes to the crossing second waits. The ends of both."""
    sent = [send(fleet, label, robot, say) for label, robot in CROSSING]
    together = []

    def both(_):
        states = [goal(fleet, one)['state'] for one in sent]
        together.append(all(state == 'executing' for state in states))
        return False
    ended = [watch(fleet, sent[0], say, both), watch(fleet, sent[1], say)]
    if not any(together):
        raise RuntimeError('the two robots of the crossing never drove at once')
    return ended


class OnceInTheMiddle:
    """True once, when the robot has driven a third of its route."""

    def __init__(self):
        self.fired = False

    def __call__(self, row):
        if self.fired or row['state'] != 'executing' or (row['route_at'] or 0) < 0.3 * len(row['route']):
            return False
        self.fired = True
        return True


def run(fleet, site_lines, say):
    """Whether all goals succeeded."""
    teach(fleet, 'r1', site_lines['r1'], say, TEACH['r1'])
    wait_for_map(fleet, 1, say)
    fleet.weft('localise', 'r2', '--at', R2_SEED)
    fleet.wait_robot('r2', 'to find itself', lambda row: row['localised'], 60)
    teach(fleet, 'r2', site_lines['r2'], say, TEACH['r2'])
    wait_for_map(fleet, 2, say)
    ended = []
    (first, first_robot), (second, second_robot) = GOALS
    ended.append(watch(fleet, send(fleet, first, first_robot, say), say))
    fleet.weft('localise', 'r3')
    fleet.wait_robot('r3', 'to find itself', lambda row: row['localised'], 90)
    say('r3 has found itself without a seed')
    middle = OnceInTheMiddle()
    ended.append(watch(fleet, send(fleet, second, second_robot, say), say, middle))
    if not middle.fired:
        raise RuntimeError(f'the goal {second} ended before the server could be killed in the middle of it')
    return all(row['state'] == 'succeeded' for row in ended + cross(fleet, say))
