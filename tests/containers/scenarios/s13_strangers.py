"""A stranger claims to be the server in a far higher epoch, and sends 100,000 malformed datagrams."""
import lab

TITLE, SECONDS = 'a stranger of a higher epoch, and 100,000 malformed datagrams', 100
TOOL = lab.TOP / 'tests' / 'containers' / 'strangers.py'
FAR = 2 ** 63
SEED, COUNT = 101, 100_000


def stranger(node, *words):
    return int(node.inside('/usr/bin/python3', TOOL, *words).split()[-1])


def run(bench):
    fleet = bench.taught()
    epoch = fleet.weft('map', 'info')['epoch']
    for name in ('r1', 'r2'):                                     # one of each vendor
        heard = lab.ROOT / f'heard-{name}'
        stranger(fleet.node(name), 'listen', 12, heard)           # the server greets every 2 s
        if not stranger(fleet.operator, 'usurp', epoch, FAR, heard):
            raise lab.Trouble(f'no greeting of the server to {name} was found, so none was forged')
    if fleet.weft('map', 'info')['epoch'] != epoch:
        raise lab.Trouble('the server took over the epoch of a stranger')
    fleet.wait_heard(fleet.names)
    fleet.succeed([fleet.send(2, 'r1'), fleet.send(5, 'r2')], 60)

    heard = lab.ROOT / 'heard-server'
    stranger(fleet.node('server'), 'listen', 6, heard)
    before = {name: int(node.inspect('{{.RestartCount}}')) for name, node in fleet.lab.nodes.items()}
    bench.may_end = True
    stranger(fleet.operator, 'storm', SEED, COUNT, heard)
    fleet.wait_server()
    fleet.wait_heard(fleet.names)
    ended = [name for name, node in fleet.lab.nodes.items() if int(node.inspect('{{.RestartCount}}')) > before[name]]
    bench.numbers[f'{COUNT} malformed datagrams'] = f"ended {', '.join(ended) or 'no program'}; all are back"
    lost = [name for name, row in fleet.robots().items() if not row['localised']]
    fleet.localise(lost)
    fleet.succeed([fleet.send(1), fleet.send(6)], 60)
