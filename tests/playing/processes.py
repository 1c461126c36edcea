"""What tests with many machines do with programs of this machine: run one, wait for something, leave none behind."""
import ctypes
import os
import signal
import subprocess
import time

SLOW = 3                       # every limit of a wait is multiplied by it


class Trouble(RuntimeError):
    """What was asked for did not happen; ends a scenario."""


def die_with_parent():
    ctypes.CDLL(None).prctl(1, signal.SIGKILL)
    os.setsid()


def run(*argv, check=True, timeout=300, **more):
    """Returns what a program printed. Trouble names it and its last words."""
    more.setdefault('input', '')
    try:
        done = subprocess.run([str(a) for a in argv], capture_output=True, text=True, timeout=timeout, **more)
    except subprocess.TimeoutExpired:
        raise Trouble(f'{argv[0]} {argv[1] if len(argv) > 1 else ""} took more than {timeout} s') from None
    if check and done.returncode:
        raise Trouble(f"{' '.join(str(a) for a in argv)[:160]}: exit {done.returncode}: {(done.stderr or done.stdout).strip()[-400:]}")
    return done.stdout


def wait_until(what, condition, seconds, every=0.1):
    """Polls until `condition()` gives something true, which it returns."""
    end = time.monotonic() + seconds * SLOW
    while True:
        value = condition()
        if value:
            return value
        if time.monotonic() > end:
            raise Trouble(f'waited {seconds * SLOW:.0f} s in vain for {what}')
        time.sleep(every)
