"""Forty light robots at the real pace, ten in a process, join at once: what an agent sends and receives."""
import concurrent.futures
import time

import fleet as fleets
import lab

TITLE, SECONDS = 'forty robots join at once', 150
FIRST, ROBOTS, IN_ONE = 101, 40, 10
LOOK_S = 10


def run(bench):
    fleet = bench.taught()
    names = [f'r{number}' for number in range(FIRST, FIRST + ROBOTS)]
    processes = names[::IN_ONE]
    began = time.monotonic()
    for name in processes:
        fleet.start_robot(name, of=IN_ONE, pace=1, last=FIRST + ROBOTS - 1)
    started = time.monotonic() - began
    fleet.wait_heard(names, seconds=60)
    bench.numbers['forty robots, all heard'] = f'{time.monotonic() - began:.1f} s after the first of four containers was started, which took {started:.1f} s'

    def look(what):
        before, at = [fleet.node(name).bytes() for name in processes], time.monotonic()
        time.sleep(LOOK_S)                                           # what is measured
        received, sent = (sum(now[way] - then[way] for now, then in zip((fleet.node(name).bytes() for name in processes), before)) for way in (0, 1))
        per = ROBOTS * (time.monotonic() - at)
        bench.numbers[f'forty robots, {what}, bytes/s an agent'] = f'{sent / per:.0f} sent, {received / per:.0f} received'
    look('idle')

    folder = lab.ROOT / 'lines'
    lab.run(lab.WORK / 'light' / 'weft-light-agents', '--lines', folder, '--first', FIRST, '--robots', ROBOTS, '--fleet', FIRST + ROBOTS - 1)

    def teach(name):
        points = [point for part, _ in fleets.lines.parts(folder / f'{name}.line') for point in part]
        part = fleets.lines.write(points[:160], folder / f'{name}.part')
        fleet.weft('teach', name, 'start', '--as', f'{name}-piece', '--along', part, timeout=60)
    with concurrent.futures.ThreadPoolExecutor(4) as some:
        list(some.map(teach, names))
        teaching = sum(row['mode'] == 'teaching' for row in fleet.robots().values())
        look(f'teaching ({teaching} of them)')
        list(some.map(lambda name: fleet.weft('teach', name, 'stop', timeout=120), names))
        list(some.map(lambda name: fleet.weft('localise', name, good=None), names))
        goals = list(some.map(lambda k: fleet.weft('goal', 'send', '--to', f'station-{k % 8}', '--robot', names[k]), range(ROBOTS)))
    lab.wait_until('robots to drive', lambda: sum(row['mode'] == 'driving' for row in fleet.robots().values()) >= 5, 30)
    driving = sum(row['mode'] == 'driving' for row in fleet.robots().values())
    look(f'with a goal each ({driving} drive)')
    for goal in goals:                                               # there is no room for forty on this ring
        fleet.weft('goal', 'cancel', goal['goal'], good=None)
    for name in processes:
        lab.docker('stop', '-t', '20', name)
        fleet.lab.remove(name)
