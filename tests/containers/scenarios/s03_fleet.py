"""Six light robots, both vendors mixed: two teach the ring, all serve twenty goals on a clean network."""
import time

import lab

TITLE, SECONDS = 'six robots are taught a ring and serve twenty goals', 150
GOALS, AT_ONCE = 20, 5
IDLE_S = 5


def measured(bench, what, work):
    fleet = bench.fleet
    meter = fleet.meter(fleet.names)
    work()
    bench.numbers[f'six robots, {what}, bytes/s a robot'] = meter.read(len(fleet.names))


def run(bench):
    fleet = bench.start_fleet()
    measured(bench, 'idle', lambda: time.sleep(IDLE_S))
    measured(bench, 'teaching (two of them)', lambda: fleet.teach(['r1', 'r2']))
    fleet.localise([name for name in fleet.names if not fleet.robot(name)['localised']])
    goals = []

    def drive():
        for number in range(0, GOALS, AT_ONCE):
            some = [fleet.send((3 * (number + k)) % 8) for k in range(AT_ONCE)]
            fleet.succeed(some, 60)
            goals.extend(some)
    measured(bench, 'driving', drive)
    rows = fleet.goals()
    bench.numbers['twenty goals, seconds each'] = f"{sum(rows[goal]['duration_s'] for goal in goals) / len(goals):.1f} on average"
    bench.numbers['peak memory, MB'] = f"server {bench.peak_memory_mb('server'):.0f}, robot {bench.peak_memory_mb('r1'):.0f}"
    if fleet.weft('map', 'info')['batches_refused']:
        raise lab.Trouble('the server refused batches on a clean network')
