"""Three robots lose their link for 5, 15 and 40 s at once; three others go on."""
import time

TITLE, SECONDS = 'three robots are cut off for 5, 15 and 40 s, three go on', 120
CUTS = {'r1': 5, 'r2': 15, 'r3': 40}


def run(bench):
    fleet = bench.taught()
    own = {name: fleet.send(number, name) for number, name in enumerate(fleet.names)}
    lab_time = time.monotonic()
    for name in CUTS:
        fleet.node(name).link(up=False)
    others = [own[name] for name in fleet.names if name not in CUTS]
    mended = {}
    while len(mended) < len(CUTS):
        for name, seconds in CUTS.items():
            if name not in mended and time.monotonic() - lab_time >= seconds:
                fleet.node(name).link(up=True)
                mended[name] = fleet.wait_heard([name])
        time.sleep(0.2)
    for name, took in mended.items():
        bench.numbers[f'heard again after a cut of {CUTS[name]} s'] = f'{took:.1f} s'
    # Robots that were cut off stand in the way of others, which go on as soon as these do.
    fleet.succeed(others, 60)
    fleet.wait_goals(list(own.values()), 60)
