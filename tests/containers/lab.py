"""A private engine in a network namespace without uplink, its containers, and faults. All of it below one folder, and
named after that, so that a run finds and removes what an aborted one left. Facts: docs/testing.md."""
import contextlib
import hashlib
import os
import pathlib
import re
import shutil
import signal
import subprocess
import sys
import time

TOP = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(TOP / 'tests'))
from playing.processes import SLOW, Trouble, die_with_parent, run, wait_until  # noqa: E402, F401

WORK = TOP / 'build' / 'containers'
ROOT = WORK / 'lab'
ENGINE = ROOT / 'engine'
TAG = 'weft-' + hashlib.sha1(str(ROOT).encode()).hexdigest()[:6]      # namespace and control group
NETWORK, SUBNET = 'bench', '10.77.0'
USER = 10001
CORE_SIGNALS = (signal.SIGQUIT, signal.SIGILL, signal.SIGTRAP, signal.SIGABRT, signal.SIGBUS, signal.SIGFPE, signal.SIGSEGV, signal.SIGSYS)


def environment():
    return dict(os.environ, DOCKER_HOST=f'unix://{ENGINE}/d.sock', DOCKER_CONFIG=str(ENGINE / 'client'), DOCKER_BUILDKIT='1',
                COMPOSE_DOCKER_CLI_BUILD='1', PATH='/usr/bin:/bin:/usr/sbin:/sbin', LANG='C.UTF-8')


def docker(*argv, **more):
    return run('/usr/bin/docker', *argv, env=environment(), **more)


class Engine:
    """dockerd, started by hand. For images it stands in the host's network, for tests in the lab's."""

    def __init__(self):
        self.process = None

    def start(self, in_lab):
        ENGINE.mkdir(parents=True, exist_ok=True)
        if len(f'{ENGINE}/d.sock') > 100:
            raise Trouble(f'{ENGINE} is too long a path for a socket')
        where = ['nsenter', f'--net=/run/netns/{TAG}'] if in_lab else []
        how = [] if in_lab else ['--iptables=false', '--ip-forward=false']
        with open(ENGINE / 'log', 'ab') as log:
            self.process = subprocess.Popen(
                [*where, 'dockerd', f'--data-root={WORK}/images', f'--exec-root={ENGINE}/exec', f'--pidfile={ENGINE}/pid', '-H',
                 f'unix://{ENGINE}/d.sock', '--bridge=none', f'--cgroup-parent=/{TAG}', '--log-level=warn', *how],
                stdout=log, stderr=log, stdin=subprocess.DEVNULL, preexec_fn=die_with_parent, env=dict(os.environ, PATH='/usr/sbin:/usr/bin:/sbin:/bin'))
        wait_until('the engine to answer', self.answers, 15)

    def answers(self):
        if self.process.poll() is not None:
            raise Trouble(f'dockerd ended: {(ENGINE / "log").read_text(errors="replace")[-400:].strip()}')
        return subprocess.run(['/usr/bin/docker', 'version'], env=environment(), capture_output=True).returncode == 0

    def stop(self):
        if self.process is None:
            return
        self.process.terminate()
        try:
            self.process.wait(10)
        except subprocess.TimeoutExpired:
            self.process.kill()
            self.process.wait()
        self.process = None


def own_processes():
    """Processes whose command line names this lab's folder, or that are in its control group; not this one's own family."""
    family, found = set(), []
    pid = os.getpid()
    while pid > 1:
        family.add(pid)
        pid = int(re.search(r'^PPid:\t(\d+)', pathlib.Path(f'/proc/{pid}/status').read_text(), re.M).group(1))
    for entry in pathlib.Path('/proc').glob('[0-9]*'):
        try:
            if int(entry.name) in family:
                continue
            command, group = (entry / 'cmdline').read_bytes().decode(errors='replace'), (entry / 'cgroup').read_text()
        except OSError:
            continue
        if str(ENGINE) in command or f'/{TAG}' in group or str(ROOT) in command:
            found.append(int(entry.name))
    return found


def own_mounts():
    rows = pathlib.Path('/proc/mounts').read_text().splitlines()
    return [row.split()[1] for row in rows if (row.split()[1] + '/').startswith((str(ROOT) + '/', str(WORK / 'images') + '/'))]


def crashes(since):
    """name -> exit code of the containers that a signal has ended of which a core tells, since that time of the wall clock."""
    said = docker('events', '--since', f'{since:.3f}', '--until', f'{time.time():.3f}', '--filter', 'event=die', '--format',
                  '{{.Actor.Attributes.name}} {{.Actor.Attributes.exitCode}}')
    ended = {name: int(code) for name, code in (line.split() for line in said.splitlines())}
    return {name: code for name, code in ended.items() if code - 128 in CORE_SIGNALS}


def clean():
    """Removes every process, mount, container, network, volume and namespace of this lab; the images stay."""
    end = time.monotonic() + 8
    while (left := own_processes()) and time.monotonic() < end:
        for pid in left:
            try:
                os.kill(pid, signal.SIGKILL)
            except ProcessLookupError:
                pass
        time.sleep(0.05)
    for mount in reversed(own_mounts()):
        subprocess.run(['umount', '-l', mount], capture_output=True)
    subprocess.run(['ip', 'netns', 'del', TAG], capture_output=True)
    for folder in ('network', 'volumes', 'containers', 'runtimes', 'swarm'):
        shutil.rmtree(WORK / 'images' / folder, ignore_errors=True)
    layers = WORK / 'images' / 'image' / 'overlay2' / 'layerdb' / 'mounts'
    for container in layers.glob('*'):                         # writable layers of containers that are gone
        for name in ('mount-id', 'init-id'):
            try:
                shutil.rmtree(WORK / 'images' / 'overlay2' / (container / name).read_text(), ignore_errors=True)
            except OSError:
                pass
        shutil.rmtree(container, ignore_errors=True)
    shutil.rmtree(ROOT, ignore_errors=True)
    for group in pathlib.Path('/sys/fs/cgroup').glob(f'*/{TAG}'):
        for inner in sorted(group.rglob('*/'), reverse=True):
            try:
                inner.rmdir()
            except OSError:
                pass
        try:
            group.rmdir()
        except OSError:
            pass


def leftovers():
    """What a clean-up has to have removed (invariant A8), in words; empty: nothing is left."""
    found = [f'process {pid}' for pid in own_processes()] + [f'mount {mount}' for mount in own_mounts()]
    if TAG in run('ip', 'netns', 'list'):
        found.append(f'namespace {TAG}')
    for kind in ('volumes', 'containers'):
        found += [f'{kind} {path.name}' for path in (WORK / 'images' / kind).glob('*') if path.is_dir()]
    return found


def host_network():
    """The host's own links and rules: a run leaves them as they were."""
    rules = run('iptables-save', check=False)
    return run('ip', '-o', 'link'), re.sub(r'#.*|\[\d+:\d+\]', '', rules)


class Node:
    """A container, by its name."""

    def __init__(self, name):
        self.name = name

    def inspect(self, what):
        return docker('inspect', '-f', what, self.name).strip()

    def pid(self):
        return int(self.inspect('{{.State.Pid}}'))

    def running(self):
        return self.inspect('{{.State.Running}}') == 'true'

    def kill(self):
        """As `docker kill`, after which the engine does not restart it by itself."""
        docker('kill', '-s', 'KILL', self.name)

    def start(self):
        docker('start', self.name)

    def inside(self, *argv, **more):
        """Runs a program of the host in its network."""
        return run('nsenter', '-t', self.pid(), '-n', *argv, **more)

    def veth(self):
        """The other end of its cable, in the lab's network."""
        index = re.search(r'@if(\d+)', self.inside('ip', '-o', 'link', 'show', 'eth0')).group(1)
        return re.search(rf'^{index}: ([^@:]+)', run('ip', '-n', TAG, '-o', 'link'), re.M).group(1)

    def link(self, up):
        """Cuts or mends its cable; the interface inside stays, without carrier."""
        run('ip', '-n', TAG, 'link', 'set', self.veth(), 'up' if up else 'down')

    def deaf_to(self, address, deaf=True):
        """Drops all that comes from there, or no longer."""
        self.inside('iptables', '-A' if deaf else '-D', 'INPUT', '-s', address, '-j', 'DROP')

    def bytes(self):
        """(received, sent) by its interface."""
        row = re.search(r'eth0:(.*)', pathlib.Path(f'/proc/{self.pid()}/net/dev').read_text()).group(1).split()
        return int(row[0]), int(row[8])

    @contextlib.contextmanager
    def slow(self, limit):
        """Lets it send and receive so many kbit a second at most, meanwhile."""
        veth, how = self.veth(), ('root', 'tbf', 'rate', f'{limit}kbit', 'burst', '16kb', 'latency', '400ms')
        self.inside('tc', 'qdisc', 'add', 'dev', 'eth0', *how)
        run('tc', '-n', TAG, 'qdisc', 'add', 'dev', veth, *how)
        try:
            yield
        finally:
            self.inside('tc', 'qdisc', 'del', 'dev', 'eth0', 'root')
            run('tc', '-n', TAG, 'qdisc', 'del', 'dev', veth, 'root')

    def open_files(self):
        return len(list(pathlib.Path(f'/proc/{self.pid()}/fd').iterdir()))


class Meter:
    """What the interfaces of some nodes send and receive from now on."""

    def __init__(self, nodes):
        self.nodes, self.began, self.before = nodes, time.monotonic(), [node.bytes() for node in nodes]

    def rates(self, sharers=1):
        """(bytes a second sent, received), of each of so many who share them."""
        now, per = [node.bytes() for node in self.nodes], sharers * (time.monotonic() - self.began)
        return tuple(sum(b[way] - a[way] for a, b in zip(self.before, now)) / per for way in (1, 0))

    def read(self, sharers=1):
        return '{:.0f} sent, {:.0f} received'.format(*self.rates(sharers))


class Loss:
    """netfault in a node's network, on all that comes in as it came off the wire: raw PREROUTING sees IP fragments, unless something
    needs whole datagrams before. The rules by which the engine answers for names do, so they are away meanwhile."""
    RULE = ('-i', 'eth0', '-j', 'NFQUEUE', '--queue-num', '0', '--queue-bypass')

    def __init__(self, node, **settings):
        self.node, pid, self.share = node, node.pid(), settings.get('loss', 0.0)
        flags = [word for name, value in settings.items() for word in ('--' + name.replace('_', '-'), str(value))]
        log = open(ROOT / f'netfault-{node.name}', 'wb')
        self.log = pathlib.Path(log.name)
        self.process = subprocess.Popen(['nsenter', '-t', str(pid), '-n', str(WORK / 'netfault'), '--queue', '0', *flags], stdout=log,
                                        stderr=log, stdin=subprocess.DEVNULL, preexec_fn=die_with_parent)
        self.names = node.inside('iptables-save', '-t', 'nat')
        node.inside('nft', 'delete', 'table', 'ip', 'nat')
        node.inside('iptables', '-t', 'raw', '-A', 'PREROUTING', *self.RULE)

    def take_away(self):
        self.node.inside('iptables', '-t', 'raw', '-D', 'PREROUTING', *self.RULE)
        self.node.inside('iptables-restore', '-T', 'nat', input=self.names)

    def drop(self):
        """Ends it, and what still waits is lost."""
        self.process.kill()
        self.process.wait(10)
        self.take_away()

    def end(self):
        """Returns (passed, lost, overtook)."""
        self.take_away()
        self.process.terminate()
        self.process.wait(10)
        words = self.log.read_text().split()
        if len(words) != 6:
            raise Trouble(f"netfault of {self.node.name}: {' '.join(words) or 'said nothing'}")
        return int(words[1]), int(words[3]), int(words[5])


@contextlib.contextmanager
def full(name):
    """Has the disk of a container full to its last byte, meanwhile."""
    path = ROOT / 'state' / name / 'ballast'
    try:
        with open(path, 'wb', buffering=0) as file:
            with contextlib.suppress(OSError):
                while True:
                    file.write(bytes(65536))
            os.fsync(file.fileno())
        yield
    finally:
        path.unlink(missing_ok=True)


def lost(losses):
    """Ends them, and says how much was lost: about what was asked of them, or else they did not work."""
    share, counts = losses[0].share, [loss.end() for loss in losses]
    passed, lost_ = (sum(row[k] for row in counts) for k in (0, 1))
    said = f'{lost_} of {passed + lost_} packets'
    if lost_ < share / 2 * (passed + lost_):
        raise Trouble(f'only {said} were lost: the fault did not work')
    return said


class Lab:
    """One network of containers. Addresses end with the number that a node is given."""

    def __init__(self):
        self.engine, self.nodes = Engine(), {}

    def open(self):
        run('ip', 'netns', 'add', TAG)
        run('ip', '-n', TAG, 'link', 'set', 'lo', 'up')
        self.engine.start(in_lab=True)
        docker('network', 'create', '--subnet', f'{SUBNET}.0/24', NETWORK)

    def folder(self, kind, name, megabytes=None):
        """A folder that a container may write, on a disk of its own of that size if one is given."""
        path = ROOT / kind / name
        if not path.exists():
            path.mkdir(parents=True)
            if megabytes:
                run('mount', '-t', 'tmpfs', '-o', f'size={megabytes}m', TAG, path)
            os.chown(path, USER, USER)
        return path

    def start(self, name, number, image, *argv, entry=None, memory='512m', flags=(), disk=None):
        """Starts a hardened container as deploy/compose.yaml does, with a folder for its state and one for its records."""
        state, records = self.folder('state', name, disk), self.folder('records', name)
        docker('run', '-d', '--name', name, '--hostname', name, '--network', NETWORK, '--ip', f'{SUBNET}.{number}', '--read-only',
               '--cap-drop', 'ALL', '--security-opt', 'no-new-privileges', '--user', f'{USER}:{USER}', '--memory', memory,
               '--pids-limit', '1024', '--log-opt', 'max-size=5m', '-v', f'{state}:/var/lib/weft', '-v', f'{records}:/records',
               '-v', f'{WORK}/light:/light:ro', '--no-healthcheck', *(['--entrypoint', entry] if entry else []), *flags, image, *argv)
        self.nodes[name] = Node(name)
        return self.nodes[name]

    def remove(self, name):
        docker('rm', '-f', name)
        self.nodes.pop(name, None)

    def log(self, name, lines=4):
        return run('sh', '-c', f'docker logs --tail {lines} {name} 2>&1', env=environment(), check=False)   # programs log to standard error
