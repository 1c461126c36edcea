"""deploy/compose.yaml as a deployer starts it: healthy, hardened, quiet, and a goal is driven."""
import time

import lab
import shop

TITLE, SECONDS = 'deploy/compose.yaml: healthy, hardened, drives a goal', 150
LOOK_S = 10


def run(bench):
    bench.open_lab()
    try:
        nodes = shop.up()
        wrong = [f'{name} {what}' for name, node in nodes.items() for what in shop.not_hardened(node)]
        if len(shop.operator('robots')['robots']) != 2:                 # by the image of the operator's command
            wrong.append('`weft robots` in a container does not tell of both robots')
        before = {name: node.bytes() for name, node in nodes.items()}
        time.sleep(LOOK_S)                                              # what is measured: idle bytes
        for name, node in nodes.items():
            received, sent = (round((now - then) / LOOK_S) for now, then in zip(node.bytes(), before[name]))
            bench.numbers[f'compose, idle, bytes/s of {name}'] = f'{sent} sent, {received} received'
        counters = shop.weft(nodes, 'map', 'info')['counters']
        wrong += [f'refused on a clean network: {what}, {times} times' for what, times in counters.items() if 'refused' in what and times]
        shop.drive_a_goal(nodes)
        if wrong:
            raise lab.Trouble('; '.join(wrong))
    finally:
        shop.down()
