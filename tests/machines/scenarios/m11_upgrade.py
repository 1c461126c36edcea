"""Newer packages are installed over the older ones: the server is started anew, the agent is not, edits of settings stay."""
import bench as shop

TITLE, SECONDS = 'an upgrade keeps map and settings, and restarts no robot', 180


def run(bench):
    broken = []
    runs, edit = bench.runs(), '# people wrote this'
    for machine, unit, file, names in ((bench.server, shop.SERVER, shop.SETTINGS, 'server cli health'),
                                       (bench.robot, shop.AGENT, shop.AGENT_SETTINGS, 'agent agent-sim health')):
        machine.write(file, f'{edit}\n')
        before = machine.unit(unit)['MainPID']
        files = ' '.join(f'{shop.DISK}/newer/weft-{name}_*.deb' for name in names.split())
        machine.run(f'DEBIAN_FRONTEND=noninteractive apt-get install -y -o Dpkg::Options::=--force-confold --no-install-recommends {files}', 90)
        restarts = unit == shop.SERVER
        after = bench.wait_active(machine, unit, other_than=before if restarts else None)
        broken += [] if (after['MainPID'] != before) == restarts else [f"{unit} was {'not ' if restarts else ''}started anew"]
        broken += [] if edit in machine.run(f'cat {file}') else [f'{file} has lost an edit']
        version = machine.run(f"dpkg-query -W -f '${{Version}}' weft-{names.split()[0]}").strip()
        broken += [] if version == bench.newer else [f'{unit} is of version {version}']
    bench.wait_heard()
    return broken + ([] if bench.runs() == runs else ['the map is another one'])
