"""The flags of deploy/demo: what they may be, and what follows from them."""
import argparse
import os
import pathlib

import lines as teach_lines
import scenario
import traffic

ABOUT = """Weft's main job on this machine, from nothing: installs the Debian packages that are missing, builds, starts a fleet map
server and three simulated robots in a warehouse, teaches two of them a loop each, sends one over a road that nobody
taught as a whole, has the third find itself and drive, kills and restarts the server meanwhile, drives two at once on
ways that cross, and judges all of it by the simulation's truth. Takes 3 to 5 minutes once built.

With --traffic it is six robots on a way round with an aisle driven both ways and a dead end: two are taught, twelve goals are
sent, an edge is closed for a while, and one robot's agent is killed on its way. What must hold then: every goal ends, or
`weft goal why` names what it waits for; nobody touches anybody.

Nothing is left running; logs stay in DIR/run.

exit: 0 every bound of tests/judge held and, without --traffic, all goals were reached; 1 not so, or something is missing or wrong (one line
says what); 2 wrong usage; 130 interrupted."""


class Parser(argparse.ArgumentParser):
    def error(self, message):
        self.exit(2, f'deploy/demo: {message}; see deploy/demo --help\n')


def arguments():
    parser = Parser(prog='deploy/demo', formatter_class=argparse.RawDescriptionHelpFormatter, description=ABOUT)
    parser.add_argument('--headless', action='store_true', help='do not open the picture at the end (it is only opened where there is a display)')
    parser.add_argument('--traffic', action='store_true', help='six robots that get in each other\'s way, instead of three that are taught')
    parser.add_argument('--seed', type=int, default=1, metavar='N', help='of everything that is random in the simulation (default 1)')
    parser.add_argument('--dds', choices=('fastdds', 'cyclonedds', 'mixed'), default='mixed',
                        help='mixed: server, r2, r4 and r6 Fast DDS, the other robots and the command line Cyclone DDS (default)')
    parser.add_argument('--site', metavar='SITE', help='a site of deploy/sites, or NAME.toml with NAME/r1.line and NAME/r2.line beside '
                        'it (default demo); with --traffic r1.line and r3.line (default traffic)')
    parser.add_argument('--floors', default='', metavar='DIR', help='floor from photographs in DIR instead of procedural')
    parser.add_argument('--out', metavar='DIR', help='where records and pictures go (default out/demo or out/traffic)')
    parser.add_argument('--keep', action='store_true', help='leave the fleet running at the end, to talk to with the weft command, until Ctrl-C')
    parser.add_argument('--domain', type=int, default=0, metavar='N', help='DDS domain, 1 to 200 (default: a free one)')
    parser.add_argument('--pace', type=float, metavar='X',
                        help='simulated seconds a second at most, over 0 to 100 (default 1.5; with --traffic 1)')
    parser.add_argument('--check', action='store_true', help=argparse.SUPPRESS)   # the arguments only
    options = parser.parse_args()
    options.scenario = traffic if options.traffic else scenario
    options.site = options.site or options.scenario.SITE
    options.out = options.out or f'out/{options.scenario.SITE}'
    options.pace = options.scenario.PACE if options.pace is None else options.pace
    return options


def check(options):
    """Fills in the domain, the site's file and its lines. Returns what is wrong, or None."""
    options.site_file = pathlib.Path(options.site if options.site.endswith('.toml') else f'deploy/sites/{options.site}.toml')
    lines = options.site_file.with_suffix('')
    if not options.site_file.is_file():
        known = ', '.join(sorted(path.stem for path in pathlib.Path('deploy/sites').glob('*.toml')))
        return f'--site: there is no {options.site_file}; deploy/sites has: {known}'
    options.lines = {robot: lines / f'{robot}.line' for robot in options.scenario.TEACH}
    if not all(path.is_file() for path in options.lines.values()):
        return f"--site: {options.site_file} has no {' and '.join(str(path) for path in options.lines.values())} to teach along"
    try:
        spots = {label for path in options.lines.values() for _, label in teach_lines.parts(path)}
    except ValueError as fault:
        return f'--site: {fault}'
    missing = options.scenario.spots() - spots
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
    return None
