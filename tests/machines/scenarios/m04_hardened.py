"""What the service manager says of the services, and the kernel of their processes."""
import re

import bench as shop

TITLE, SECONDS = 'services are hardened, and run without rights', 120
EXPOSURE = 2.0


def exposure(machine, unit):
    found = re.search(r'Overall exposure level for \S+: ([\d.]+)', machine.run(f'systemd-analyze security --no-pager {unit}', 60))
    return float(found.group(1)) if found else 10.0


def not_hardened(machine, unit):
    """What is missing of it, as the kernel tells it."""
    pid = machine.unit(unit)['MainPID']
    status = dict(line.split(':\t', 1) for line in machine.run(f'cat /proc/{pid}/status').splitlines() if ':\t' in line)
    root = machine.run(f"awk '$2 == \"/\" {{ print $4 }}' /proc/{pid}/mounts").strip().split(',')
    bad = {'runs as root': '0' in status['Uid'].split(), 'has capabilities': int(status['CapEff'], 16) != 0,
           'may gain privileges': status['NoNewPrivs'].strip() != '1', 'has no seccomp filter': status['Seccomp'].strip() != '2',
           'may write its root': 'ro' not in root}
    return [f'{unit} {what}' for what, is_so in bad.items() if is_so]


def run(bench):
    broken = []
    for machine, unit in ((bench.server, shop.SERVER), (bench.server, shop.BACKUP), (bench.robot, shop.AGENT)):
        level = exposure(machine, unit)
        bench.say(f'{unit}: exposure {level}')
        broken += [] if level <= EXPOSURE else [f'{unit}: exposure {level}, at most {EXPOSURE} is good']
        broken += [] if unit == shop.BACKUP else not_hardened(machine, unit)
    return broken
