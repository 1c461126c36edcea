"""Three robots with rendered cameras while two packets in a hundred are lost: two are taught ways that overlap, the third finds
itself and drives over both; tests/judge holds all to the demo's bounds. Then a tenth is lost while one robot of each vendor is
taught on: what it sends is at most five times what it hands in."""
import lab
from rendered_fleet import Rendered

TITLE, SECONDS = 'three rendered robots, 2 % lost, a goal over what two were taught', 260
LOSS, MORE_LOSS, GOALS, MOST_TIMES = 0.02, 0.1, ('near', 'far'), 5


def begin(fleet, losses, *names):
    for name in names:
        losses.append(lab.Loss(fleet.start_robot(name), seed=102 + len(losses), loss=LOSS))
    fleet.wait_heard(names)


def teach_on(bench, fleet):
    losses = [lab.Loss(fleet.node(name), seed=201 + number, loss=MORE_LOSS) for number, name in enumerate(('server', 'r1', 'r2'))]
    times = {fleet.vendors[name]: fleet.bytes_for_a_byte(name) for name in ('r1', 'r2')}
    lab.lost(losses)
    for vendor, factor in times.items():
        bench.at_most(f'{vendor}, a tenth lost: bytes were sent for each byte of contents', factor, MOST_TIMES)


def run(bench):
    bench.close_lab()
    fleet = Rendered(bench)
    losses = [lab.Loss(fleet.node('server'), seed=101, loss=LOSS)]
    begin(fleet, losses, 'r1', 'r2')
    for name in ('r2', 'r1'):
        fleet.teach_line(name, name, name)
    begin(fleet, losses, 'r3')
    fleet.localise(['r3'])
    for label in GOALS:
        fleet.wait_goals([fleet.weft('goal', 'send', '--to', label, '--robot', 'r3', '--no-return')['goal']], 60)
    lab.lost(losses)
    fleet.judged(bench)
    teach_on(bench, fleet)
    bench.close_lab()
