"""network.png: the floor plan with the true positions of what the fleet built and drove, overlaid by the judge."""
import math

import matplotlib
matplotlib.use('Agg')
import matplotlib.pyplot as plt
from matplotlib.patches import Polygon
from matplotlib.ticker import MultipleLocator

try:
    import tomllib
except ImportError:                       # Debian 12 has Python 3.11; this is for older ones
    tomllib = None

COLOURS = ('#0072b2', '#d55e00', '#009e73', '#cc79a7')      # Okabe & Ito 2008: told apart by everyone
DRIVES = ('#111111', '#7a3db8', '#b8004f', '#5b7f00')


COLOUR_OF = {'rack': '#c9b79c', 'pillar': '#8c8c8c'}
SIZE_OF = {'rack': (2.7, 1.0), 'pillar': (0.4, 0.4)}       # defaults of the site file, docs/simulation.md


def corners(kind, row):
    x, y, h = row['x'], row['y'], math.radians(row.get('heading_deg', 0.0))
    a, b = row.get('length_m', row.get('side_m', SIZE_OF[kind][0])) / 2, row.get('width_m', row.get('side_m', SIZE_OF[kind][1])) / 2
    c, s = math.cos(h), math.sin(h)
    return [(x + c * u - s * v, y + s * u + c * v) for u, v in ((a, b), (-a, b), (-a, -b), (a, -b))]


def draw_site(axes, path):
    if tomllib is None or path is None or not path.exists():
        return
    site = tomllib.loads(path.read_text())
    for kind, colour in COLOUR_OF.items():
        for number, row in enumerate(site.get(kind, [])):
            axes.add_patch(Polygon(corners(kind, row), closed=True, facecolor=colour, edgecolor='#666666', linewidth=0.5,
                                   label=None if number else kind, zorder=1))
    for number, row in enumerate(site.get('wall', [])):
        axes.plot(*zip(row['from'], row['to']), color='#8c8c8c', linewidth=4, zorder=1, label=None if number else 'wall')


def draw_stations(axes, path):
    if tomllib is None or path is None or not path.exists():
        return
    for number, row in enumerate(tomllib.loads(path.read_text()).get('station', [])):
        axes.plot(row['x'], row['y'], 's', color='none', markeredgecolor='#cc0000', markersize=13, markeredgewidth=1.4, zorder=8,
                  linestyle='none', label=None if number else 'station of the site')
        axes.annotate(row['name'], (row['x'], row['y']), xytext=(0, -17), textcoords='offset points', fontsize=8, ha='center',
                      color='#cc0000', zorder=8)


def draw_network(axes, records, found):
    groups = {}
    for row in sorted(records.places.values(), key=lambda r: (r['experience'], r['index'])):
        groups.setdefault(row['experience'], []).append(row)
    # in the order of teaching, so that colours do not depend on random ids
    order = sorted(groups, key=lambda e: (records.names.get(e, e), groups[e][0]['robot']))
    for number, experience in enumerate(order):
        rows = groups[experience]
        poses = [records.true_place(row['id']) for row in rows]
        name = f'"{records.names[experience]}"' if experience in records.names else f'experience {experience[:6]}'
        axes.plot([p[0] for p in poses], [p[1] for p in poses], '.-', markersize=3, linewidth=1.2, zorder=4,
                  color=COLOURS[number % len(COLOURS)], label=f'taught: {name} by {rows[0]["robot"]}, {len(rows)} places')
    draw_stitches(axes, records, [row for row in found if row['right'] and not row['joins']], '#e6b800', 0.9, 3,
                  'stitch within one experience')
    draw_stitches(axes, records, [row for row in found if row['right'] and row['joins']], '#e6b800', 2.2, 5,
                  'stitch between two')
    draw_stitches(axes, records, [row for row in found if not row['right']], '#ff0000', 2.5, 9, 'WRONG stitch')


def draw_stitches(axes, records, rows, colour, width, order, label):
    for number, row in enumerate(rows):
        p, q = records.true_place(row['a']), records.true_place(row['b'])
        axes.plot([p[0], q[0]], [p[1], q[1]], '-', color=colour, linewidth=width, zorder=order,
                  label=None if number else f'{label} ({len(rows)})')


def draw_drives(axes, records, goals, frames_of):
    for number, goal in enumerate(goals):
        frames = frames_of(records, goal)[0]
        poses = [records.truth[goal['robot']][f] for f in frames if f in records.truth.get(goal['robot'], {})]
        if not poses:
            continue
        colour = DRIVES[number % len(DRIVES)]
        axes.plot([p[0] for p in poses], [p[1] for p in poses], '--', color=colour, linewidth=1.6, zorder=6,
                  label=f'driven: {goal["robot"]} to {goal["to"]}, {goal["state"]}')
        axes.plot(poses[0][0], poses[0][1], 'o', color=colour, markersize=6, zorder=7)
        axes.plot(poses[-1][0], poses[-1][1], '*', color=colour, markersize=12, zorder=7)
    axes.plot([], [], 's', color='white', markeredgecolor='#555555', markersize=9, linestyle='none', label='label of a place')
    for sign, size, label in (('o', 6, 'start of a drive'), ('*', 12, 'end of a drive')):
        axes.plot([], [], sign, color='#555555', markersize=size, linestyle='none', label=label)


def draw(records, found, frames_of, path):
    figure, axes = plt.subplots(figsize=(13, 8.5))
    draw_site(axes, records.site)
    draw_network(axes, records, found)
    draw_drives(axes, records, records.goals, frames_of)
    draw_stations(axes, records.site)
    for name, place in records.network.get('labels', {}).items():
        x, y, _ = records.true_place(place)
        axes.annotate(name, (x, y), xytext=(8, 9), textcoords='offset points', fontsize=9, zorder=8,
                      bbox=dict(boxstyle='round,pad=0.2', facecolor='white', edgecolor='#555555', linewidth=0.5))
    finish(figure, axes, f'What {len(records.truth)} robots taught, stitched and drove: true positions, by the simulation', path)


def finish(figure, axes, title, path):
    axes.set_aspect('equal')
    axes.margins(0.03)
    axes.xaxis.set_major_locator(MultipleLocator(2))
    axes.yaxis.set_major_locator(MultipleLocator(2))
    axes.set_xlabel('x, metres (site frame)')
    axes.set_ylabel('y, metres (site frame)')
    axes.set_title(title)
    axes.legend(loc='upper left', bbox_to_anchor=(1.01, 1.0), fontsize=9, frameon=False)
    axes.grid(linewidth=0.3)
    figure.savefig(path, dpi=110, bbox_inches='tight', pad_inches=0.15)
    plt.close(figure)
