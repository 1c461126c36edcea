"""One robot's wall clock is half a minute ahead, another one's behind."""
import pathlib

import fleet as fleets
import lab

TITLE, SECONDS = 'wall clocks at +30 s and -30 s', 60
SKEWS = {'r1': 30, 'r2': -30}


def run(bench):
    if not pathlib.Path(fleets.FAKETIME).exists():
        raise lab.Trouble('libfaketime is not installed')
    fleet = bench.taught()
    for name, skew in SKEWS.items():
        lab.docker('stop', name)
        fleet.lab.remove(name)
        fleet.start_robot(name, skew)
        bench.files.pop(name, None)
    fleet.wait_heard(list(SKEWS))

    def told():
        rows = fleet.robots()
        return all(abs(rows[name]['clock_skew_s'] - skew) < 5 for name, skew in SKEWS.items())
    lab.wait_until('the skews to be told', told, 30)
    said = fleet.weft('doctor', good=(0, 1))
    text = str(said)
    for name in SKEWS:
        if name not in text:
            raise lab.Trouble(f'doctor does not name {name}, whose clock is off')
    fleet.localise(list(SKEWS))
    fleet.succeed([fleet.send(3, 'r1'), fleet.send(6, 'r2')], 60)
    for name in SKEWS:                        # as they were, for whoever comes next
        lab.docker('stop', name)
        fleet.lab.remove(name)
        fleet.start_robot(name)
        bench.files.pop(name, None)
    fleet.wait_heard(list(SKEWS))
    fleet.localise(list(SKEWS))
