"""replay.png: path, matches, fixes and, with a trajectory, speed of a recording."""
from sheet import BLUE, INK, ORANGE, VERMILION, columns, dress, panels, read_json, save


def plot_path(axes, series):
    if series['trajectory']:
        axes.plot(*columns(series['trajectory']), color=INK, linewidth=2.4, label='trajectory file, aligned')
    axes.plot(*columns(series['odometry']), color=VERMILION, linewidth=1.3, label='odometry')
    dress(axes, 'path, by odometry', 'x, m', 'y, m', is_map=True)


def plot_matches(axes, series):
    axes.plot(*columns(series['matches']), color=BLUE, linewidth=1.0, label='while mapping')
    axes.set_ylim(bottom=0.0)
    dress(axes, 'matches', 'time, s', 'matches a view')


def plot_fixes(axes, series):
    axes.plot(*columns(series['fixes']), 'o', color=ORANGE, markersize=3.0, label='fixes')
    axes.set_ylim(bottom=0.0)
    dress(axes, 'place that it found itself at', 'time, s', 'number of the place')


def plot_speed(axes, series):
    seconds, speeds, true_speeds = zip(*series['speeds'])
    axes.plot(seconds, true_speeds, color=INK, linewidth=2.2, label='trajectory file')
    axes.plot(seconds, speeds, color=VERMILION, linewidth=1.1, label='inferred')
    axes.set_ylim(bottom=0.0)
    dress(axes, 'speed over 5 frames', 'time, s', 'speed, m/s')


def draw(folder):
    series = read_json(folder / 'series' / 'replay.json')
    plots = [plot_path, plot_matches, plot_fixes] + ([plot_speed] if series['speeds'] else [])
    figure, grid = panels(f'Replayed: {series["recording"]}', series['about'], len(plots), 2)
    for axes, plot in zip(grid, plots):
        plot(axes, series)
    yield save(figure, folder, 'replay.png')
