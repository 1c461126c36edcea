"""An agent is killed in the middle of a route, and another one twice within three seconds while it is taught."""
import time

import lab

TITLE, SECONDS = 'agents are killed -9 on a route and while they are taught', 75


def run(bench):
    fleet = bench.taught()
    goal = fleet.send(2, 'r3')
    fleet.wait_under_way(goal)
    fleet.node('r3').kill()
    fleet.node('r3').start()
    fleet.wait_heard(['r3'])
    fleet.localise(['r3'])
    fleet.wait_goals([goal], 60)

    # Its hand lets go of it when it dies. It has handed in, or keeps, what it was taught; then it is led on.
    before, places = len(bench.records.update().acks), fleet.weft('map', 'info')['places']
    fleet.lead(bench.records, 'r5', 'r5-broken', 18)
    lab.wait_until('r5 to be taught some places', lambda: len(bench.records.update().acks) > before, 30)
    for _ in range(2):
        fleet.node('r5').kill()
        fleet.node('r5').start()
        time.sleep(1)                                              # the second kill comes into its start
    fleet.wait_heard(['r5'])
    if fleet.weft('map', 'info')['places'] <= places:
        raise lab.Trouble('nothing of what r5 was taught until it was killed came to the server')
    fleet.lead_on(bench.records, 'r5', 'r5-again', 8)
    if not fleet.robot('r5')['localised']:
        fleet.localise(['r5'])
    fleet.wait_goals([fleet.send(5, 'r5')], 60)
