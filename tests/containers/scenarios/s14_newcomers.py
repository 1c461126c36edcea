"""A newcomer of the next protocol and a robot's twin arrive."""
import shutil

import lab

TITLE, SECONDS = 'a newer protocol, and a twin', 90


def run(bench):
    fleet = bench.taught()
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
