"""An agent is killed in the middle of a route, and another one twice within three seconds while it is taught."""
import time

import fleet as fleets
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

    # It is led on along its line; what it had spooled comes to the server all the same.
    folder = lab.ROOT / 'lines'
    lab.run(lab.WORK / 'light' / 'weft-light-agents', '--lines', folder, '--first', 5, '--robots', 1, '--fleet', len(fleet.names))
    before, map_before = len(bench.records.update().acks), fleet.weft('map', 'info')
    points = [point for part, _ in fleets.lines.parts(folder / 'r5.line') for point in part]
    row = bench.records.robots['r5'].rows[-1]                      # the hand takes it from where it stands
    nearest = min(range(len(points)), key=lambda i: (points[i][0] - row[2]) ** 2 + (points[i][1] - row[3]) ** 2)
    part = fleets.lines.write(points[nearest:nearest + 60], folder / 'r5.part')
    fleet.weft('teach', 'r5', 'start', '--as', 'r5-broken', '--along', part)
    lab.wait_until('r5 to be taught some places', lambda: len(bench.records.update().acks) >= before + 1, 30)
    for _ in range(2):
        fleet.node('r5').kill()
        fleet.node('r5').start()
        time.sleep(1)                                              # not a wait: the second kill comes into its start
    fleet.wait_heard(['r5'])
    fleet.localise(['r5'])
    after = fleet.weft('map', 'info')
    if after['places'] <= map_before['places']:
        raise lab.Trouble('nothing of what r5 was taught until it was killed came to the server')
    fleet.succeed([fleet.send(5, 'r5')], 60)
