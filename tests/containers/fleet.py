"""A server, light robots, and the operator's command, in the lab."""
import contextlib
import json
import pathlib
import re
import subprocess
import sys
import time

import lab

sys.path.insert(0, str(lab.TOP / 'deploy' / 'demonstration'))
import lines  # noqa: E402

PACE = 6
SERVER_NUMBER, OPERATOR_NUMBER, FIRST_ROBOT = 10, 11, 20
VENDORS = ('fastdds', 'cyclonedds')
SERVER_DISK_MB, ROBOT_DISK_MB = 96, 24
OVER = ('succeeded', 'failed', 'cancelled', 'rejected')
NOT_REACHED = 3
FAKETIME = '/usr/lib/x86_64-linux-gnu/faketime'


class Fleet:
    def __init__(self, lab_, robots, say, dds='fastdds'):
        self.lab, self.say, self.dds = lab_, say, dds
        self.names = [f'r{number}' for number in range(1, robots + 1)]
        self.accepted, self.ended = [], {}       # goals that were answered; id -> how they ended
        self.killed = set()                      # containers that are down on purpose
        self.server_number = SERVER_NUMBER
        self.restarts = 0
        self.patience = 20                       # seconds that a command waits for its answer
        self.helped = {}                         # robot -> when it was sent out of the way last

    # ---- processes
    def start_alone(self):
        """The server and the operator's command."""
        self.start_server()
        self.operator = self.lab.start('operator', OPERATOR_NUMBER, 'weft-server', 'infinity', entry='sleep')
        self.operator_pid = self.operator.pid()
        self.wait_server()

    def start(self):
        self.start_alone()
        for name in self.names:
            self.start_robot(name)
        self.wait_heard(self.names)

    def start_server(self, number=SERVER_NUMBER, gate=None):
        self.server_number = number
        return self.begin_at(gate, 'server', number, 'weft-server', ['--store', '/var/lib/weft/map', '--listen', 'eth0', '--dds', self.dds], SERVER_DISK_MB)

    def begin_at(self, gate, name, number, program, argv, disk, flags=()):
        """Starts a program in a container; with a gate, a file, it begins when that is there."""
        if gate:
            argv = ['-c', f'while [ ! -e {gate} ]; do sleep 0.1; done; exec "$0" "$@"', program, *argv]
        return self.lab.start(name, number, 'weft-server', *argv, entry='/bin/sh' if gate else program, flags=['--restart', 'on-failure', *flags], disk=disk)

    def start_robot(self, name, skew=None, gate=None, of=1, pace=PACE, last=0):
        """One robot, or `of` them in one process, from that name on: then of Fast DDS, as Cyclone DDS takes one bus a process. `last`: the
        highest number of all, by which they stand evenly on the ring."""
        number = int(name[1:])
        flags = []
        if skew is not None:
            flags = ['-v', f'{FAKETIME}:{FAKETIME}:ro', '-e', f'LD_PRELOAD={FAKETIME}/libfaketimeMT.so.1', '-e', f'FAKETIME={skew:+d}s', '-e',
                     'FAKETIME_DONT_FAKE_MONOTONIC=1']
        argv = ['--first', number, '--robots', of, '--fleet', last or max(len(self.names), number + of - 1), '--pace', pace, '--state', '/var/lib/weft',
                '--records', '/records', '--listen', 'eth0', '--server', 'server', '--dds', VENDORS[number % 2] if of == 1 else VENDORS[0]]
        return self.begin_at(gate, name, FIRST_ROBOT + number, '/light/weft-light-agents', argv, ROBOT_DISK_MB, flags)

    def end_robots(self):
        """Ends all robots of the fleet in good order; none comes back."""
        for name in self.names:
            lab.docker('stop', name)
            self.killed.add(name)

    def start_newcomer(self, name, protocol):
        """One that greets as an agent of another protocol, and does nothing else."""
        number = int(name[1:])
        return self.begin_at(None, name, FIRST_ROBOT + number, '/light/weft-light-agents', ['--first', number, '--fleet', number, '--protocol', protocol, '--state',
                             '/var/lib/weft', '--records', '/records', '--listen', 'eth0', '--server', 'server'], ROBOT_DISK_MB)

    def node(self, name):
        return self.lab.nodes[name]

    def meter(self, names):
        return lab.Meter([self.node(name) for name in names])

    def start_late(self, name, start):
        """Starts a container whose program begins while its cable is out, and puts it in once the program says that it waits for it."""
        self.lab.remove(name)
        gate = self.lab.folder('records', name) / 'go'
        gate.unlink(missing_ok=True)
        node = start(gate='/records/go')
        node.link(up=False)
        gate.touch()
        lab.wait_until(f'{name} to say that it waits for its link', lambda: 'waits for its link' in self.lab.log(name, 'all'), 20)
        node.link(up=True)

    def kill_server(self):
        self.node('server').kill()

    def restart_server(self):
        self.node('server').start()
        self.restarts += 1
        self.wait_server()

    def begin_journal(self):
        """Has the server end in good order and start anew: then its store has no journal yet."""
        lab.docker('stop', 'server')
        self.restart_server()
        self.wait_heard(self.names)

    def wait_server(self):
        return lab.wait_until('the server to answer', lambda: self.weft('map', 'info', timeout=3, good=None), 20)

    # ---- the operator
    def argv(self, *words, timeout=None):
        timeout = timeout or self.patience
        return ['nsenter', '-t', str(self.operator_pid), '-n', str(lab.WORK / 'bin' / 'weft'), '--listen', 'eth0', '--server',
                f'{lab.SUBNET}.{self.server_number}', '--timeout', str(timeout), '--json', *(str(word) for word in words)]

    def weft(self, *words, timeout=None, good=(0,)):
        """Returns the answer; with `good` None, none where the command fails."""
        for _ in range(lab.SLOW):
            done = subprocess.run(self.argv(*words, timeout=timeout), capture_output=True, text=True, stdin=subprocess.DEVNULL, timeout=(timeout or self.patience) + 30)
            if good is None or done.returncode != NOT_REACHED:
                break                            # a machine that is busy may need more than the ten seconds in which a server has to greet
        if good is None and done.returncode:
            return None
        if good is not None and done.returncode not in good:
            raise lab.Trouble(f"weft {' '.join(str(w) for w in words)}: exit {done.returncode}: {(done.stderr or done.stdout).strip()[-300:]}")
        return json.loads(done.stdout) if done.stdout.strip() else {}

    @contextlib.contextmanager
    def slow_robots(self, kbit):
        """Has each robot on a link of so many kbit a second, meanwhile."""
        with contextlib.ExitStack() as links:
            for name in self.names:
                links.enter_context(self.node(name).slow(kbit))
            yield

    @contextlib.contextmanager
    def patient(self, seconds):
        """Has commands wait so long for their answers, meanwhile."""
        before, self.patience = self.patience, seconds
        try:
            yield
        finally:
            self.patience = before

    def ask(self, *words):
        """(exit code, all that it said)."""
        done = subprocess.run(self.argv(*words), capture_output=True, text=True, stdin=subprocess.DEVNULL, timeout=self.patience + 30)
        return done.returncode, done.stdout + done.stderr

    def begin(self, *words, timeout=60):
        return subprocess.Popen(self.argv(*words, timeout=timeout), stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, stdin=subprocess.DEVNULL,
                                preexec_fn=lab.die_with_parent)

    def finish(self, command, accepts=True, seconds=90):
        out, err = command.communicate(timeout=seconds)
        if command.returncode:
            raise lab.Trouble(f'weft: exit {command.returncode}: {(err or out).strip()[-300:]}')
        answer = json.loads(out)
        if accepts:
            self.accepted.append(answer['goal'])
        return answer

    def robots(self):
        return {row['name']: row for row in self.weft('robots')['robots']}

    def robot(self, name):
        return self.robots().get(name, {})

    def wait_heard(self, names, heard=True, seconds=30):
        def all_are():
            rows = self.robots()
            return all(rows.get(name, {}).get('heard', False) == heard for name in names)
        began = time.monotonic()
        lab.wait_until(f"{', '.join(names)} to be {'heard' if heard else 'silent'}", all_are, seconds)
        return time.monotonic() - began

    # ---- teaching
    def teach(self, names):
        """Leads robots along their lines at once, and labels stations; each label is where its robot stood."""
        folder = lab.ROOT / 'lines'
        folder.mkdir(exist_ok=True)
        lab.run(lab.WORK / 'light' / 'weft-light-agents', '--lines', folder, '--robots', len(self.names), '--fleet', len(self.names))
        work = {name: iter(self.lesson(name, folder / f'{name}.line')) for name in names}
        waiting = {name: next(steps) for name, steps in work.items()}
        end = time.monotonic() + 240 * lab.SLOW
        while waiting:
            if time.monotonic() > end:
                raise lab.Trouble(f"teaching did not end: {', '.join(waiting)}")
            rows = self.robots()
            for name, done in list(waiting.items()):
                if done(rows[name]):
                    waiting[name] = next(work[name], None)
                    if waiting[name] is None:
                        del waiting[name]
            time.sleep(0.1)

    def lesson(self, name, line):
        """Yields what to wait for."""
        for number, (points, label) in enumerate(lines.parts(line)):
            part = lines.write(points, line.with_suffix(f'.{number}'))
            before = self.robot(name).get('frame', 0)
            self.weft('teach', name, 'start', '--as', f'{name}-ring', '--along', part)
            yield lambda row: row['reason'] == 'hand_done' and row['frame'] > before + 5
            if label:
                self.weft('map', 'label', 'here', '--robot', name, label)
        self.weft('teach', name, 'stop')

    def lead(self, records, name, experience, metres):
        """Begins to teach a robot along so many metres of its line, from where it truly stands."""
        folder = lab.ROOT / 'lines'
        lab.run(lab.WORK / 'light' / 'weft-light-agents', '--lines', folder, '--first', name[1:], '--robots', 1, '--fleet', len(self.names))
        points = [point for part, _ in lines.parts(folder / f'{name}.line') for point in part]
        lab.wait_until(f'{name} to have no goal', lambda: (lambda row: row['mode'] == 'idle' and row['goal'] is None)(self.robot(name)), 30)
        here = records.update().robots[name].rows[-1][2:4]
        nearest = min(range(len(points)), key=lambda i: (points[i][0] - here[0]) ** 2 + (points[i][1] - here[1]) ** 2)
        ahead = (points + points)[nearest + 8:nearest + 8 + round(metres / 0.25)]
        part = lines.write([here, *ahead], folder / f'{name}.part')

        def begun():                                # until then it may have been asked to make way once more
            return self.weft('teach', name, 'start', '--as', experience, '--along', part, timeout=60, good=None)
        lab.wait_until(f'{name} to be taught', begun, 30, every=0.5)

    def lead_on(self, records, name, experience, metres):
        """Teaches a robot so much more, to the end."""
        before = self.robot(name)['frame']
        self.lead(records, name, experience, metres)
        lab.wait_until(f'{name} to be led on', lambda: (lambda row: row['reason'] == 'hand_done' and row['frame'] > before + 5)(self.robot(name)), 40)
        self.weft('teach', name, 'stop', timeout=60)

    def localise(self, names):
        def located():
            rows = self.robots()
            return all(rows[name]['localised'] for name in names)
        for name in names:
            self.weft('localise', name)
        lab.wait_until(f"{', '.join(names)} to find themselves", located, 30)

    # ---- goals
    def send(self, station, robot=None):
        goal = self.weft('goal', 'send', '--to', f'station-{station}', *(['--robot', robot] if robot else []))['goal']
        self.accepted.append(goal)
        return goal

    def send_under_way(self, station, robot, share):
        goal = self.send(station, robot)
        self.wait_under_way(goal, share)
        return goal

    def goals(self):
        return {row['id']: row for row in self.weft('goal', 'list')['goals']}

    def wait_goals(self, ids, seconds=60, states=OVER):
        def there():
            rows = self.goals()
            self.help()
            return all(rows[goal]['state'] in states for goal in ids) and rows
        return lab.wait_until(f"{len(ids)} goals to be {'over' if states == OVER else '/'.join(states)}", there, seconds, every=0.3)

    def help(self):
        """Does what the server says would help, as an operator does: sends an idle robot that is in the way elsewhere."""
        for row in self.robots().values():
            name = re.search(r'--robot (r\d+)', row.get('standstill') or '')
            if name and time.monotonic() > self.helped.get(name.group(1), 0) + 10:
                self.helped[name.group(1)] = time.monotonic()
                self.weft('goal', 'send', '--to', f'station-{len(self.helped) * 3 % 8}', '--robot', name.group(1), good=None)

    def wait_under_way(self, goal, share=0.2):
        """Until its robot has driven that share of its route."""
        def driven():
            row = self.goals()[goal]
            return row['state'] in OVER or (row['state'] == 'executing' and (row.get('route_at') or 0) >= share * len(row['route']) > 0)
        lab.wait_until(f'goal {goal} to be under way', driven, 40)
        return self.goals()[goal]

    def succeed(self, ids, seconds=60):
        rows = self.wait_goals(ids, seconds)
        failed = [f"{rows[goal]['to']} {rows[goal]['state']}" for goal in ids if rows[goal]['state'] != 'succeeded']
        if failed:
            raise lab.Trouble(f"{len(failed)} of {len(ids)} goals did not succeed: {', '.join(failed[:4])}")

    def events(self, kind):
        """How many of the last thousand events are of that kind."""
        return sum(row['kind'] == kind for row in self.event_rows('--kind', kind, '--last', 1000))

    def told(self, kind, name=None):
        """What the last event of that kind says, of a robot if one is named; none: there is none."""
        rows = self.event_rows('--kind', kind, *(['--robot', name] if name else []))
        return rows[-1]['cause'] if rows else None

    def event_rows(self, *words):
        done = subprocess.run(self.argv('events', *words), capture_output=True, text=True, stdin=subprocess.DEVNULL, timeout=60)
        return [json.loads(line) for line in done.stdout.splitlines()]

    def alarms(self, name):
        """The kinds of the alarms of a robot."""
        return {row['kind'] for row in self.weft('alarms', good=(0, 1))['alarms'] if row['robot'] == name}

    def wait_alarm(self, name, kind, is_raised=True):
        lab.wait_until(f"the alarm {kind} of {name} to be {'raised' if is_raised else 'over'}", lambda: (kind in self.alarms(name)) == is_raised, 40)

    def export(self):
        path = lab.ROOT / 'network.json'
        self.weft('map', 'export', path)
        return json.loads(pathlib.Path(path).read_text())
