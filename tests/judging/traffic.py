"""Judges a demo with --traffic: whether every goal has ended or is named, what those that stood waited for, and
whether anybody drove over the edge while it was closed."""
import bisect
import json
import re

from judging import geometry, metrics, verdict

STANDS_S, STANDS_M = 10.0, 0.05      # not moved farther for so long: it stands, and somebody has to be able to say why
SETS_OFF_S = 2.0                     # after it was let go on
CLOSED_M = 0.15                      # from the middle of the closed edge: driven over it
IN_AISLE_M = 0.5                     # from the places at which the victim was to die: it stands in nobody's way elsewhere
LEAST_SUCCEEDED = 7                  # goals; the others may wait for good, for the robot that was killed
OVER = ('succeeded', 'failed', 'cancelled', 'rejected')
UNTIL_EVER = 1 << 62


def by_itself(records):
    """robot -> frames: those that came after the last of them had been led."""
    return {robot: range(records.traffic['taught'][robot] + 1, UNTIL_EVER) for robot in records.truth}


def stands(records, robot, frame, since):
    """Whether the robot had stood at that frame for STANDS_S, all of it after the frame `since`, and did not set off just then."""
    frames, times = sorted(records.truth[robot]), records.times[robot]
    at = bisect.bisect_right(frames, frame) - 1
    if at < 0 or times[frames[at]] - times[frames[max(0, bisect.bisect_right(frames, since) - 1)]] < STANDS_S:
        return False
    here, now = records.truth[robot][frames[at]], times[frames[at]]
    near = [one for one in frames if now - STANDS_S <= times[one] <= now + SETS_OFF_S]
    return all(geometry.distance(here, records.truth[robot][one]) <= STANDS_M for one in near)


def cause(document):
    """Returns the cause of a wait that a document of `weft goal why` names; None where it names none."""
    goal, robot = document['goal'], document.get('robot') or {}
    for link in document['waits']:
        causes = list(link['held_by']) + ([f"rule {link['rule']}"] if link['rule'] else [])
        if causes:
            return f"{link['robot']} waits for {' and '.join(causes)}"
    if goal['robot'] and robot.get('heard') is False:
        return f"{goal['robot']} is not heard"
    if goal['robot'] and (robot.get('standstill') or robot.get('reason')):
        return robot.get('standstill') or robot['reason']
    if goal['state'] == 'executing':
        return None              # its history tells how it set off, not why it stands
    return goal['history'][-1]['cause'] or None if goal['history'] else None


def asked(records):
    """Each answer of `weft goal why`: goal, cause, whether there had to be one (its robot truly stands, or it has none), fault."""
    killed, rows, first = (records.traffic.get('killed') or {}).get('robot'), [], {}
    for why in records.whys:
        row = dict(goal=why['goal'], cause=None, waits=False, fault=None)
        rows.append(row)
        try:
            document = json.loads(why['answer'])
            row['cause'], state, robot = cause(document), document['goal']['state'], document['goal']['robot']
            frame = document['robot']['frame'] if robot else None
            heard = document['robot']['heard'] if robot else None
        except (ValueError, KeyError, TypeError) as fault:
            row['fault'] = f'{type(fault).__name__} {fault}'
            continue
        since = first.setdefault((why['goal'], robot), frame)
        row['waits'] = state not in OVER and (robot is None or (robot == killed and not heard) or stands(records, robot, frame, since))
    return rows


def summarise(records):
    rows, goals = asked(records), []
    for goal in records.goals:
        if goal['kind'] == 'yield':
            continue
        mine = [row for row in rows if row['goal'] == goal['id']]
        judged = metrics.judge_goal(records, goal)
        goals.append(dict({key: judged[key] for key in ('id', 'robot', 'to', 'state', 'length_m', 'duration_s', 'final_error_m')},
                          wanted=goal['wanted'], reason=goal['history'][-1]['cause'] if goal['history'] else '',
                          named=mine[-1]['cause'] if mine else None, waited=sum(row['waits'] for row in mine),
                          unnamed=sum(row['waits'] and not row['cause'] for row in mine), faults=[row['fault'] for row in mine if row['fault']]))
    return dict(metrics.common(records, metrics.stitches(records), by_itself(records)), goals=goals, killed=records.traffic.get('killed'),
                yields=sum(goal['kind'] == 'yield' for goal in records.goals), trespassed=trespassed(records),
                beside_aisle_m=beside_aisle_m(records))


def beside_aisle_m(records):
    """How far the killed robot stands from the aisle in which it was to die; None where nobody was killed."""
    killed = records.traffic.get('killed')
    if not killed or not records.truth.get(killed['robot']):
        return None
    frames = records.truth[killed['robot']]
    return min(geometry.distance(frames[max(frames)], records.true_place(place)) for place in killed['aisle'])


def trespassed(records):
    """Robots that came by the middle of the closed edge in a frame in which it was closed."""
    closed = records.traffic.get('closed')
    if not closed or 'opened' not in closed:
        return []
    a, b = records.true_place(closed['a']), records.true_place(closed['b'])
    middle = ((a[0] + b[0]) / 2, (a[1] + b[1]) / 2)
    return [robot for robot, first in closed['closed'].items() if any(
        first < frame < closed['opened'].get(robot, UNTIL_EVER) and geometry.distance(here, middle) < CLOSED_M
        for frame, here in records.truth.get(robot, {}).items())]


def waits_for_the_dead(goal, goals, killed):
    """Whether a goal that has not ended waits for the killed robot by a chain: for robots that are named, for its own robot's
    earlier goal, or, asked of any robot, for those that have goals."""
    robots = {goal['robot'], goal['wanted'], *re.findall(r'\w+', goal['named'] or '')} - {None}
    if killed in robots:
        return True
    others = [other for other in goals if other is not goal and other['state'] not in OVER]
    is_for_any = goal['robot'] is None and goal['wanted'] is None
    return any((is_for_any or other['robot'] in robots) and waits_for_the_dead(other, others, killed) for other in others)


def faults(summary, wanted_goals=12):
    """Every broken bound, named with its measured value."""
    goals, broken = summary['goals'], []
    if len(goals) < wanted_goals:
        broken.append(f'{len(goals)} goals, {wanted_goals} wanted')
    for goal in goals:
        name = f"goal {goal['to']} ({goal['robot'] or 'no robot'})"
        if goal['state'] not in OVER and not goal['named']:
            broken.append(f"{name}: still {goal['state']}, and nothing says why")
        if goal['state'] in OVER[1:] and not goal['reason']:
            broken.append(f"{name}: {goal['state']} without a reason")
        if goal['state'] == 'succeeded' and not (goal['final_error_m'] or 0.0) <= verdict.BOUNDS[0][1]:
            broken.append(f"{name}: final_error_m {goal['final_error_m']:.3f} > {verdict.BOUNDS[0][1]}")
        if goal['unnamed']:
            broken.append(f"{name}: waited, and {goal['unnamed']} of {goal['waited']} times nothing said why")
        broken += [f'{name}: `weft goal why --json` cannot be read: {fault}' for fault in goal['faults']]
    succeeded = sum(goal['state'] == 'succeeded' for goal in goals)
    if succeeded < LEAST_SUCCEEDED:
        broken.append(f'{succeeded} goals succeeded, {LEAST_SUCCEEDED} wanted')
    broken += [f'{robot} drove over the edge while it was closed' for robot in summary['trespassed']]
    killed = summary['killed']
    broken += [f"goal {goal['to']} ({goal['robot'] or goal['wanted'] or 'no robot'}): still {goal['state']}, and not for {killed['robot']}: {goal['named']}"
               for goal in goals if killed and goal['state'] not in OVER and goal['named'] and not waits_for_the_dead(goal, goals, killed['robot'])]
    if not killed or not killed.get('holds'):
        broken.append(f"{killed['robot'] if killed else 'nobody'} was killed and holds nothing at the end")
    beside_m = summary['beside_aisle_m']
    if killed and beside_m is None:
        broken.append(f"no truth says where {killed['robot']} was killed")
    elif killed and beside_m > IN_AISLE_M:
        broken.append(f"{killed['robot']} was killed {beside_m:.1f} m from the aisle that it was to block")
    return broken + verdict.shared(summary)


def table(summary):
    yield from verdict.heads(summary)
    head = ('goal', 'asked of', 'robot', 'state', 'reason', 'length m', 'time s', 'end mm', 'waits asked')
    rows = [(g['to'], g['wanted'] or 'any', str(g['robot'] or '-'), g['state'], (g['reason'] if g['state'] in OVER else g['named'] or '')[:60],
             verdict.number(g['length_m'], 1), verdict.number(g['duration_s'], 0),
             verdict.number(g['final_error_m'] and 1000 * g['final_error_m'], 1), f"{g['waited'] - g['unnamed']} of {g['waited']}")
            for g in summary['goals']]
    yield from verdict.columns(head, rows, 4)
    yield f"{summary['yields']} times a robot made way for others" + (
        f"; {summary['killed']['robot']} was killed and holds {summary['killed'].get('holds')}" if summary['killed'] else '')
