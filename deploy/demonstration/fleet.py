"""The fleet of a demo: one server, some robots, and the operator's command line, each on the vendor it was given."""
import json
import pathlib
import subprocess

from processes import Process, Watch, wait_until

SERVERS = {'fastdds': ('fastdds', 'fastdds'), 'cyclonedds': ('cyclonedds', 'cyclonedds'), 'mixed': ('fastdds', 'cyclonedds')}


def vendors(dds, robots):
    """Returns the DDS vendor of each program: when mixed, Fast DDS for the server and every second robot, else Cyclone DDS."""
    server, other = SERVERS[dds]
    return dict(server=server, **{name: server if number % 2 else other for number, name in enumerate(robots)}, cli=other)


class Refused(RuntimeError):
    pass


class Fleet:
    def __init__(self, options, robots, say, server_flags=(), agent_flags=()):
        self.options, self.say = options, say
        self.server_flags, self.agent_flags = server_flags, agent_flags
        self.vendors = vendors(options.dds, robots)
        self.out = pathlib.Path(options.out)
        self.bin = pathlib.Path('build/release/bin')
        self.work = self.out / 'run'
        self.experiences = {}      # id -> the name that it was taught as
        self.killed = set()        # robots, for good
        self.work.mkdir(parents=True, exist_ok=True)
        self.server = Process('server', self.server_argv(), self.work / 'server.log')
        self.robots = {name: Process(name, self.robot_argv(name), self.work / f'{name}.log') for name in robots}
        self.watch = Watch(self.all())

    def all(self):
        """Returns the processes that are to run."""
        return [self.server, *(robot for name, robot in self.robots.items() if name not in self.killed)]

    def wire(self, who):
        return ['--dds', self.vendors[who], '--domain', self.options.domain]

    def server_argv(self):
        return [self.bin / 'weft-server', *self.wire('server'), '--store', self.work / 'store', '--name', 'server',
                *self.server_flags]

    def robot_argv(self, name):
        argv = [self.bin / 'weft-agent-sim', *self.wire(name), '--server', '127.0.0.1', '--name', name,
                '--state', self.work / name, '--method', 'floor', '--body', 'sim', '--site', self.options.site_file,
                '--seed', self.options.seed, '--records', self.out, '--truth', self.out / 'truth.jsonl', '--pace', self.options.pace]
        return argv + (['--floors', self.options.floors] if self.options.floors else []) + list(self.agent_flags)

    def weft(self, *arguments, timeout=20, good=(0,)):
        """Types a command as the operator does, and returns the answer as JSON. Refused carries the command's own words, when it exits
        with none of `good`."""
        answer = self.answer(*arguments, timeout=timeout, good=good)
        return json.loads(answer) if answer.strip() else None

    def answer(self, *arguments, timeout=20, good=(0,)):
        """Types it too, and returns the answer as it is printed."""
        argv = [self.bin / 'weft', '--server', '127.0.0.1', *self.wire('cli'), '--timeout', timeout, '--json', *arguments]
        done = subprocess.run([str(a) for a in argv], capture_output=True, text=True, timeout=timeout + 30)
        if done.returncode not in good:
            words = ' '.join(str(a) for a in arguments)
            raise Refused(f'weft {words}: exit {done.returncode}: {(done.stderr or done.stdout).strip()}')
        return done.stdout

    def start(self):
        self.server.start()
        wait_until('the server to answer', self.answers, 30, [self.server])
        for robot in self.robots.values():
            robot.start()
        self.watch.start()
        wait_until('all robots to report', lambda: sum(row['heard'] for row in self.weft('robots')['robots']) == len(self.robots), 60,
                   self.all())

    def answers(self):
        try:
            return self.weft('map', 'info', timeout=3)
        except Refused:
            return None

    def robot(self, name):
        found = [row for row in self.weft('robots')['robots'] if row['name'] == name]
        if not found:
            raise Refused(f'the server knows no robot {name} any more')
        return found[0]

    def wait_robot(self, name, what, condition, seconds):
        return wait_until(f'{name} {what}', lambda: condition(self.robot(name)), seconds, self.all(), every=0.5)

    def kill_robot(self, name):
        """Its agent; nobody restarts it."""
        self.killed.add(name)
        self.robots[name].kill()

    def kill_and_restart_server(self):
        self.server.kill()
        self.server.start()
        wait_until('the restarted server to answer', self.answers, 30, [self.server])

    def stop(self):
        self.watch.over.set()
        for process in [*self.robots.values(), self.server]:
            process.stop()
