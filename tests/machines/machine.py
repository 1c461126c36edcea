"""One machine in QEMU: started, asked over a port of its own, cut off from power. KVM where this machine has it, else emulated."""
import base64
import itertools
import os
import pathlib
import select
import signal
import socket
import subprocess
import time

from playing.processes import Trouble, die_with_parent, run

EMULATOR = 'qemu-system-x86_64'
EMULATED = 'qemu64,+ssse3,+sse4.1,+sse4.2,+popcnt'     # a third less to do than for one with wider vectors
ADDRESSES = {'server': '10.77.0.1', 'robot': '10.77.0.2'}
SLOWER = 10                    # emulated, nothing is quick: waits for a command's answer are multiplied by it


def has_kvm():
    return os.access('/dev/kvm', os.R_OK | os.W_OK)


class Machine:
    """`folder` has its disk, which outlives the machine, its console, and the sockets of both its cables."""

    def __init__(self, name, image, packages, folder, peer, memory_mb):
        self.name, self.image, self.packages, self.folder, self.peer, self.memory_mb = name, image, packages, folder, peer, memory_mb
        self.address = ADDRESSES[name]
        self.process, self.port, self.numbers = None, None, itertools.count(1)
        folder.mkdir(parents=True, exist_ok=True)
        self.disk, self.console = folder / f'{name}.qcow2', folder / f'{name}.console'
        run('qemu-img', 'create', '-q', '-f', 'qcow2', '-b', image / 'disk', '-F', 'raw', self.disk)

    # ---- power
    def start(self):
        for kind in ('port', 'cable'):
            self.socket(kind).unlink(missing_ok=True)
        with open(self.console, 'ab') as log:
            self.process = subprocess.Popen(self.command(), stdout=log, stderr=log, stdin=subprocess.DEVNULL, preexec_fn=die_with_parent)
        self.port = socket.socket(socket.AF_UNIX)
        end = time.monotonic() + 60
        while True:
            try:
                self.port.connect(str(self.socket('port')))
                return
            except OSError:
                if time.monotonic() > end or not self.is_on():
                    raise Trouble(f'{self.name} does not start: {self.last_words()}') from None
                time.sleep(0.1)

    def socket(self, kind):
        return self.folder / f'{self.name}.{kind}'

    def command(self):
        cable = f'dgram,id=cable,local.type=unix,local.path={self.socket("cable")},remote.type=unix,remote.path={self.folder / (self.peer + ".cable")}'
        kernel = ('root=/dev/vda rw rootfstype=ext4 console=ttyS0 quiet loglevel=4 net.ifnames=0 mitigations=off tsc=reliable panic=-1 '
                  f'systemd.hostname={self.name} weft.test={self.name}')
        how = ['-accel', 'kvm', '-cpu', 'host'] if has_kvm() else ['-accel', 'tcg,thread=multi,tb-size=256', '-cpu', EMULATED]
        return [EMULATOR, '-nodefaults', '-no-user-config', '-no-reboot', '-machine', 'q35', *how, '-m', str(self.memory_mb), '-smp', '1',
                '-display', 'none', '-kernel', self.image / 'kernel', '-initrd', self.image / 'initrd', '-append', kernel,
                '-chardev', f'file,id=console,path={self.console},append=on', '-serial', 'chardev:console',
                '-drive', f'file={self.disk},if=none,id=disk,format=qcow2', '-device', 'virtio-blk-pci,drive=disk',
                '-drive', f'file={self.packages},if=none,id=packages,format=raw,readonly=on', '-device', 'virtio-blk-pci,drive=packages',
                '-netdev', cable, '-device', f'virtio-net-pci,netdev=cable,mac=52:54:00:77:00:0{self.address[-1]},romfile=',
                '-device', 'virtio-rng-pci', '-device', 'virtio-serial-pci',
                '-chardev', f'socket,id=port,path={self.socket("port")},server=on,wait=off', '-device', 'virtserialport,chardev=port,name=weft-test']

    def is_on(self):
        return self.process is not None and self.process.poll() is None

    def cut_power(self):
        """As when its plug is pulled: what it had not handed to its disk is gone."""
        if self.is_on():
            os.kill(self.process.pid, signal.SIGKILL)
            self.process.wait()
        self.close()

    def shut_down(self, seconds=300):
        """As people do it."""
        self.run('systemctl poweroff --no-block')
        try:
            self.process.wait(seconds)
        except subprocess.TimeoutExpired:
            raise Trouble(f'{self.name} does not shut down: {self.last_words()}') from None
        self.close()

    def close(self):
        if self.port is not None:
            self.port.close()
        self.port = self.process = None

    def last_words(self):
        try:
            return self.console.read_text(errors='replace').strip()[-300:]
        except OSError:
            return ''

    # ---- commands
    def run(self, script, seconds=30, good=(0,)):
        """What a script of the shell printed there, run as root. Trouble: it ended with another code than these (None: any will do)."""
        code, said = self.ask(script, seconds)
        if good is not None and code not in good:
            raise Trouble(f'{self.name}: {script.strip()[:160]}: exit {code}: {said.strip()[-500:]}')
        return said

    def ask(self, script, seconds=30):
        """(exit code, what it printed)."""
        if not self.is_on():
            raise Trouble(f'{self.name} is off')
        number = next(self.numbers)
        self.port.sendall(f'{number} {base64.b64encode(script.encode()).decode()}\n'.encode())
        answer, end = b'', time.monotonic() + seconds * SLOWER
        while not (answer.endswith(b'\n') and answer.rsplit(b'\n', 2)[-2].startswith(f'{number} '.encode())):
            if not select.select([self.port], [], [], max(0.0, end - time.monotonic()))[0]:
                raise Trouble(f'{self.name}: {script.strip()[:160]}: no answer in {seconds * SLOWER} s')
            more = self.port.recv(65536)
            if not more:
                raise Trouble(f'{self.name} went off during: {script.strip()[:160]}')
            answer += more
        _, code, words = answer.decode().splitlines()[-1].split(' ')
        return int(code), base64.b64decode(words).decode(errors='replace')

    def write(self, path, text, mode='a'):
        """Appends to a file there, or with mode 'w' writes it anew."""
        words = base64.b64encode(text.encode()).decode()
        self.run(f"mkdir -p '{pathlib.PurePosixPath(path).parent}'; base64 -d <<<{words} {'>>' if mode == 'a' else '>'}'{path}'")

    # ---- services
    def unit(self, name):
        """What systemd knows of a unit."""
        said = self.run(f"systemctl show -p ActiveState,SubState,Result,NRestarts,MainPID,ExecMainStatus,UnitFileState '{name}'")
        return dict(line.split('=', 1) for line in said.splitlines() if '=' in line)

    def journal(self, unit, last=200):
        return self.run(f"journalctl --no-pager -o cat -n {last} -u '{unit}'")
