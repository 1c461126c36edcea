"""Many light robots at the real pace beside the fleet, several in a process: they join, are taught, and drive."""
import datetime
import statistics
import time

import fleet as fleets
import lab

FIRST = 101
PIECE = 160                # points of its line along which each is taught


def seconds_until(goal, state):
    """From when the server had the goal; none: it has not come to that state."""
    at = {row['state']: datetime.datetime.fromisoformat(row['at'].replace('Z', '+00:00')) for row in reversed(goal['history'])}
    return (at[state] - at['pending']).total_seconds() if state in at else None


class Forty:
    def __init__(self, fleet, robots, in_one):
        self.fleet, self.in_one = fleet, in_one
        self.names = [f'r{number}' for number in range(FIRST, FIRST + robots)]
        self.processes = self.names[::in_one]
        self.folder = lab.ROOT / 'lines'
        self.goals = []

    def join(self):
        """Starts them at once, and says how long it took until the server heard all."""
        began, last = time.monotonic(), FIRST + len(self.names) - 1
        for name in self.processes:
            self.fleet.start_robot(name, of=self.in_one, pace=1, last=last)
        started = time.monotonic() - began
        self.fleet.wait_heard(self.names, seconds=60)
        lab.run(lab.WORK / 'light' / 'weft-light-agents', '--lines', self.folder, '--first', FIRST, '--robots', len(self.names), '--fleet', last)
        return f'{time.monotonic() - began:.1f} s after the first of {len(self.processes)} containers was started, which took {started:.1f} s'

    def count(self, mode):
        rows = self.fleet.robots()
        return sum(rows[name]['mode'] == mode for name in self.names)

    def wait_count(self, mode, least):
        """How many are in that mode, as soon as there are enough."""
        return lab.wait_until(f'{least} robots to be {mode}', lambda: (lambda many: many >= least and many)(self.count(mode)), 60, every=0.5)

    def teach(self, name):
        points = [point for part, _ in fleets.lines.parts(self.folder / f'{name}.line') for point in part]
        part = fleets.lines.write(points[:PIECE], self.folder / f'{name}.part')
        self.fleet.weft('teach', name, 'start', '--as', f'{name}-piece', '--along', part, timeout=60)

    def end_teaching(self, name):
        self.fleet.weft('teach', name, 'stop', timeout=120)
        self.fleet.weft('localise', name, good=None)

    def send(self, name):
        self.goals.append(self.fleet.weft('goal', 'send', '--to', f'station-{len(self.goals) % 8}', '--robot', name, timeout=60)['goal'])

    def until_assigned(self):
        """Says how soon goals were assigned, beside what the network takes: an operator's message to the server and back."""
        rows, trip = self.fleet.goals(), self.fleet.weft('doctor', 'network', timeout=60, good=(0, 1))['network']['small']
        took = sorted(took for goal in self.goals if (took := seconds_until(rows[goal], 'assigned')) is not None)
        return (f'{1000 * statistics.median(took):.0f} ms median, {1000 * took[-1]:.0f} ms at most, of {len(took)} of {len(self.goals)}; there and back by '
                f"DDS {1000 * trip['delay_median_s']:.1f} ms median, {1000 * trip['delay_99_s']:.1f} ms for 99 %")

    def leave(self):
        for goal in self.goals:                                          # there is no room for forty on this ring
            self.fleet.weft('goal', 'cancel', goal, good=None)
        for name in self.processes:
            lab.docker('stop', '-t', '20', name)
            self.fleet.lab.remove(name)
