"""The panels of the study of floors, each of one floor's runs as series/floor.json has them."""
import math

from sheet import BLUE, GREEN, INK, ORANGE, QUIET, VERMILION, colour, columns, dress


def title_of(shown, more=''):
    """What the panel of a floor is called; one on which nothing could be measured says why."""
    if shown['fixes'] == 0:
        return f'{shown["floor"]}: the robot did not find itself, and stood'
    return f'{shown["floor"]}: {more}' if more else shown['floor']


def plot_scale(axes, shown):
    given = shown['camera_height_m']
    seconds, inferred = [], []
    for second, speed, true_speed in shown['speeds']:
        seconds.append(second)
        inferred.append(given * true_speed / speed if speed else math.nan)
    axes.plot(seconds, inferred, color=BLUE, linewidth=1.2, label='inferred: true / measured way x given height')
    axes.axhline(given, color=INK, linestyle='--', linewidth=1.4, label='given')
    axes.set_ylim(0.9 * given, 1.1 * given)
    dress(axes, shown['floor'], 'time while teaching, s', 'height of the camera, m')


def plot_speed(axes, shown):
    seconds, speeds, true_speeds = zip(*shown['speeds']) if shown['speeds'] else ((), (), ())
    axes.plot(seconds, true_speeds, color=INK, linewidth=2.4, label='true')
    axes.plot(seconds, speeds, color=VERMILION, linewidth=1.1, label='inferred')
    axes.set_ylim(bottom=0.0)
    off = shown['speed_percent']
    dress(axes, shown['floor'] + (f': {off:.2f} % off' if off is not None else ''), 'time while teaching, s', 'speed over 5 frames, m/s')


def plot_path(axes, shown):
    axes.plot(*columns(shown['taught']), color=INK, linewidth=2.4, label='true')
    axes.plot(*columns(shown['odometry']), color=VERMILION, linewidth=1.3, label='odometry')
    dress(axes, shown['floor'], 'x, m', 'y, m', is_map=True)


def name_of_rate(rate):
    return f'{rate["fps"]:g} fps'


def plot_rate_matches(axes, shown):
    for i, rate in enumerate(shown['rates']):
        axes.plot(*columns(rate['matches']), color=colour(i), linewidth=1.4, label=name_of_rate(rate))
    axes.set_ylim(bottom=0.0)
    dress(axes, f'{shown["floor"]}: matches', 'time, s', 'matches a view, mean of 1 s')


def plot_rate_speeds(axes, shown):
    for i, rate in enumerate(shown['rates']):
        axes.plot(*columns(rate['speeds']), color=colour(i), linewidth=1.1, label=name_of_rate(rate))
    axes.set_ylim(bottom=0.0)
    dress(axes, f'{shown["floor"]}: speed', 'time, s', 'inferred speed, m/s')


def plot_rate_paths(axes, shown):
    axes.plot(*columns(shown['rates'][0]['path']), color=INK, linestyle='--', linewidth=1.6, label='true')
    for i, rate in enumerate(shown['rates']):
        axes.plot(*columns(rate['odometry']), color=colour(i), linewidth=1.3, label=name_of_rate(rate))
    dress(axes, f'{shown["floor"]}: path', 'x, m', 'y, m', is_map=True)


def plot_localisation(axes, shown):
    axes.plot(*columns(shown['fixed']), 'o', color=ORANGE, markersize=5.0, label='where its fixes say it was')
    axes.plot(*columns(shown['taught']), color=VERMILION, linewidth=2.6, label='map (true)')
    axes.plot(*columns(shown['repeated']), color=BLUE, linewidth=1.2, label='query (true)')
    dress(axes, title_of(shown, f'{shown["fixes"]} fixes'), 'x, m', 'y, m', is_map=True)


def plot_consistency(axes, shown):
    seconds, odometry, fixes = zip(*shown['between_fixes']) if shown['between_fixes'] else ((), (), ())
    axes.plot(seconds, odometry, color=INK, linewidth=2.4, label='odometry')
    axes.plot(seconds, fixes, color=ORANGE, linewidth=1.2, label='localisation')
    axes.set_ylim(bottom=0.0)
    apart = shown['apart_percent']
    dress(axes, title_of(shown, f'{apart:.2f} % apart' if apart is not None else ''), 'time while repeating, s', 'speed between fixes, m/s')


def plot_repeat(axes, shown):
    axes.plot(*columns(shown['taught']), color=VERMILION, linewidth=3.0, label='taught (true)')
    axes.plot(*columns(shown['repeated']), color=BLUE, linewidth=1.3, label='repeated (true)')
    dress(axes, shown['floor'], 'x, m', 'y, m', is_map=True)


def plot_off(axes, shown):
    """To the left of the taught path; promised are 30 mm."""
    axes.plot([off[1] for off in shown['off']], [1e3 * off[2] for off in shown['off']], color=BLUE, linewidth=1.3,
              label='true pose against the taught path')
    for i, bound in enumerate((30.0, -30.0)):
        axes.axhline(bound, color=QUIET, linestyle='--', linewidth=1.2, label='30 mm' if i == 0 else None)
    dress(axes, title_of(shown, 'beside the path'), 'driven, m', 'to the left, mm')


def plot_heading(axes, shown):
    axes.plot([off[0] for off in shown['off']], [math.degrees(off[3]) for off in shown['off']], color=BLUE, linewidth=1.3,
              label='true heading against the taught one')
    dress(axes, title_of(shown), 'time while repeating, s', 'heading error, degrees')


def plot_two(axes, shown):
    first, second = shown['two_taught']
    axes.plot(*columns(first), color=VERMILION, linewidth=4.0, label='first experience')
    axes.plot(*columns(second), color=GREEN, linewidth=3.0, label='second, another robot')
    axes.plot(*columns(shown['two_repeated']), color=INK, linewidth=1.3, label='repeated as one')
    dress(axes, title_of(shown), 'x, m', 'y, m', is_map=True)
