"""Both programs hang: systemd sees it, and starts them again."""
from playing.processes import wait_until

import bench as shop

TITLE, SECONDS = 'programs that hang are started again', 180


def run(bench):
    hung = ((bench.robot, shop.AGENT), (bench.server, shop.SERVER))
    before = {unit: machine.unit(unit) for machine, unit in hung}
    runs = bench.runs()
    for machine, unit in hung:
        machine.run(f"kill -STOP {before[unit]['MainPID']}")
    broken = []
    for machine, unit in hung:
        after = bench.wait_active(machine, unit, other_than=before[unit]['MainPID'])
        broken += [] if int(after['NRestarts']) > int(before[unit]['NRestarts']) else [f"{unit} was started again {after['NRestarts']} times"]
        broken += [] if 'watchdog' in machine.run(f'journalctl --no-pager -u {unit}').lower() else [f'the journal has no watchdog of {unit}']
    bench.wait_heard()
    wait_until('the map to be served', lambda: bench.weft('map', 'info', good=None), 30)
    return broken + ([] if bench.runs() == runs else ['the map is another one'])
