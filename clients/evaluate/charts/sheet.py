"""What the pictures of all studies share: colours, panels beside and below each other, legends, reading of files."""
import csv
import json
import textwrap

import matplotlib
matplotlib.use('Agg')
from matplotlib import pyplot

INK, QUIET, GRID = '#212630', '#808891', '#e1e3e8'
BLUE, VERMILION, GREEN, ORANGE = '#0072b2', '#d55e00', '#009e73', '#e69f00'     # Okabe & Ito 2008: told apart by everyone
PURPLE, SKY = '#cc79a7', '#56b4e9'
PALETTE = (BLUE, VERMILION, GREEN, ORANGE, PURPLE, SKY, INK, QUIET)

HEAD = 0.75             # inches, for the title of a picture and the line below it
PANEL, MAP = (5.6, 3.5), (5.4, 4.4)     # inches
STYLE = {'font.family': 'DejaVu Sans', 'font.size': 9, 'axes.edgecolor': QUIET, 'axes.labelcolor': INK, 'axes.titlesize': 10.5,
         'axes.titlecolor': INK, 'axes.spines.top': False, 'axes.spines.right': False, 'axes.grid': True, 'grid.color': GRID,
         'axes.axisbelow': True, 'xtick.color': QUIET, 'ytick.color': QUIET, 'legend.frameon': False, 'legend.fontsize': 8.5,
         'lines.solid_capstyle': 'round'}


def read_json(path, otherwise=None):
    """The document; `otherwise`, if given, where there is no such file."""
    if otherwise is not None and not path.exists():
        return otherwise
    with open(path, encoding='utf-8') as file:
        return json.load(file)


def read_rows(path):
    """The rows of a CSV file as dictionaries of strings."""
    with open(path, newline='', encoding='utf-8') as file:
        return list(csv.DictReader(file))


def columns(rows):
    """x and y of a list of pairs, for plot(*columns(rows)); two empty lists of none."""
    return [row[0] for row in rows], [row[1] for row in rows]


def colour(i):
    return PALETTE[i % len(PALETTE)]


def words_of(seeds):
    return f'seed {seeds[0]}' if seeds[0] == seeds[1] else f'seeds {seeds[0]} to {seeds[1]}'


def panels(title, about, count, beside, size=PANEL):
    """A figure with a head, and its axes row by row, `beside` in each."""
    pyplot.rcParams.update(STYLE)
    beside = min(beside, count)
    below = -(-count // beside)
    wide, tall = size[0] * beside, size[1] * below + HEAD
    figure, grid = pyplot.subplots(below, beside, figsize=(wide, tall), squeeze=False, layout='constrained')
    figure.get_layout_engine().set(rect=(0.0, 0.0, 1.0, 1.0 - HEAD / tall), w_pad=0.12, h_pad=0.12)
    figure.text(0.18 / wide, 1.0 - 0.34 / tall, title, fontsize=15, color=INK)
    figure.text(0.18 / wide, 1.0 - 0.60 / tall, about, fontsize=9, color=QUIET)
    axes = list(grid.flat)
    for unused in axes[count:]:
        unused.set_axis_off()
    return figure, axes[:count]


def dress(axes, title, x, y, is_map=False):
    """Title, units and a legend above what was plotted, which is as many rows high as it needs."""
    axes.set_xlabel(x)
    axes.set_ylabel(y)
    if is_map:
        axes.margins(0.06)
        axes.set_aspect('equal', adjustable='datalim')
    names = axes.get_legend_handles_labels()[1]
    room = 14.0 * axes.figure.get_size_inches()[0] / axes.get_gridspec().ncols    # letters in a row of the legend
    beside = max([n for n in range(1, len(names) + 1) if n * (max(map(len, names)) + 6) <= room] or [1])
    rows = -(-len(names) // beside) if names else 0
    axes.set_title('\n'.join(textwrap.wrap(title, 64)), loc='left', pad=6.0 + 13.5 * rows)
    if names:
        axes.legend(loc='lower left', bbox_to_anchor=(0.0, 1.0), ncols=beside, borderpad=0.2, borderaxespad=0.0, handlelength=1.8,
                    columnspacing=1.4, labelspacing=0.25)


def save(figure, folder, name):
    """Writes the PNG; returns its name."""
    figure.savefig(folder / name, dpi=110)
    pyplot.close(figure)
    return name


def plot_found(axes, metres, trials, end_m, name, ink):
    """Steps of the share of `trials` that were found within so many metres, up to `end_m`."""
    metres = sorted(metres)
    shares = [(i + 1) / trials for i in range(len(metres))]
    last = shares[-1] if shares else 0.0
    axes.step([0.0, *metres, max([end_m, *metres])], [0.0, *shares, last], where='post', color=ink, linewidth=1.8, label=name)
    axes.set_ylim(0.0, 1.03)
