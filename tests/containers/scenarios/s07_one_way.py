"""A robot that is not heard but hears, and one that hears nothing but is heard."""
import time

import lab

TITLE, SECONDS = 'links that work in one direction', 80
SERVER = f'{lab.SUBNET}.10'


def said(fleet, kind, direction):
    lab.wait_until(f'{kind} to name the direction {direction}', lambda: direction in (fleet.told(kind, 'r4') or ''), 20)


def run(bench):
    fleet = bench.taught()
    robot, server = fleet.node('r4'), fleet.node('server')
    address = f'{lab.SUBNET}.24'
    # From robot to server nothing comes through: it counts as silent, and is found again.
    goal = fleet.send(3, 'r4')
    fleet.wait_under_way(goal, 0.05)
    server.deaf_to(address)
    fleet.wait_heard(['r4'], heard=False)
    time.sleep(10)                                # the length of the fault: of less than 12 s nothing is told
    server.deaf_to(address, False)
    bench.numbers['heard again after it was not heard'] = f"{fleet.wait_heard(['r4']):.1f} s"
    said(fleet, 'robot.unheard', 'from the robot to the server')
    fleet.wait_goals([goal], 60)

    # From server to robot nothing comes through: it stands at its released place at the latest (A3 judges that).
    goal = fleet.send(7, 'r4')
    fleet.wait_under_way(goal, 0.05)
    robot.deaf_to(SERVER)

    def stands():
        rows = bench.records.update().robots['r4'].rows[-5:]
        return all(abs(row[4]) < 0.02 for row in rows)
    lab.wait_until('r4, which hears nothing, to stand', stands, 30)
    said(fleet, 'robot.deaf', 'from the server to the robot')
    fleet.wait_heard(['r4'], heard=False)                  # DDS gives up who is not heard, so the robot speaks no more
    time.sleep(10)
    robot.deaf_to(SERVER, False)
    said(fleet, 'robot.unheard', 'from the server to the robot')
    fleet.wait_heard(['r4'])
    fleet.wait_goals([goal], 60)
