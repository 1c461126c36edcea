"""How near two bodies came while one of them drove by itself. Truth of several robots has no common clock: a line of
truth.jsonl is written as it comes about, so that its order says who was where at once."""
import tomllib

from judging import geometry

DEFAULT_RADIUS_M = 0.28       # of the site file's base, docs/simulation.md
STANDS_M = 1e-4               # moved less from one frame to the next


def radius_m(site):
    """Of every body: a site describes one base."""
    if site is None or not site.exists():
        return DEFAULT_RADIUS_M
    return tomllib.loads(site.read_text()).get('base', {}).get('radius_m', DEFAULT_RADIUS_M)


def drives(records, frames_of):
    """robot -> frames in which it drove by itself; a hand's are nobody's."""
    found = {}
    for goal in records.goals:
        found.setdefault(goal['robot'], set()).update(frames_of(records, goal)[0])
    return found


def nearest(records, by_itself):
    """The least gap between two bodies of which one moved in a frame of `by_itself`, a robot's frames: gap_m (negative: they
    touched), robots, frame (of the one that moved); None where no two were ever seen at once."""
    last, least = {}, None
    diameter = 2 * radius_m(records.site)
    for robot, frame in records.order:
        here = records.truth[robot][frame]
        moved = robot in last and geometry.distance(last[robot], here) > STANDS_M
        last[robot] = here
        if not moved or frame not in by_itself.get(robot, ()):
            continue
        for other, there in last.items():
            gap = geometry.distance(here, there) - diameter
            if other != robot and (least is None or gap < least['gap_m']):
                least = dict(gap_m=gap, robots=[robot, other], frame=frame)
    return least
