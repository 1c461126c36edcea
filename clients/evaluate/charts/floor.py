"""The ten pictures of the study of floors: figures 6 to 10 of the paper and their parts."""
import collections
import math

from floor_panels import (plot_consistency, plot_heading, plot_localisation, plot_off, plot_path, plot_rate_matches, plot_rate_paths,
                          plot_rate_speeds, plot_repeat, plot_scale, plot_speed, plot_two)
from sheet import MAP, PANEL, colour, dress, panels, read_json, save, words_of

MAPPING = 'mapping'     # the part of a row that is no light

# file, title, panels of each floor, columns, size
OF_FIRST_SEED = (
    ('floor-6a-scale.png', 'Scale over time', (plot_scale,), 2, PANEL),
    ('floor-6b-speed.png', 'Inferred and true speed while mapping', (plot_speed,), 2, PANEL),
    ('floor-6c-paths.png', 'Ground-plane trajectories while mapping', (plot_path,), 2, MAP),
    ('floor-7-frame-rates.png', 'Fewer images a second', (plot_rate_matches, plot_rate_speeds, plot_rate_paths), 3, PANEL),
    ('floor-8a-localisation.png', 'Localisation of another robot on another day', (plot_localisation,), 2, MAP),
    ('floor-8b-consistency.png', 'Odometry and localisation say how fast it drove', (plot_consistency,), 2, PANEL),
    ('floor-10a-repeat.png', 'Repeated against taught', (plot_repeat, plot_off), 2, PANEL),
    ('floor-10b-heading.png', 'Heading error over the repeat', (plot_heading,), 2, PANEL),
    ('floor-10c-two-experiences.png', 'Two experiences repeated as one', (plot_two,), 2, MAP))


def blind_distances(rows, study):
    """By light and floor, over all seeds that were asked for."""
    first, last = study.get('seeds', (0, math.inf))
    by_light = collections.defaultdict(lambda: collections.defaultdict(list))
    for row in rows:
        is_asked = row['part'] in study.get('lights', [row['part']]) and row['floor'] in study.get('floors', [row['floor']])
        if is_asked and row['part'] != MAPPING and first <= row['seed'] <= last:
            by_light[row['part']][row['floor']] += row['blind_distances_m']
    return by_light


def plot_blind(axes, light, by_floor):
    """Shares of the blind stretches that are at least so long, as steps."""
    for i, (floor, distances) in enumerate(sorted(by_floor.items())):
        shares = [1.0 - k / len(distances) for k in range(len(distances) + 1)] if distances else [0.0]  # never blind
        axes.step([0.0, *sorted(distances)], shares, where='post', color=colour(i), linewidth=1.8, label=floor)
    axes.set_ylim(0.0, 1.03)
    axes.set_xlim(left=0.0)
    dress(axes, f'repeated under: {light}', 'x: true distance without a right fix, m', 'P(X >= x)')


def draw_blind(folder, rows, study):
    by_light = blind_distances(rows, study)
    seeds = study.get('seeds') or (min(row['seed'] for row in rows), max(row['seed'] for row in rows))
    figure, grid = panels('Driven without a right fix', f'{study.get("about", "method floor")}, {words_of(seeds)}', len(by_light), 2)
    for axes, (light, by_floor) in zip(grid, sorted(by_light.items())):
        plot_blind(axes, light, by_floor)
    return save(figure, folder, 'floor-9-blind.png')


def draw(folder):
    rows = read_json(folder / 'floor.json')['rows']
    study = read_json(folder / 'series' / 'floor.json', otherwise={})
    if any(row['part'] != MAPPING for row in rows):
        yield draw_blind(folder, rows, study)
    shown = study.get('shown', [])
    for name, title, plots, beside, size in OF_FIRST_SEED if shown else ():
        figure, grid = panels(title, f'{study["about"]}, {study["of_first"]}', len(plots) * len(shown), beside, size)
        for i, axes in enumerate(grid):
            plots[i % len(plots)](axes, shown[i // len(plots)])
        yield save(figure, folder, name)
