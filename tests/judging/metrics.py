"""What the judge counts. Truth is joined by frame number, never by time."""
import math

from judging import contact, geometry

RIGHT_FIX = (0.05, 2.0)       # metres, degrees
RIGHT_STITCH = (0.10, 3.0)
JOIN_M = 1.0                  # left out of the lateral error around each join


def within(measured, true, bounds):
    metres, degrees = geometry.error(measured, true)
    return metres <= bounds[0] and degrees <= bounds[1]


def stitches(records):
    """Every stitch with whether it is right."""
    rows = []
    for edge in records.network['edges']:
        if edge['origin'] != 'stitch':
            continue
        relation = (edge['a_from_b']['x'], edge['a_from_b']['y'], edge['a_from_b']['heading'])
        true = geometry.between(records.true_place(edge['a']), records.true_place(edge['b']))
        metres, degrees = geometry.error(relation, true)
        rows.append(dict(a=edge['a'], b=edge['b'], error_m=metres, error_deg=degrees,
                         right=metres <= RIGHT_STITCH[0] and degrees <= RIGHT_STITCH[1],
                         joins=records.places[edge['a']]['experience'] != records.places[edge['b']]['experience']))
    return rows


def stitched_metres(records, found):
    """Separate metres of the stitching experience's true path that carry a right stitch to another experience."""
    along = {}
    by_experience = {}
    for place in records.places.values():
        by_experience.setdefault(place['experience'], []).append(place)
    for places in by_experience.values():
        length, before = 0.0, None
        for place in sorted(places, key=lambda row: row['index']):
            here = records.true_place(place['id'])
            length += geometry.distance(here, before) if before else 0.0
            along[place['id']] = length
            before = here
    return len({(records.places[row['b']]['experience'], math.floor(along[row['b']]))
                for row in found if row['right'] and row['joins']})


def lost_acknowledged(records):
    """(acknowledged batches, those not found once and whole in the network). An ack names the places it made durable."""
    acknowledged = {(row['experience'], row['sequence']): row for row in records.acks}
    ids = [row['id'] for row in records.network['places']]
    twice = len(ids) - len(set(ids))
    lost = sum(1 for (experience, _), row in acknowledged.items()
               if any(f'{experience}:{index}' not in records.places
                      for index in range(row['first'], row['first'] + row['places'])))
    return len(acknowledged), lost + twice


def taught_polyline(records, route):
    """True taught path along a route as pieces (one for each stretch of one experience), and the joins: between pieces,
    and where the robot, which may have stood beside the path, joins the first."""
    pieces, joins = [], [records.true_place(route[0])]
    for place in route:
        row = records.places[place]
        if pieces and pieces[-1][-1]['experience'] == row['experience'] and pieces[-1][-1]['index'] + 1 == row['index']:
            pieces[-1].append(row)
        else:
            if pieces:
                joins += [records.true_place(pieces[-1][-1]['id']), records.true_place(place)]
            pieces.append([row])
    polyline = []
    for piece in pieces:
        frames = records.truth[piece[0]['robot']]
        polyline.append([frames[f] for f in range(piece[0]['frame'], piece[-1]['frame'] + 1) if f in frames])
    return polyline, joins


def goal_frames(records, goal):
    """The robot's frames of its drive, first to last, and the frame at which it said that it had arrived."""
    rows = [row for row in records.drives if row['goal'] == goal['id'] and row['robot'] == goal['robot']]
    arrived = [row['frame'] for row in rows if row['phase'] == 'arrived']
    if not rows:
        return [], None
    last = arrived[0] if arrived else max(row['frame'] for row in rows)
    return range(min(row['frame'] for row in rows), last + 1), (arrived[0] if arrived else None)


def max_blind_m(records, robot, frames):
    """Greatest true distance driven between consecutive right fixes, the start included."""
    right = set()
    for fix in records.fixes:
        if fix['robot'] == robot and fix['frame'] in frames:
            relation = fix['place_from_robot']
            believed = geometry.compose(records.true_place(fix['place']), (relation['x'], relation['y'], relation['heading']))
            if within(believed, records.true_pose(robot, fix['frame']), RIGHT_FIX):
                right.add(fix['frame'])
    worst, since, before = 0.0, 0.0, None
    for frame in frames:
        here = records.truth[robot].get(frame)
        if here is None:
            continue
        since += geometry.distance(here, before) if before else 0.0
        before = here
        worst = max(worst, since)
        if frame in right:
            since = 0.0
    return worst


def lateral(records, robot, frames, route):
    pieces, joins = taught_polyline(records, route)
    errors = []
    for frame in frames:
        here = records.truth[robot].get(frame)
        if here is None or any(geometry.distance(here, join) < JOIN_M for join in joins):
            continue
        errors.append(min(geometry.to_polyline(here, piece) for piece in pieces if piece))
    return math.sqrt(sum(e * e for e in errors) / len(errors)) if errors else None


def driven_m(records, robot, frames):
    poses = [records.truth[robot][f] for f in frames if f in records.truth[robot]]
    return sum(geometry.distance(p, q) for p, q in zip(poses, poses[1:]))


def judge_goal(records, goal):
    frames, arrived = goal_frames(records, goal)
    route = goal['route']
    experiences = []
    for place in route:
        name = records.places[place]['experience']
        if not experiences or experiences[-1] != name:
            experiences.append(name)
    indices = [records.places[p]['index'] for p in route]
    whole = len(set(experiences)) == 1 and all(b == a + 1 for a, b in zip(indices, indices[1:]))
    row = dict(id=goal['id'], robot=goal['robot'], to=goal['to'], state=goal['state'],
               route_experiences=list(dict.fromkeys(experiences)), taught_whole=whole,
               length_m=driven_m(records, goal['robot'], frames), duration_s=goal['duration_s'],
               final_error_m=None, final_heading_error_deg=None,
               lateral_rmse_m=lateral(records, goal['robot'], frames, route) if route else None,
               max_blind_m=max_blind_m(records, goal['robot'], frames))
    if goal['state'] == 'succeeded' and arrived is not None:
        row['final_error_m'], row['final_heading_error_deg'] = geometry.error(
            records.true_pose(goal['robot'], arrived), records.true_place(goal['place']))
    return row


def common(records, found, by_itself):
    """Returns the numbers that are told of every demo: `found` are its stitches, `by_itself` as contact.nearest wants it."""
    acknowledged, lost = lost_acknowledged(records)
    rss = {row['name']: row['peak_memory_mb'] for row in records.processes}
    return dict(
        dds={row['name']: row['vendor'] for row in records.processes},
        robots=len(records.truth), places=len(records.places),
        experiences=len({row['experience'] for row in records.places.values()}),
        stitches=len(found), wrong_stitches=sum(not row['right'] for row in found),
        nearest=contact.nearest(records, by_itself),
        acknowledged=acknowledged, lost_acknowledged=lost,
        server_rss_mb=rss.get('server'),
        agent_rss_mb={name: mb for name, mb in rss.items() if name not in ('server', 'cli')})


def summarise(records):
    found = stitches(records)
    return dict(common(records, found, contact.drives(records, goal_frames)),
                stitched_metres=stitched_metres(records, found),
                goals=[judge_goal(records, goal) for goal in records.goals])
