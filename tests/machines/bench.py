"""What scenarios share: a server's machine and a robot's with a cable between them, and what people type on them."""
import json
import shutil

import image
from machine import Machine
from playing import steps
from playing.processes import Trouble, wait_until

MEMORY_MB = {'server': 900, 'robot': 1400}
SERVER, AGENT, BACKUP = 'weft-server.service', 'weft-agent@r1.service', 'weft-backup.service'
SETTINGS, AGENT_SETTINGS = '/etc/weft/server.toml', '/etc/weft/agents/r1.toml'
MAP, STATE, BACKUPS = '/var/lib/weft/map', '/var/lib/weft/agents/r1', '/var/backups/weft'
ACKS = f'{STATE}/records/acks.jsonl'
PATIENCE, NOT_REACHED = 4, (3, 5)           # a machine that is emulated may be too busy to answer in time
DISK, SITE = '/packages', '/root/weft'      # where the packages' disk is mounted, and where the archive is unpacked


class Bench:
    def __init__(self, say=steps.say):
        self.say, self.machines, self.folder = say, {}, image.WORK / 'run'

    def open(self, base, packages):
        shutil.rmtree(self.folder, ignore_errors=True)
        self.folder.mkdir(parents=True)
        for name, peer in (('server', 'robot'), ('robot', 'server')):
            self.machines[name] = Machine(name, base, packages, self.folder, peer, MEMORY_MB[name])

    @property
    def server(self):
        return self.machines['server']

    @property
    def robot(self):
        return self.machines['robot']

    def boot(self, *names):
        """Starts machines at once, and waits until systemd has started all that it should."""
        started = [self.machines[name] for name in names or self.machines]
        for one in started:
            one.start()
        for one in started:
            state = one.ask('systemctl is-system-running --wait', 60)[1].strip()
            if state != 'running':
                raise Trouble(f"{one.name} is {state}: {one.run('systemctl --failed --no-legend --plain', good=None).strip()}")

    def cut_power(self, *names):
        for name in names or self.machines:
            self.machines[name].cut_power()

    # ---- services
    def wait_active(self, machine, unit, seconds=60, other_than=None):
        """Until the service is up; with `other_than`, a process id, as another process. Returns what systemd knows of it."""
        def there():
            known = machine.unit(unit)
            return known['ActiveState'] == 'active' and known['MainPID'] not in ('0', other_than) and known
        return wait_until(f'{unit} to be active', there, seconds, every=0.5)

    def wait_failed(self, machine, unit, seconds=40):
        def ended():
            known = machine.unit(unit)
            return known['ActiveState'] == 'failed' and known
        return wait_until(f'{unit} to have failed', ended, seconds, every=0.5)

    # ---- the operator, on the server's machine
    def weft(self, *words, good=(0,), seconds=60):
        """The answer; none where `good` is None and the command fails."""
        address, flat = self.server.address, ' '.join(f"'{word}'" for word in words)
        command = f'weft --listen {address} --server {address} --timeout {seconds} --json {flat}'
        for _ in range(PATIENCE):
            code, said = self.server.ask(f'{command} 2>/root/told || {{ code=$?; cat /root/told; exit $code; }}', seconds)
            if code not in NOT_REACHED:
                break
        if good is None and code:
            return None
        if good is not None and code not in good:
            raise Trouble(f"weft {' '.join(str(word) for word in words)}: exit {code}: {said.strip()[-300:]}")
        return json.loads(said)

    def row(self, name='r1'):
        rows = (self.weft('robots', good=None) or {'robots': []})['robots']
        return next((row for row in rows if row['name'] == name), {})

    def wait_heard(self, heard=True, seconds=60):
        def is_so():
            row = self.row()
            return row and row['heard'] == heard and row
        return wait_until(f"r1 to be {'heard' if heard else 'silent'}", is_so, seconds, every=0.5)

    def runs(self):
        """name -> (id, places, labels) of all that was taught."""
        return {run['name']: (run['id'], run['places'], run['labels']) for run in self.weft('map', 'list')['experiences']}

    def lead(self, metres, name):
        """Begins to teach r1 straight ahead from where a simulated body stands when its agent has started."""
        points = ''.join(f'{6.5 - 0.25 * step:.2f} 6.40\n' for step in range(int(4 * metres) + 1))
        self.server.write('/root/line', points, 'w')
        begin = ('teach', 'r1', 'start', '--as', name, '--along', '/root/line')
        wait_until('r1 to be taught', lambda: self.weft(*begin, good=None) is not None, 40, every=1)

    def wait_led(self, frame, seconds=100):
        """Until nobody leads r1 any more."""
        def is_there():
            row = self.row()
            return row.get('reason') == 'hand_done' and row['frame'] > frame + 5
        return wait_until('r1 to be led to the end', is_there, seconds, every=1)

    def export(self):
        self.weft('map', 'export', '/root/network.json')
        return json.loads(self.server.run('cat /root/network.json'))

    def keep_logs(self, scenario):
        """Saves consoles and journals, for people who look into a failure."""
        folder = image.WORK / 'logs' / scenario
        shutil.rmtree(folder, ignore_errors=True)
        folder.mkdir(parents=True)
        for name, machine in self.machines.items():
            shutil.copy(machine.console, folder)
            if machine.is_on():
                try:
                    (folder / f'{name}.journal').write_text(machine.run('journalctl --no-pager -b -n 4000', 60, good=None))
                except (Trouble, OSError) as trouble:
                    (folder / f'{name}.journal').write_text(str(trouble))
