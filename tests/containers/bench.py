"""What scenarios share: the lab, one fleet of light robots that has been taught, and the invariants after each of them."""
import math
import pathlib
import shutil
import sys
import time

import fleet as fleets
import lab

sys.path.insert(0, str(lab.TOP / 'tests'))
from judging import network  # noqa: E402

ROBOTS = 6
HEALS_IN = 60
MORE_FILES = 60            # open files that a process may have more than when it was looked at first


class Bench:
    def __init__(self, say, build):
        self.say, self.build, self.numbers = say, build, {}
        self.lab, self.fleet, self.records = None, None, None
        self.ended, self.files, self.restarts = {}, {}, {}
        self.unknown = set()                     # robots that speak under another one's identity: where they stand nobody is told
        self.may_end = False                     # programs that a scenario attacks may end, and are started anew

    def open_lab(self):
        if self.lab is None:
            self.lab = lab.Lab()
            self.lab.open()
        return self.lab

    def at_most(self, what, factor, most):
        """Keeps what was measured, and holds it to a bound."""
        self.numbers[what] = f'{factor:.2f}'
        if factor > most:
            raise lab.Trouble(f'{what}: {factor:.1f}, {most} at most are wanted')

    def close_lab(self):
        if self.lab is not None:
            self.lab.engine.stop()
        self.lab = self.fleet = self.records = None
        self.ended, self.files, self.restarts = {}, {}, {}
        lab.clean()

    def start_fleet(self):
        """A fleet that knows nothing yet."""
        self.fleet = fleets.Fleet(self.open_lab(), ROBOTS, self.say)
        self.fleet.start()
        self.records = network.Records(lab.ROOT / 'records')
        return self.fleet

    def taught(self):
        """The shared fleet, which r1 and r2 have taught the ring; all robots know where they are."""
        if self.fleet is None:
            self.teach_fleet()
        return self.fleet

    def teach_fleet(self):
        fleet = self.start_fleet()
        began = time.monotonic()
        fleet.teach(['r1', 'r2'])
        fleet.localise([name for name in fleet.names if not fleet.robot(name)['localised']])
        info = fleet.weft('map', 'info')
        self.say(f"taught in {time.monotonic() - began:.0f} s: {info['places']} places, {info['stitches']} stitches")
        return fleet

    # ---- what holds after each scenario
    def broken(self, since):
        """The invariants that do not hold now, in words."""
        if self.fleet is None:
            return []
        fleet = self.fleet
        rows = self.heal()
        names = {row['id']: row['name'] for row in fleet.weft('robots')['robots']}
        records = self.records.update(fleet.export())
        broken = [f'A1: {what}' for what in network.acknowledged(records)]
        broken += [f'A2: {what}' for what in network.goals(fleet.accepted, rows.values(), self.ended)]
        self.ended = {goal: row['state'] for goal, row in rows.items() if row['state'] in network.OVER}
        beyond, on_routes = network.released(records, records.true_places(names), since)
        moving, standing = network.stands(records, since)
        touching, least = network.apart(records, since, self.unknown)
        broken += [f'A3: {what}' for what in beyond] + [f'A4: {what}' for what in moving] + [f'A5: {what}' for what in touching]
        broken += [f'A6: {what}' for what in self.windows()] + [f'A7: {what}' for what in self.processes(since)]
        nearest = f', robots never nearer than {least:.2f} m' if math.isfinite(least) else ''
        self.say(f'judged {len(records.acks)} acknowledged batches, {on_routes} frames on routes, {standing} standing{nearest}')
        return broken

    def heal(self):
        """All goals, once those that were accepted are over; robots that are lost look for themselves."""
        fleet, end = self.fleet, time.monotonic() + HEALS_IN
        while True:
            rows = fleet.goals()
            if all(rows.get(goal, {}).get('state') in network.OVER for goal in fleet.accepted if goal in rows) or time.monotonic() > end:
                return rows
            fleet.help()
            for name, row in fleet.robots().items():
                if row['mode'] == 'lost':
                    fleet.weft('localise', name, good=None)
            time.sleep(1)

    def windows(self):
        """Robots whose window is not what the server has for them, a while after everything has ended."""
        def behind():
            rows = self.fleet.robots()
            return [name for name in self.fleet.names if name not in self.fleet.killed and not rows[name]['window_current']]
        end = time.monotonic() + HEALS_IN
        while (left := behind()) and time.monotonic() < end:
            time.sleep(0.5)
        return [f"the window of {name} is not the server's" for name in left]

    def processes(self, since):
        """What is wrong with the containers: crashed, ended, started anew by the engine, short of memory, or with ever more open files."""
        crashed = lab.crashes(time.time() - (time.monotonic() - since))
        broken = [] if self.may_end else [f'{name} has crashed, code {code}' for name, code in crashed.items()]
        for name, node in self.lab.nodes.items():
            if name in self.fleet.killed:
                continue
            running, oom, code, restarts = node.inspect('{{.State.Running}} {{.State.OOMKilled}} {{.State.ExitCode}} {{.RestartCount}}').split()
            if int(restarts) > self.restarts.get(name, 0) and not self.may_end:
                broken.append(f'{name} has ended by itself, and was started anew: {self.lab.log(name, 2).strip()}')
            self.restarts[name] = int(restarts)
            if running != 'true' or oom != 'false':
                broken.append(f'{name} has ended, code {code}{", out of memory" if oom == "true" else ""}: {self.lab.log(name, 2).strip()}')
                continue
            files = node.open_files()
            if files > self.files.setdefault(name, files) + MORE_FILES:
                broken.append(f'{name} has {files} open files, {self.files[name]} at first')
        return broken

    def peak_memory_mb(self, name):
        path = pathlib.Path('/sys/fs/cgroup/memory') / lab.TAG / self.lab.nodes[name].inspect('{{.Id}}') / 'memory.max_usage_in_bytes'
        try:
            return int(path.read_text()) / 1e6
        except OSError:
            return 0.0

    def keep_logs(self, scenario):
        """Saves every container's log, for people who look into a failure."""
        folder = lab.WORK / 'logs' / scenario
        shutil.rmtree(folder, ignore_errors=True)
        folder.mkdir(parents=True)
        for name in self.lab.nodes if self.lab else ():
            (folder / f'{name}.log').write_text(lab.run('sh', '-c', f'/usr/bin/docker logs {name} 2>&1', env=lab.environment(), check=False))
        for kind in ('records',):
            if (lab.ROOT / kind).exists():
                shutil.copytree(lab.ROOT / kind, folder / kind, dirs_exist_ok=True)
