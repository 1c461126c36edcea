"""disturbances.png: what each disturbance of the simulated body costs, alone and among all others."""
import math
import statistics

from sheet import BLUE, GREEN, QUIET, VERMILION, dress, panels, read_json, read_rows, save

MEASURES = (('speed error of odometry', 'mm/s, RMS over 0.5 s', 'speed_error_mm_s'), ('drift of odometry over 10 m', 'mm, median', 'drift_mm'),
            ('error of fixes', 'mm, median', 'fix_mm'), ('right fixes', '% of the views near a place', 'fixes_percent'))
VARIANTS = (('all but this one', 'without', BLUE, 'white', -0.16), ('all and this one', 'with', GREEN, 'white', -0.16),
            ('this one alone', 'only', VERMILION, VERMILION, 0.16))
ROW, LEFT, PANEL_WIDE = 0.34, 1.7, 2.7     # inches


def values_of(rows, variant, column, seeds):
    """Of the seeds, where there was something to measure."""
    return [float(row[column]) for row in rows
            if row['variant'] == variant and row[column] and (not seeds or seeds[0] <= int(row['seed']) <= seeds[1])]


def plot_measure(axes, rows, names, measure, seeds):
    title, unit, column = measure
    for name, variant, ink in (('all', 'all', BLUE), ('none', 'none', VERMILION)):
        values = values_of(rows, variant, column, seeds)
        if values:
            axes.axvline(statistics.fmean(values), color=ink, linestyle='--', linewidth=1.4, label=name)
    for label, prefix, ink, fill, aside in VARIANTS:
        spreads = [(i, values_of(rows, f'{prefix} {name}', column, seeds)) for i, name in enumerate(names)]
        spreads = [(i + aside, values) for i, values in spreads if values]
        axes.hlines([y for y, _ in spreads], [min(v) for _, v in spreads], [max(v) for _, v in spreads], color=ink, linewidth=1.2)
        axes.plot([statistics.fmean(v) for _, v in spreads], [y for y, _ in spreads], 'o', color=ink, markerfacecolor=fill,
                  markersize=5.5, label=label)
    axes.set_xlim(0.0, 1.04 * axes.get_xlim()[1])
    axes.set_ylim(len(names) - 0.5, -0.5)
    axes.grid(axis='y', visible=False)
    axes.set_title(title, loc='left')
    axes.set_xlabel(unit)


def names_of(rows):
    """Of a folder without its series: what variants are about, in the order of the file."""
    words = [row['variant'].split(' ', 1) for row in rows]
    return list(dict.fromkeys(word[1] for word in words if len(word) == 2))


def draw(folder):
    rows = read_rows(folder / 'disturbances.csv')
    study = read_json(folder / 'series' / 'disturbances.json', otherwise={})
    names = study['disturbances'] if 'disturbances' in study else names_of(rows)
    about = study.get('about', 'method floor') + '; lines from the least to the most of the seeds'
    size = ((LEFT + len(MEASURES) * PANEL_WIDE) / len(MEASURES), 1.3 + ROW * max(4, len(names)))
    figure, grid = panels('What each disturbance of the simulated body costs', about, len(MEASURES), len(MEASURES), size)
    for axes, measure in zip(grid, MEASURES):
        plot_measure(axes, rows, names, measure, study.get('seeds'))
        axes.set_yticks(range(len(names)), names if axes is grid[0] else [''] * len(names))
    handles, labels = grid[0].get_legend_handles_labels()
    figure.legend(handles, labels, loc='upper right', ncols=5, borderpad=0.8)
    yield save(figure, folder, 'disturbances.png')
