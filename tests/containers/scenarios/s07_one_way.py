"""A robot that is not heard but hears, and one that hears nothing but is heard."""
import time

import lab

TITLE, SECONDS = 'links that work in one direction', 80
SERVER, ROBOT = f'{lab.SUBNET}.10', f'{lab.SUBNET}.24'
FAULT_S = 10                                      # and 5 before: of less than 12 s nothing is told
UP, DOWN = 'from the robot to the server', 'from the server to the robot'


def said(fleet, kind, direction):
    lab.wait_until(f'{kind} to name the direction {direction}', lambda: direction in (fleet.told(kind, 'r4') or ''), 20)


def run(bench):
    fleet = bench.taught()
    robot, server = fleet.node('r4'), fleet.node('server')
    # From robot to server nothing comes through: it counts as silent, and is found again.
    goal = fleet.send_under_way(3, 'r4', 0.05)
    server.deaf_to(ROBOT)
    fleet.wait_heard(['r4'], heard=False)
    time.sleep(FAULT_S)
    server.deaf_to(ROBOT, False)
    bench.numbers['heard again after it was not heard'] = f"{fleet.wait_heard(['r4']):.1f} s"
    said(fleet, 'robot.unheard', UP)
    fleet.wait_goals([goal], 60)
    # From server to robot nothing comes through: it stands at its released place at the latest (A3 judges that).
    goal = fleet.send_under_way(7, 'r4', 0.05)
    robot.deaf_to(SERVER)
    lab.wait_until('r4, which hears nothing, to stand', lambda: bench.records.update().robots['r4'].stood(5), 30)
    said(fleet, 'robot.deaf', DOWN)
    fleet.wait_heard(['r4'], heard=False)                  # DDS gives up who is not heard, so the robot speaks no more
    time.sleep(FAULT_S)
    robot.deaf_to(SERVER, False)
    said(fleet, 'robot.unheard', DOWN)
    fleet.wait_heard(['r4'])
    fleet.wait_goals([goal], 60)
