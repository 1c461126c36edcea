"""Processes of a demo: started with a log each, stopped with the demo whatever happens to it."""
import ctypes
import pathlib
import signal
import subprocess
import threading
import time

PR_SET_PDEATHSIG = 1


def die_with_parent():
    ctypes.CDLL(None).prctl(PR_SET_PDEATHSIG, signal.SIGKILL)


class Process:
    """One program of the fleet. Its peak memory is watched, because a killed process leaves none to read."""

    def __init__(self, name, argv, log):
        self.name, self.argv, self.log = name, [str(a) for a in argv], pathlib.Path(log)
        self.peak_memory_mb = 0.0
        self.child = None

    def start(self):
        with open(self.log, 'ab') as log:
            self.child = subprocess.Popen(self.argv, stdout=log, stderr=subprocess.STDOUT, stdin=subprocess.DEVNULL,
                                          preexec_fn=die_with_parent)

    def running(self):
        return self.child is not None and self.child.poll() is None

    def read_memory(self):
        try:
            for line in pathlib.Path(f'/proc/{self.child.pid}/status').read_text().splitlines():
                if line.startswith('VmHWM:'):
                    self.peak_memory_mb = max(self.peak_memory_mb, int(line.split()[1]) / 1024)
        except (OSError, AttributeError):
            pass

    def kill(self):
        self.read_memory()
        self.child.kill()
        self.child.wait()

    def stop(self, seconds=10):
        if not self.running():
            return
        self.read_memory()
        self.child.terminate()
        try:
            self.child.wait(seconds)
        except subprocess.TimeoutExpired:
            self.kill()

    def last_words(self, lines=4):
        try:
            return ' / '.join(self.log.read_text(errors='replace').splitlines()[-lines:])
        except OSError:
            return ''


class Watch(threading.Thread):
    """Reads the peak memory of all processes once a second."""

    def __init__(self, processes):
        super().__init__(daemon=True)
        self.processes = processes
        self.over = threading.Event()

    def run(self):
        while not self.over.wait(1.0):
            for process in self.processes:
                if process.running():
                    process.read_memory()


def wait_until(what, condition, seconds, processes=(), every=0.25):
    """Polls until `condition()` gives something true; RuntimeError with the last words of a process that died."""
    end = time.monotonic() + seconds
    while True:
        value = condition()
        if value:
            return value
        for process in processes:
            if not process.running():
                raise RuntimeError(f'{process.name} has ended: {process.last_words()}')
        if time.monotonic() > end:
            raise RuntimeError(f'waited {seconds:.0f} s in vain for {what}')
        time.sleep(every)
