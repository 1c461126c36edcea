"""One packet in ten is lost both ways, fragments counted one by one, with jitter and overtaking; then 1 Mbit/s."""
import time

import lab

TITLE, SECONDS = 'a tenth lost, 60 ms of jitter, a tenth overtaking; then 1 Mbit/s', 150
LOSSY = {'loss': 0.1, 'delay_ms': 1, 'jitter_ms': 60, 'overtake': 0.1}
MOST_TIMES = 5


def run(bench):
    fleet = bench.taught()
    nodes = [fleet.node('server'), *(fleet.node(name) for name in fleet.names)]
    before = {node.name: node.bytes()[1] for node in nodes}
    contents = fleet.weft('map', 'info')['content_bytes']
    losses = [lab.Loss(node, seed=101 + number, **LOSSY) for number, node in enumerate(nodes)]
    began, fleet.patience = time.monotonic(), 60
    try:
        for number in range(0, 10, 5):
            fleet.succeed([fleet.send((number + 3 * k) % 8) for k in range(5)], 90)
        teacher = 'r6'
        fleet.weft('teach', teacher, 'start', '--as', 'lossy', timeout=60)
        lab.wait_until('it to be taught', lambda: fleet.robot(teacher)['mode'] == 'teaching', 30)
        fleet.weft('teach', teacher, 'stop', timeout=90)
    finally:
        counts = [loss.end() for loss in losses]
    took = time.monotonic() - began
    passed, lost = (sum(row[k] for row in counts) for k in (0, 1))
    if lost < 0.05 * (passed + lost):
        raise lab.Trouble(f'only {lost} of {passed + lost} packets were lost: the fault did not work')
    for vendor, names in (('fastdds', ['r2', 'r4', 'r6']), ('cyclonedds', ['r1', 'r3', 'r5'])):
        sent = sum(fleet.node(name).bytes()[1] - before[name] for name in names) / len(names)
        bench.numbers[f'{vendor}, a tenth lost: bytes/s sent by a robot'] = f'{sent / took:.0f}'
    grown = fleet.weft('map', 'info')['content_bytes'] - contents
    bench.numbers['a tenth lost'] = f'{lost} of {passed + lost} packets in {took:.0f} s, {grown} bytes of contents'
    fleet.node('server').rate(1000)
    try:
        fleet.succeed([fleet.send(2), fleet.send(6)], 60)
    finally:
        fleet.node('server').rate()
        fleet.patience = 20
