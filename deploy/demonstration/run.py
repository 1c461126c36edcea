#!/usr/bin/python3
"""Starts the fleet, plays the scenario, gathers the records and lets tests/judge say how it went."""
import argparse
import json
import os
import pathlib
import shutil
import signal
import subprocess
import sys
import time

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
import lines as teach_lines  # noqa: E402
import scenario  # noqa: E402
from fleet import Fleet  # noqa: E402

RECORDS = ('truth.jsonl', 'fixes.jsonl', 'drives.jsonl', 'acks.jsonl', 'goals.jsonl', 'processes.jsonl', 'experiences.jsonl', 'network.json',
           'network.png', 'map.svg', 'summary.json', 'site.toml', 'floor.pgm', 'versions')


ABOUT = """Weft's main job on this machine, from nothing: installs the Debian packages that are missing, builds, starts a fleet map
server and three simulated robots in a warehouse, teaches two of them a loop each, sends one over a road that nobody
taught as a whole, has the third find itself and drive, kills and restarts the server meanwhile, drives two at once on
ways that cross, and judges all of it by the simulation's truth. Takes 3 to 5 minutes once built. Nothing is left running; logs stay in DIR/run.

exit: 0 all goals reached and every bound of tests/judge held; 1 not so, or something is missing or wrong (one line
says what); 2 wrong usage; 130 interrupted."""


class Parser(argparse.ArgumentParser):
    def error(self, message):
        self.exit(2, f'deploy/demo: {message}; see deploy/demo --help\n')


def arguments():
    parser = Parser(prog='deploy/demo', formatter_class=argparse.RawDescriptionHelpFormatter, description=ABOUT)
    parser.add_argument('--headless', action='store_true', help='do not open the picture at the end (it is only opened where there is a display)')
    parser.add_argument('--seed', type=int, default=1, metavar='N', help='of everything that is random in the simulation (default 1)')
    parser.add_argument('--dds', choices=('fastdds', 'cyclonedds', 'mixed'), default='mixed',
                        help='mixed: server and r2 Fast DDS, r1, r3 and the command line Cyclone DDS (default)')
    parser.add_argument('--site', default='demo', metavar='SITE',
                        help='a site of deploy/sites, or NAME.toml with NAME/r1.line and NAME/r2.line beside it (default demo)')
    parser.add_argument('--floors', default='', metavar='DIR', help='floor from photographs in DIR instead of procedural')
    parser.add_argument('--out', default='out/demo', metavar='DIR', help='where records and pictures go (default out/demo)')
    parser.add_argument('--keep', action='store_true', help='leave the fleet running at the end, to talk to with the weft command, until Ctrl-C')
    parser.add_argument('--domain', type=int, default=0, metavar='N', help='DDS domain, 1 to 200 (default: a free one)')
    parser.add_argument('--pace', type=float, default=1.5, metavar='X',
                        help='simulated seconds a second at most, over 0 to 100 (default 1.5)')
    parser.add_argument('--check', action='store_true', help=argparse.SUPPRESS)   # the arguments only
    return parser.parse_args()


def check(options):
    options.site_file = pathlib.Path(options.site if options.site.endswith('.toml') else f'deploy/sites/{options.site}.toml')
    lines = options.site_file.with_suffix('')
    if not options.site_file.is_file():
        known = ', '.join(sorted(path.stem for path in pathlib.Path('deploy/sites').glob('*.toml')))
        return f'--site: there is no {options.site_file}; deploy/sites has: {known}'
    if not (lines / 'r1.line').is_file() or not (lines / 'r2.line').is_file():
        return f'--site: {options.site_file} has no {lines}/r1.line and {lines}/r2.line to teach along'
    try:
        spots = {label for robot in ('r1', 'r2') for _, label in teach_lines.parts(lines / f'{robot}.line')}
    except ValueError as fault:
        return f'--site: {fault}'
    missing = {scenario.R2_SEED, *(label for label, _ in scenario.GOALS + scenario.CROSSING)} - spots
    if missing:
        return f"--site: the lines in {lines} name no spot {', '.join(sorted(missing))} (a row '# label NAME')"
    if options.floors and not pathlib.Path(options.floors).is_dir():
        return f'--floors: {options.floors} is no folder'
    if options.seed < 0:
        return f'--seed: {options.seed} is negative'
    if not 0 <= options.domain <= 200:
        return f'--domain: {options.domain} is not in 1 to 200'
    if not 0 < options.pace <= 100:
        return f'--pace: {options.pace} is not over 0 to 100'
    options.domain = options.domain or 1 + os.getpid() % 200
    options.lines = {'r1': lines / 'r1.line', 'r2': lines / 'r2.line'}
    return None


def write_lines(path, rows):
    path.write_text(''.join(json.dumps(row) + '\n' for row in rows))


def gather(fleet, out, site_file):
    fleet.weft('map', 'export', out / 'network.json')
    fleet.weft('map', 'draw', out / 'map.svg')
    write_lines(out / 'goals.jsonl', fleet.weft('goal', 'list')['goals'])
    rows = [dict(name='server', vendor=fleet.weft('map', 'info')['vendor'], peer=None, peak_memory_mb=fleet.server.peak_memory_mb)]
    client = fleet.weft('doctor')['client']
    for row in fleet.weft('robots')['robots']:
        rows.append(dict(name=row['name'], vendor=row['vendor'], peer=row['id'],
                         peak_memory_mb=fleet.robots[row['name']].peak_memory_mb))
    rows.append(dict(name='cli', vendor=client['vendor'], peer=None, peak_memory_mb=None))
    rows = [dict(row, asked=fleet.vendors[row['name']]) for row in rows]
    write_lines(out / 'processes.jsonl', rows)
    write_lines(out / 'experiences.jsonl', [dict(experience=id, name=name) for id, name in fleet.experiences.items()])
    shutil.copy(site_file, out / 'site.toml')
    photographs = ['--floors', fleet.options.floors] if fleet.options.floors else []
    subprocess.run([fleet.bin / 'sim-floor', site_file, out / 'floor.pgm', *photographs], check=True)
    programs = ('weft', 'weft-server', 'weft-agent')
    (out / 'versions').write_text(''.join(
        subprocess.run([fleet.bin / program, '--version'], capture_output=True, text=True).stdout for program in programs))


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
    fleet = Fleet(options, say)
    try:
        say(f'start: server and three robots, DDS domain {options.domain}, ' +
            ', '.join(f'{who} {vendor}' for who, vendor in fleet.vendors.items()))
        fleet.start()
        ended = scenario.run(fleet, options.lines, say)
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
    good = judged == 0 and all(row['state'] == 'succeeded' for row in ended)
    say(f"{'done' if good else 'NOT as wanted'}: look at {out}/network.png")
    viewer = shutil.which('xdg-open')
    if good and viewer and not options.headless and os.environ.get('DISPLAY'):
        subprocess.run([viewer, str(out / 'network.png')], check=False)
    return 0 if good else 1


if __name__ == '__main__':
    sys.exit(main())
