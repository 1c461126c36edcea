"""The fleet of a demo: one server, three robots, and the operator's command line, each on the vendor it was given."""
import json
import pathlib
import subprocess

from processes import Process, Watch, wait_until

VENDORS = {
    'fastdds': dict(server='fastdds', r1='fastdds', r2='fastdds', r3='fastdds', cli='fastdds'),
    'cyclonedds': dict(server='cyclonedds', r1='cyclonedds', r2='cyclonedds', r3='cyclonedds', cli='cyclonedds'),
    'mixed': dict(server='fastdds', r1='cyclonedds', r2='fastdds', r3='cyclonedds', cli='cyclonedds'),
}
ROBOTS = ('r1', 'r2', 'r3')


class Refused(RuntimeError):
    pass


class Fleet:
    def __init__(self, options, say):
        self.options, self.say = options, say
        self.vendors = VENDORS[options.dds]
        self.out = pathlib.Path(options.out)
        self.bin = pathlib.Path('build/release/bin')
        self.work = self.out / 'run'
        self.experiences = {}      # id -> the name that it was taught as
        self.work.mkdir(parents=True, exist_ok=True)
        self.server = Process('server', self.server_argv(), self.work / 'server.log')
        self.robots = {name: Process(name, self.robot_argv(name), self.work / f'{name}.log') for name in ROBOTS}
        self.watch = Watch(self.all())

    def all(self):
        return [self.server, *self.robots.values()]

    def wire(self, who):
        return ['--dds', self.vendors[who], '--domain', self.options.domain]

    def server_argv(self):
        return [self.bin / 'weft-server', *self.wire('server'), '--store', self.work / 'store', '--name', 'server']

    def robot_argv(self, name):
        argv = [self.bin / 'weft-agent', *self.wire(name), '--server', '127.0.0.1', '--name', name,
                '--state', self.work / name, '--method', 'floor', '--body', 'sim', '--site', self.options.site_file,
                '--seed', self.options.seed, '--records', self.out, '--truth', self.out / 'truth.jsonl', '--pace', self.options.pace]
        return argv + (['--floors', self.options.floors] if self.options.floors else [])

    def weft(self, *arguments, timeout=20):
        """What the operator types; the answer as JSON. Refused carries the command's own words."""
        argv = [self.bin / 'weft', '--server', '127.0.0.1', *self.wire('cli'), '--timeout', timeout, '--json', *arguments]
        done = subprocess.run([str(a) for a in argv], capture_output=True, text=True, timeout=timeout + 30)
        if done.returncode != 0:
            words = ' '.join(str(a) for a in arguments)
            raise Refused(f'weft {words}: exit {done.returncode}: {(done.stderr or done.stdout).strip()}')
        return json.loads(done.stdout) if done.stdout.strip() else None

    def start(self):
        self.server.start()
        wait_until('the server to answer', self.answers, 30, [self.server])
        for robot in self.robots.values():
            robot.start()
        self.watch.start()
        wait_until('three robots to report', lambda: len(self.weft('robots')['robots']) == len(ROBOTS), 60, self.all())

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

    def kill_and_restart_server(self):
        self.server.kill()
        self.server.start()
        wait_until('the restarted server to answer', self.answers, 30, [self.server])

    def stop(self):
        self.watch.over.set()
        for process in [*self.robots.values(), self.server]:
            process.stop()
