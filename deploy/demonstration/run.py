#!/usr/bin/python3
"""Starts the fleet, plays the scenario, gathers the records and lets tests/judge say how it went."""
import os
import pathlib
import shutil
import signal
import subprocess
import sys
import time

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
from fleet import Fleet  # noqa: E402
from gather import RECORDS, gather  # noqa: E402
from options import arguments, check  # noqa: E402


def keep(fleet, options, say):
    """Until Ctrl-C, which is the way to end it, or a process of the fleet ends by itself."""
    say('the fleet stays until Ctrl-C here; in another shell, in this folder, talk to it, for example:')
    for words in ('robots', 'goal send --to dock-2', 'goal list', 'stop --all', 'resume --all', 'map draw map.png'):
        print(f'    {fleet.bin}/weft --domain {options.domain} {words}', flush=True)
    try:
        while all(process.running() for process in fleet.all()):
            time.sleep(1)
        say('ended by itself: ' + ', '.join(process.name for process in fleet.all() if not process.running()))
    except KeyboardInterrupt:
        say('stopping the fleet')


def interrupt(*_):
    raise KeyboardInterrupt


def main():
    signal.signal(signal.SIGINT, interrupt)      # also where the shell has it ignored, in the background
    signal.signal(signal.SIGTERM, interrupt)
    options = arguments()
    began = time.monotonic()

    def say(text):
        print(f'[{time.monotonic() - began:5.0f} s] {text}', flush=True)

    fault = check(options)
    if fault:
        print(f'deploy/demo: {fault}', file=sys.stderr)
        return 2
    if options.check:
        return 0
    out = pathlib.Path(options.out)
    out.mkdir(parents=True, exist_ok=True)
    for name in RECORDS:
        (out / name).unlink(missing_ok=True)
    shutil.rmtree(out / 'run', ignore_errors=True)
    fleet = Fleet(options, options.scenario.ROBOTS, say, **options.scenario.FLAGS)
    try:
        say(f'start: server and {len(options.scenario.ROBOTS)} robots, DDS domain {options.domain}, ' +
            ', '.join(f'{who} {vendor}' for who, vendor in fleet.vendors.items()))
        fleet.start()
        ended = options.scenario.run(fleet, options.lines, say)
        gather(fleet, out, options.site_file)
        judged = subprocess.run(['tests/judge', str(out)]).returncode
        if options.keep:
            keep(fleet, options, say)
    except KeyboardInterrupt:
        print('deploy/demo: interrupted', file=sys.stderr)
        return 130
    except (RuntimeError, OSError, ValueError, subprocess.SubprocessError) as failure:
        print(f'deploy/demo: {failure}; logs are in {fleet.work}', file=sys.stderr)
        return 1
    finally:
        fleet.stop()
    good = judged == 0 and ended
    say(f"{'done' if good else 'NOT as wanted'}: look at {out}/network.png")
    viewer = shutil.which('xdg-open')
    if good and viewer and not options.headless and os.environ.get('DISPLAY'):
        subprocess.run([viewer, str(out / 'network.png')], check=False)
    return 0 if good else 1


if __name__ == '__main__':
    sys.exit(main())
