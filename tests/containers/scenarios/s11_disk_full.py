"""The server's disk is full, then a robot's; each has room again."""
import os

import lab

TITLE, SECONDS = 'disks full at the server, then at a robot, then room', 80


def ballast(name, is_full):
    """Fills the disk of a container to its last byte, or gives the room back."""
    path = lab.ROOT / 'state' / name / 'ballast'
    if not is_full:
        path.unlink(missing_ok=True)
        return
    with open(path, 'wb', buffering=0) as file:
        try:
            while True:
                file.write(bytes(65536))
        except OSError:
            os.fsync(file.fileno())


def store_is(fleet, stopped):
    info = fleet.weft('map', 'info', good=None) or {}
    return bool(info.get('stopped')) == stopped


def run(bench):
    fleet = bench.taught()
    before = fleet.weft('map', 'info')['places']
    # A journal keeps the room that it had once. One that was closed and begun anew has none to write into.
    lab.docker('stop', 'server')
    fleet.restart_server()
    fleet.wait_heard(fleet.names)
    ballast('server', True)
    try:
        fleet.lead(bench.records, 'r4', 'into-full', 12)
        lab.wait_until('the store to say that it takes nothing', lambda: store_is(fleet, True), 30)
        if 'store' not in str(fleet.weft('doctor', good=(0, 1))):
            raise lab.Trouble('doctor says nothing of the store')
    finally:
        ballast('server', False)
    lab.wait_until('the store to take batches again', lambda: store_is(fleet, False), 40)
    fleet.weft('teach', 'r4', 'stop', timeout=60)

    # A robot that cannot keep what it is taught does not act as if it could; it is well again with room.
    ballast('r3', True)
    began = fleet.weft('teach', 'r3', 'start', '--as', 'from-full', good=None)
    lab.wait_until('the full disk of r3 to be an alarm', lambda: 'spool' in fleet.alarms('r3'), 30)
    ballast('r3', False)
    lab.wait_until('r3 to have room again', lambda: 'spool' not in fleet.alarms('r3'), 40)
    if began is not None:
        fleet.weft('teach', 'r3', 'stop', good=(0, 1, 4), timeout=60)
    fleet.wait_goals([fleet.send(1), fleet.send(5)], 60)
    if fleet.weft('map', 'info')['places'] < before:
        raise lab.Trouble('places are gone')
