"""An agent stands still for ten seconds in the middle of a route, then the server for twelve."""
import time

import lab

TITLE, SECONDS = 'an agent hangs for 10 s, the server for 12 s', 80


def hang(name, seconds):
    lab.docker('pause', name)
    time.sleep(seconds)                       # the length of the fault
    lab.docker('unpause', name)


def run(bench):
    fleet = bench.taught()
    goal = fleet.send(1, 'r2')
    fleet.wait_under_way(goal, 0.05)
    hang('r2', 10)
    fleet.wait_heard(['r2'])
    fleet.wait_goals([goal], 60)

    goals = [fleet.send(4, 'r3'), fleet.send(0, 'r5')]
    fleet.wait_heard(fleet.names)
    blamed = fleet.events('robot.silent')
    hang('server', 12)
    fleet.wait_server()
    fleet.wait_heard(fleet.names)
    more = fleet.events('robot.silent') - blamed
    if more:
        raise lab.Trouble(f'the server stood still, and blamed robots for its own silence {more} times')
    fleet.succeed(goals, 60)
