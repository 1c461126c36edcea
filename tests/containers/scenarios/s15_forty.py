"""Forty light robots at the real pace, ten in a process, join at once: what an agent sends and receives, and how soon a goal is assigned."""
import concurrent.futures
import time

from forty import Forty

TITLE, SECONDS = 'forty robots join at once', 240
ROBOTS, IN_ONE = 40, 10
LOOK_S, TAUGHT, DRIVE = 10, 10, 3


def run(bench):
    fleet = bench.taught()
    fleet.end_robots()                 # they have made the map; at six times the real pace they would take as much as the forty
    robots = Forty(fleet, ROBOTS, IN_ONE)
    bench.numbers['forty robots, all heard'] = robots.join()

    def look(what):
        meter = fleet.meter(robots.processes)
        time.sleep(LOOK_S)                                           # what is measured
        bench.numbers[f'forty robots, {what}, bytes/s an agent'] = meter.read(ROBOTS)
    look('idle')
    with concurrent.futures.ThreadPoolExecutor(4) as some:
        few = robots.names[:TAUGHT]                                  # as many as two cores drive beside the others
        list(some.map(robots.teach, few))
        look(f"{robots.wait_count('teaching', TAUGHT)} of them being taught")
        list(some.map(robots.end_teaching, few))
        list(some.map(robots.send, few))
    look(f"{robots.wait_count('driving', DRIVE)} of them driving")
    bench.numbers['forty robots, from a goal at the server to `assigned`'] = robots.until_assigned()
    robots.leave()
