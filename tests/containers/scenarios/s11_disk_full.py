"""The server's disk is full, then a robot's; each has room again."""
import lab

TITLE, SECONDS = 'disks full at the server, then at a robot, then room', 80


def wait_store(fleet, what, stopped):
    lab.wait_until(f'the store to {what}', lambda: bool((fleet.weft('map', 'info', good=None) or {}).get('stopped')) == stopped, 40)


def server_full(bench, fleet):
    fleet.begin_journal()              # one that has been written keeps the room that it had once
    with lab.full('server'):
        fleet.lead(bench.records, 'r4', 'into-full', 12)
        wait_store(fleet, 'say that it takes nothing', True)
        if 'store' not in str(fleet.weft('doctor', good=(0, 1))):
            raise lab.Trouble('doctor says nothing of the store')
    wait_store(fleet, 'take batches again', False)
    fleet.weft('teach', 'r4', 'stop', timeout=60)


def robot_full(fleet):
    """It does not act as if it kept what it is taught: it refuses and says why, or raises an alarm. It is well again with room."""
    with lab.full('r3'):
        code, said = fleet.ask('teach', 'r3', 'start', '--as', 'from-full')
        if code and 'spool' not in said and 'disk' not in said:
            raise lab.Trouble(f'r3, whose disk is full, says to a lesson, with exit code {code}: {said.strip()[-200:]}')
        fleet.wait_alarm('r3', 'spool')
    fleet.wait_alarm('r3', 'spool', is_raised=False)
    fleet.weft('teach', 'r3', 'stop', good=(0, 1, 4), timeout=60)


def run(bench):
    fleet = bench.taught()
    before = fleet.weft('map', 'info')['places']
    server_full(bench, fleet)
    robot_full(fleet)
    fleet.wait_goals([fleet.send(1), fleet.send(5)], 60)
    if fleet.weft('map', 'info')['places'] < before:
        raise lab.Trouble('places are gone')
