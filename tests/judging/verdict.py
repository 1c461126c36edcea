"""The bounds that a demo must keep, and the table that says so."""
import re

from judging import repeats

BOUNDS = (('final_error_m', 0.05), ('final_heading_error_deg', 3.0), ('lateral_rmse_m', 0.05))
LEAST_GAP_M = 0.0              # between two bodies of which one drives by itself


def faults(summary, wanted_goals=2):
    """Every broken bound, named with its measured value."""
    broken = []
    if len(summary['goals']) < wanted_goals:
        broken.append(f"{len(summary['goals'])} goals, {wanted_goals} wanted")
    for goal in summary['goals']:
        name = f"goal {goal['to']}"
        if goal['state'] != 'succeeded':
            broken.append(f"{name}: {goal['state']}")
        for key, bound in BOUNDS:
            if goal[key] is None or not goal[key] <= bound:
                broken.append(f'{name}: {key} {goal[key]} > {bound}')
    if summary['goals']:
        first = summary['goals'][0]
        if len(first['route_experiences']) != 2 or first['taught_whole']:
            broken.append(f"the first goal's route is of {len(first['route_experiences'])} experiences, 2 wanted")
    if summary['stitched_metres'] < 5:
        broken.append(f"{summary['stitched_metres']} stitched metres, 5 wanted")
    return broken + shared(summary)


def shared(summary):
    """Judges what has to hold in every demo: nobody touches anybody, the map is right, nothing acknowledged is lost."""
    broken, near = [], summary['nearest']
    if near and near['gap_m'] < LEAST_GAP_M:
        broken.append(f"{near['robots'][0]} drove into {near['robots'][1]}: gap {near['gap_m']:.3f} m < {LEAST_GAP_M}, at frame "
                      f"{near['frame']} of {near['robots'][0]}")
    if summary['wrong_stitches']:
        broken.append(f"{summary['wrong_stitches']} wrong stitches of {summary['stitches']}")
    if not summary['acknowledged'] or summary['lost_acknowledged']:
        broken.append(f"{summary['lost_acknowledged']} lost of {summary['acknowledged']} acknowledged batches")
    return broken


def repeating(records):
    """Where robots tell places by the floor it must not repeat; tiles do, and say so in the site file."""
    if records.site.exists() and re.search(r'^\s*material\s*=\s*"tiles"', records.site.read_text(), re.MULTILINE):
        return []
    found = repeats.fault(records.floor)
    return [found] if found else []


def misplaced(records):
    """What a demo is to show beside its bounds: who was asked for served, and every process spoke what it was told to."""
    broken = []
    taught = {place['robot'] for place in records.places.values()}
    for goal in records.goals:
        if goal.get('wanted') and goal['robot'] != goal['wanted']:
            broken.append(f"goal {goal['to']}: asked of {goal['wanted']}, served by {goal['robot']}")
        if not goal.get('wanted') and goal['robot'] in taught:
            broken.append(f"goal {goal['to']}: for any robot, served by {goal['robot']}, which taught: a third was wanted")
    return broken + misspoken(records)


def misspoken(records):
    """Processes that did not speak what they were told to."""
    broken = []
    for row in records.processes:
        if row['vendor'] != row.get('asked', row['vendor']):
            broken.append(f"{row['name']} speaks {row['vendor']}, {row['asked']} was asked for")
    return broken


def number(value, digits=3):
    return '-' if value is None else f'{value:.{digits}f}'


def heads(summary):
    """The lines above the goals, of every demo."""
    over = f" over {summary['stitched_metres']} separate metres" if 'stitched_metres' in summary else ''
    yield (f"{summary['robots']} robots, {summary['experiences']} experiences, {summary['places']} places, "
           f"{summary['stitches']} stitches ({summary['wrong_stitches']} wrong){over}")
    yield f"{summary['acknowledged']} batches acknowledged, {summary['lost_acknowledged']} lost"
    yield 'dds: ' + ', '.join(f'{name} {vendor}' for name, vendor in summary['dds'].items())
    if summary['nearest']:
        yield (f"nearest while driving: {' and '.join(summary['nearest']['robots'])}, "
               f"{number(summary['nearest']['gap_m'], 2)} m between their bodies")
    agents = max(summary['agent_rss_mb'].values(), default=None)
    yield f"peak memory: server {number(summary['server_rss_mb'], 0)} MB, largest agent {number(agents, 0)} MB"
    yield ''


def table(summary):
    yield from heads(summary)
    head = ('goal', 'robot', 'state', 'experiences', 'length m', 'time s', 'end mm', 'end deg', 'lateral mm', 'blind m')
    rows = [(g['to'], str(g['robot']), g['state'], str(len(g['route_experiences'])), number(g['length_m'], 1),
             number(g['duration_s'], 0), number(g['final_error_m'] and 1000 * g['final_error_m'], 1),
             number(g['final_heading_error_deg'], 2), number(g['lateral_rmse_m'] and 1000 * g['lateral_rmse_m'], 1),
             number(g['max_blind_m'], 2)) for g in summary['goals']]
    yield from columns(head, rows, 2)


def columns(head, rows, left):
    """A table of texts; the first columns, through `left`, stand left."""
    widths = [max(len(row[i]) for row in [head, *rows]) for i in range(len(head))]
    for row in [head, *rows]:
        yield '  '.join(cell.rjust(width) if i > left else cell.ljust(width) for i, (cell, width) in enumerate(zip(row, widths))).rstrip()
