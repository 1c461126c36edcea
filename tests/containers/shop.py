"""The fleet of deploy/compose.yaml, as a deployer has it: a server and two robots with rendered cameras."""
import json
import pathlib
import sys

import lab

sys.path.insert(0, str(lab.TOP / 'deploy' / 'demonstration'))
import lines  # noqa: E402

SERVICES = ('server', 'r1', 'r2')
COMPOSE = ('/usr/bin/docker-compose', '-f', 'deploy/compose.yaml', '-p', 'shop')
TAUGHT_POINTS = (12, 20)       # of r1's line: to where a goal leads, and on from there


def compose(*words, **more):
    return lab.run(*COMPOSE, *words, env=lab.environment(), cwd=lab.TOP, **more)


def up():
    """Starts it and returns its containers, once all are healthy and both robots are heard."""
    compose('up', '-d')
    nodes = {name: lab.Node(f'shop_{name}_1') for name in SERVICES}
    lab.wait_until('all services to be healthy', lambda: all(node.inspect('{{.State.Health.Status}}') == 'healthy' for node in nodes.values()), 40)
    lab.wait_until('both robots to be heard', lambda: sum(row['heard'] for row in weft(nodes, 'robots')['robots']) == 2, 20)
    return nodes


def down():
    compose('down', '-v', check=False)


def operator(*words):
    """What the service `weft` answers."""
    return json.loads(compose('run', '--rm', '-T', 'weft', '--json', *words))


def weft(nodes, *words):
    """The same command, started quicker: in the network of the server's container."""
    address = nodes['server'].inspect('{{range .NetworkSettings.Networks}}{{.IPAddress}}{{end}}')
    said = nodes['server'].inside(lab.WORK / 'bin' / 'weft', '--listen', 'eth0', '--server', address, '--timeout', '30', '--json', *words)
    return json.loads(said) if said.strip() else {}


def not_hardened(node):
    """What is missing of the hardening, as the kernel tells it."""
    process = pathlib.Path(f'/proc/{node.pid()}')
    status = dict(line.split(':\t', 1) for line in (process / 'status').read_text().splitlines() if ':\t' in line)
    root = next(line.split()[3].split(',') for line in (process / 'mounts').read_text().splitlines() if line.split()[1] == '/')
    bad = {'runs as root': '0' in status['Uid'].split(), 'has capabilities': int(status['CapEff'], 16) != 0,
           'may gain privileges': status['NoNewPrivs'].strip() != '1', 'has no seccomp filter': status['Seccomp'].strip() != '2',
           'may write its root': 'ro' not in root}
    return [what for what, is_so in bad.items() if is_so]


def drive_a_goal(nodes):
    """r1 is taught some metres, and goes on; r2, which stands where it began, is sent along them."""
    points = [point for part, _ in lines.parts(lab.TOP / 'deploy/sites/demo/r1.line') for point in part]
    robot = lambda name: next(row for row in weft(nodes, 'robots')['robots'] if row['name'] == name)  # noqa: E731
    begun = 0
    for label, end in zip(('begin', 'middle'), (*TAUGHT_POINTS,)):
        part = lines.write(points[begun:end], lab.ROOT / f'shop-{begun}.line')
        before, begun = robot('r1')['frame'], end - 1
        weft(nodes, 'teach', 'r1', 'start', '--as', 'way')
        weft(nodes, 'map', 'label', 'here', '--robot', 'r1', label)
        weft(nodes, 'teach', 'r1', 'start', '--as', 'way', '--along', str(part))
        lab.wait_until('r1 to be led on', lambda: (lambda row: row['reason'] == 'hand_done' and row['frame'] > before + 5)(robot('r1')), 40)
    weft(nodes, 'teach', 'r1', 'stop')
    weft(nodes, 'localise', 'r2', '--at', 'begin')
    lab.wait_until('r2 to find itself', lambda: robot('r2')['localised'], 30)
    goal = weft(nodes, 'goal', 'send', '--to', 'middle', '--robot', 'r2', '--no-return')['goal']
    state = lambda: next(row['state'] for row in weft(nodes, 'goal', 'list')['goals'] if row['id'] == goal)  # noqa: E731
    lab.wait_until('the goal to end', lambda: state() in ('succeeded', 'failed', 'cancelled', 'rejected'), 40)
    if state() != 'succeeded':
        raise lab.Trouble(f'the goal has {state()}')
