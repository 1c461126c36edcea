"""topometric.png, topometric-overlay.png: a map, paths over it, how far odometry is off over time, and grids over walls."""
import math

from sheet import BLUE, GREEN, INK, ORANGE, PANEL, QUIET, VERMILION, columns, dress, panels, read_json, save

PATHS = (('truth', 'truth', INK, 1.8), ('raw', 'raw odometry', VERMILION, 1.0), ('open', 'open odometry', GREEN, 1.2),
         ('located', 'located', BLUE, 1.0))
ERRORS = (('raw_error', 'raw odometry', VERMILION), ('open_error', 'open odometry', GREEN))
OTHERS = (('shortcut', 'a shortcut'), ('obstacles', 'past what was not there'), ('one-way', 'there and back'),
          ('other-robot', "by another robot's map"),
          ('merge', 'two robots that were told nothing'))
WAYS = (('taught', 'taught', QUIET), ('truth', 'driven', BLUE), ('first', 'first robot', QUIET), ('second', 'second robot', BLUE))


def pairs(points):
    """Points with None, which JSON has for what is no number, as NaN: a line is broken there."""
    return [[math.nan if value is None else value for value in point] for point in points]


def plot_walls(axes, shown):
    if shown.get('walls'):
        axes.plot(*columns(pairs(shown['walls'])), color=INK, linewidth=0.7, label='what stands there')


def plot_paths(axes, deliveries, walls):
    plot_walls(axes, walls)
    for name, label, ink, thick in PATHS:
        if deliveries.get(name):
            axes.plot(*columns(pairs(deliveries[name])), color=ink, linewidth=thick, label=label)
    for name, label, mark, ink in (('switches', 'charts change', '|', ORANGE), ('goals', 'goals', 'o', ORANGE)):
        if deliveries.get(name):
            axes.plot(*columns(deliveries[name]), mark, color=ink, markersize=7.0, label=label)
    dress(axes, 'deliveries (Dayoub et al., fig. 9)', 'x, m', 'y, m', is_map=True)


def plot_errors(axes, deliveries):
    blind = [second for second, is_blind in deliveries.get('blind', []) if is_blind]
    for i, second in enumerate(blind):
        axes.axvline(second, color=QUIET, linewidth=0.5, alpha=0.5, label='blind' if i == 0 else None)
    for name, label, ink in ERRORS:
        axes.plot(*columns(deliveries[name]), color=ink, linewidth=1.4, label=label)
    axes.set_ylim(bottom=0.0)
    dress(axes, 'how far odometry is off (fig. 8)', 'time, s', 'off, m')


def plot_ways(axes, shown, title):
    plot_walls(axes, shown)
    for name, label, ink in WAYS:
        if shown.get(name):
            axes.plot(*columns(pairs(shown[name])), color=ink, linewidth=1.4, label=label)
    dress(axes, title, 'x, m', 'y, m', is_map=True)


def plot_overlay(axes, shown, name, label, ink):
    plot_walls(axes, shown)
    axes.plot(*columns(shown[name]), 's', color=ink, markersize=1.2, label=label)
    dress(axes, f'occupied cells, {label} (fig. 6)', 'x, m', 'y, m', is_map=True)
    across, up = columns(shown[name])
    axes.set_aspect('equal', adjustable='box')
    axes.set_xlim(min(across) - 0.5, max(across) + 0.5)
    axes.set_ylim(min(up) - 0.5, max(up) + 0.5)


def draw(folder):
    series = folder / 'series'
    about = read_json(series / 'topometric.json')
    shown = {name: read_json(series / f'{name}.json', otherwise={}) for name in ('map', 'deliveries', *(name for name, _ in OTHERS))}
    plots = []
    if shown['deliveries']:
        plots += [lambda axes: plot_paths(axes, shown['deliveries'], shown['map']), lambda axes: plot_errors(axes, shown['deliveries'])]
    plots += [lambda axes, name=name, title=title: plot_ways(axes, shown[name], title) for name, title in OTHERS if shown[name]]
    words = '; '.join(filter(None, (about['about'], about.get('of_first'))))
    if plots:
        figure, grid = panels('How robots navigate by a stereo pair alone', words, len(plots), 2, (PANEL[0] + 0.9, PANEL[1] + 0.5))
        for axes, plot in zip(grid, plots):
            plot(axes)
        yield save(figure, folder, 'topometric.png')
    if shown['map'].get('registered') and shown['map'].get('unregistered'):
        figure, grid = panels('A chart of two runs', words, 2, 2, (PANEL[0] + 0.9, PANEL[1] + 1.5))
        plot_overlay(grid[0], shown['map'], 'unregistered', 'as odometry has them', VERMILION)
        plot_overlay(grid[1], shown['map'], 'registered', 'registered', GREEN)
        yield save(figure, folder, 'topometric-overlay.png')
