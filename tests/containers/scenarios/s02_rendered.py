"""Three robots with rendered cameras while two packets in a hundred are lost: two are taught ways that overlap, the third finds
itself and drives over both; tests/judge holds all to the demo's bounds. Then a tenth is lost while one robot of each vendor is
taught on: what it sends is at most five times what it hands in."""
import pathlib
import subprocess
import sys
import types

import fleet as fleets
import lab

sys.path.insert(0, str(lab.TOP / 'deploy' / 'demonstration'))
import gather  # noqa: E402
import scenario  # noqa: E402

TITLE, SECONDS = 'three rendered robots, 2 % lost, a goal over what two were taught', 260
SITE = lab.TOP / 'tests' / 'containers' / 'rendered'
LOSS, MORE_LOSS, GOALS, MOST_TIMES = 0.02, 0.1, ('near', 'far'), 5


class Rendered(fleets.Fleet):
    """What deploy/demonstration expects of a fleet, in containers."""

    def __init__(self, bench):
        super().__init__(bench.lab, 3, bench.say)
        self.experiences, self.work = {}, self.lab.folder('records', 'all')
        self.vendors = dict(server=self.dds, cli=fleets.VENDORS[1], **{name: fleets.VENDORS[int(name[1:]) % 2] for name in self.names})

    def start_robot(self, name):                       # by the server's address: where packets are lost nobody answers for names
        return self.lab.start(name, fleets.FIRST_ROBOT + int(name[1:]), 'weft-agent-sim', '--dds', self.vendors[name], '--listen', 'eth0', '--server', f'{lab.SUBNET}.{fleets.SERVER_NUMBER}',
                              '--name', name, '--method', 'floor', '--body', 'sim', '--site', '/site/site.toml', '--seed', 1, '--records', '/all',
                              '--truth', '/all/truth.jsonl', flags=['-v', f'{SITE}:/site:ro', '-v', f'{self.work}:/all'], memory='1g')

    def wait_robot(self, name, what, condition, seconds):
        return lab.wait_until(f'{name} {what}', lambda: condition(self.robot(name)), seconds / lab.SLOW, every=0.5)


def begin(fleet, losses, *names):
    for name in names:
        node = fleet.start_robot(name) if name != 'server' else fleet.node('server')
        losses.append(lab.Loss(node, seed=101 + len(losses), loss=LOSS))
    fleet.wait_heard([name for name in names if name != 'server'])


def play(fleet, losses, say):
    fleet.start_server()
    fleet.operator_pid = fleet.lab.start('operator', fleets.OPERATOR_NUMBER, 'weft-server', 'infinity', entry='sleep').pid()
    fleet.wait_server()
    begin(fleet, losses, 'server', 'r1', 'r2')
    for name in ('r2', 'r1'):
        scenario.teach(fleet, name, SITE / f'{name}.line', say, name)
    begin(fleet, losses, 'r3')
    fleet.localise(['r3'])
    for label in GOALS:
        goal = fleet.weft('goal', 'send', '--to', label, '--robot', 'r3', '--no-return')['goal']
        fleet.wait_goals([goal], 60)


def end(losses):
    """Mends the links; each has to have lost about what was asked of it."""
    counts = [loss.end() for loss in losses]
    passed, lost = (sum(row[k] for row in counts) for k in (0, 1))
    share = losses[0].share
    if lost < share / 2 * (passed + lost):
        raise lab.Trouble(f'only {lost} of {passed + lost} packets were lost: the fault did not work')


def bytes_for_a_byte(fleet, name, say):
    """What a robot that is taught some metres sends, for each byte of contents that it hands in."""
    node, held = fleet.node(name), fleet.weft('map', 'info')['content_bytes']
    sent = node.bytes()[1]
    scenario.teach(fleet, name, SITE / f'{name}-on.line', say, f'{name}-on')
    return (node.bytes()[1] - sent) / (fleet.weft('map', 'info')['content_bytes'] - held)


def teach_on(bench, fleet):
    nodes = [fleet.node(name) for name in ('server', 'r1', 'r2')]
    losses = [lab.Loss(node, seed=201 + number, loss=MORE_LOSS) for number, node in enumerate(nodes)]
    times = {fleet.vendors[name]: bytes_for_a_byte(fleet, name, bench.say) for name in ('r1', 'r2')}
    end(losses)
    for vendor, factor in times.items():
        bench.numbers[f'{vendor}, a tenth lost: bytes sent for a byte of contents'] = f'{factor:.2f}'
        if factor > MOST_TIMES:
            raise lab.Trouble(f'{vendor}: {factor:.1f} bytes were sent for each byte of contents, {MOST_TIMES} at most are wanted')


def records(bench, fleet):
    """Leaves what tests/judge reads in the folder into which the robots have written."""
    peak = {name: types.SimpleNamespace(peak_memory_mb=bench.peak_memory_mb(name)) for name in ('server', *fleet.names)}
    gather.gather(types.SimpleNamespace(weft=fleet.weft, server=peak['server'], robots=peak, vendors=fleet.vendors, experiences=fleet.experiences,
                                        options=types.SimpleNamespace(floors=None), bin=pathlib.Path(bench.build) / 'bin'), fleet.work, SITE / 'site.toml')
    return fleet.work


def run(bench):
    bench.close_lab()
    bench.open_lab()
    fleet, losses = Rendered(bench), []
    play(fleet, losses, bench.say)
    end(losses)
    judged = subprocess.run([lab.TOP / 'tests' / 'judge', records(bench, fleet)], capture_output=True, text=True)
    if judged.returncode:
        raise lab.Trouble('; '.join(line for line in judged.stdout.splitlines() if line.startswith('judge:')) or judged.stderr)
    teach_on(bench, fleet)
    bench.close_lab()
