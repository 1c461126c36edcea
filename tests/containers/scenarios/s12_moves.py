"""The server comes back at another address; server and robots start while their link is down; a newcomer of the
next protocol and a robot's twin arrive."""
import shutil

import fleet as fleets
import lab

TITLE, SECONDS = 'another address, links that come late, a newer protocol, a twin', 150
ELSEWHERE = 12


def late(fleet, name, start):
    """Starts a container whose program begins while its cable is out, and puts it in."""
    fleet.lab.remove(name)
    bench_gate = fleet.lab.folder('records', name) / 'go'
    bench_gate.unlink(missing_ok=True)
    node = start(gate='/records/go')
    node.link(up=False)
    bench_gate.touch()
    lab.wait_until(f'{name} to say that it waits for its link', lambda: 'waits for its link' in lab.run('sh', '-c', f'docker logs {name} 2>&1', env=lab.environment()), 20)
    node.link(up=True)


def run(bench):
    fleet = bench.taught()
    fleet.kill_server()
    fleet.lab.remove('server')
    fleet.start_server(ELSEWHERE)
    fleet.wait_server()
    bench.numbers['all robots heard after the server moved'] = f'{fleet.wait_heard(fleet.names):.1f} s'

    late(fleet, 'server', lambda gate: fleet.start_server(ELSEWHERE, gate=gate))
    fleet.wait_server()
    fleet.wait_heard(fleet.names)
    for name in ('r5', 'r6'):                                        # one of each vendor
        late(fleet, name, lambda gate: fleet.start_robot(name, gate=gate))
        bench.files.pop(name, None)
    bench.files.pop('server', None)
    fleet.wait_heard(fleet.names)
    fleet.localise(['r5', 'r6'])

    fleet.start_newcomer('r8', 2)                                    # of the next protocol: named, and no robot
    lab.wait_until('the newcomer to be named', lambda: 'update this side' in (fleet.told('peer.refused') or ''), 30)
    fleet.lab.remove('r8')
    if 'r8' in fleet.robots():
        raise lab.Trouble('who speaks another protocol is listed as a robot')

    twin = fleet.lab.folder('state', 'r9') / 'r9'
    shutil.copytree(lab.ROOT / 'state' / 'r4' / 'r4', twin, ignore=shutil.ignore_patterns('health', 'lock', 'spool'))
    lab.run('chown', '-R', str(lab.USER), twin)
    bench.unknown.add('r9')
    fleet.start_robot('r9')
    lab.wait_until('the twins to be told of', lambda: fleet.events('robot.twins') > 0, 30)
    fleet.lab.remove('r9')
    lab.wait_until('the twin to be forgotten', lambda: fleet.events('robot.twins_ended') > 0, 40)
    lab.wait_until('r4 to be let go on', lambda: fleet.weft('resume', 'r4', good=None) is not None, 20, every=0.5)
    fleet.succeed([fleet.send(2, 'r1'), fleet.send(6, 'r3')], 60)
