"""Plays scenarios one after the other, counts them, and ends with "N passed, N failed, N skipped"."""
import fcntl
import os
import signal
import subprocess
import sys
import time

from playing.processes import Trouble

TROUBLES = (Trouble, OSError, KeyError, ValueError, subprocess.SubprocessError)


class Ended(BaseException):
    """Somebody ended the run."""


def end(number, _):
    signal.signal(signal.SIGTERM, signal.SIG_IGN)
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    raise Ended(number)


def say(words):
    print(f'    {words}', flush=True)


class Steps:
    """What has passed, failed and was skipped so far; `minutes` after it was made, or at WEFT_DEADLINE, nothing more begins."""

    def __init__(self, minutes):
        self.passed, self.failures, self.skipped = 0, [], 0
        own = time.time() + 60 * minutes
        self.deadline = min(own, float(os.environ.get('WEFT_DEADLINE', own)) - 20)

    def step(self, name, work):
        """Whether `work` returned nothing that is broken, and nothing went wrong in it."""
        began = time.monotonic()
        print(f'--- {name}', flush=True)
        try:
            broken = work() or []
        except TROUBLES as trouble:
            broken = [f'{"" if isinstance(trouble, Trouble) else type(trouble).__name__ + ": "}{trouble}']
        took = time.monotonic() - began
        for what in broken[:20]:
            say(what)
        if broken:
            self.failures.append(name)
        else:
            self.passed += 1
        print(f"--- {name}: {'FAILED' if broken else 'passed'}, {took:.0f} s", flush=True)
        return not broken

    def skip(self, name, why):
        self.skipped += 1
        print(f'--- {name}: SKIPPED, {why}', flush=True)

    def has_time(self, title, seconds):
        """Whether so many seconds are left; skips it where they are not."""
        if time.time() + seconds <= self.deadline:
            return True
        self.skip(title, f'takes up to {seconds} s and {max(0, self.deadline - time.time()):.0f} are left')
        return False

    def play(self, everything, clean):
        """Does it all, cleans up when somebody ends it, prints the closing line and returns the exit code."""
        signal.signal(signal.SIGTERM, end)
        signal.signal(signal.SIGINT, end)
        ended = None
        try:
            everything()
        except Ended as signalled:
            ended = signalled.args[0]
            print('--- ended; cleaning up', flush=True)
            clean()
        except BaseException:                       # a defect of the scenarios
            clean()
            raise
        if self.failures:
            print('failed: ' + ', '.join(self.failures))
        print(f'{self.passed} passed, {len(self.failures)} failed, {self.skipped} skipped', flush=True)
        if self.failures:
            return 1
        return 128 + ended if ended else 0


def run_alone(name, folder):
    """An open file that keeps others out as long as it is; none, and a word to standard error: another one runs here."""
    folder.mkdir(parents=True, exist_ok=True)
    lock = open(folder / 'lock', 'w')
    try:
        fcntl.flock(lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
    except OSError:
        print(f'{name}: another one runs here; end that one first', file=sys.stderr)
        return None
    return lock
