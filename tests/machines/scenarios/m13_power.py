"""The power of both machines fails while a robot is taught: what the server had acknowledged is there when it comes back."""
import json

from judging import network
from playing.processes import wait_until

import bench as shop

TITLE, SECONDS = 'a power cut while a robot is taught loses nothing acknowledged', 300


class Seen:
    """Records for the judge, as far as they were seen."""

    def __init__(self, acks):
        self.acks, self.network = [json.loads(line) for line in acks.splitlines() if line.endswith('}')], {'places': []}


def run(bench):
    bench.robot.run(f'systemctl restart {shop.AGENT}', 60)       # its body stands where it began
    bench.wait_heard()
    broken, earlier = [], len(Seen(bench.robot.run(f'cat {shop.ACKS}')).acks)
    bench.lead(2.0, 'cut')
    wait_until('batches to be acknowledged', lambda: len(Seen(bench.robot.run(f'cat {shop.ACKS}')).acks) >= earlier + 3, 100, every=1)
    goal = bench.weft('goal', 'send', '--to', 'end', '--no-return')['goal']
    seen = Seen(bench.robot.run(f'cat {shop.ACKS}'))
    bench.cut_power()
    bench.boot()
    bench.wait_active(bench.server, shop.SERVER)
    bench.wait_active(bench.robot, shop.AGENT)
    bench.wait_heard()
    bench.weft('map', 'check', seconds=120)
    seen.network = bench.export()
    bench.say(f'{len(seen.acks)} acknowledged batches, {len(seen.acks) - earlier} of them since the robot was led on')
    broken += network.acknowledged(seen)
    broken += [] if goal in [row['id'] for row in bench.weft('goal', 'list')['goals']] else ['a goal that was answered is not listed']
    return broken
